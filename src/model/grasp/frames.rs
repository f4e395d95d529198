//! Contacts, loads and motions in other coordinate systems.
//!
//! A pose, with the rotation R and the translation p, describes the frame in which a quantity is given, as seen from the target frame: a point r
//! becomes r' = R r + p. With the force f, the moment m about the origin, the translation u of the body's point at the origin and the rotation θ of
//! the body,
//!
//! ```text
//! f' = R f,   m' = R m + p × f',      θ' = R θ,   u' = R u + p × θ'
//! ```
//!
//! so that the work `f·u + m·θ` does not depend on the frame. In the plane R does not change m and θ.

use nalgebra::{AbstractRotation, Isometry, SMatrix, SVector};

use super::commands::CommandAxes;
use super::contact::Contact;
use super::wrench::{Twist, Wrench};
use crate::numerics::{Space, Vector, by_axis};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl<const C: usize> Contact<C> {
    /// This contact in another frame. `pose` is the frame in which the contact is given, as seen from the target frame. A contact may be given in the
    /// frame of a finger's last link, for example, or of the object. All contacts of a grasp must be in the same frame.
    ///
    /// Points become `r' = R r + p`; normal and tangents are rotated by R. A tangent that was not given is set to the default of the old frame
    /// and rotated, too. Commands, stiffnesses and forces in the contact frame therefore do not change.
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
    pub fn transformed<R: AbstractRotation<f64, C>>(mut self, pose: &Isometry<f64, R, C>) -> Self {
        // If normal and tangent give no valid frame, the given tangent is rotated alone. `Grasp::new` then returns an error for this contact.
        let tangent = self.frame(0).map_or(self.tangent, |frame| Some(frame.column(1).into_owned()));
        self.tangent = tangent.map(|tangent| pose.rotation.transform_vector(&tangent));
        self.point = pose.rotation.transform_vector(&self.point) + pose.translation.vector;
        self.normal = pose.rotation.transform_vector(&self.normal);
        if self.command_axes == CommandAxes::World {
            self.command = pose.rotation.transform_vector(&self.command);
        }
        self
    }

    /// This contact with its normal tilted towards its tangents by the angles `tilt`, rad; the frame rotates with it. The axis of rotation is
    /// orthogonal to the normal and to `tilt`, and the angle of rotation is the norm of `tilt`. The first component of `tilt` is ignored.
    pub(crate) fn tilted(mut self, tilt: &SVector<f64, C>) -> Self {
        // Without a valid frame this function returns the contact unchanged. `Grasp::new` then returns an error for this contact.
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

/// The load or motion `v` with its linear and its angular part rotated by `rotation`.
fn turned<R: AbstractRotation<f64, C>, const C: usize>(rotation: &R, v: &Vector) -> Vector {
    let part = |from: usize| rotation.transform_vector(&by_axis(|a| v[from + a]));
    let linear = part(0);
    // In the plane a moment or an angle of rotation is the same in all frames. So are the displacements of joints.
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
            /// This load with its moment taken about `point` instead of the origin, along the same axes. With the force f and the moment m, the new
            /// moment is `m - point × f`. The result has `point` as its origin.
            pub fn about(&self, point: impl Into<[f64; $c]>) -> Self {
                let space = Space::of::<$c>();
                let from = -SVector::<f64, $c>::from(point.into());
                let points = self.points_of_action().moved(&self.force_part(), &from);
                Self::among(space, &space.moved_wrench(&from, &self.coordinates(space))).acting_at(points)
            }

            /// This load in another frame. `pose` is the frame in which the load is given, as seen from the target frame: points become `r' = R r +
            /// p`. With the force f and the moment m, `f' = R f` and `m' = R m + p × f'`; in the plane R does not change m.
            pub fn transformed<R: AbstractRotation<f64, $c>>(&self, pose: &Isometry<f64, R, $c>) -> Self {
                let space = Space::of::<$c>();
                let turned = turned::<_, $c>(&pose.rotation, &self.coordinates(space));
                let rotation = SMatrix::<f64, $c, $c>::from_fn(|i, j| {
                    pose.rotation.transform_vector(&SVector::<f64, $c>::ith(j, 1.0))[i]
                });
                let force = pose.rotation.transform_vector(&self.force_part());
                let points =
                    self.points_of_action().rotated(&rotation).moved(&force, &pose.translation.vector);
                let load = Self::among(space, &space.moved_wrench(&pose.translation.vector, &turned));
                load.acting_at(points)
            }
        }

        impl Twist<$c> {
            /// This motion with the translation of the object's point at `point` in place of the translation of the origin. The translation becomes
            /// [`Self::displacement_at`] that point, and the rotation stays. The result has `point` as its origin.
            pub fn about(&self, point: impl Into<[f64; $c]>) -> Self {
                let space = Space::of::<$c>();
                let from = -SVector::<f64, $c>::from(point.into());
                Self::among(space, &space.moved_twist(&from, &self.coordinates(space)))
            }

            /// This motion in another frame. `pose` is the frame in which the motion is given, as seen from the target frame: points become
            /// `r' = R r + p`. With the translation u of the origin and the rotation θ, `θ' = R θ` and `u' = R u + p × θ'`; in the plane R does not
            /// change θ.
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
