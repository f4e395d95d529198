//! A matrix from a contact to coordinates.

use core::ops::{Index, IndexMut, Mul, Range};

use nalgebra::{SMatrix, SVector};

use super::map_entries::MapEntries;
use super::size::Size;
use super::vector::Vector;
use crate::prelude::*;

/// A matrix from C numbers of a contact to coordinates: a grasp map.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Map<D: Size, const C: usize> {
    entries: D::Map<C>,
    size: D,
}

impl<D: Size, const C: usize> Map<D, C> {
    #[inline]
    pub(crate) fn zeros(size: D) -> Self {
        Self { entries: D::Map::<C>::zeros(), size }
    }

    #[inline]
    pub(crate) fn from_fn(size: D, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut map = Self::zeros(size);
        for a in 0..C {
            for k in 0..size.count() {
                map.entries.set(k, a, entry(k, a));
            }
        }
        map
    }

    #[inline]
    pub(crate) fn size(&self) -> D {
        self.size
    }

    /// The rows that may have entries, in order; all others are zero.
    pub(crate) fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.entries.rows()
    }

    /// Drops rows outside of these ranges; they must have no entries.
    pub(crate) fn keep(&mut self, ranges: &[Range<usize>; 2]) {
        self.entries.keep(ranges);
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        // Column by column, as nalgebra sums.
        let squares = |a: usize| self.size.column_square::<C>(&self.entries, a);
        (0..C).fold(0.0, |sum, a| sum + squares(a)).sqrt()
    }

    #[inline]
    pub(crate) fn column(&self, a: usize) -> Vector<D> {
        let mut column = Vector::all_zero(self.size);
        for k in self.rows() {
            column[k] = self[(k, a)];
        }
        column
    }

    /// The entries of a column in one of the ranges given to [`Self::keep`].
    #[inline]
    pub(crate) fn column_within(&self, a: usize, range: Range<usize>) -> &[f64] {
        self.entries.column(a, range)
    }

    #[inline]
    pub(crate) fn row(&self, k: usize) -> SVector<f64, C> {
        SVector::from_fn(|a, _| self[(k, a)])
    }

    #[inline]
    pub(crate) fn set_column(&mut self, a: usize, column: &Vector<D>) {
        let given = column.as_slice().len();
        column.iter().enumerate().for_each(|(k, x)| self.entries.set(k, a, *x));
        // Components behind the end of a list are zero.
        let behind: Vec<usize> = self.rows().filter(|k| *k >= given).collect();
        for k in behind {
            self.entries.set(k, a, 0.0);
        }
    }

    pub(crate) fn set_row(&mut self, k: usize, row: &SVector<f64, C>) {
        for a in 0..C {
            self.entries.set(k, a, row[a]);
        }
    }

    /// `G K`, column by column, as nalgebra sums.
    #[inline]
    pub(crate) fn times(&self, by: &SMatrix<f64, C, C>) -> Self {
        let mut product = Self::zeros(self.size);
        for k in self.rows() {
            for b in 0..C {
                let entry = (1..C).fold(self[(k, 0)] * by[(0, b)], |sum, a| sum + self[(k, a)] * by[(a, b)]);
                product.entries.set(k, b, entry);
            }
        }
        product
    }

    /// `Gᵀv`.
    #[inline]
    pub(crate) fn tr_mul(&self, v: &Vector<D>) -> SVector<f64, C> {
        self.size.felt(&self.entries, &v.0)
    }

    /// Adds `G f` to a vector.
    #[inline]
    pub(crate) fn push(&self, f: &SVector<f64, C>, to: &mut Vector<D>) {
        self.size.add_mapped(&self.entries, f, &mut to.0);
    }

    /// `|G f|`.
    #[inline]
    pub(crate) fn pushed_norm(&self, f: &SVector<f64, C>) -> f64 {
        self.size.mapped_square(&self.entries, f).sqrt()
    }
}

impl<D: Size, const C: usize> Index<(usize, usize)> for Map<D, C> {
    type Output = f64;

    #[inline]
    fn index(&self, (k, a): (usize, usize)) -> &f64 {
        self.entries.entry(k, a)
    }
}

impl<D: Size, const C: usize> IndexMut<(usize, usize)> for Map<D, C> {
    #[inline]
    fn index_mut(&mut self, (k, a): (usize, usize)) -> &mut f64 {
        self.entries.entry_mut(k, a)
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
