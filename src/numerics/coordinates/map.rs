//! A matrix from a contact to coordinates.

use std::ops::{Index, IndexMut, Mul};

use nalgebra::{SMatrix, SVector};

use super::list::List;
use super::size::Size;
use super::vector::Vector;

/// A matrix from C numbers of a contact to coordinates: a grasp map.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Map<D: Size, const C: usize> {
    entries: D::Map<C>,
    size: D,
}

impl<D: Size, const C: usize> Map<D, C> {
    #[inline]
    pub(crate) fn zeros(size: D) -> Self {
        Self { entries: D::Map::<C>::zeros(size.count() * C), size }
    }

    #[inline]
    pub(crate) fn from_fn(size: D, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut map = Self::zeros(size);
        for a in 0..C {
            for k in 0..size.count() {
                map[(k, a)] = entry(k, a);
            }
        }
        map
    }

    #[inline]
    pub(crate) fn size(&self) -> D {
        self.size
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        // Column by column, as nalgebra sums.
        let squares = |a: usize| self.column(a).norm_squared();
        (0..C).fold(0.0, |sum, a| sum + squares(a)).sqrt()
    }

    #[inline]
    pub(crate) fn column(&self, a: usize) -> Vector<D> {
        let column = self.column_slice(a);
        Vector::from_fn(self.size, |k| column[k])
    }

    #[inline]
    pub(crate) fn column_slice(&self, a: usize) -> &[f64] {
        let n = self.size.count();
        &self.entries.slice()[a * n..(a + 1) * n]
    }

    #[inline]
    pub(crate) fn row(&self, k: usize) -> SVector<f64, C> {
        SVector::from_fn(|a, _| self[(k, a)])
    }

    #[inline]
    pub(crate) fn set_column(&mut self, a: usize, column: &Vector<D>) {
        for k in 0..self.size.count() {
            self[(k, a)] = column[k];
        }
    }

    pub(crate) fn set_row(&mut self, k: usize, row: &SVector<f64, C>) {
        for a in 0..C {
            self[(k, a)] = row[a];
        }
    }

    /// `G K`, column by column, as nalgebra sums.
    #[inline]
    pub(crate) fn times(&self, by: &SMatrix<f64, C, C>) -> Self {
        Self::from_fn(self.size, |k, b| {
            (1..C).fold(self[(k, 0)] * by[(0, b)], |sum, a| sum + self[(k, a)] * by[(a, b)])
        })
    }

    /// `Gᵀv`.
    #[inline]
    pub(crate) fn tr_mul(&self, v: &Vector<D>) -> SVector<f64, C> {
        self.size.felt(&self.entries, &v.0)
    }
}

impl<D: Size, const C: usize> Index<(usize, usize)> for Map<D, C> {
    type Output = f64;

    #[inline]
    fn index(&self, (k, a): (usize, usize)) -> &f64 {
        &self.entries.slice()[a * self.size.count() + k]
    }
}

impl<D: Size, const C: usize> IndexMut<(usize, usize)> for Map<D, C> {
    #[inline]
    fn index_mut(&mut self, (k, a): (usize, usize)) -> &mut f64 {
        let n = self.size.count();
        &mut self.entries.slice_mut()[a * n + k]
    }
}

impl<D: Size, const C: usize> Mul<&SVector<f64, C>> for &Map<D, C> {
    type Output = Vector<D>;

    #[inline]
    fn mul(self, f: &SVector<f64, C>) -> Vector<D> {
        Vector(self.size.mapped(&self.entries, f))
    }
}

impl<D: Size, const C: usize> Mul<SVector<f64, C>> for &Map<D, C> {
    type Output = Vector<D>;

    #[inline]
    fn mul(self, f: SVector<f64, C>) -> Vector<D> {
        Vector(self.size.mapped(&self.entries, &f))
    }
}
