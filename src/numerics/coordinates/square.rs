//! A square matrix over coordinates. The coordinates of a grasp describe the motion of the object, of joints and of further bodies.

use crate::numerics::{add_times, amax};
use core::ops::{Add, AddAssign, Index, IndexMut, Mul};

use nalgebra::SMatrix;

use super::list::List;
use super::products::{add_combined, add_fixed};
use super::size::{Size, WHOLE};
use super::vector::Vector;
use crate::prelude::*;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Square {
    entries: Entries,
    size: Size,
}

/// Entries of a square matrix, column by column. The entries of up to six columns are stored in place, with zeros after the last entry.
#[derive(Debug, Clone, PartialEq)]
enum Entries {
    Few([f64; WHOLE * WHOLE]),
    More(Vec<f64>),
}

impl Entries {
    #[inline]
    fn zeros(count: usize) -> Self {
        if count <= WHOLE { Self::Few([0.0; WHOLE * WHOLE]) } else { Self::More(vec![0.0; count * count]) }
    }
}

/// Adds the product of a square matrix and the vector `times` to `sum`. If both vectors have N components, the compiler knows the length of the
/// loops. Otherwise the length is known only at run time.
#[inline]
fn fixed_product<const N: usize>(entries: &[f64], times: &List, sum: &mut List) {
    match (times.fixed::<N>(), sum.fixed_mut::<N>()) {
        (Some(times), Some(sum)) => add_fixed(entries, times, sum),
        (_, _) => add_combined(entries, times.slice(), sum.slice_mut()),
    }
}

impl Default for Square {
    /// The matrix without rows and columns.
    fn default() -> Self {
        Self::zeros(Size::default())
    }
}

impl Square {
    #[inline]
    pub(crate) fn zeros(size: Size) -> Self {
        Self { entries: Entries::zeros(size.count()), size }
    }

    #[inline]
    pub(crate) fn size(&self) -> Size {
        self.size
    }

    #[inline]
    pub(crate) fn as_slice(&self) -> &[f64] {
        match &self.entries {
            Entries::Few(few) => &few[..(self.size.count() * self.size.count()).min(WHOLE * WHOLE)],
            Entries::More(more) => more,
        }
    }

    #[inline]
    pub(crate) fn as_mut_slice(&mut self) -> &mut [f64] {
        match &mut self.entries {
            Entries::Few(few) => &mut few[..(self.size.count() * self.size.count()).min(WHOLE * WHOLE)],
            Entries::More(more) => more,
        }
    }

    #[inline]
    pub(crate) fn amax(&self) -> f64 {
        amax(self.as_slice())
    }

    pub(crate) fn fill(&mut self, entry: f64) {
        self.as_mut_slice().fill(entry);
    }

    #[inline]
    pub(crate) fn swap_columns(&mut self, a: usize, b: usize) {
        let n = self.size.count();
        for k in 0..n {
            self.as_mut_slice().swap(a * n + k, b * n + k);
        }
    }

    #[inline]
    pub(crate) fn swap_rows(&mut self, a: usize, b: usize) {
        let n = self.size.count();
        for k in 0..n {
            self.as_mut_slice().swap(k * n + a, k * n + b);
        }
    }

    pub(crate) fn transpose(&self) -> Self {
        let mut transposed = Self::zeros(self.size);
        for i in 0..self.size.count() {
            for j in 0..self.size.count() {
                transposed[(j, i)] = self[(i, j)];
            }
        }
        transposed
    }

    #[inline]
    pub(crate) fn column_slice(&self, j: usize) -> &[f64] {
        let n = self.size.count();
        &self.as_slice()[j * n..(j + 1) * n]
    }

    #[inline]
    pub(crate) fn column_slice_mut(&mut self, j: usize) -> &mut [f64] {
        let n = self.size.count();
        &mut self.as_mut_slice()[j * n..(j + 1) * n]
    }

    /// Adds the dyad `a bᵀ` of two vectors to this matrix.
    #[inline]
    pub(crate) fn add_product(&mut self, a: &[f64], b: &[f64]) {
        let n = self.size.count();
        for (column, b) in self.as_mut_slice().chunks_exact_mut(n.max(1)).zip(b) {
            add_times(column, a, *b);
        }
    }
}

impl<const D: usize> From<SMatrix<f64, D, D>> for Square {
    fn from(entries: SMatrix<f64, D, D>) -> Self {
        let mut square = Self::zeros(Size::of(D));
        square.as_mut_slice().copy_from_slice(entries.as_slice());
        square
    }
}

impl Square {
    #[inline]
    pub(crate) fn from_columns(size: Size, mut column: impl FnMut(usize) -> Vector) -> Self {
        let mut square = Self::zeros(size);
        for j in 0..size.count() {
            let column = column(j);
            for i in 0..size.count() {
                square[(i, j)] = column[i];
            }
        }
        square
    }
}

impl Index<(usize, usize)> for Square {
    type Output = f64;

    #[inline]
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.as_slice()[j * self.size.count() + i]
    }
}

impl IndexMut<(usize, usize)> for Square {
    #[inline]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        let n = self.size.count();
        &mut self.as_mut_slice()[j * n + i]
    }
}

impl Mul<&Vector> for &Square {
    type Output = Vector;

    #[inline]
    fn mul(self, v: &Vector) -> Vector {
        let mut product = Vector::all_zero(self.size);
        let (entries, times, sum) = (self.as_slice(), &v.0, &mut product.0);
        match self.size.count() {
            3 => fixed_product::<3>(entries, times, sum),
            WHOLE => fixed_product::<WHOLE>(entries, times, sum),
            _ => add_combined(entries, times.slice(), sum.slice_mut()),
        }
        product
    }
}

impl Mul<&Square> for &Square {
    type Output = Square;

    #[inline]
    fn mul(self, other: &Square) -> Square {
        let (n, mut product) = (self.size.count(), Square::zeros(self.size));
        let columns = other.as_slice().chunks_exact(n.max(1));
        for (column, sum) in columns.zip(product.as_mut_slice().chunks_exact_mut(n.max(1))) {
            add_combined(self.as_slice(), column, sum);
        }
        product
    }
}

impl AddAssign<&Square> for Square {
    #[inline]
    fn add_assign(&mut self, other: &Square) {
        add_times(self.as_mut_slice(), other.as_slice(), 1.0);
    }
}

impl Add<&Square> for Square {
    type Output = Square;

    #[inline]
    fn add(mut self, other: &Square) -> Square {
        self += other;
        self
    }
}
