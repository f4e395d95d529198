//! One drive of a hand as the arithmetic sees it: a spring of one axis over the joints.

use nalgebra::SVector;

use crate::contact::{Compliance, Coulomb, Polygon, PolygonCone};
use crate::grasp::contact::Hold;
use crate::grasp::site::Site;
use crate::numerics::{Size, Vector};
use crate::prelude::*;

/// Whose spring a drive is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Owner {
    /// The joint with this number.
    Joint(usize),
    /// The tendon with this number.
    Tendon(usize),
    /// A stiffness among joints that is nobody's own.
    Nobody,
}

/// What a drive does with its force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// It pushes and pulls without limit.
    Holds,
    /// It pulls only: its force is that of a contact without friction.
    Pulls,
    /// It slips where its force reaches a bound: that of a contact whose normal force is the bound, and whose friction coefficient is one.
    Slips,
    /// The half of a saturating drive that ends its force at the upper bound: what a contact without friction carries is the bound less the force.
    EndsAbove,
    /// The other half, which ends it at the lower bound: it carries the force less the bound.
    EndsBelow,
}

/// A drive in inside coordinates: its force in N along a unit of length, whatever the units of its joints.
#[derive(Debug, Clone)]
pub(crate) struct Drive<D: Size> {
    pub(crate) owner: Owner,
    pub(crate) role: Role,
    /// How the coordinates feel its force.
    pub(super) along: Vector<D>,
    pub(super) stiffness: f64,
    /// The bound on its force, where it has one.
    pub(super) bound: f64,
    /// Torque or tension of the owner for a unit of force.
    pub(super) unit: f64,
    /// Stretch for a unit of each command.
    pub(super) commands: Vec<(usize, f64)>,
    /// Stretch at no command.
    pub(super) rest: f64,
}

impl<D: Size> Drive<D> {
    /// A spring that holds one coordinate and belongs to no joint.
    pub(super) fn unowned(coordinate: usize, stiffness: f64) -> Self {
        let mut along = Vector::zeros();
        along[coordinate] = 1.0;
        Self {
            owner: Owner::Nobody,
            role: Role::Holds,
            along,
            stiffness,
            bound: f64::INFINITY,
            unit: 1.0,
            commands: Vec::new(),
            rest: 0.0,
        }
    }

    /// The axis of its site along which the spring acts.
    fn axis(&self) -> usize {
        usize::from(self.role == Role::Slips)
    }

    /// The site that obeys its law.
    pub(crate) fn site<const C: usize>(&self, size: D) -> Site<D, C> {
        let slips = self.role == Role::Slips;
        let springs = Compliance::new(&SVector::repeat(self.stiffness), if slips { C } else { 1 });
        let hold = match self.role {
            Role::Holds => Hold::Bonded,
            Role::Slips => Hold::KeptClosed,
            Role::Pulls | Role::EndsAbove | Role::EndsBelow => Hold::Unilateral,
        };
        let mut site = Site::of_axis(size, (self.axis(), &self.along), springs, hold);
        if !slips {
            return site;
        }
        // A square with corners on its one axis holds a line to exactly its bound.
        let square = || alloc::sync::Arc::new(Polygon::new(&PolygonCone::square()));
        (site.friction, site.polygon) = (Coulomb::new(1.0), (C == 3).then(square));
        site
    }

    /// What these commands stretch its site by.
    pub(super) fn stretch<const C: usize>(&self, commands: &[f64]) -> SVector<f64, C> {
        let mut stretch = self.change(commands);
        stretch[self.axis()] += self.rest;
        if self.role == Role::Slips {
            stretch[0] = self.bound / self.stiffness;
        }
        stretch
    }

    /// What a change of commands stretches its site by.
    pub(super) fn change<const C: usize>(&self, commands: &[f64]) -> SVector<f64, C> {
        let mut stretch = SVector::zeros();
        stretch[self.axis()] = self.commands.iter().map(|&(k, weight)| weight * commands[k]).sum();
        stretch
    }

    /// Torque or tension that its owner exerts with this force of its site; `None` for the one half of a saturating drive that does not say.
    pub(crate) fn carried<const C: usize>(&self, force: &SVector<f64, C>) -> Option<f64> {
        match self.role {
            Role::EndsBelow => None,
            Role::EndsAbove => Some((self.bound - force[0]) * self.unit),
            Role::Holds | Role::Pulls | Role::Slips => Some(force[self.axis()] * self.unit),
        }
    }

    /// Makes its spring so many times as stiff; its bounds stay.
    pub(super) fn stiffen(&mut self, times: f64) {
        self.stiffness *= times;
        self.rest /= times;
    }

    /// The owner's stiffness, N m/rad or N/m.
    pub(crate) fn stiffness_of_owner(&self) -> f64 {
        self.stiffness * (self.unit * self.unit) / self.halves()
    }

    /// How many times as stiff as its owner it is: a saturating drive has two springs in series.
    fn halves(&self) -> f64 {
        if matches!(self.role, Role::EndsAbove | Role::EndsBelow) { 2.0 } else { 1.0 }
    }

    /// What more of the owner's stiffness, N m/rad or N/m, adds to the force of its site while the stretch stays.
    pub(crate) fn by_stiffness<const C: usize>(&self, force: &SVector<f64, C>) -> SVector<f64, C> {
        let mut more = SVector::zeros();
        // Of the halves of a saturating drive the force counts from the bounds.
        let elastic = match self.role {
            Role::EndsAbove => force[0] - self.bound,
            Role::EndsBelow => force[0] - self.rest * self.stiffness,
            Role::Holds | Role::Pulls | Role::Slips => force[self.axis()],
        };
        more[self.axis()] = self.halves() * elastic / self.stiffness / (self.unit * self.unit);
        more
    }

    /// What more of the owner's limit stretches its site by, and does to the coordinates besides.
    pub(crate) fn by_limit<const C: usize>(&self) -> (SVector<f64, C>, Vector<D>) {
        let (mut stretch, per_force) = (SVector::zeros(), 1.0 / self.unit);
        let held = match self.role {
            Role::Slips => {
                stretch[0] = per_force / self.stiffness;
                Vector::zeros()
            }
            // The bound is held against each half on both sides of it; that below is zero where nothing pushes.
            Role::EndsAbove | Role::EndsBelow if !self.pulls_only() => {
                stretch[0] = per_force / self.stiffness;
                -&self.along * per_force
            }
            Role::Holds | Role::Pulls | Role::EndsAbove | Role::EndsBelow => Vector::zeros(),
        };
        (stretch, held)
    }

    /// Displacement by which a force stretches its spring.
    pub(crate) fn give(&self, force: f64) -> f64 {
        force / self.stiffness
    }

    /// Whether it is the half of a saturating drive that never pushes.
    pub(crate) fn pulls_only(&self) -> bool {
        self.role == Role::Pulls || (self.role == Role::EndsBelow && self.rest == 0.0)
    }

    /// Energy stored with this force of its site, J; both halves of a saturating drive are told by the one that says its force.
    pub(crate) fn stored<const C: usize>(&self, force: &SVector<f64, C>) -> f64 {
        let square = |force: f64| force * force / self.stiffness;
        match self.role {
            Role::Holds | Role::Pulls | Role::Slips => 0.5 * square(force[self.axis()]),
            Role::EndsAbove => square(self.bound - force[0]),
            Role::EndsBelow => 0.0,
        }
    }

    /// Commands and displacements of its owner for a displacement of its site.
    pub(crate) fn displacement(&self, along: f64) -> f64 {
        // Force times displacement is work in either unit.
        along / self.unit
    }
}
