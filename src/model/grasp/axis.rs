//! The axis that a small motion turns about.

use nalgebra::SVector;

use super::wrench::Twist;

/// A rotation: in the plane its angle from x to y, in space its rotation vector, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rotation<const C: usize> {
    Plane(f64),
    Space(SVector<f64, C>),
}

impl<const C: usize> Twist<C> {
    /// Translation of the origin, m, and rotation.
    pub(crate) fn parts(&self) -> (SVector<f64, C>, Rotation<C>) {
        let (along, turning) = self.components().split_at(C);
        let rotation = if C == 2 {
            Rotation::Plane(turning[0])
        } else {
            Rotation::Space(SVector::from_column_slice(turning))
        };
        (SVector::from_column_slice(along), rotation)
    }
}

impl<const C: usize> Rotation<C> {
    /// Absolute angle of the rotation, rad.
    pub(crate) fn size(&self) -> f64 {
        match self {
            Self::Plane(turn) => turn.abs(),
            Self::Space(omega) => omega.norm(),
        }
    }

    /// Unit vector of the axis; zero in the plane.
    pub(crate) fn axis(&self) -> SVector<f64, C> {
        match self {
            Self::Plane(_) => SVector::zeros(),
            Self::Space(omega) => omega.normalize(),
        }
    }

    /// Vector from a point with displacement u = `moves` to the nearest point of the axis: `ω × u / |ω|²`.
    pub(crate) fn way_to_axis(&self, moves: &SVector<f64, C>) -> SVector<f64, C> {
        match self {
            Self::Plane(turn) => {
                SVector::from_fn(|a, _| if a == 0 { -moves[1] / turn } else { moves[0] / turn })
            }
            Self::Space(omega) => {
                let cross = |a: usize| {
                    omega[(a + 1) % C] * moves[(a + 2) % C] - omega[(a + 2) % C] * moves[(a + 1) % C]
                };
                SVector::from_fn(|a, _| cross(a)) / omega.norm_squared()
            }
        }
    }

    /// Part of a point's displacement `moves` along the axis.
    pub(crate) fn along_axis(&self, moves: &SVector<f64, C>) -> SVector<f64, C> {
        let axis = self.axis();
        axis * axis.dot(moves)
    }
}
