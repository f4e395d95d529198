//! Lists of the elements of an iterator.

use crate::prelude::*;

/// An iterator whose elements make a list. `collect` compiles several adapters for each iterator, and asks it for its length first.
pub(crate) trait IntoList: Iterator + Sized {
    /// The elements, in order.
    fn list(mut self) -> Vec<Self::Item> {
        let mut all = const { Vec::new() };
        loop {
            let Some(element) = self.next() else { return all };
            all.push(element);
        }
    }

    /// The values of all elements, in order; `None` from the first element that has none.
    fn all_some<T>(mut self) -> Option<Vec<T>>
    where
        Self: Iterator<Item = Option<T>>,
    {
        let mut all = const { Vec::new() };
        loop {
            let Some(element) = self.next() else { return Some(all) };
            all.push(element?);
        }
    }

    /// The values of all elements, in order, or the first error.
    fn all_ok<T, E>(mut self) -> Result<Vec<T>, E>
    where
        Self: Iterator<Item = Result<T, E>>,
    {
        let mut all = const { Vec::new() };
        loop {
            let Some(element) = self.next() else { return Ok(all) };
            all.push(element?);
        }
    }
}

impl<I: Iterator> IntoList for I {}
