//! A matrix that maps vectors along the axes of a contact to vectors over the coordinates of a grasp. The coordinates of a grasp describe the motion
//! of the object, of joints and of further bodies.

use crate::numerics::by_axis;
use core::ops::{Index, IndexMut, Mul, Range};

use nalgebra::{SMatrix, SVector};

use super::map_entries::MapEntries;
use super::size::{Size, WHOLE};
use super::vector::Vector;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A matrix from the three axes of a contact to coordinates, such as a grasp map G.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Map {
    entries: MapEntries,
    size: Size,
}

impl Map {
    #[inline]
    pub(crate) fn zeros(size: Size) -> Self {
        Self { entries: MapEntries::zeros(size), size }
    }

    #[inline]
    pub(crate) fn from_fn(size: Size, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut map = Self::zeros(size);
        for a in 0..3 {
            for k in 0..size.count() {
                map.entries.set(k, a, entry(k, a));
            }
        }
        map
    }

    #[inline]
    pub(crate) fn size(&self) -> Size {
        self.size
    }

    /// The indices of the stored rows, in order; all other rows are zero.
    pub(crate) fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.entries.row_count(self.size)).map(|position| self.entries.row(position))
    }

    /// Stores only the rows of these ranges; all other rows must be zero.
    pub(crate) fn keep_rows(&mut self, ranges: &[Range<usize>; 2]) {
        self.entries.keep_rows(ranges);
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        (0..3).fold(0.0, |sum, a| sum + self.entries.column_square(a, self.size)).sqrt()
    }

    #[inline]
    pub(crate) fn column(&self, a: usize) -> Vector {
        let mut column = Vector::all_zero(self.size);
        for k in self.rows() {
            column[k] = self[(k, a)];
        }
        column
    }

    /// A column as an array of six numbers, with zeros beyond the last coordinate; `None` for more than six coordinates.
    #[inline]
    pub(crate) fn whole_column(&self, a: usize) -> Option<&[f64; WHOLE]> {
        match &self.entries {
            MapEntries::Whole(columns) => Some(&columns[a]),
            MapEntries::Few(_) => None,
        }
    }

    /// All three columns as arrays of six numbers, with zeros beyond the last coordinate; `None` for more than six coordinates.
    #[inline]
    pub(crate) fn whole_columns(&self) -> Option<&[[f64; WHOLE]; 3]> {
        match &self.entries {
            MapEntries::Whole(columns) => Some(columns),
            MapEntries::Few(_) => None,
        }
    }

    /// The entries of a column in one of the ranges given to [`Self::keep_rows`].
    #[inline]
    pub(crate) fn column_within(&self, a: usize, range: Range<usize>) -> &[f64] {
        self.entries.column(a, range)
    }

    #[inline]
    pub(crate) fn row(&self, k: usize) -> SVector<f64, 3> {
        by_axis(|a| self[(k, a)])
    }

    #[inline]
    pub(crate) fn set_column(&mut self, a: usize, column: &[f64]) {
        for (k, x) in column.iter().enumerate() {
            self.entries.set(k, a, *x);
        }
        // Components beyond the end of `column` are zero.
        for position in 0..self.entries.row_count(self.size) {
            let k = self.entries.row(position);
            if k >= column.len() {
                self.entries.set(k, a, 0.0);
            }
        }
    }

    pub(crate) fn set_row(&mut self, k: usize, row: &SVector<f64, 3>) {
        for a in 0..3 {
            self.entries.set(k, a, row[a]);
        }
    }

    /// The product `G K` of this map G and the matrix K in `by`. Terms are added column by column as in nalgebra, so that the result equals
    /// nalgebra's bit for bit.
    #[inline]
    pub(crate) fn times(&self, by: &SMatrix<f64, 3, 3>) -> Self {
        let mut product = Self::zeros(self.size);
        for k in self.rows() {
            for b in 0..3 {
                let entry = (1..3).fold(self[(k, 0)] * by[(0, b)], |sum, a| sum + self[(k, a)] * by[(a, b)]);
                product.entries.set(k, b, entry);
            }
        }
        product
    }

    /// The product `Gᵀv` of this map G, transposed, and a vector v over the coordinates.
    #[inline]
    pub(crate) fn tr_mul(&self, v: &Vector) -> SVector<f64, 3> {
        self.entries.tr_mul(self.size, &v.0)
    }

    /// Adds the product `G f` of this map G and a contact force f to a vector.
    #[inline]
    pub(crate) fn push(&self, f: &SVector<f64, 3>, to: &mut Vector) {
        to.grow(self.size);
        self.entries.add_mapped(f, &mut to.0);
    }

    /// The norm `|G f|` of the product of this map G and a contact force f.
    #[inline]
    pub(crate) fn pushed_norm(&self, f: &SVector<f64, 3>) -> f64 {
        self.entries.mapped_square(self.size, f).sqrt()
    }
}

impl Index<(usize, usize)> for Map {
    type Output = f64;

    #[inline]
    fn index(&self, (k, a): (usize, usize)) -> &f64 {
        self.entries.entry(k, a)
    }
}

impl IndexMut<(usize, usize)> for Map {
    #[inline]
    fn index_mut(&mut self, (k, a): (usize, usize)) -> &mut f64 {
        self.entries.entry_mut(k, a)
    }
}

impl Mul<&SVector<f64, 3>> for &Map {
    type Output = Vector;

    #[inline]
    fn mul(self, f: &SVector<f64, 3>) -> Vector {
        let mut sum = Vector::all_zero(self.size);
        self.entries.add_mapped(f, &mut sum.0);
        sum
    }
}

impl Mul<SVector<f64, 3>> for &Map {
    type Output = Vector;

    #[inline]
    fn mul(self, f: SVector<f64, 3>) -> Vector {
        Mul::mul(self, &f)
    }
}
