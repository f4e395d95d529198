//! Lists of the elements of an iterator.

use crate::prelude::*;

/// Collects the elements of an iterator. It replaces `collect`, which the compiler instantiates with several adapters for each iterator; this loop
/// compiles faster.
pub(crate) trait IntoList: Iterator + Sized {
    /// The elements, in order.
    fn list(mut self) -> Vec<Self::Item> {
        let mut all = const { Vec::new() };
        self.append_to(&mut all);
        all
    }

    /// Appends the elements to a list. The list is not owned here, so that this loop needs no code that drops it if the iterator panics.
    fn append_to(&mut self, all: &mut Vec<Self::Item>) {
        loop {
            let Some(element) = self.next() else { return };
            all.push(element);
        }
    }
}

impl<I: Iterator> IntoList for I {}

/// The values of all elements, in order. If an element is `None`, returns `None` at once.
pub(crate) fn all_some<T>(elements: impl Iterator<Item = Option<T>>) -> Option<Vec<T>> {
    let mut all = Vec::new();
    for element in elements {
        all.push(element?);
    }
    Some(all)
}
