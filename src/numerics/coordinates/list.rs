//! Numbers in a row, in place or on the heap.

use std::fmt::{Debug, Formatter};

use nalgebra::SMatrix;

/// Numbers in a row.
pub(crate) trait List: Clone + Debug + PartialEq + Send + Sync {
    fn zeros(count: usize) -> Self;
    fn slice(&self) -> &[f64];
    fn slice_mut(&mut self) -> &mut [f64];
    /// At least so many, zeros behind those that there are.
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

/// More components than these are asked for from the allocator.
const FEW: usize = 24;

/// A list of its own length: a few numbers in place, more on the heap.
#[derive(Clone)]
pub(crate) struct Short {
    len: usize,
    few: [f64; FEW],
    more: Vec<f64>,
}

impl List for Short {
    #[inline]
    fn zeros(count: usize) -> Self {
        let more = if count > FEW { vec![0.0; count] } else { Vec::new() };
        Self { len: count, few: [0.0; FEW], more }
    }

    #[inline]
    fn slice(&self) -> &[f64] {
        if self.len > FEW { &self.more } else { &self.few[..self.len] }
    }

    #[inline]
    fn slice_mut(&mut self) -> &mut [f64] {
        if self.len > FEW { &mut self.more } else { &mut self.few[..self.len] }
    }

    #[inline]
    fn reach(&mut self, count: usize) {
        if self.len >= count {
            return;
        }
        if count > FEW {
            if self.len <= FEW {
                self.more.clear();
                self.more.extend_from_slice(&self.few[..self.len]);
            }
            self.more.resize(count, 0.0);
        } else {
            self.few[self.len..count].fill(0.0);
        }
        self.len = count;
    }
}

impl PartialEq for Short {
    fn eq(&self, other: &Self) -> bool {
        let (short, long) =
            if self.len <= other.len { (self.slice(), other.slice()) } else { (other.slice(), self.slice()) };
        let (same, more) = long.split_at(short.len());
        same == short && more.iter().all(|x| *x == 0.0)
    }
}

impl Debug for Short {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        self.slice().fmt(f)
    }
}
