//! A matrix from coordinates to a contact.

use core::ops::{Index, IndexMut, Mul};

use nalgebra::SVector;

use super::list::List;
use super::size::Size;
use super::vector::Vector;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A matrix from coordinates to C numbers of a contact.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Seen<D: Size, const C: usize> {
    entries: D::Seen<C>,
    size: D,
}

impl<D: Size, const C: usize> Seen<D, C> {
    #[inline]
    pub(crate) fn zeros(size: D) -> Self {
        Self { entries: D::Seen::<C>::zeros(size.count() * C), size }
    }

    #[inline]
    pub(crate) fn size(&self) -> D {
        self.size
    }

    /// The column of coordinate k.
    #[inline]
    pub(crate) fn column(&self, k: usize) -> SVector<f64, C> {
        SVector::from_fn(|a, _| self[(a, k)])
    }

    /// `Sᵀf`.
    #[inline]
    pub(crate) fn tr_mul(&self, f: &SVector<f64, C>) -> Vector<D> {
        Vector(self.size.seen_back(&self.entries, f))
    }

    #[inline]
    pub(crate) fn norm_squared(&self) -> f64 {
        // Column by column, as nalgebra sums.
        let column =
            |k: usize| SVector::<f64, C>::from_column_slice(&self.entries.slice()[k * C..(k + 1) * C]);
        (0..self.size.count()).fold(0.0, |sum, k| sum + column(k).norm_squared())
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        self.norm_squared().sqrt()
    }
}

impl<D: Size, const C: usize> Index<(usize, usize)> for Seen<D, C> {
    type Output = f64;

    #[inline]
    fn index(&self, (a, k): (usize, usize)) -> &f64 {
        &self.entries.slice()[k * C + a]
    }
}

impl<D: Size, const C: usize> IndexMut<(usize, usize)> for Seen<D, C> {
    #[inline]
    fn index_mut(&mut self, (a, k): (usize, usize)) -> &mut f64 {
        &mut self.entries.slice_mut()[k * C + a]
    }
}

impl<D: Size, const C: usize> Mul<&Vector<D>> for &Seen<D, C> {
    type Output = SVector<f64, C>;

    #[inline]
    fn mul(self, v: &Vector<D>) -> SVector<f64, C> {
        self.size.seen(&self.entries, &v.0)
    }
}
