//! The set of wrenches that the contact forces of a grasp can exert within a budget. The set is described by its support points. The budget is an
//! upper limit of the normal force of each contact, or of the sum of all normal forces. Moments are taken about a reference point and divided by a
//! reference length, both given by a [`WrenchScale`].
//!
//! The support point in the direction v is the wrench of the contact forces within the budget that do most work along v. At each contact with grasp
//! map G_i this is the force in the friction cone that does most work along the displacement `u = G_iᵀv`. On the round cone this work is `u_n + μ
//! |u_t|` per newton of normal force, with the normal and tangential components u_n and u_t. A contact whose force could only do negative work does
//! not press.

use nalgebra::SVector;

use super::budget::{Budget, WrenchScale};
use crate::contact::{Coulomb, tangential, tangential_norm};
use crate::error::Error;
use crate::grasp::{Engine, Space, Twist, Wrench};
use crate::numerics::{Map, Vector, highest, mapped, numbered, tried, unit};
use crate::object::Problem;
use crate::prelude::*;

/// The forces that one contact may exert per newton of normal force: a round cone, or the corners of a polygonal cone.
enum Cone {
    Round(Coulomb),
    Corners(Vec<SVector<f64, 3>>),
}

struct ContactCone {
    /// Maps a force in the contact frame to its wrench about the reference point, with moments divided by the reference length.
    map: Map,
    cone: Cone,
}

impl ContactCone {
    /// The force of this contact, per newton of normal force, that does most work along the motion `v`; and this work per newton.
    fn most(&self, v: &Vector) -> (SVector<f64, 3>, f64) {
        let u = self.map.tr_mul(v);
        match &self.cone {
            Cone::Round(cone) => {
                let length = tangential_norm(&u);
                let along = if length > 0.0 { tangential(&u) / length } else { unit(1) };
                let force = cone.generator(&along);
                (force, force.dot(&u))
            }
            Cone::Corners(corners) => {
                let most = highest(corners, &|force| force.dot(&u));
                most.map_or((unit(0), u[0]), |force| (*force, force.dot(&u)))
            }
        }
    }
}

/// The wrenches that contact forces within a budget can exert. Moments are about the reference point of `scale` and divided by its reference length.
pub(super) struct WrenchSet {
    space: Space,
    contacts: Vec<ContactCone>,
    budget: Budget,
    scale: WrenchScale<3>,
    /// Wrench of the suction cups' vacuum, which is added to every wrench of the set and does not depend on the contact forces.
    vacuum: Vector,
    /// Unit wrenches along which no contact force has a component. The set is widened along them, so that it has an interior; empty unless the caller
    /// sets them.
    pub(super) flat: Vec<Vector>,
}

impl WrenchSet {
    pub(super) fn new(
        problem: &Problem<'_>,
        grasp: &Engine,
        budget: Budget,
        scale: WrenchScale<3>,
        question: &'static str,
    ) -> Result<Self, Error> {
        let (space, axes) = (grasp.space(), grasp.space().axes());
        let about = SVector::from(scale.about);
        let pushing = |contact: usize| {
            let (local, frame) = (problem.local(contact), &grasp.sites()[contact].frame);
            let arm = grasp.contacts()[contact].point() - about;
            let mut map = grasp.space().grasp_map(grasp.size(), &arm, frame);
            for k in axes..grasp.size().count() {
                for a in 0..axes {
                    map[(k, a)] /= scale.length;
                }
            }
            let unlimited = local.is_bonded() || local.may_pull() || local.never_slides();
            if unlimited {
                let contact = grasp.contacts()[contact].label(contact);
                return Err(Error::Unlimited { question, contact });
            }
            let cone = local.cone();
            let corners = || mapped(&local.polygon.corners, &|corner| cone.generator(corner));
            let cone = if local.is_round() {
                Cone::Round(cone)
            } else if cone.has_edges() {
                Cone::Corners(corners())
            } else {
                Cone::Corners(vec![unit(0)])
            };
            Ok(ContactCone { map, cone })
        };
        let contacts = tried(&numbered(problem.len(), &|i| i), &|contact| pushing(*contact))?;
        let set = Self { space, contacts, budget, scale, vacuum: Vector::zeros(), flat: Vec::new() };
        Ok(Self { vacuum: set.inside(&grasp.with_vacuum(&Wrench::ZERO)), ..set })
    }

    /// The contact forces within the budget whose wrench is the support point in direction `v`.
    pub(super) fn forces(&self, v: &Vector) -> Vec<SVector<f64, 3>> {
        let (Budget::Each(bound) | Budget::Total(bound)) = self.budget;
        let mut forces = Vec::with_capacity(self.contacts.len());
        // The contact whose force does most work along `v`; the last contact among equals.
        let mut best = (0, f64::NEG_INFINITY);
        for (i, contact) in self.contacts.iter().enumerate() {
            let (force, work) = contact.most(v);
            forces.push(force * if work > 0.0 { bound } else { 0.0 });
            if work.total_cmp(&best.1).is_ge() {
                best = (i, work);
            }
        }
        if let Budget::Total(_) = self.budget {
            for (i, force) in forces.iter_mut().enumerate() {
                if i != best.0 {
                    *force = SVector::zeros();
                }
            }
        }
        forces
    }

    /// The support point in direction `v`: the wrench of the set (vacuum and widening included) that does most work along it.
    pub(super) fn support(&self, v: &Vector) -> Vector {
        let (Budget::Each(bound) | Budget::Total(bound)) = self.budget;
        let mut sum = self.vacuum.clone();
        for (contact, force) in self.contacts.iter().zip(self.forces(v)) {
            contact.map.push(&force, &mut sum);
        }
        for flat in &self.flat {
            sum.add_times(flat, bound.copysign(flat.dot(v)));
        }
        sum
    }

    /// Converts a wrench about the origin, in the user's coordinates, to a wrench about the reference point, with moments divided by the reference
    /// length.
    pub(super) fn inside(&self, wrench: &Wrench<3>) -> Vector {
        let about = SVector::from(self.scale.about);
        let moved = self.space.moved_wrench(&-about, &wrench.coordinates(self.space));
        scaled(self.space, moved, 1.0 / self.scale.length)
    }

    /// Converts a wrench about the reference point, with moments divided by the reference length, to the user's coordinates.
    pub(super) fn outside(&self, wrench: Vector) -> Wrench<3> {
        let about = SVector::from(self.scale.about);
        let wrench = scaled(self.space, wrench, self.scale.length);
        Wrench::among(self.space, &self.space.moved_wrench(&about, &wrench))
    }

    /// The motion, in the user's coordinates, that corresponds to `direction`, a vector in the coordinates of the set. Along this motion a wrench
    /// does the work `direction · w`, where w is the wrench converted by [`Self::inside`].
    pub(super) fn motion(&self, direction: Vector) -> Twist<3> {
        let about = SVector::from(self.scale.about);
        let direction = scaled(self.space, direction, 1.0 / self.scale.length);
        Twist::among(self.space, &self.space.moved_twist(&about, &direction))
    }
}

/// The vector `v` with its angular components (moments or rotations) multiplied by `by`.
fn scaled(space: Space, mut v: Vector, by: f64) -> Vector {
    v.iter_mut().skip(space.axes()).for_each(|x| *x *= by);
    v
}
