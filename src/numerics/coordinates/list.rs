//! Lists of numbers, in place or on the heap.

use core::fmt::{Debug, Formatter};

use nalgebra::SMatrix;

use crate::prelude::*;

/// A list of numbers.
pub(crate) trait List: Clone + Debug + PartialEq + Send + Sync {
    fn zeros(count: usize) -> Self;
    fn slice(&self) -> &[f64];
    fn slice_mut(&mut self) -> &mut [f64];
    /// Extends the list with zeros to at least `count` numbers.
    fn reach(&mut self, count: usize);
}

impl<const R: usize, const C: usize> List for SMatrix<f64, R, C> {
    #[inline]
    fn zeros(_: usize) -> Self {
        SMatrix::<f64, R, C>::zeros()
    }

    #[inline]
    fn slice(&self) -> &[f64] {
        self.as_slice()
    }

    #[inline]
    fn slice_mut(&mut self) -> &mut [f64] {
        self.as_mut_slice()
    }

    #[inline]
    fn reach(&mut self, _: usize) {}
}

impl List for Vec<f64> {
    fn zeros(count: usize) -> Self {
        vec![0.0; count]
    }

    fn slice(&self) -> &[f64] {
        self
    }

    fn slice_mut(&mut self) -> &mut [f64] {
        self
    }

    fn reach(&mut self, count: usize) {
        if self.len() < count {
            self.resize(count, 0.0);
        }
    }
}

/// Largest number of components kept in place: with their count they fill two cache lines, which are moved without a call. Longer lists are on the
/// heap.
const FEW: usize = 15;

/// A list of any length: up to [`FEW`] numbers in place with zeros behind them, more on the heap.
#[derive(Clone)]
#[allow(clippy::large_enum_variant)] // most lists are short
#[repr(u32)] // tag and length share one word, so the numbers behind them are copied by whole words
pub(crate) enum Short {
    Few(u32, [f64; FEW]),
    More(Vec<f64>),
}

impl List for Short {
    #[inline]
    fn zeros(count: usize) -> Self {
        match u32::try_from(count) {
            Ok(few) if count <= FEW => Self::Few(few, [0.0; FEW]),
            _ => Self::on_the_heap(count),
        }
    }

    #[inline]
    fn slice(&self) -> &[f64] {
        match self {
            Self::Few(len, few) => &few[..(*len as usize).min(FEW)],
            Self::More(more) => more,
        }
    }

    #[inline]
    fn slice_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Few(len, few) => &mut few[..(*len as usize).min(FEW)],
            Self::More(more) => more,
        }
    }

    #[inline]
    fn reach(&mut self, count: usize) {
        match (self, u32::try_from(count)) {
            (Self::Few(len, _), Ok(few)) if count <= FEW => *len = few.max(*len),
            (short, _) if short.slice().len() < count => short.move_out(count),
            _ => {}
        }
    }
}

impl Short {
    #[inline(never)]
    fn on_the_heap(count: usize) -> Self {
        Self::More(vec![0.0; count])
    }

    #[inline(never)]
    fn move_out(&mut self, count: usize) {
        let mut more = self.slice().to_vec();
        more.resize(count, 0.0);
        *self = Self::More(more);
    }
}

impl PartialEq for Short {
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (self.slice(), other.slice());
        let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
        let (same, more) = long.split_at(short.len());
        same == short && more.iter().all(|x| *x == 0.0)
    }
}

impl Debug for Short {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        self.slice().fmt(f)
    }
}
