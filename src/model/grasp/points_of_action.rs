//! Points of action of a load. Equilibrium depends on the line of a force alone. Its stability depends on the point, too: a weight that stands above
//! its support turns over, and one that hangs below it does not.
//!
//! For forces F at points r the sum `V = Σ F rᵀ` determines both the moment m and this stability. The antisymmetric part of V gives the moment m. Let
//! the body turn by the small rotation vector θ while the forces keep their directions. Their potential then changes by `-m·θ + ½ θ·Mθ` with
//! `M = (tr V) 1 - ½ (V + Vᵀ)`.

use core::ops::{Add, Mul};

use nalgebra::{SMatrix, SVector};

use super::wrench::Wrench;

/// The sum `V = Σ F rᵀ` of the forces F of a load and their points of action r, N m. `None` if the points are not known.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointsOfAction(Option<SMatrix<f64, 3, 3>>);

impl PointsOfAction {
    /// The sum V without forces. A pure moment has no point of action and adds nothing to V.
    pub(crate) const NO_FORCE: Self =
        Self(Some(SMatrix::from_array_storage(nalgebra::ArrayStorage([[0.0; 3]; 3]))));
    /// Unknown points of action: only the resultant and the moment of the forces are known.
    pub(crate) const UNKNOWN: Self = Self(None);

    /// The sum V for one force, N, at one point, m; in the plane the third components are zero.
    pub(crate) fn of<const C: usize>(force: &SVector<f64, C>, point: &SVector<f64, C>) -> Self {
        Self::NO_FORCE.moved(force, point)
    }

    /// The sum V after all points have moved by `shift`, m; `force` is the resultant of the forces, N.
    pub(crate) fn moved<const C: usize>(self, force: &SVector<f64, C>, shift: &SVector<f64, C>) -> Self {
        self.map(|mut sum| {
            for i in 0..C {
                for j in 0..C {
                    sum[(i, j)] += force[i] * shift[j];
                }
            }
            sum
        })
    }

    /// The sum V if forces and points are rotated by the matrix `rotation`.
    pub(crate) fn rotated<const C: usize>(self, rotation: &SMatrix<f64, C, C>) -> Self {
        let mut turn = SMatrix::<f64, 3, 3>::identity();
        turn.fixed_view_mut::<C, C>(0, 0).copy_from(rotation);
        self.map(|sum| turn * sum * turn.transpose())
    }

    /// The sum V after the body has turned by the matrix `rotation` about the origin, while the forces keep their directions.
    pub(crate) fn turned(self, rotation: &SMatrix<f64, 3, 3>) -> Self {
        self.map(|sum| sum * rotation.transpose())
    }

    /// The sum V if all forces are multiplied by `factor`.
    pub(crate) fn times(self, factor: f64) -> Self {
        // A load of zero has no forces, and V is zero, even if the points of action of the whole load are not known.
        if factor == 0.0 { Self::NO_FORCE } else { self.map(|sum| sum * factor) }
    }

    /// The sum V over the forces of both loads; unknown if it is unknown for either load.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self(self.0.zip(other.0).map(|(a, b)| a + b))
    }

    /// The matrix M of the second derivative of the load's potential with respect to rotations of the body, N m: `½ θ·Mθ` for the rotation vector θ;
    /// `None` if the points are not known.
    pub(crate) fn stiffness(self) -> Option<SMatrix<f64, 3, 3>> {
        self.0.map(|sum| SMatrix::identity() * sum.trace() - (sum + sum.transpose()) * 0.5)
    }

    #[inline]
    pub(crate) fn is_known(&self) -> bool {
        self.0.is_some()
    }

    /// The entry `Σ F_a r_b` of the sum V, N m; zero if the points are not known.
    #[inline]
    pub(crate) fn product(&self, a: usize, b: usize) -> f64 {
        self.0.map_or(0.0, |sum| sum[(a, b)])
    }

    fn map(self, change: impl FnOnce(SMatrix<f64, 3, 3>) -> SMatrix<f64, 3, 3>) -> Self {
        Self(self.0.map(change))
    }
}

impl<const C: usize> Wrench<C> {
    /// This wrench with these points of action.
    pub(crate) fn acting_at(self, points: PointsOfAction) -> Self {
        Self(self.0, points)
    }

    pub(crate) fn points_of_action(&self) -> PointsOfAction {
        self.1
    }
}

impl<const C: usize> PartialEq for Wrench<C> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<const C: usize> Add for Wrench<C> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1.plus(other.1))
    }
}

impl<const C: usize> Mul<f64> for Wrench<C> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor, self.1.times(factor))
    }
}
