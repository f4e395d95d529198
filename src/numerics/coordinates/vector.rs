//! A vector over coordinates.

use core::ops::{Index, IndexMut};

use nalgebra::SVector;

use super::list::List;
use super::size::{Fixed, Size};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A vector over coordinates: a motion, or a wrench.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Vector<D: Size>(pub(super) D::List);

impl<D: Size> Default for Vector<D> {
    #[inline]
    fn default() -> Self {
        Self(D::List::zeros(0))
    }
}

impl<D: Size> Vector<D> {
    /// The zero vector of any number of coordinates.
    #[inline]
    pub(crate) fn zeros() -> Self {
        Self::default()
    }

    #[inline]
    pub(crate) fn from_fn(size: D, mut component: impl FnMut(usize) -> f64) -> Self {
        let mut v = Self::all_zero(size);
        for (k, x) in v.iter_mut().enumerate() {
            *x = component(k);
        }
        v
    }

    /// The zero vector with a component for every coordinate.
    #[inline]
    pub(crate) fn all_zero(size: D) -> Self {
        Self(D::List::zeros(size.count()))
    }

    /// The unit vector along a coordinate.
    #[inline]
    pub(crate) fn unit(size: D, along: usize) -> Self {
        Self::from_fn(size, |k| if k == along { 1.0 } else { 0.0 })
    }

    /// Extends the vector with zeros to a component for every coordinate.
    #[inline]
    pub(crate) fn reach(&mut self, size: D) {
        self.0.reach(size.count());
    }

    /// Adds `times` another vector.
    #[inline]
    pub(crate) fn add_times(&mut self, other: &Self, times: f64) {
        let other = other.as_slice();
        self.0.reach(other.len());
        self.iter_mut().zip(other).for_each(|(x, y)| *x += y * times);
    }

    #[inline]
    pub(crate) fn as_slice(&self) -> &[f64] {
        self.0.slice()
    }

    #[inline]
    pub(crate) fn as_mut_slice(&mut self) -> &mut [f64] {
        self.0.slice_mut()
    }

    #[inline]
    pub(crate) fn iter(&self) -> core::slice::Iter<'_, f64> {
        self.0.slice().iter()
    }

    #[inline]
    pub(crate) fn iter_mut(&mut self) -> core::slice::IterMut<'_, f64> {
        self.0.slice_mut().iter_mut()
    }

    #[inline]
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        D::dot(&self.0, &other.0)
    }

    #[inline]
    pub(crate) fn norm_squared(&self) -> f64 {
        self.dot(self)
    }

    #[inline]
    pub(crate) fn norm(&self) -> f64 {
        self.norm_squared().sqrt()
    }

    #[inline]
    pub(crate) fn normalize(&self) -> Self {
        self / self.norm()
    }

    /// The largest size of a component.
    #[inline]
    pub(crate) fn amax(&self) -> f64 {
        self.iter().fold(0.0, |most: f64, x| if x.abs() > most { x.abs() } else { most })
    }

    /// The index of the component of largest size.
    pub(crate) fn iamax(&self) -> usize {
        let mut most = 0;
        for (k, x) in self.iter().enumerate() {
            if x.abs() > self[most].abs() {
                most = k;
            }
        }
        most
    }

    #[inline]
    pub(crate) fn sum(&self) -> f64 {
        self.iter().fold(0.0, |sum, x| sum + x)
    }

    #[inline]
    pub(crate) fn map(&self, mut by: impl FnMut(f64) -> f64) -> Self {
        let mut mapped = self.clone();
        mapped.iter_mut().for_each(|x| *x = by(*x));
        mapped
    }

    #[inline]
    pub(crate) fn component_mul(&self, other: &Self) -> Self {
        let mut product = self.clone();
        product.component_mul_assign(other);
        product
    }

    #[inline]
    pub(crate) fn component_mul_assign(&mut self, other: &Self) {
        self.iter_mut().enumerate().for_each(|(k, x)| *x *= other[k]);
    }

    #[inline]
    pub(crate) fn component_div_assign(&mut self, other: &Self) {
        self.iter_mut().enumerate().for_each(|(k, x)| *x /= other[k]);
    }
}

impl<const D: usize> From<SVector<f64, D>> for Vector<Fixed<D>> {
    fn from(components: SVector<f64, D>) -> Self {
        Self(components)
    }
}

impl<const D: usize> Vector<Fixed<D>> {
    pub(crate) fn to_svector(&self) -> SVector<f64, D> {
        self.0
    }
}

impl<D: Size> Index<usize> for Vector<D> {
    type Output = f64;

    #[inline]
    fn index(&self, k: usize) -> &f64 {
        self.0.slice().get(k).unwrap_or(&0.0)
    }
}

impl<D: Size> IndexMut<usize> for Vector<D> {
    #[inline]
    fn index_mut(&mut self, k: usize) -> &mut f64 {
        self.0.reach(k + 1);
        &mut self.0.slice_mut()[k]
    }
}
