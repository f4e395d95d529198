//! Sums and multiples of vectors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::list::List;
use super::size::Size;
use super::vector::Vector;

macro_rules! sums {
    ($trait:ident, $operate:ident, $assign:ident, $operate_assign:ident) => {
        impl<D: Size> $assign<&Vector<D>> for Vector<D> {
            #[inline]
            fn $operate_assign(&mut self, other: &Vector<D>) {
                let other = other.as_slice();
                self.0.reach(other.len());
                self.iter_mut().zip(other).for_each(|(x, y)| x.$operate_assign(y));
            }
        }

        impl<D: Size> $assign for Vector<D> {
            #[inline]
            fn $operate_assign(&mut self, other: Vector<D>) {
                self.$operate_assign(&other);
            }
        }

        impl<D: Size> $trait<&Vector<D>> for Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(mut self, other: &Vector<D>) -> Vector<D> {
                self.$operate_assign(other);
                self
            }
        }

        impl<D: Size> $trait for Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(mut self, other: Vector<D>) -> Vector<D> {
                self.$operate_assign(&other);
                self
            }
        }

        impl<D: Size> $trait<&Vector<D>> for &Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(self, other: &Vector<D>) -> Vector<D> {
                self.clone().$operate(other)
            }
        }

        impl<D: Size> $trait<Vector<D>> for &Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(self, other: Vector<D>) -> Vector<D> {
                self.clone().$operate(&other)
            }
        }
    };
}

sums!(Add, add, AddAssign, add_assign);
sums!(Sub, sub, SubAssign, sub_assign);

macro_rules! multiples {
    ($trait:ident, $operate:ident, $assign:ident, $operate_assign:ident) => {
        impl<D: Size> $assign<f64> for Vector<D> {
            #[inline]
            fn $operate_assign(&mut self, factor: f64) {
                self.iter_mut().for_each(|x| x.$operate_assign(factor));
            }
        }

        impl<D: Size> $trait<f64> for Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(mut self, factor: f64) -> Vector<D> {
                self.$operate_assign(factor);
                self
            }
        }

        impl<D: Size> $trait<f64> for &Vector<D> {
            type Output = Vector<D>;

            #[inline]
            fn $operate(self, factor: f64) -> Vector<D> {
                self.clone().$operate(factor)
            }
        }
    };
}

multiples!(Mul, mul, MulAssign, mul_assign);
multiples!(Div, div, DivAssign, div_assign);

impl<D: Size> Neg for Vector<D> {
    type Output = Vector<D>;

    #[inline]
    fn neg(mut self) -> Vector<D> {
        self.iter_mut().for_each(|x| *x = -*x);
        self
    }
}

impl<D: Size> Neg for &Vector<D> {
    type Output = Vector<D>;

    #[inline]
    fn neg(self) -> Vector<D> {
        -self.clone()
    }
}

impl<D: Size> Sum for Vector<D> {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::zeros(), |sum, v| sum + v)
    }
}
