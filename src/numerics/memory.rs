//! Scratch buffers that one solve leaves for the next.

use core::any::Any;
use core::fmt::{Debug, Formatter};

use crate::prelude::*;

/// Scratch buffers that the solver of a grasp keeps for its next computation. If the next computation needs buffers of another type, the stored ones
/// are dropped. A clone starts without buffers.
#[derive(Default)]
pub(crate) struct Memory(Option<Box<dyn Any + Send + Sync>>);

impl Memory {
    /// The stored buffers if they have this type, otherwise new buffers from `new`.
    pub(crate) fn of<T: Any + Send + Sync>(&mut self, new: impl FnOnce() -> T) -> &mut T {
        let kept = self.0.take().and_then(|kept| kept.downcast::<T>().ok());
        let kept = self.0.insert(kept.unwrap_or_else(|| Box::new(new())));
        kept.downcast_mut().expect("the type that was put in")
    }
}

impl Clone for Memory {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Debug for Memory {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.write_str("Memory")
    }
}
