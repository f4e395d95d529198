//! Lists of the elements of an iterator.

use crate::prelude::*;

/// An iterator whose elements make a list. `collect` compiles several adapters for each iterator, and asks it for its length first.
pub(crate) trait IntoList: Iterator + Sized {
    /// The elements, in order.
    fn list(self) -> Vec<Self::Item> {
        let mut all = Vec::new();
        for element in self {
            all.push(element);
        }
        all
    }
}

impl<I: Iterator> IntoList for I {}
