//! One drive of a hand in the engine: the spring of a joint or tendon between its command and its displacement, with its force limit. A motor or
//! clutch limits the torque or tension. A drive acts along a single axis. The springs of stiffness matrices of joints and of compliance matrices are
//! also drives, which belong to no single joint or tendon and have no limit.

use nalgebra::SVector;

use crate::contact::{Compliance, Coulomb, Polygon, PolygonCone};
use crate::grasp::contact::Hold;
use crate::grasp::site::Site;
use crate::numerics::{Size, Space, Vector, summed};
use crate::prelude::*;

/// The joint or tendon to which a drive belongs, if any.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DriveOwner {
    /// The joint with this index, from 0, finger by finger.
    Joint(usize),
    /// The tendon with this index, from 0.
    Tendon(usize),
    /// No joint or tendon: the drive is a spring of a stiffness matrix of joints, or of a compliance matrix.
    Nobody,
}

/// How the force of a drive is limited, and the contact law that models this limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DriveLaw {
    /// The drive pushes and pulls without limit.
    Holds,
    /// The drive only pulls. Its force obeys the law of a frictionless contact.
    Pulls,
    /// The drive slips when its force reaches a bound. The drive is modelled by a contact whose normal force is the bound and whose friction
    /// coefficient is one.
    Slips,
    /// The upper half of a drive that yields: at an upper and at a lower bound the force of the drive stays constant. Such a drive is modelled by two
    /// springs in series. This half is a frictionless contact whose normal force is the upper bound minus the drive's force; it opens at the upper
    /// bound.
    UpperHalf,
    /// The lower half of a drive that yields at two bounds of its force: the second of the two springs in series. It is a frictionless contact that
    /// opens at the lower bound. Its normal force is the drive's force minus the lower bound.
    LowerHalf,
}

/// A drive in the engine's coordinates. The force of a drive is in N and the displacement in m, for any units of the joints.
#[derive(Debug, Clone)]
pub(crate) struct Drive {
    pub(crate) owner: DriveOwner,
    pub(crate) role: DriveLaw,
    /// Generalised force on the coordinates per newton of the drive's force.
    pub(super) along: Vector,
    pub(super) stiffness: f64,
    /// Bound on the drive's force, N; infinite or unused if the drive has no bound.
    pub(super) bound: f64,
    /// Torque of the joint (N m or N), or tension of the tendon (N), per newton of the drive's force.
    pub(super) unit: f64,
    /// Index of each joint or tendon command that stretches the drive, and stretch in m per unit of this command.
    pub(super) commands: Vec<(usize, f64)>,
    /// Stretch of the drive's spring, m, if all commands and displacements are zero.
    pub(super) rest: f64,
}

impl Drive {
    /// A spring on a single coordinate, without a joint or tendon as its owner.
    pub(super) fn unowned(coordinate: usize, stiffness: f64) -> Self {
        let mut along = Vector::zeros();
        along[coordinate] = 1.0;
        Self {
            owner: DriveOwner::Nobody,
            role: DriveLaw::Holds,
            along,
            stiffness,
            bound: f64::INFINITY,
            unit: 1.0,
            commands: Vec::new(),
            rest: 0.0,
        }
    }

    /// The axis of the drive's contact frame along which the spring acts: the first tangent if the drive slips, otherwise the normal.
    fn axis(&self) -> usize {
        usize::from(self.role == DriveLaw::Slips)
    }

    /// The point contact that models this drive by a contact law.
    pub(crate) fn site(&self, space: Space, size: Size) -> Site {
        let slips = self.role == DriveLaw::Slips;
        let springs = Compliance::new(&SVector::repeat(self.stiffness), if slips { space.axes() } else { 1 });
        let hold = match self.role {
            DriveLaw::Holds => Hold::Bonded,
            DriveLaw::Slips => Hold::KeptClosed,
            DriveLaw::Pulls | DriveLaw::UpperHalf | DriveLaw::LowerHalf => Hold::Unilateral,
        };
        let mut site = Site::of_axis(space, size, (self.axis(), &self.along), springs, hold);
        if !slips {
            return site;
        }
        // The section of the friction cone is a square instead of a circle. Its corners lie on the tangents, at |F_t| = μ F_n. The force of the drive
        // acts along the first tangent, thus towards a corner, so that the drive slips exactly at its bound.
        let square = || alloc::sync::Arc::new(Polygon::new(space, &PolygonCone::square()));
        (site.friction, site.polygon) = (Coulomb::new(1.0), (space == Space::Spatial).then(square));
        site
    }

    /// Stretch of the drive's spring, m, if joints and tendons have these commands and no displacements. It is a vector in the drive's contact frame,
    /// with one component along the normal and two along the tangents. The component along [`Self::axis`] is the stretch. For a drive that slips, the
    /// normal component produces the bound of the force.
    pub(super) fn stretch(&self, commands: &[f64]) -> SVector<f64, 3> {
        let mut stretch = self.change(commands);
        stretch[self.axis()] += self.rest;
        if self.role == DriveLaw::Slips {
            stretch[0] = self.bound / self.stiffness;
        }
        stretch
    }

    /// Change of the stretch of the drive's spring, m, if the commands of joints and tendons change by `commands`. It is a vector in the drive's
    /// contact frame, whose component along [`Self::axis`] is the change; the others are zero.
    pub(super) fn change(&self, commands: &[f64]) -> SVector<f64, 3> {
        let mut stretch = SVector::zeros();
        stretch[self.axis()] = summed(&self.commands, &|(k, weight)| weight * commands[*k]);
        stretch
    }

    /// Torque of the drive's joint (N m or N), or tension of its tendon (N), for a force of the drive, N. `None` for the lower half of a drive that
    /// yields at a constant force, since the upper half returns the value.
    pub(crate) fn carried(&self, force: &SVector<f64, 3>) -> Option<f64> {
        match self.role {
            DriveLaw::LowerHalf => None,
            DriveLaw::UpperHalf => Some((self.bound - force[0]) * self.unit),
            DriveLaw::Holds | DriveLaw::Pulls | DriveLaw::Slips => Some(force[self.axis()] * self.unit),
        }
    }

    /// Multiplies the stiffness of the drive's spring by `times`; bounds of the force do not change.
    pub(super) fn stiffen(&mut self, times: f64) {
        self.stiffness *= times;
        self.rest /= times;
    }

    /// Stiffness of this spring divided by the stiffness of its joint or tendon, both in N/m along the drive. It is 2 for each of the two springs in
    /// series that model a drive which yields at a constant force, else 1.
    fn halves(&self) -> f64 {
        if matches!(self.role, DriveLaw::UpperHalf | DriveLaw::LowerHalf) { 2.0 } else { 1.0 }
    }

    /// Derivative of the drive's force with respect to the stiffness (N m/rad or N/m) of its joint or tendon, at constant stretch. It is a vector in
    /// the drive's contact frame (normal, two tangents), in which only the component along [`Self::axis`] is not zero.
    pub(crate) fn by_stiffness(&self, force: &SVector<f64, 3>) -> SVector<f64, 3> {
        let mut more = SVector::zeros();
        // If the drive has no force, the spring of its upper half carries the upper bound, and the spring of its lower half the magnitude of the
        // lower bound. The elastic force is `force` minus this preload.
        let elastic = match self.role {
            DriveLaw::UpperHalf => force[0] - self.bound,
            DriveLaw::LowerHalf => force[0] - self.rest * self.stiffness,
            DriveLaw::Holds | DriveLaw::Pulls | DriveLaw::Slips => force[self.axis()],
        };
        more[self.axis()] = self.halves() * elastic / self.stiffness / (self.unit * self.unit);
        more
    }

    /// Derivatives with respect to the torque limit of the joint or the tension limit of the tendon. The first is the derivative of the stretch of
    /// the drive's spring, as a vector in its contact frame (normal, two tangents). The second is the derivative of the constant generalised forces
    /// on the coordinates.
    pub(crate) fn by_limit(&self) -> (SVector<f64, 3>, Vector) {
        let (mut stretch, per_force) = (SVector::zeros(), 1.0 / self.unit);
        let held = match self.role {
            DriveLaw::Slips => {
                stretch[0] = per_force / self.stiffness;
                Vector::zeros()
            }
            // The limit enters both the stretch and the constant force of each half. For a drive that only pulls, the lower bound is zero,
            // independent of the limit.
            DriveLaw::UpperHalf | DriveLaw::LowerHalf if !self.pulls_only() => {
                stretch[0] = per_force / self.stiffness;
                -&self.along * per_force
            }
            DriveLaw::Holds | DriveLaw::Pulls | DriveLaw::UpperHalf | DriveLaw::LowerHalf => Vector::zeros(),
        };
        (stretch, held)
    }

    /// Stretch of the drive's spring, m, under a force, N.
    pub(crate) fn deflection(&self, force: f64) -> f64 {
        force / self.stiffness
    }

    /// Whether the drive never pushes, since it belongs to a tendon that only pulls. If such a tendon has a largest tension, two springs model its
    /// drive. The result is then true for the lower half.
    pub(crate) fn pulls_only(&self) -> bool {
        self.role == DriveLaw::Pulls || (self.role == DriveLaw::LowerHalf && self.rest == 0.0)
    }

    /// Energy stored in the drive's spring, J, at a force of the drive, N. A drive that yields at a constant force is modelled by two springs; its
    /// upper half returns the energy of both.
    pub(crate) fn stored(&self, force: &SVector<f64, 3>) -> f64 {
        let square = |force: f64| force * force / self.stiffness;
        match self.role {
            DriveLaw::Holds | DriveLaw::Pulls | DriveLaw::Slips => 0.5 * square(force[self.axis()]),
            DriveLaw::UpperHalf => square(self.bound - force[0]),
            DriveLaw::LowerHalf => 0.0,
        }
    }

    /// Displacement of the joint or tendon, rad or m, that corresponds to a displacement of the drive, m. Changes of commands are converted in the
    /// same way.
    pub(crate) fn displacement(&self, along: f64) -> f64 {
        // The drive and its joint or tendon do the same work, force times displacement, and `unit` is the ratio of their forces.
        along / self.unit
    }
}
