//! Lists of numbers, stored in place or on the heap.

use core::fmt::{Debug, Formatter};

use crate::prelude::*;

/// Largest number of components stored in place. With their count they fill two cache lines, which are copied without a function call. Longer
/// lists are on the heap.
const IN_PLACE: usize = 15;

/// A list of any length. Up to [`IN_PLACE`] numbers are stored in place, followed by zeros; longer lists are on the heap.
#[derive(Clone)]
#[repr(u32)] // tag and length share one word, so the numbers behind them are copied by whole words
pub(super) enum List {
    Few(u32, [f64; IN_PLACE]),
    More(Vec<f64>),
}

impl List {
    #[inline]
    pub(super) fn zeros(count: usize) -> Self {
        match u32::try_from(count) {
            Ok(few) if count <= IN_PLACE => Self::Few(few, [0.0; IN_PLACE]),
            _ => Self::on_heap(count),
        }
    }

    #[inline]
    pub(super) fn slice(&self) -> &[f64] {
        match self {
            Self::Few(len, few) => &few[..(*len as usize).min(IN_PLACE)],
            Self::More(more) => more,
        }
    }

    #[inline]
    pub(super) fn slice_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Few(len, few) => &mut few[..(*len as usize).min(IN_PLACE)],
            Self::More(more) => more,
        }
    }

    /// The list as an array of N numbers, with zeros beyond its end. `None` for a list of more than N numbers or on the heap, or if N exceeds
    /// [`IN_PLACE`].
    #[inline]
    pub(super) fn fixed<const N: usize>(&self) -> Option<&[f64; N]> {
        match self {
            Self::Few(len, few) if *len as usize <= N => few.first_chunk(),
            _ => None,
        }
    }

    /// The list as a mutable array of N numbers. `None` for a list of more than N numbers or on the heap, or if N exceeds [`IN_PLACE`]. Numbers
    /// beyond the end of the list must stay zero.
    #[inline]
    pub(super) fn fixed_mut<const N: usize>(&mut self) -> Option<&mut [f64; N]> {
        match self {
            Self::Few(len, few) if *len as usize <= N => few.first_chunk_mut(),
            _ => None,
        }
    }

    /// Extends the list with zeros to at least `count` numbers.
    #[inline]
    pub(super) fn grow(&mut self, count: usize) {
        match (self, u32::try_from(count)) {
            (Self::Few(len, _), Ok(few)) if count <= IN_PLACE => *len = few.max(*len),
            (list, _) if list.slice().len() < count => list.move_to_heap(count),
            _ => {}
        }
    }

    #[inline(never)]
    fn on_heap(count: usize) -> Self {
        Self::More(vec![0.0; count])
    }

    #[inline(never)]
    fn move_to_heap(&mut self, count: usize) {
        let mut more = self.slice().to_vec();
        more.resize(count, 0.0);
        *self = Self::More(more);
    }
}

impl PartialEq for List {
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (self.slice(), other.slice());
        let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
        let (same, more) = long.split_at(short.len());
        same == short && more.iter().all(|x| *x == 0.0)
    }
}

impl Debug for List {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        self.slice().fmt(f)
    }
}
