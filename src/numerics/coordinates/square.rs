//! A square matrix over coordinates.

use core::ops::{Add, AddAssign, Index, IndexMut, Mul};

use nalgebra::SMatrix;

use super::list::List;
use super::size::{Fixed, Size};
use super::vector::Vector;

/// A square matrix over coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Square<D: Size> {
    entries: D::Square,
    size: D,
}

impl<D: Size> Default for Square<D> {
    /// The zero matrix; it has no coordinates if their number is known at run time only.
    fn default() -> Self {
        Self::zeros(D::default())
    }
}

impl<D: Size> Square<D> {
    #[inline]
    pub(crate) fn zeros(size: D) -> Self {
        Self { entries: D::Square::zeros(size.count() * size.count()), size }
    }

    pub(crate) fn from_diagonal(size: D, mut entry: impl FnMut(usize) -> f64) -> Self {
        let mut square = Self::zeros(size);
        for k in 0..size.count() {
            square[(k, k)] = entry(k);
        }
        square
    }

    #[inline]
    pub(crate) fn size(&self) -> D {
        self.size
    }

    #[inline]
    pub(crate) fn as_slice(&self) -> &[f64] {
        self.entries.slice()
    }

    #[inline]
    pub(crate) fn as_mut_slice(&mut self) -> &mut [f64] {
        self.entries.slice_mut()
    }

    #[inline]
    pub(crate) fn amax(&self) -> f64 {
        self.as_slice().iter().fold(0.0, |most: f64, x| if x.abs() > most { x.abs() } else { most })
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

    /// Sets all entries to zero and the size to this, in the same memory if the size is unchanged.
    pub(crate) fn clear(&mut self, size: D) {
        if self.size == size { self.fill(0.0) } else { *self = Self::zeros(size) }
    }

    /// Adds `a bᵀ`.
    #[inline]
    pub(crate) fn add_product(&mut self, a: &Vector<D>, b: &Vector<D>) {
        let n = self.size.count();
        for (column, b) in self.as_mut_slice().chunks_exact_mut(n.max(1)).zip(b.iter()) {
            column.iter_mut().zip(a.iter()).for_each(|(entry, a)| *entry += a * b);
        }
    }
}

impl<const D: usize> From<SMatrix<f64, D, D>> for Square<Fixed<D>> {
    fn from(entries: SMatrix<f64, D, D>) -> Self {
        Self { entries, size: Fixed }
    }
}

impl<D: Size> Square<D> {
    #[inline]
    pub(crate) fn from_columns(size: D, mut column: impl FnMut(usize) -> Vector<D>) -> Self {
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

impl<D: Size> Index<(usize, usize)> for Square<D> {
    type Output = f64;

    #[inline]
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.entries.slice()[j * self.size.count() + i]
    }
}

impl<D: Size> IndexMut<(usize, usize)> for Square<D> {
    #[inline]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        let n = self.size.count();
        &mut self.entries.slice_mut()[j * n + i]
    }
}

impl<D: Size> Mul<&Vector<D>> for &Square<D> {
    type Output = Vector<D>;

    #[inline]
    fn mul(self, v: &Vector<D>) -> Vector<D> {
        Vector(self.size.times(&self.entries, &v.0))
    }
}

impl<D: Size> Mul<&Square<D>> for &Square<D> {
    type Output = Square<D>;

    #[inline]
    fn mul(self, other: &Square<D>) -> Square<D> {
        Square { entries: self.size.product(&self.entries, &other.entries), size: self.size }
    }
}

impl<D: Size> AddAssign<&Square<D>> for Square<D> {
    #[inline]
    fn add_assign(&mut self, other: &Square<D>) {
        self.as_mut_slice().iter_mut().zip(other.as_slice()).for_each(|(x, y)| *x += y);
    }
}

impl<D: Size> Add<&Square<D>> for Square<D> {
    type Output = Square<D>;

    #[inline]
    fn add(mut self, other: &Square<D>) -> Square<D> {
        self += other;
        self
    }
}
