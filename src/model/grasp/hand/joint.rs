//! One joint of a finger. It moves the links, the rigid parts of the finger, that are farther from the palm.

use alloc::sync::Arc;

use nalgebra::SVector;

use crate::grasp::well_posed::{length_or_culprit, unit};
use crate::numerics::Space;
use crate::prelude::*;

/// How a joint moves the links behind it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum JointMotion<const C: usize> {
    /// A rotation about a point of the plane, or about a line of space.
    Revolute { point: SVector<f64, C>, axis: SVector<f64, C> },
    /// A translation along a direction.
    Prismatic { direction: SVector<f64, C> },
    /// A motion that is known only through the Jacobians of the contacts.
    Given,
}

/// Kind of a joint's motion, which determines the units in answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum JointKind {
    /// Rotation: displacement in rad, torque in N m.
    Turns,
    /// Translation: displacement in m, force in N.
    Slides,
    /// A motion known only through the Jacobians of the contacts, in the units of these Jacobians.
    #[default]
    Given,
}

/// Largest torque (N m) or force (N) of a joint's motor or clutch, and the behaviour at this limit: slip, or a constant torque.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(remote = "Self", rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Limit {
    /// A clutch, or friction in a gear: at this torque it slips, and the slip remains when the torque decreases.
    Slips(f64),
    /// A controller, or a motor that stalls: the torque stays at this bound, and follows the spring again when the load decreases.
    Saturates(f64),
}

#[cfg(feature = "serde")]
crate::serial::object::read_as_object!("a limit, {\"saturates\": 0.5} or {\"slips\": 0.5}", Limit);

impl Limit {
    /// The bound on the torque or force, N m or N.
    #[must_use]
    pub fn bound(self) -> f64 {
        let (Self::Slips(bound) | Self::Saturates(bound)) = self;
        bound
    }
}

/// A joint with its spring, command and limit, built step by step. By default the stiffness and the command are zero, and there is no limit.
///
/// The torque of the joint's spring is `k (θ - φ)`. Here k is the stiffness of structure and controller in series, θ the commanded and φ the actual
/// displacement. Displacements are measured from the posture in which the contacts are given. Positive rotations turn from x to y in the plane and
/// follow the right-hand rule in space. Units are N m/rad, rad and N m for a revolute joint, N/m, m and N for a prismatic joint.
///
/// ```
/// use grasp_lcp::planar::hand::Joint;
///
/// let knuckle = Joint::revolute([0.0, 0.1]).name("knuckle").stiffness(0.8).command(0.05).limit(grasp_lcp::Limit::Saturates(0.6));
/// # let _ = knuckle;
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Joint<const C: usize> {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) motion: JointMotion<C>,
    pub(crate) stiffness: f64,
    pub(crate) command: f64,
    pub(crate) torque: f64,
    pub(crate) limit: Option<Limit>,
}

impl Joint<2> {
    /// A revolute joint about a point of the plane, m.
    pub fn revolute(point: impl Into<[f64; 2]>) -> Self {
        Self::moving(JointMotion::Revolute { point: SVector::from(point.into()), axis: SVector::zeros() })
    }
}

impl Joint<3> {
    /// A revolute joint about the line through a point, m, along an axis vector of any length.
    pub fn revolute(point: impl Into<[f64; 3]>, axis: impl Into<[f64; 3]>) -> Self {
        let (point, axis) = (SVector::from(point.into()), SVector::from(axis.into()));
        Self::moving(JointMotion::Revolute { point, axis })
    }
}

impl<const C: usize> Joint<C> {
    pub(super) fn kind(&self) -> JointKind {
        match self.motion {
            JointMotion::Revolute { .. } => JointKind::Turns,
            JointMotion::Prismatic { .. } => JointKind::Slides,
            JointMotion::Given => JointKind::Given,
        }
    }

    fn moving(motion: JointMotion<C>) -> Self {
        Self { name: None, motion, stiffness: 0.0, command: 0.0, torque: 0.0, limit: None }
    }

    /// A prismatic joint along a direction vector of any length; its displacement is in m.
    pub fn prismatic(direction: impl Into<[f64; C]>) -> Self {
        Self::moving(JointMotion::Prismatic { direction: SVector::from(direction.into()) })
    }

    /// A joint whose motion is neither a rotation nor a translation of links. Only [`Finger::contact_moved_by`](super::Finger::contact_moved_by)
    /// determines how contacts move with it.
    pub fn given() -> Self {
        Self::moving(JointMotion::Given)
    }

    setters! {
        /// Sets the name for messages and tables.
        pub fn name(mut self, name: impl Into<String>) { self.name = Some(name.into().into()); }

        /// Sets the stiffness of the joint's own spring, N m/rad or N/m. With the default of zero, couplings, tendons or a constant torque must
        /// support the joint.
        pub fn stiffness(mut self, stiffness: f64) { self.stiffness = stiffness; }

        /// Sets the commanded displacement θ, rad or m.
        pub fn command(mut self, theta: f64) { self.command = theta; }

        /// Sets a constant torque on the joint, positive along its displacement φ, N m (for a prismatic joint a force, N). Examples are a finger
        /// under force control and the weight of a link.
        pub fn torque(mut self, torque: f64) { self.torque = torque; }

        /// Sets a bound on the magnitude of the torque of the joint's own spring. A constant [torque](Self::torque) does not count.
        pub fn limit(mut self, limit: Limit) { self.limit = Some(limit); }
    }
}

impl<const C: usize> JointMotion<C> {
    /// The point about which a revolute joint turns; `None` for other joints.
    pub(super) fn centre(&self) -> Option<SVector<f64, C>> {
        if let Self::Revolute { point, .. } = self { Some(*point) } else { None }
    }

    /// The unit vector along the axis of a revolute joint, in the plane that out of the plane; `None` for other joints.
    pub(super) fn axis(&self, space: Space) -> Option<SVector<f64, 3>> {
        let Self::Revolute { axis, .. } = self else { return None };
        let mut along = SVector::z();
        if space == Space::Spatial {
            (0..C).for_each(|a| along[a] = axis[a]);
        }
        unit(&along)
    }

    /// Velocity of the point `at` per unit velocity of the joint. For a revolute joint it is `axis × (at - point)`, with the unit vector along the
    /// axis. For a prismatic joint it is the unit direction, and for a given motion zero. For an invalid axis or direction, the error is the length
    /// of this vector, or its component that is not finite.
    pub(super) fn of_point(&self, at: &SVector<f64, C>) -> Result<SVector<f64, C>, f64> {
        let along = |axis: &SVector<f64, C>| unit(axis).ok_or_else(|| length_or_culprit(axis));
        match self {
            Self::Given => Ok(SVector::zeros()),
            Self::Prismatic { direction } => along(direction),
            Self::Revolute { point, axis } => {
                let arm = at - point;
                let mut velocity = SVector::zeros();
                if C == 2 {
                    (velocity[0], velocity[1]) = (-arm[1], arm[0]);
                } else {
                    let axis = along(axis)?;
                    for a in 0..C {
                        let (b, c) = ((a + 1) % C, (a + 2) % C);
                        velocity[a] = axis[b] * arm[c] - axis[c] * arm[b];
                    }
                }
                Ok(velocity)
            }
        }
    }
}
