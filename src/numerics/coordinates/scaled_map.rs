//! A matrix from coordinates to contact axes.

use core::ops::{Index, IndexMut, Mul};

use nalgebra::SVector;

use super::size::{Size, WHOLE};
use super::vector::Vector;
use crate::prelude::*;

/// A matrix S from coordinates to the axes of a contact, such as a transposed and scaled grasp map.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ScaledMap {
    /// Entries column by column.
    entries: Columns,
    size: Size,
}

/// Columns of three numbers: up to six in place, with zeros beyond the last column.
#[derive(Debug, Clone, PartialEq)]
enum Columns {
    Few([[f64; 3]; WHOLE]),
    More(Vec<[f64; 3]>),
}

impl ScaledMap {
    #[inline]
    pub(crate) fn zeros(size: Size) -> Self {
        let count = size.count();
        let entries = if count <= WHOLE {
            Columns::Few([[0.0; 3]; WHOLE])
        } else {
            Columns::More(vec![[0.0; 3]; count])
        };
        Self { entries, size }
    }

    #[inline]
    pub(super) fn columns(&self) -> &[[f64; 3]] {
        match &self.entries {
            Columns::Few(few) => &few[..self.size.count().min(WHOLE)],
            Columns::More(more) => more,
        }
    }

    #[inline]
    fn columns_mut(&mut self) -> &mut [[f64; 3]] {
        match &mut self.entries {
            Columns::Few(few) => &mut few[..self.size.count().min(WHOLE)],
            Columns::More(more) => more,
        }
    }

    /// The product `Sᵀf` of this matrix S, transposed, and a force.
    #[inline]
    pub(crate) fn tr_mul(&self, f: &SVector<f64, 3>) -> Vector {
        let columns = self.columns();
        Vector::from_fn(self.size, |k| (0..3).fold(0.0, |sum, a| sum + columns[k][a] * f[a]))
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

impl Index<(usize, usize)> for ScaledMap {
    type Output = f64;

    #[inline]
    fn index(&self, (a, k): (usize, usize)) -> &f64 {
        &self.columns()[k][a]
    }
}

impl IndexMut<(usize, usize)> for ScaledMap {
    #[inline]
    fn index_mut(&mut self, (a, k): (usize, usize)) -> &mut f64 {
        &mut self.columns_mut()[k][a]
    }
}

impl Mul<&Vector> for &ScaledMap {
    type Output = SVector<f64, 3>;

    #[inline]
    fn mul(self, v: &Vector) -> SVector<f64, 3> {
        let mut sum = SVector::zeros();
        for (column, v) in self.columns().iter().zip(v.iter()) {
            for a in 0..3 {
                sum[a] += column[a] * v;
            }
        }
        sum
    }
}
