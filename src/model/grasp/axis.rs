//! The axis of rotation of a small motion.

use nalgebra::SVector;

use super::wrench::Twist;
use crate::numerics::{Space, by_axis};

/// A small rotation: in the plane its angle from x to y, in space its rotation vector, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rotation {
    Plane(f64),
    Space(SVector<f64, 3>),
}

impl Twist<3> {
    /// The two parts of a twist in space: the translation of the body's point at the origin, m, and the rotation, rad.
    pub(crate) fn parts(&self) -> (SVector<f64, 3>, Rotation) {
        self.parts_in(Space::Spatial)
    }

    /// The two parts of a twist in the plane or in space, depending on `space`: the translation of the body's point at the origin, m, and the
    /// rotation, rad.
    pub(crate) fn parts_in(&self, space: Space) -> (SVector<f64, 3>, Rotation) {
        let (along, turning) = self.components().split_at(3);
        let rotation = match space {
            Space::Planar => Rotation::Plane(turning[2]),
            Space::Spatial => Rotation::Space(SVector::from_column_slice(turning)),
        };
        (SVector::from_column_slice(along), rotation)
    }
}

impl Rotation {
    /// Absolute angle of the rotation, rad.
    pub(crate) fn size(&self) -> f64 {
        match self {
            Self::Plane(turn) => turn.abs(),
            Self::Space(omega) => omega.norm(),
        }
    }

    /// Unit vector along the axis of rotation; zero in the plane.
    pub(crate) fn axis(&self) -> SVector<f64, 3> {
        match self {
            Self::Plane(_) => SVector::zeros(),
            Self::Space(omega) => omega.normalize(),
        }
    }

    /// Vector from a point to the nearest point of the axis of rotation: `ω × u / |ω|²`, with the rotation vector ω and the displacement u of the
    /// point, `moves`. Not finite if the rotation is zero.
    pub(crate) fn way_to_axis(&self, moves: &SVector<f64, 3>) -> SVector<f64, 3> {
        match self {
            Self::Plane(turn) => SVector::from([-moves[1] / turn, moves[0] / turn, 0.0]),
            Self::Space(omega) => {
                let cross = |a: usize| {
                    omega[(a + 1) % 3] * moves[(a + 2) % 3] - omega[(a + 2) % 3] * moves[(a + 1) % 3]
                };
                by_axis(cross) / omega.norm_squared()
            }
        }
    }

    /// The component along the axis of rotation of a point's displacement `moves`, as a vector; zero in the plane.
    pub(crate) fn along_axis(&self, moves: &SVector<f64, 3>) -> SVector<f64, 3> {
        let axis = self.axis();
        axis * axis.dot(moves)
    }
}
