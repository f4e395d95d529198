//! A value that is computed once for a grasp and then kept with the grasp.

use alloc::sync::Arc;
use core::any::Any;
use core::fmt;

use crate::numerics::Once;

/// A value computed on first use, of a type that only the caller knows. It may depend only on the contacts of a grasp and on its drives, the springs
/// of joints and tendons.
#[derive(Clone, Default)]
pub(crate) struct CachedValue(Once<Arc<dyn Any + Send + Sync>>);

impl CachedValue {
    /// The stored value, computed by `make` on first use. If a value of another type is stored, `make` computes the value at every call, without
    /// storing it.
    pub(crate) fn get<T: Any + Send + Sync>(&self, make: impl Fn() -> T) -> Arc<T> {
        let kept = self.0.get_or_init(|| Arc::new(make())).clone();
        kept.downcast().unwrap_or_else(|_| Arc::new(make()))
    }
}

impl fmt::Debug for CachedValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.get().is_some() { "Remembered" } else { "NotYet" })
    }
}
