//! A value that is computed when first needed and then kept, like `std::sync::OnceLock`.

use crate::prelude::*;

use once_cell::race::OnceBox;

/// A value that is computed once. No thread waits: several threads may compute the value at the same time, and the first result is kept.
#[derive(Debug, Clone)]
pub(crate) struct Once<T>(OnceBox<T>);

impl<T> Once<T> {
    pub(crate) const fn new() -> Self {
        Self(OnceBox::new())
    }

    pub(crate) fn get(&self) -> Option<&T> {
        self.0.get()
    }

    pub(crate) fn get_or_init(&self, make: impl FnOnce() -> T) -> &T {
        self.0.get_or_init(|| Box::new(make()))
    }
}

impl<T> Default for Once<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> From<T> for Once<T> {
    fn from(made: T) -> Self {
        Self(OnceBox::with_value(Box::new(made)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_made_once_and_kept() {
        let once = Once::new();
        assert!(once.get().is_none());
        assert_eq!((once.get_or_init(|| 1), once.get_or_init(|| 2)), (&1, &1));
        assert_eq!((once.clone().get(), Once::from(3).get()), (Some(&1), Some(&3)));
        assert!(Once::<u8>::default().get().is_none());
    }
}
