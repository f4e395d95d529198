//! A load that turns: a harmonic function of an angle. A leg is a section of a load program. A drive is the spring of a joint or tendon of a hand,
//! with its force limit. In names of this file, `edge` is the boundary of a contact's friction cone, or the force limit of a drive.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::trajectory::Trajectory;
use crate::error::{ContactLabel, Error};
use crate::grasp::{Engine, PartLabel, Space, Wrench};
use crate::numerics::{Each, Harmonic, Vector};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// A load that turns: at angle θ >= 0 (rad) it is `constant + cosine cos θ + sine sin θ`; finger commands stay constant.
///
/// An example is the weight of an object that is tilted together with its grasp ([`Turn::tilting`]). In the frame of the object, in which grasps are
/// given, its direction turns.
///
/// ```
/// use grasp_lcp::planar::{Turn, Wrench};
///
/// // A weight of 2 N at (0, 0.1), and a cable that pulls with 1 N whatever the tilt.
/// let cable = Wrench::force([1.0, 0.0]);
/// let turn = Turn::tilting([0.0, -2.0], [0.0, 0.1]).beside(cable);
/// // On its side by a quarter turn against the clock, the object feels its weight along -x.
/// let load = turn.load_at(std::f64::consts::FRAC_PI_2);
/// assert!((load.resultant()[0] + 1.0).abs() < 1e-15 && load.resultant()[1].abs() < 1e-15);
/// assert!((load.moment() - 0.2).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Turn<const C: usize> {
    pub(super) load: Harmonic<Wrench<C>>,
    /// Last angle of the turn, at which it ends, rad.
    pub(super) angle: f64,
    /// The axis about which the bodies of a scene are tilted under their own weights, which then take the place of `load`. Only the scene knows
    /// these weights. `None` if `load` itself turns.
    pub(crate) tilts_bodies_about: Option<SVector<f64, 3>>,
}

impl<const C: usize> From<&Self> for Turn<C> {
    fn from(turn: &Self) -> Self {
        *turn
    }
}

impl<const C: usize> Turn<C> {
    /// A load that turns by one revolution, from its constant term and its coefficients of cos θ and sin θ (N, N m).
    pub fn new(constant: Wrench<C>, cosine: Wrench<C>, sine: Wrench<C>) -> Self {
        Self { load: Harmonic { constant, cosine, sine }, angle: TAU, tilts_bodies_about: None }
    }

    /// A turn in which the bodies of a scene are tilted about `axis`, of any length but zero, by the right-hand rule. Only a scene, which knows the
    /// weights of its bodies, can answer questions about this turn.
    #[cfg(feature = "serde")]
    pub(crate) fn of_bodies(axis: SVector<f64, 3>) -> Self {
        let turn = Self::new(Wrench::ZERO, Wrench::ZERO, Wrench::ZERO);
        Self { tilts_bodies_about: Some(axis), ..turn }
    }

    setters! {
        /// This turn with `load` added to its constant term.
        pub fn beside(mut self, load: Wrench<C>) { self.load.constant = self.load.constant + load; }

        /// This turn, ending at the angle `angle` (rad). The angle must be positive and at most 1e6 rad; it may be many revolutions.
        pub fn up_to(mut self, angle: f64) { self.angle = angle; }
    }

    /// The turn in the opposite direction from the same beginning: θ becomes -θ.
    pub fn reversed(mut self) -> Self {
        self.load.sine = -self.load.sine;
        self.tilts_bodies_about = self.tilts_bodies_about.map(|axis| -axis);
        self
    }

    /// The same loads in reverse order: a turn that begins with the load at this turn's last angle, and ends with the load at angle zero.
    pub(crate) fn back(mut self) -> Self {
        let (sin, cos) = self.angle.sin_cos();
        let Harmonic { cosine, sine, .. } = self.load;
        (self.load.cosine, self.load.sine) = (cosine * cos + sine * sin, cosine * sin - sine * cos);
        self
    }

    /// Last angle of the turn, at which it ends, rad.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The constant term of the load and its coefficients of cos θ and sin θ.
    pub fn parts(&self) -> [Wrench<C>; 3] {
        self.load.parts().each(|part| *part)
    }

    /// The load at an angle, rad.
    pub fn load_at(&self, angle: f64) -> Wrench<C> {
        self.load.at(angle)
    }
}

impl Turn<3> {
    /// The load of this turn, which has been checked, in the engine's coordinates, with moments about the centroid of the contacts. The constant pull
    /// of the suction cups' vacuums and the constant loads on bodies and joints are added to its constant term.
    pub(crate) fn inside(&self, grasp: &Engine) -> Harmonic<Vector> {
        inside(grasp, &self.load)
    }
}

impl<const C: usize> Turn<C> {
    /// The load of a leg (section of a load program) with this turn, as a function of the fraction of the leg. It begins with `load`, and changes
    /// from there as the load of this turn changes from angle zero on. The whole leg is the whole turn.
    pub(super) fn beginning_with(&self, load: &Wrench<C>) -> Trajectory<Wrench<C>> {
        let load = Harmonic { constant: *load - self.load.cosine, ..self.load };
        Trajectory::Turn { load, angle: self.angle }
    }

    /// The angle of the turn (rad), but at most one revolution, because every load of the turn occurs within one revolution.
    pub(crate) fn whole_angle(&self) -> f64 {
        self.angle.min(TAU)
    }

    /// Refuses, with an error, terms of the load that are not finite or beyond 1e50, and an angle that [`Self::check_angle`] refuses.
    pub(crate) fn check_in(&self, space: Space) -> Result<(), Error> {
        self.load.constant.check_in(space, "constant load")?;
        self.load.cosine.check_in(space, "cosine of the load")?;
        self.load.sine.check_in(space, "sine of the load")?;
        if self.tilts_bodies_about.is_some() {
            // The text of the error if the bodies have no weight that could turn.
            let no_weight: &str = "is missing: give weight, or force, or cosine and sine; without them gravity turns, where a scene's bodies have masses under `gravity`, by onset_of_turn and need";
            return Err(Error::Question { question: "turn", field: "weight", fault: no_weight });
        }
        self.check_angle()
    }

    /// Refuses, with an error, an angle that is not positive or beyond 1e6 rad.
    pub(crate) fn check_angle(&self) -> Result<(), Error> {
        // At larger angles the rounding error of the angle is no longer small within a revolution.
        if !(self.angle > 0.0 && self.angle <= 1e6) {
            let allowed = "more than 0 and at most 1e6 rad";
            return Err(Error::Argument { what: "angle of the turn", value: self.angle, allowed });
        }
        Ok(())
    }

    /// The turn of a force, from three forces: its component along the axis, its component across the axis at θ = 0, and the force into which this
    /// second component has turned a quarter revolution later. `wrench` makes the wrench of each of these forces.
    fn of_forces(parts: [SVector<f64, C>; 3], wrench: impl Fn(SVector<f64, C>) -> Wrench<C>) -> Self {
        let [constant, cosine, sine] = parts.each(wrench);
        Self::new(constant, cosine, sine)
    }
}

impl Turn<2> {
    /// A force (N) through `point` (m) that turns in the sense from the x axis to the y axis. `force` is its value at angle zero.
    pub fn force_at(force: impl Into<[f64; 2]>, point: impl Into<[f64; 2]>) -> Self {
        let ([x, y], point) = (force.into(), point.into());
        let parts = [SVector::zeros(), SVector::from([x, y]), SVector::from([-y, x])];
        Self::of_forces(parts, |force| Wrench::<2>::force_at(force, point))
    }

    /// A weight (N) whose centre is at `point` (m), while the object is tilted together with its grasp. It is tilted in the sense from the x axis to
    /// the y axis.
    pub fn tilting(weight: impl Into<[f64; 2]>, point: impl Into<[f64; 2]>) -> Self {
        Self::force_at(weight, point).reversed()
    }
}

impl Turn<3> {
    /// A force (N) through `point` (m) that turns about an axis by the right-hand rule. `force` is its value at angle zero; the axis has any length
    /// but zero.
    ///
    /// ```
    /// use grasp_lcp::spatial::Turn;
    ///
    /// // About the direction (0, 0, 1), from x to y; what lies along the axis stays.
    /// let turn = Turn::force_at([2.0, 0.0, -1.0], [0.0; 3], [0.0, 0.0, 5.0])?;
    /// let [x, y, z] = turn.load_at(std::f64::consts::FRAC_PI_2).resultant();
    /// assert!(x.abs() < 1e-15 && (y - 2.0).abs() < 1e-15 && z == -1.0);
    ///
    /// let refused = Turn::force_at([2.0, 0.0, -1.0], [0.0; 3], [0.0; 3]).unwrap_err();
    /// assert_eq!(refused.to_string(), "length of the axis is 0, must be more than 0 and at most 1e50");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Argument`] if the axis has no direction.
    pub fn force_at(
        force: impl Into<[f64; 3]>,
        point: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
    ) -> Result<Self, Error> {
        let (force, point, axis) =
            (SVector::<f64, 3>::from(force.into()), point.into(), SVector::<f64, 3>::from(axis.into()));
        // The largest component is factored out, so that no square overflows or underflows.
        let scale = axis.amax();
        let length = scale * (axis / scale).norm();
        if !(length > 0.0 && length <= 1e50) {
            let (what, allowed) = ("length of the axis", "more than 0 and at most 1e50");
            let value = if scale == 0.0 { 0.0 } else { length };
            return Err(Error::Argument { what, value, allowed });
        }
        let axis = axis / scale / (length / scale);
        let along = axis * axis.dot(&force);
        let parts = [along, force - along, axis.cross(&force)];
        Ok(Self::of_forces(parts, |force| Wrench::<3>::force_at(force, point)))
    }

    /// A weight (N) whose centre is at `point` (m), while the object is tilted about an axis together with its grasp, by the right-hand
    /// rule.
    ///
    /// # Errors
    /// [`Error::Argument`] if the axis has no direction.
    pub fn tilting(
        weight: impl Into<[f64; 3]>,
        point: impl Into<[f64; 3]>,
        axis: impl Into<[f64; 3]>,
    ) -> Result<Self, Error> {
        Ok(Self::force_at(weight, point, axis)?.reversed())
    }
}

/// The turning load `load`, which has been checked, in the engine's coordinates. The constant pull of the suction cups' vacuums and the constant
/// loads on bodies and joints are added to its constant term.
pub(super) fn inside(grasp: &Engine, load: &Harmonic<Wrench<3>>) -> Harmonic<Vector> {
    Harmonic {
        constant: grasp.load_unchecked(&load.constant),
        cosine: grasp.inside_unchecked(&load.cosine),
        sine: grasp.inside_unchecked(&load.sine),
    }
}

/// A contact whose force reaches the boundary of its friction cone without crossing it, or a drive of a hand that reaches its force limit without
/// exceeding it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EdgeTouch {
    /// The contact that reaches the boundary of its cone, or the drive that reaches its force limit.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub of: EdgeOf,
    /// The angle of the load at which the boundary or the force limit is reached, rad.
    #[cfg_attr(feature = "serde", serde(rename = "angle_rad", with = "AsComputed::<f64>"))]
    pub angle: f64,
}

/// The parts of a grasp whose forces are limited: contacts with a friction cone, and drives.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(untagged))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum EdgeOf {
    /// A contact, whose force is limited by its friction cone.
    Contact(ContactLabel),
    /// A joint or a tendon, whose drive has a force limit.
    Drive(PartLabel),
}
