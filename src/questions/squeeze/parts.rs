//! Conditions that are broken under a set of loads at a factor of the squeeze.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::loads::Loads;
use super::sticking_response::{
    ContactForces, Push, StickingResponse, is_broken, push, round_parts, round_row,
};
use crate::contact::{Edges, ZERO_SLACK, tangential};
use crate::grasp::{Motion, Wrench};
use crate::load_path::Turn;
use crate::numerics::{Harmonic, Turning, Vector};
use crate::prelude::*;

/// A condition `row·F >= 0`, its value under a load, and the size of its forces.
pub(super) struct Condition {
    pub(super) row: SVector<f64, 3>,
    pub(super) value: f64,
    size: f64,
    pub(super) load: Wrench<3>,
}

/// Forces contact by contact, of the whole squeeze and of the loads without squeeze.
pub(super) struct Parts<'l> {
    loads: &'l Loads<3>,
    squeeze: ContactForces,
    /// Forces under each load of a list, by the three parts of a turn, or under the base load of forces of any direction.
    base: Vec<ContactForces>,
    pushes: Vec<Push>,
}

impl<'l> Parts<'l> {
    pub(super) fn of(sticking: &StickingResponse<'_>, loads: &'l Loads<3>) -> Result<Self, Motion<3>> {
        let grasp = sticking.grasp;
        let commands: Vec<_> =
            grasp.contacts().iter().map(|contact| SVector::from(contact.commanded())).collect();
        let squeeze = sticking.forces(&grasp.drive_changes(Some(&commands), None), &Vector::zeros())?;
        let mut without = grasp.drives();
        without.iter_mut().zip(&commands).for_each(|(drive, command)| *drive -= command);
        let at_rest = vec![SVector::zeros(); without.len()];
        let under = |load: &Wrench<3>| sticking.forces(&without, &grasp.load_unchecked(load));
        let mut pushes = Vec::new();
        let base = match loads {
            Loads::Each(list) => list.iter().map(under).collect::<Result<_, _>>()?,
            Loads::AnyForce { base, point, .. } => {
                pushes = sticking.pushes(point)?;
                vec![under(base)?]
            }
            Loads::Turn(turn) => {
                let inside = turn.inside(grasp);
                vec![
                    sticking.forces(&without, &inside.constant)?,
                    sticking.forces(&at_rest, &inside.cosine)?,
                    sticking.forces(&at_rest, &inside.sine)?,
                ]
            }
        };
        Ok(Self { loads, squeeze, base, pushes })
    }

    /// The broken condition at a factor that needs the most additional squeeze, with its contact.
    pub(super) fn broken(&self, sticking: &StickingResponse<'_>, factor: f64) -> Option<(usize, Condition)> {
        let mut most: Option<(f64, usize, Condition)> = None;
        for (contact, edges) in sticking.edges.iter().enumerate() {
            let conditions = match self.loads {
                Loads::Each(list) => self.under_each(list, edges, (contact, factor)),
                Loads::AnyForce { base, size, point } => {
                    self.under_any_force((base, *size, point), edges, (contact, factor))
                }
                Loads::Turn(turn) => self.under_a_turn(turn, edges, (contact, factor)),
            };
            for condition in conditions {
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

    /// The gain of a condition's value by the whole squeeze; zero where it is rounding.
    pub(super) fn gain(&self, contact: usize, row: &SVector<f64, 3>) -> f64 {
        let gain = row.dot(&self.squeeze.of[contact]);
        if gain.abs() > ZERO_SLACK * row.norm() * self.squeeze.sizes[contact] { gain } else { 0.0 }
    }

    /// The force of `factor` times the squeeze, and its size.
    fn pressed(&self, contact: usize, factor: f64) -> (SVector<f64, 3>, f64) {
        (self.squeeze.of[contact] * factor, self.squeeze.sizes[contact] * factor)
    }

    /// Under each load of a list, the condition with the least value.
    fn under_each(
        &self,
        list: &[Wrench<3>],
        edges: &Edges,
        (contact, factor): (usize, f64),
    ) -> Vec<Condition> {
        let (squeeze, size) = self.pressed(contact, factor);
        let worst = |(load, forces): (&Wrench<3>, &ContactForces)| {
            let (row, value) = edges.worst(&(forces.of[contact] + squeeze))?;
            Some(Condition { row, value, size: forces.sizes[contact] + size, load: *load })
        };
        list.iter().zip(&self.base).filter_map(worst).collect()
    }

    /// Under the worst of all forces of a size: the conditions of each facet, or of a round cone one broken facet.
    fn under_any_force(
        &self,
        (base, size, point): (&Wrench<3>, f64, &[f64; 3]),
        edges: &Edges,
        (contact, factor): (usize, f64),
    ) -> Vec<Condition> {
        let (forces, pushes) = (&self.base[0], &self.pushes[contact]);
        let (squeeze, pressed) = self.pressed(contact, factor);
        let force = forces.of[contact] + squeeze;
        let sizes = forces.sizes[contact] + pressed + pushes.size * size;
        let condition = |row: SVector<f64, 3>| {
            let felt = pushes.felt(&row);
            let against: [f64; 3] = (felt / -felt.norm().max(f64::MIN_POSITIVE)).into();
            let value = row.dot(&force) - size * felt.norm();
            Condition { row, value, size: sizes, load: *base + push(point, &against) * size }
        };
        match edges {
            Edges::Rows(rows) => rows.iter().copied().map(condition).collect(),
            Edges::Round { limit } => {
                let number = round_parts(*limit).map(|&(times, axis)| times * force[axis]);
                let turning = Turning { number, vector: pushes.turning(*limit, size) };
                turning.deepest(TAU).map(|angle| condition(round_row(*limit, angle))).into_iter().collect()
            }
        }
    }

    /// Conditions that are broken at some angle of a turn.
    fn under_a_turn(&self, turn: &Turn<3>, edges: &Edges, (contact, factor): (usize, f64)) -> Vec<Condition> {
        let (squeeze, pressed) = self.pressed(contact, factor);
        let mut force = Harmonic::new(core::array::from_fn(|k| self.base[k].of[contact]));
        force.constant += squeeze;
        let size = pressed + self.base.iter().map(|part| part.sizes[contact]).sum::<f64>();
        let margins: Vec<Turning<3>> = match edges {
            Edges::Rows(rows) => {
                let margin = |row: &SVector<f64, 3>| Turning {
                    number: force.map(|x| row.dot(x)),
                    vector: Harmonic::new([SVector::zeros(); 3]),
                };
                rows.iter().map(margin).collect()
            }
            Edges::Round { limit } => {
                vec![Turning { number: force.map(|x| limit * x[0]), vector: force.map(tangential) }]
            }
        };
        let broken = |angle: f64| {
            let (row, value) = edges.worst(&force.at(angle))?;
            Some(Condition { row, value, size, load: turn.load_at(angle) })
        };
        margins.iter().filter_map(|margin| broken(margin.deepest(turn.whole_angle())?)).collect()
    }
}
