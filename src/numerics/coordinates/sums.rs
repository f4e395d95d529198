//! Sums and multiples of vectors.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::products::exactly;
use super::size::WHOLE;
use super::vector::Vector;

macro_rules! sums {
    ($trait:ident, $operate:ident, $assign:ident, $operate_assign:ident) => {
        impl $assign<&Vector> for Vector {
            #[inline]
            fn $operate_assign(&mut self, other: &Vector) {
                let other = other.as_slice();
                self.0.grow(other.len());
                let to = self.0.slice_mut();
                // With exactly six coordinates the compiler knows the length of the loop.
                if let (Some(to), Some(other)) = (to.first_chunk_mut::<WHOLE>(), exactly::<WHOLE>(other)) {
                    for k in 0..WHOLE {
                        to[k].$operate_assign(other[k]);
                    }
                    return;
                }
                for (x, y) in to.iter_mut().zip(other) {
                    x.$operate_assign(y);
                }
            }
        }

        impl $assign for Vector {
            #[inline]
            fn $operate_assign(&mut self, other: Vector) {
                self.$operate_assign(&other);
            }
        }

        impl $trait<&Vector> for Vector {
            type Output = Vector;

            #[inline]
            fn $operate(mut self, other: &Vector) -> Vector {
                self.$operate_assign(other);
                self
            }
        }

        impl $trait for Vector {
            type Output = Vector;

            #[inline]
            fn $operate(mut self, other: Vector) -> Vector {
                self.$operate_assign(&other);
                self
            }
        }

        impl $trait<&Vector> for &Vector {
            type Output = Vector;

            #[inline]
            fn $operate(self, other: &Vector) -> Vector {
                self.clone().$operate(other)
            }
        }

        impl $trait<Vector> for &Vector {
            type Output = Vector;

            #[inline]
            fn $operate(self, other: Vector) -> Vector {
                self.clone().$operate(&other)
            }
        }
    };
}

sums!(Add, add, AddAssign, add_assign);
sums!(Sub, sub, SubAssign, sub_assign);

macro_rules! multiples {
    ($trait:ident, $operate:ident, $assign:ident, $operate_assign:ident) => {
        impl $assign<f64> for Vector {
            #[inline]
            fn $operate_assign(&mut self, factor: f64) {
                self.iter_mut().for_each(|x| x.$operate_assign(factor));
            }
        }

        impl $trait<f64> for Vector {
            type Output = Vector;

            #[inline]
            fn $operate(mut self, factor: f64) -> Vector {
                self.$operate_assign(factor);
                self
            }
        }

        impl $trait<f64> for &Vector {
            type Output = Vector;

            #[inline]
            fn $operate(self, factor: f64) -> Vector {
                self.clone().$operate(factor)
            }
        }
    };
}

multiples!(Mul, mul, MulAssign, mul_assign);
multiples!(Div, div, DivAssign, div_assign);

impl Neg for Vector {
    type Output = Vector;

    #[inline]
    fn neg(mut self) -> Vector {
        self.iter_mut().for_each(|x| *x = -*x);
        self
    }
}

impl Neg for &Vector {
    type Output = Vector;

    #[inline]
    fn neg(self) -> Vector {
        -self.clone()
    }
}

impl Sum for Vector {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::zeros(), |sum, v| sum + v)
    }
}
