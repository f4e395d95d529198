//! A matrix from coordinates to a contact.

use core::ops::{Index, IndexMut, Mul};

use nalgebra::SVector;

use super::size::{Size, WHOLE};
use super::vector::Vector;
use crate::prelude::*;

/// A matrix from coordinates to C numbers of a contact.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Seen<const C: usize> {
    /// Column by column.
    entries: Columns<C>,
    size: Size,
}

/// Columns of C numbers: in place for one object, with zeros behind the last one.
#[derive(Debug, Clone, PartialEq)]
enum Columns<const C: usize> {
    Few([[f64; C]; WHOLE]),
    More(Vec<[f64; C]>),
}

impl<const C: usize> Seen<C> {
    #[inline]
    pub(crate) fn zeros(size: Size) -> Self {
        let count = size.count();
        let entries = if count <= WHOLE {
            Columns::Few([[0.0; C]; WHOLE])
        } else {
            Columns::More(vec![[0.0; C]; count])
        };
        Self { entries, size }
    }

    #[inline]
    pub(super) fn columns(&self) -> &[[f64; C]] {
        match &self.entries {
            Columns::Few(few) => &few[..self.size.count().min(WHOLE)],
            Columns::More(more) => more,
        }
    }

    #[inline]
    fn columns_mut(&mut self) -> &mut [[f64; C]] {
        match &mut self.entries {
            Columns::Few(few) => &mut few[..self.size.count().min(WHOLE)],
            Columns::More(more) => more,
        }
    }

    /// `Sᵀf`.
    #[inline]
    pub(crate) fn tr_mul(&self, f: &SVector<f64, C>) -> Vector {
        let columns = self.columns();
        Vector::from_fn(self.size, |k| (0..C).fold(0.0, |sum, a| sum + columns[k][a] * f[a]))
    }

    #[inline]
    pub(crate) fn norm_squared(&self) -> f64 {
        let mut sum = 0.0;
        for column in self.columns() {
            sum += column.iter().fold(0.0, |sum, x| sum + x * x);
        }
        sum
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        self.norm_squared().sqrt()
    }
}

impl<const C: usize> Index<(usize, usize)> for Seen<C> {
    type Output = f64;

    #[inline]
    fn index(&self, (a, k): (usize, usize)) -> &f64 {
        &self.columns()[k][a]
    }
}

impl<const C: usize> IndexMut<(usize, usize)> for Seen<C> {
    #[inline]
    fn index_mut(&mut self, (a, k): (usize, usize)) -> &mut f64 {
        &mut self.columns_mut()[k][a]
    }
}

impl<const C: usize> Mul<&Vector> for &Seen<C> {
    type Output = SVector<f64, C>;

    #[inline]
    fn mul(self, v: &Vector) -> SVector<f64, C> {
        let mut sum = SVector::zeros();
        for (column, v) in self.columns().iter().zip(v.iter()) {
            for a in 0..C {
                sum[a] += column[a] * v;
            }
        }
        sum
    }
}
