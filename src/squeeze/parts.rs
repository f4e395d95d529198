//! What is broken under a set of loads at some factor of the squeeze.

use std::f64::consts::TAU;

use nalgebra::SVector;

use super::loads::Loads;
use super::rolling::{Rolling, felt, is_broken, push, round_row, worst_row};
use crate::contact::Edges;
use crate::grasp::{Twist, Wrench};
use crate::load_path::{InsideTurn, Turn};
use crate::numerics::Turning;

/// A condition `row·F >= 0`, its value under a load, and the size of its forces.
pub(super) struct Condition<const D: usize, const C: usize> {
    pub(super) row: SVector<f64, C>,
    pub(super) value: f64,
    size: f64,
    pub(super) load: Wrench<D, C>,
}

/// Forces contact by contact, of the whole squeeze and of the loads without it.
pub(super) struct Parts<'l, const D: usize, const C: usize> {
    loads: &'l Loads<D, C>,
    pub(super) squeeze: Vec<SVector<f64, C>>,
    /// For each load of a list; of a turn its three parts; of forces of any direction that of the base.
    base: Vec<Vec<SVector<f64, C>>>,
    /// Of 1 N along each axis.
    pushes: Vec<[SVector<f64, C>; C]>,
}

impl<'l, const D: usize, const C: usize> Parts<'l, D, C> {
    pub(super) fn of(rolling: &Rolling<'_, D, C>, loads: &'l Loads<D, C>) -> Result<Self, Twist<D, C>> {
        let grasp = rolling.grasp;
        let commands: Vec<_> =
            grasp.contacts().iter().map(|contact| SVector::from(contact.commanded())).collect();
        let squeeze = rolling.forces(&grasp.drive_changes(Some(&commands), None), &SVector::zeros())?;
        let mut without = grasp.drives();
        without.iter_mut().zip(&commands).for_each(|(drive, command)| *drive -= command);
        let at_rest = vec![SVector::zeros(); without.len()];
        let under = |load: &Wrench<D, C>| rolling.forces(&without, &grasp.load_unchecked(load));
        let mut pushes = Vec::new();
        let base = match loads {
            Loads::Each(list) => list.iter().map(under).collect::<Result<_, _>>()?,
            Loads::AnyForce { base, point, .. } => {
                pushes = rolling.forces_of_pushes(point)?;
                vec![under(base)?]
            }
            Loads::Turn(turn) => {
                let inside = InsideTurn::of(grasp, turn);
                vec![
                    rolling.forces(&without, &inside.constant)?,
                    rolling.forces(&at_rest, &inside.cosine)?,
                    rolling.forces(&at_rest, &inside.sine)?,
                ]
            }
        };
        Ok(Self { loads, squeeze, base, pushes })
    }

    /// The condition that is broken at a factor and asks for most squeeze, with its contact.
    pub(super) fn broken(
        &self,
        rolling: &Rolling<'_, D, C>,
        factor: f64,
    ) -> Option<(usize, Condition<D, C>)> {
        let mut most: Option<(f64, usize, Condition<D, C>)> = None;
        for (contact, edges) in rolling.edges.iter().enumerate() {
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
                let gain = condition.row.dot(&self.squeeze[contact]);
                let missing = if gain > 0.0 { -condition.value / gain } else { f64::INFINITY };
                if most.as_ref().is_none_or(|(known, ..)| missing > *known) {
                    most = Some((missing, contact, condition));
                }
            }
        }
        most.map(|(_, contact, condition)| (contact, condition))
    }

    /// Under each load of a list the condition that its force breaks most.
    fn under_each(
        &self,
        list: &[Wrench<D, C>],
        edges: &Edges<C>,
        (contact, factor): (usize, f64),
    ) -> Vec<Condition<D, C>> {
        let squeeze = self.squeeze[contact] * factor;
        let worst = |(load, forces): (&Wrench<D, C>, &Vec<SVector<f64, C>>)| {
            let size = forces[contact].norm() + squeeze.norm();
            let (row, value) = worst_row(edges, &(forces[contact] + squeeze))?;
            Some(Condition { row, value, size, load: *load })
        };
        list.iter().zip(&self.base).filter_map(worst).collect()
    }

    /// Under the worst of all forces of a size: of each facet, and of the facets of a round cone one that it breaks.
    fn under_any_force(
        &self,
        (base, size, point): (&Wrench<D, C>, f64, &[f64; C]),
        edges: &Edges<C>,
        (contact, factor): (usize, f64),
    ) -> Vec<Condition<D, C>> {
        let (forces, columns) = (self.base[0][contact], &self.pushes[contact]);
        let squeeze = self.squeeze[contact] * factor;
        let force = forces + squeeze;
        let reach = columns.iter().map(SVector::norm).sum::<f64>() * size;
        let condition = |row: SVector<f64, C>| {
            let felt = felt(columns, &row);
            let against: [f64; C] = (felt / -felt.norm().max(f64::MIN_POSITIVE)).into();
            let value = row.dot(&force) - size * felt.norm();
            let load = *base + push(point, &against) * size;
            Condition { row, value, size: forces.norm() + squeeze.norm() + reach, load }
        };
        match edges {
            Edges::Rows(rows) => rows.iter().copied().map(condition).collect(),
            Edges::Round { limit } => {
                let parts = [(*limit, 0), (-1.0, 1), (-1.0, C - 1)];
                let along = |(times, axis): (f64, usize)| {
                    SVector::<f64, C>::from_fn(|k, _| times * size * columns[k][axis])
                };
                let turning = Turning {
                    number: parts.map(|(times, axis)| times * force[axis]),
                    vector: parts.map(along),
                };
                turning.deepest(TAU).map(|angle| condition(round_row(*limit, angle))).into_iter().collect()
            }
        }
    }

    /// Where in a turn a condition is broken.
    fn under_a_turn(
        &self,
        turn: &Turn<D, C>,
        edges: &Edges<C>,
        (contact, factor): (usize, f64),
    ) -> Vec<Condition<D, C>> {
        let parts: [_; 3] = std::array::from_fn(|k| self.base[k][contact]);
        let squeeze = self.squeeze[contact] * factor;
        let waves = [parts[0] + squeeze, parts[1], parts[2]];
        let size = squeeze.norm() + parts.iter().map(SVector::norm).sum::<f64>();
        let tangential =
            |x: SVector<f64, C>| SVector::<f64, C>::from_fn(|k, _| if k == 0 { 0.0 } else { x[k] });
        let margins: Vec<Turning<C>> = match edges {
            Edges::Rows(rows) => {
                let margin = |row: &SVector<f64, C>| Turning {
                    number: waves.map(|x| row.dot(&x)),
                    vector: [SVector::zeros(); 3],
                };
                rows.iter().map(margin).collect()
            }
            Edges::Round { limit } => {
                vec![Turning { number: waves.map(|x| limit * x[0]), vector: waves.map(tangential) }]
            }
        };
        let broken = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let (row, value) = worst_row(edges, &(waves[0] + waves[1] * cos + waves[2] * sin))?;
            Some(Condition { row, value, size, load: turn.load_at(angle) })
        };
        margins.iter().filter_map(|margin| broken(margin.deepest(turn.whole_angle())?)).collect()
    }
}
