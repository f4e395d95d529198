//! A vector over coordinates. The coordinates of a grasp describe the motion of the object, of joints and of further bodies.

use crate::numerics::{add_times, amax, by_axis};
use core::ops::{Deref, Index, IndexMut};

use nalgebra::SVector;

use super::list::List;
use super::products::{dot, dot_whole, exactly};
use super::size::{Size, WHOLE};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A vector over the coordinates of a grasp: a motion, or a generalised force.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Vector(pub(super) List);

impl Default for Vector {
    #[inline]
    fn default() -> Self {
        Self(List::zeros(0))
    }
}

impl Vector {
    /// The zero vector, for any number of coordinates.
    #[inline]
    pub(crate) fn zeros() -> Self {
        Self::default()
    }

    #[inline]
    pub(crate) fn from_fn(size: Size, mut component: impl FnMut(usize) -> f64) -> Self {
        let mut v = Self::all_zero(size);
        for (k, x) in v.iter_mut().enumerate() {
            *x = component(k);
        }
        v
    }

    pub(crate) fn from_slice(components: &[f64]) -> Self {
        Self::from_fn(Size::of(components.len()), |k| components[k])
    }

    /// The zero vector with one stored component per coordinate; other zero vectors store none.
    #[inline]
    pub(crate) fn all_zero(size: Size) -> Self {
        Self(List::zeros(size.count()))
    }

    #[inline]
    pub(crate) fn unit(size: Size, along: usize) -> Self {
        Self::from_fn(size, |k| if k == along { 1.0 } else { 0.0 })
    }

    /// Extends the vector with zeros to one stored component per coordinate.
    #[inline]
    pub(crate) fn grow(&mut self, size: Size) {
        self.0.grow(size.count());
    }

    /// Adds another vector, multiplied by `times`, to this vector.
    #[inline]
    pub(crate) fn add_times(&mut self, other: &Self, times: f64) {
        let other = other.as_slice();
        self.0.grow(other.len());
        let to = self.0.slice_mut();
        // With exactly six coordinates the compiler knows the length of the loop.
        if let (Some(to), Some(other)) = (to.first_chunk_mut::<WHOLE>(), exactly::<WHOLE>(other)) {
            for k in 0..WHOLE {
                to[k] += other[k] * times;
            }
            return;
        }
        add_times(to, other, times);
    }

    /// The components as an array of six numbers, with zeros beyond the last component; `None` for more than six components.
    #[inline]
    pub(crate) fn array(&self) -> Option<&[f64; WHOLE]> {
        self.0.fixed()
    }

    /// The components as a mutable array of six numbers; `None` for more than six components. Numbers beyond the last component must stay zero.
    #[inline]
    pub(crate) fn array_mut(&mut self) -> Option<&mut [f64; WHOLE]> {
        self.0.fixed_mut()
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
        match (self.0.fixed::<WHOLE>(), other.0.fixed::<WHOLE>()) {
            (Some(a), Some(b)) => dot_whole(a, b),
            _ => dot(self.as_slice(), other.as_slice()),
        }
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

    #[inline]
    pub(crate) fn amax(&self) -> f64 {
        amax(self.as_slice())
    }

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
        let mut sum = 0.0;
        for x in self.as_slice() {
            sum += x;
        }
        sum
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

impl<const D: usize> From<SVector<f64, D>> for Vector {
    fn from(components: SVector<f64, D>) -> Self {
        Self::from_fn(Size::of(D), |k| components[k])
    }
}

impl Vector {
    pub(crate) fn to_svector<const D: usize>(&self) -> SVector<f64, D> {
        by_axis(|k| self[k])
    }
}

impl Deref for Vector {
    type Target = [f64];

    #[inline]
    fn deref(&self) -> &[f64] {
        self.as_slice()
    }
}

impl Index<usize> for Vector {
    type Output = f64;

    #[inline]
    fn index(&self, k: usize) -> &f64 {
        self.0.slice().get(k).unwrap_or(&0.0)
    }
}

impl IndexMut<usize> for Vector {
    #[inline]
    fn index_mut(&mut self, k: usize) -> &mut f64 {
        self.0.grow(k + 1);
        &mut self.0.slice_mut()[k]
    }
}
