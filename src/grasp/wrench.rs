//! Wrenches and twists: what pulls on the object, and how it moves.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::{ArrayStorage, Matrix, SVector};

use super::rotation::{displacement_of, wrench_of};

/// A load on the object: forces first, then moments about the origin of the coordinates, `d` components.
///
/// Unit N for forces and N m for moments, whatever consistent units the contacts use. Positive moments turn from x to
/// y in the plane and follow the right-hand rule in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench<const D: usize>(SVector<f64, D>);

/// A small motion of the object: translation of the origin of the coordinates, then rotation, `d` components.
///
/// The displacement of the body at a point r is, to first order (equation 4.1 of the paper without its quadratic
/// term), `translation + rotation × r`; see [`Twist::displacement_at`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist<const D: usize>(SVector<f64, D>);

macro_rules! vector_like {
    ($name:ident) => {
        impl<const D: usize> $name<D> {
            /// All components zero.
            pub const ZERO: Self = Self(Matrix::from_array_storage(ArrayStorage([[0.0; D]])));

            /// From its `d` components: linear ones first, then angular ones.
            #[must_use]
            pub fn from_vector(components: impl Into<SVector<f64, D>>) -> Self {
                Self(components.into())
            }

            /// Its `d` components: linear ones first, then angular ones.
            #[must_use]
            pub fn as_vector(&self) -> &SVector<f64, D> {
                &self.0
            }
        }

        impl<const D: usize> Add for $name<D> {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl<const D: usize> Sub for $name<D> {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl<const D: usize> Neg for $name<D> {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl<const D: usize> Mul<f64> for $name<D> {
            type Output = Self;
            fn mul(self, factor: f64) -> Self {
                Self(self.0 * factor)
            }
        }

        impl<const D: usize> Mul<$name<D>> for f64 {
            type Output = $name<D>;
            fn mul(self, other: $name<D>) -> $name<D> {
                $name(other.0 * self)
            }
        }
    };
}

vector_like!(Wrench);
vector_like!(Twist);

impl Wrench<3> {
    /// A force (x, y) through the origin and a moment about it.
    #[must_use]
    pub fn new(force: [f64; 2], moment: f64) -> Self {
        Self(SVector::from([force[0], force[1], moment]))
    }

    /// A force through the origin, no moment.
    #[must_use]
    pub fn force(force: [f64; 2]) -> Self {
        Self::new(force, 0.0)
    }

    /// A force through `point`: its moment about the origin is `x f_y - y f_x`.
    #[must_use]
    pub fn force_at(force: [f64; 2], point: [f64; 2]) -> Self {
        Self(wrench_of(&point.into(), &force.into()))
    }
}

impl Wrench<6> {
    /// A force through the origin and a moment about it.
    #[must_use]
    pub fn new(force: [f64; 3], moment: [f64; 3]) -> Self {
        Self(SVector::from([force[0], force[1], force[2], moment[0], moment[1], moment[2]]))
    }

    /// A force through the origin, no moment.
    #[must_use]
    pub fn force(force: [f64; 3]) -> Self {
        Self::new(force, [0.0; 3])
    }

    /// A force through `point`: its moment about the origin is `point × force`.
    #[must_use]
    pub fn force_at(force: [f64; 3], point: [f64; 3]) -> Self {
        Self(wrench_of(&point.into(), &force.into()))
    }
}

impl Twist<3> {
    /// Translation of the object's point at the origin, m.
    #[must_use]
    pub fn translation(&self) -> [f64; 2] {
        [self.0[0], self.0[1]]
    }

    /// Rotation from x towards y, rad.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.0[2]
    }

    /// Displacement of the object's point `point`, to first order: `(dx - θ y, dy + θ x)`.
    #[must_use]
    pub fn displacement_at(&self, point: [f64; 2]) -> [f64; 2] {
        displacement_of(&point.into(), &self.0).into()
    }
}

impl Twist<6> {
    /// Translation of the object's point at the origin, m.
    #[must_use]
    pub fn translation(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// Rotation vector, rad.
    #[must_use]
    pub fn rotation(&self) -> [f64; 3] {
        [self.0[3], self.0[4], self.0[5]]
    }

    /// Displacement of the object's point `point`, to first order: `translation + rotation × point`.
    #[must_use]
    pub fn displacement_at(&self, point: [f64; 3]) -> [f64; 3] {
        displacement_of(&point.into(), &self.0).into()
    }
}
