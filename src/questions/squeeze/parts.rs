//! Finds the sticking condition that is broken most under a set of loads, if all commands and vacuums are multiplied by a factor. A command is the
//! displacement that a finger would make if there were no object. A clearance is the gap between finger and object before the command; it is negative
//! if they overlap. The set of loads may be a force of any direction, added to a constant base load. In the code the facets of a friction cone are
//! edges.

use nalgebra::SVector;

use super::loads::Loads;
use crate::contact::{Edges, ZERO_SLACK, is_broken};
use crate::equilibrium::{ContactForces, Influence, StickingResponse, push};
use crate::grasp::{Motion, Wrench};
use crate::numerics::{Each, Harmonic, IntoList, Vector, add_times, mapped, moved, summed, tried};
use crate::prelude::*;

/// The condition `row·F >= 0` that keeps a contact sticking. F is the contact's force, a sum of several forces; `row` has the coefficients of one
/// facet of its friction cone.
pub(super) struct Condition {
    pub(super) row: SVector<f64, 3>,
    /// The value of `row·F` under `load`, N; negative if the condition is broken.
    pub(super) value: f64,
    /// Sum of the magnitudes of the forces whose sum is F, N. The rounding error of F is proportional to it.
    size: f64,
    pub(super) load: Wrench<3>,
}

/// The contact forces while all contacts stick, as a sum of two parts. One, `squeeze`, is due to the commands and vacuums at factor 1. The other,
/// `base`, is due to the loads and clearances, without commands and vacuums.
pub(super) struct ForceParts<'l> {
    loads: &'l Loads<3>,
    edges: Vec<Edges>,
    squeeze: ContactForces,
    /// Contact forces without commands and vacuums, due to the loads and clearances. For a list of loads there is an entry for each load. For a
    /// turning load there are three entries, for its constant, cosine and sine terms. For a force of any direction there is one entry, for the base
    /// load.
    base: Vec<ContactForces>,
    influences: Vec<Influence>,
}

impl<'l> ForceParts<'l> {
    pub(super) fn of(sticking: StickingResponse<'_>, loads: &'l Loads<3>) -> Result<Self, Motion<3>> {
        let grasp = sticking.grasp;
        let commands: Vec<_> = mapped(grasp.contacts(), &|contact| SVector::from(contact.commanded()));
        let vacuum = grasp.vacuum().map_or_else(Vector::zeros, |vacuum| vacuum.inside.clone());
        let squeeze = sticking.forces(&grasp.offset_changes(Some(&commands), None), &vacuum)?;
        let mut without = grasp.offsets();
        add_times(&mut without, &commands, -1.0);
        let at_rest = sticking.at_rest();
        let under = |load: &Wrench<3>| sticking.forces(&without, &(grasp.load_unchecked(load) - &vacuum));
        let mut influences = Vec::new();
        let base = match loads {
            Loads::Each(list) => tried(list, &under)?,
            Loads::AnyForce { base, point, .. } => {
                influences = sticking.influences(point)?;
                vec![under(base)?]
            }
            Loads::Turn(turn) => {
                let inside = turn.inside(grasp);
                vec![
                    sticking.forces(&without, &(inside.constant - &vacuum))?,
                    sticking.forces(&at_rest, &inside.cosine)?,
                    sticking.forces(&at_rest, &inside.sine)?,
                ]
            }
        };
        Ok(Self { loads, edges: sticking.edges, squeeze, base, influences })
    }

    /// Among the sticking conditions that are broken if commands and vacuums are multiplied by `factor`, the condition that needs the largest factor,
    /// with its contact. `None` if no condition is broken.
    pub(super) fn broken(&self, factor: f64) -> Option<(usize, Condition)> {
        let mut most: Option<(f64, usize, Condition)> = None;
        for contact in 0..self.edges.len() {
            for condition in self.worst(contact, factor) {
                if !is_broken(condition.value, &condition.row, condition.size) {
                    continue;
                }
                let gain = self.gain(contact, &condition.row);
                let missing = if gain > 0.0 { -condition.value / gain } else { f64::INFINITY };
                if most.as_ref().is_none_or(|(known, ..)| missing > *known) {
                    most = Some((missing, contact, condition));
                }
            }
        }
        most.map(|(_, contact, condition)| (contact, condition))
    }

    /// The force, N, that commands and vacuums at factor 1 add to the margin `row·F` of a sticking condition: F is the contact force, and `row` has
    /// the coefficients of the condition ([`Condition::row`]). Zero if the added force is only rounding.
    pub(super) fn gain(&self, contact: usize, row: &SVector<f64, 3>) -> f64 {
        let gain = row.dot(&self.squeeze.of[contact]);
        if gain.abs() > ZERO_SLACK * row.norm() * self.squeeze.sizes[contact] { gain } else { 0.0 }
    }

    /// The sticking conditions of a contact with the least margins (the values [`Condition::value`]) if commands and vacuums are multiplied by
    /// `factor`. For a list of loads there is one condition under each load. For a force of any direction there is one for each facet of a polygonal
    /// cone, and at most one for a round cone. Each of these conditions is evaluated in the direction of the force that is worst for it. For a
    /// turning load there is one condition at each angle where a margin is least.
    fn worst(&self, contact: usize, factor: f64) -> Vec<Condition> {
        let edges = &self.edges[contact];
        let (squeeze, pressed) = (self.squeeze.of[contact] * factor, self.squeeze.sizes[contact] * factor);
        let pressed = pressed + summed(&self.base, &|part| part.sizes[contact]);
        let at = |force: &SVector<f64, 3>, size: f64, load: Wrench<3>| {
            edges.worst(force).map(|(row, value)| Condition { row, value, size, load })
        };
        match self.loads {
            Loads::Each(list) => {
                let under = |(load, base): (&Wrench<3>, &ContactForces)| {
                    let size = self.squeeze.sizes[contact] * factor + base.sizes[contact];
                    at(&(base.of[contact] + squeeze), size, *load)
                };
                list.iter().zip(&self.base).filter_map(under).list()
            }
            Loads::AnyForce { base, size, point } => {
                let (force, influence) = (self.base[0].of[contact] + squeeze, &self.influences[contact]);
                let condition = |row: SVector<f64, 3>| {
                    let gradient = influence.gradient_of(&row);
                    let against: [f64; 3] = (gradient / -gradient.norm().max(f64::MIN_POSITIVE)).into();
                    let value = row.dot(&force) - size * gradient.norm();
                    let load = *base + push(point, &against) * *size;
                    Condition { row, value, size: pressed + influence.size * size, load }
                };
                moved(edges.on_a_sphere(&force, &influence.of, *size), &condition)
            }
            Loads::Turn(turn) => {
                let mut force = Harmonic::new([0, 1, 2].each(|k| self.base[k].of[contact]));
                force.constant += squeeze;
                let angles = edges.on_a_turn(&force, turn.whole_angle()).into_iter();
                angles.filter_map(|angle| at(&force.at(angle), pressed, turn.load_at(angle))).list()
            }
        }
    }
}
