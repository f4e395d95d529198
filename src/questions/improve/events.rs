//! The value of each condition of each contact under each load, and its derivative.

use core::f64::consts::TAU;

use nalgebra::{DVector, SVector};

use super::by_source::{BySource, LOADS, REST, SQUEEZE, StickingForces};
use super::goal::ImproveGoal;
use super::loaded::Loaded;
use crate::contact::{Edges, Line, LocalLaw, tangential};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{mapped, numbered, unit, vector_of};
use crate::prelude::*;

/// Identifies a condition of a contact, also after the contact has moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ConeRow {
    /// Index of the load; `None` for a force of any direction.
    pub(super) load: Option<usize>,
    pub(super) contact: usize,
    /// Number of the condition among those of this contact and load.
    pub(super) number: usize,
}

/// A condition, its value (the load factor at which it is broken, or the reserve, N) and the derivatives of the value by each variable.
#[derive(Debug, Clone)]
pub(super) struct SlipEvent {
    pub(super) condition: ConeRow,
    pub(super) value: f64,
    pub(super) gradient: DVector<f64>,
}

/// A quantity that must stay at or above zero, `left` in N, and its derivatives by each variable.
#[derive(Debug, Clone)]
pub(super) struct Constraint {
    pub(super) contact: usize,
    pub(super) kind: ConstraintKind,
    pub(super) left: f64,
    pub(super) gradient: DVector<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ConstraintKind {
    /// The contact sticks at rest.
    Sticks,
    /// The contact at rest presses at most with its greatest allowed force.
    Force,
}

/// The critical conditions at a force: all facets of a polygon; on the round cone the facet nearest to the friction force, or eight facets all around
/// without such a force.
fn nearest(edges: &Edges, force: &SVector<f64, 3>) -> Vec<SVector<f64, 3>> {
    let friction = tangential(force);
    edges.rows(&|_| {
        if friction.norm() > NEGLIGIBLE * force[0].abs() {
            return vec![friction[2].atan2(friction[1])];
        }
        // All conditions are equally close at the tip, so that some of them all around represent the cone.
        let around = 8;
        numbered(around, &|k| TAU * k as f64 / around as f64)
    })
}

/// A contact with its force at rest, and the derivatives of all forces by one unit of each variable.
struct Pressed<'a> {
    number: usize,
    law: LocalLaw<'a>,
    edges: &'a Edges,
    goal: ImproveGoal,
    force: SVector<f64, 3>,
    derivatives: &'a [BySource],
}

impl Pressed<'_> {
    fn by_variable(&self, f: &dyn Fn(&BySource) -> f64) -> DVector<f64> {
        DVector::from_iterator(self.derivatives.len(), self.derivatives.iter().map(f))
    }

    /// The change of its force at rest by one unit of a variable.
    fn change(&self, d: &BySource) -> SVector<f64, 3> {
        d[REST][self.number] + d[SQUEEZE][self.number]
    }

    /// The constraints on the contact at rest.
    fn constraints(&self, most: Option<f64>) -> Vec<Constraint> {
        let constraint = |kind, row: &SVector<f64, 3>, left| {
            let gradient = self.by_variable(&|d| row.dot(&self.change(d)));
            Constraint { contact: self.number, kind, left, gradient }
        };
        let sticks = |row: &SVector<f64, 3>| constraint(ConstraintKind::Sticks, row, row.dot(&self.force));
        let mut all: Vec<_> = mapped(&nearest(self.edges, &self.force), &sticks);
        if let Some(most) = most {
            all.push(constraint(ConstraintKind::Force, &-unit(0), most - self.force[0]));
        }
        all
    }

    /// An event for each condition that the load can break. `added` is the part that the load adds to its margin, `added_changes` the change of that
    /// by one unit of a variable.
    fn events(
        &self,
        load: Option<usize>,
        rows: Vec<SVector<f64, 3>>,
        added: &dyn Fn(&SVector<f64, 3>) -> f64,
        added_changes: &dyn Fn(&SVector<f64, 3>, &BySource) -> f64,
    ) -> Vec<SlipEvent> {
        let mut events = Vec::new();
        for (number, row) in rows.into_iter().enumerate() {
            let added = added(&row);
            let Some(value) = self.goal.counts(row.dot(&self.force), added) else { continue };
            let gradient = self.by_variable(&|d| {
                self.goal.change(value, added, [row.dot(&self.change(d)), added_changes(&row, d)])
            });
            let condition = ConeRow { load, contact: self.number, number };
            events.push(SlipEvent { condition, value, gradient });
        }
        events
    }

    /// Events under one load, under which the force changes by `rate`.
    fn under(&self, load: usize, rate: SVector<f64, 3>) -> Vec<SlipEvent> {
        let force = self.force;
        let line = Line { force, rate, force_size: force.norm(), rate_size: rate.norm() };
        let at = match self.goal {
            ImproveGoal::FirstSlip => self.law.first_exit(&line).map(|(exit, _)| exit.step),
            ImproveGoal::Reserve => Some(1.0),
        };
        let rows = at.map_or(Vec::new(), |at| nearest(self.edges, &(force + rate * at)));
        self.events(Some(load), rows, &|row| row.dot(&rate), &|row, d| row.dot(&d[LOADS + load][self.number]))
    }

    /// Slip events under a force of given size and any direction. Column k of `influence` is the contact force under this force along axis k.
    fn under_any_force(&self, influence: &[SVector<f64, 3>]) -> Vec<SlipEvent> {
        let gradient = |row: &SVector<f64, 3>, by: &dyn Fn(usize) -> SVector<f64, 3>| {
            vector_of(influence.len(), &|k| row.dot(&by(k)))
        };
        let known = |k: usize| influence[k];
        // The worst direction reduces the margin by the norm of its gradient.
        let added = |row: &SVector<f64, 3>| -gradient(row, &known).norm();
        let value = |row: &SVector<f64, 3>| self.goal.counts(row.dot(&self.force), added(row));
        let rows = self.edges.least(&|row| value(row).unwrap_or(f64::INFINITY));
        self.events(None, rows, &added, &|row, d| {
            let v = gradient(row, &known);
            let size = v.norm();
            let changes = gradient(row, &|k| d[LOADS + k][self.number]);
            if size > 0.0 { -v.dot(&changes) / size } else { 0.0 }
        })
    }
}

/// All events and constraints of a placing; `most` has the greatest allowed normal force of each contact, if it has one.
pub(super) fn events(
    loaded: &Loaded,
    most: &[Option<f64>],
    sticking: &StickingForces,
    derivatives: &[BySource],
) -> (Vec<SlipEvent>, Vec<Constraint>) {
    let (mut all, mut constraints) = (Vec::new(), Vec::new());
    let response = sticking.response();
    for (number, edges) in response.edges.iter().enumerate() {
        let (law, force) = (response.law(number), sticking.at_rest(number));
        let pressed = Pressed { number, law, edges, goal: loaded.goal, force, derivatives };
        constraints.extend(pressed.constraints(most[number]));
        let by_loads = numbered(sticking.loads(), &|load| sticking.by(LOADS + load, number));
        if loaded.any.is_some() {
            all.extend(pressed.under_any_force(&by_loads));
        } else {
            for (load, rate) in by_loads.into_iter().enumerate() {
                all.extend(pressed.under(load, rate));
            }
        }
    }
    (all, constraints)
}
