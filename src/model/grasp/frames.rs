//! Contacts, loads and motions in other coordinates.
//!
//! A pose says where the frame in which something was given lies in the frame in which it is wanted: r' = R r + p for points. With f the force, m the
//! moment about the origin, u the translation of the origin and θ the rotation,
//!
//! ```text
//! f' = R f,   m' = R m + p × f',      θ' = R θ,   u' = R u + p × θ'
//! ```
//!
//! so that the work `f·u + m·θ` does not depend on the frame. In the plane R leaves m and θ as they
//! are.

use nalgebra::{AbstractRotation, Isometry, SVector};

use super::commands::Axes;
use super::contact::Contact;
use super::wrench::{Twist, Wrench};
use crate::numerics::Vector;
use crate::numerics::{Space, by_axis};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl<const C: usize> Contact<C> {
    /// This contact in other coordinates: `pose` is the frame in which it was given – of a finger's
    /// last link, say, or of the object – as seen from the frame in which it is wanted. Contacts of
    /// one grasp must all be in one frame.
    ///
    /// For points `r' = R r + p`, for normal and tangents R alone. A tangent that was not given becomes the default one, turned with the contact. So
    /// commands, stiffnesses and forces in the contact frame stay the same.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::{Isometry2, Vector2};
    /// use grasp_lcp::planar::Contact;
    /// use std::f64::consts::FRAC_PI_2;
    ///
    /// let in_the_link = Contact::new([0.02, 0.0], [1.0, 0.0]);
    /// let link = Isometry2::new(Vector2::new(0.1, 0.3), FRAC_PI_2);
    /// let point = in_the_link.transformed(&link).point();
    /// assert!((point - Vector2::new(0.1, 0.32)).norm() < 1e-16);
    /// ```
    #[must_use]
    pub fn transformed<R: AbstractRotation<f64, C>>(mut self, pose: &Isometry<f64, R, C>) -> Self {
        // A contact without a frame is refused later, when its grasp is made.
        let tangent = self.frame(0).map_or(self.tangent, |frame| Some(frame.column(1).into_owned()));
        self.tangent = tangent.map(|tangent| pose.rotation.transform_vector(&tangent));
        self.point = pose.rotation.transform_vector(&self.point) + pose.translation.vector;
        self.normal = pose.rotation.transform_vector(&self.normal);
        if self.command_axes == Axes::World {
            self.command = pose.rotation.transform_vector(&self.command);
        }
        self
    }

    /// This contact with its normal tilted towards its tangents by these angles, rad; its frame turns with it. The axis is across the normal and the
    /// tilt, the angle the root of the sum of their squares. The first component is ignored.
    pub(crate) fn tilted(mut self, tilt: &SVector<f64, C>) -> Self {
        // A contact without a frame is refused later, when its grasp is made.
        let Ok(frame) = self.frame(0) else { return self };
        let mut towards = *tilt;
        towards[0] = 0.0;
        let angle = towards.norm();
        if angle == 0.0 {
            return self;
        }
        towards /= angle;
        let (sin, cos) = angle.sin_cos();
        let (normal, across) = (frame.column(0), frame * towards);
        self.tangent = Some(frame.column(1) + (across * (cos - 1.0) - normal * sin) * towards[1]);
        self.normal = normal * cos + across * sin;
        self
    }
}

/// `v` with its linear and its angular part rotated.
fn turned<R: AbstractRotation<f64, C>, const C: usize>(rotation: &R, v: &Vector) -> Vector {
    let part = |from: usize| rotation.transform_vector(&by_axis(|a| v[from + a]));
    let linear = part(0);
    // A rotation about the one axis of the plane is the same in all frames, and so are displacements of joints.
    let angular = (C == 3).then(|| part(C));
    let mut turned = v.clone();
    for a in 0..C {
        turned[a] = linear[a];
        if let Some(angular) = angular {
            turned[C + a] = angular[a];
        }
    }
    turned
}

macro_rules! in_other_frames {
    ($c:literal) => {
        impl Wrench<$c> {
            /// This load with moments about `point` instead of the origin: `m - point × f`, in axes
            /// parallel to the old ones. In its result `point` is the origin.
            #[must_use]
            pub fn about(&self, point: impl Into<[f64; $c]>) -> Self {
                let space = Space::of::<$c>();
                let from = -SVector::<f64, $c>::from(point.into());
                Self::among(space, &space.moved_wrench(&from, &self.coordinates(space)))
            }

            /// This load in other coordinates: `pose` is the frame in which it was given as seen
            /// from the one in which it is wanted (points: `r' = R r + p`). `f' = R f`, `m' = R m +
            /// p × f'`; in the plane R leaves m as it is.
            #[must_use]
            pub fn transformed<R: AbstractRotation<f64, $c>>(&self, pose: &Isometry<f64, R, $c>) -> Self {
                let space = Space::of::<$c>();
                let turned = turned::<_, $c>(&pose.rotation, &self.coordinates(space));
                Self::among(space, &space.moved_wrench(&pose.translation.vector, &turned))
            }
        }

        impl Twist<$c> {
            /// This motion with the translation of the object's point at `point` instead of that at the origin: its translation is
            /// [`Self::displacement_at`] that point, its rotation stays. In its result `point` is the origin.
            #[must_use]
            pub fn about(&self, point: impl Into<[f64; $c]>) -> Self {
                let space = Space::of::<$c>();
                let from = -SVector::<f64, $c>::from(point.into());
                Self::among(space, &space.moved_twist(&from, &self.coordinates(space)))
            }

            /// This motion in other coordinates: `pose` is the frame in which it was given as seen
            /// from the one in which it is wanted (points: `r' = R r + p`). `θ' = R θ`, `u' = R u +
            /// p × θ'` for the translation u of the origin; in the plane R leaves θ as it is.
            #[must_use]
            pub fn transformed<R: AbstractRotation<f64, $c>>(&self, pose: &Isometry<f64, R, $c>) -> Self {
                let space = Space::of::<$c>();
                let turned = turned::<_, $c>(&pose.rotation, &self.coordinates(space));
                Self::among(space, &space.moved_twist(&pose.translation.vector, &turned))
            }
        }
    };
}

in_other_frames!(2);
in_other_frames!(3);
