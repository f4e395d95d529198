//! The value of each sticking condition of each contact under each load, and its derivatives with respect to the variables of the search. A sticking
//! condition is `a·F >= 0` for the contact force F and the coefficients a of one facet of its friction cone. [`Edges`] are all conditions of one
//! contact. If the goal is a late first slip, the value of a condition is the load factor that breaks it. If the goal is a reserve, it is the margin
//! `a·F` under the load. In the code a sticking condition under a load is an event. The variables are places of contacts (positions on their curves
//! or surfaces) and commanded normal forces; a design point is one choice of all of them. The base load acts before the loads of the question grow.
//! An idle contact is open or touches without force under the base load, and stays so until a load pushes it.

use core::f64::consts::TAU;

use nalgebra::{DVector, SVector};

use super::by_source::{BySource, LOADS, REST, SQUEEZE, StickingForces};
use super::goal::ImproveGoal;
use super::loaded::LoadSet;
use crate::contact::{Edges, Line, LocalLaw, tangential};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{mapped, numbered, unit, vector_of};
use crate::prelude::*;

/// Identifies one sticking condition under a load, so that the condition is found again after the contact has moved. The condition is `a·F >= 0` for
/// the contact force F, with the coefficients a of one facet of the friction cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ConeRow {
    /// Index of the load, from 0; `None` for a force of any direction.
    pub(super) load: Option<usize>,
    pub(super) contact: usize,
    /// Index, from 0, of the condition among the conditions of the same contact and load.
    pub(super) number: usize,
}

/// A sticking condition of a contact under a load.
#[derive(Debug, Clone)]
pub(super) struct SlipEvent {
    pub(super) condition: ConeRow,
    /// The load factor at which the sticking condition is broken, or for the goal of a reserve the margin of this condition under the load, N.
    pub(super) value: f64,
    /// The derivatives of the value with respect to each variable.
    pub(super) gradient: DVector<f64>,
}

/// A quantity `left` of a contact under the base load, N, that must not become negative, and its derivatives with respect to each variable.
#[derive(Debug, Clone)]
pub(super) struct Constraint {
    pub(super) contact: usize,
    pub(super) kind: ConstraintKind,
    pub(super) left: f64,
    pub(super) gradient: DVector<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ConstraintKind {
    /// A sticking condition under the base load and the commands; `left` is its margin.
    Sticks,
    /// The greatest allowed normal force of the contact under the base load; `left` is this force minus the normal force.
    Force,
    /// An idle contact, which touches without force, must not be pressed under the base load; `left` is its gap times its stiffness.
    Idle,
}

/// The coefficients a of the sticking conditions `a·F >= 0` that can become active near the contact force F = `force`. For a polygonal cone these are
/// the conditions of all its facets. For a round cone it is the facet towards the friction force, or eight facets all around if there is no friction
/// force.
fn nearest(edges: &Edges, force: &SVector<f64, 3>) -> Vec<SVector<f64, 3>> {
    let friction = tangential(force);
    edges.rows(&|_| {
        if friction.norm() > NEGLIGIBLE * force[0].abs() {
            return vec![friction[2].atan2(friction[1])];
        }
        // Without friction force all facets of the round cone are equally near, so that eight of them represent all.
        let around = 8;
        numbered(around, &|k| TAU * k as f64 / around as f64)
    })
}

/// A contact with its force under the base load, in the contact frame, N. `derivatives` has the derivatives of all contact forces with respect to
/// each variable.
struct PressedContact<'a> {
    number: usize,
    law: LocalLaw<'a>,
    edges: &'a Edges,
    goal: ImproveGoal,
    force: SVector<f64, 3>,
    derivatives: &'a [BySource],
}

impl PressedContact<'_> {
    fn by_variable(&self, f: &dyn Fn(&BySource) -> f64) -> DVector<f64> {
        DVector::from_vec(mapped(self.derivatives, f))
    }

    /// The derivative of this contact's force under the base load with respect to one variable. `d` has these derivatives for all contact forces.
    fn change(&self, d: &BySource) -> SVector<f64, 3> {
        d[REST][self.number] + d[SQUEEZE][self.number]
    }

    /// The constraints on the contact under the base load: it sticks, and its normal force is at most `most`, N, if there is a limit.
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

    /// The constraint on an idle contact under the base load: it is not pressed. `closing` is the normal force, N, that its springs would exert under
    /// the base load and the commands if it were closed. If it has a gap, `closing` is negative.
    fn keeps_off(&self, closing: f64) -> Constraint {
        let gradient = self.by_variable(&|d| -self.change(d)[0]);
        Constraint { contact: self.number, kind: ConstraintKind::Idle, left: -closing, gradient }
    }

    /// A [`SlipEvent`] for each sticking condition in `rows`. If the goal is first slip, conditions that the load cannot break are left out. `added`
    /// returns the change of a condition's margin due to the load, and `added_changes` the derivative of this change with respect to a variable.
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

    /// The [`SlipEvent`]s of this contact under the load with index `load`, which changes the contact force at the rate `rate` per unit of load
    /// factor.
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

    /// The [`SlipEvent`]s of this contact under a force of given magnitude and any direction. `influence` has one entry for each coordinate axis: the
    /// change of the contact force if this force acts along the axis.
    fn under_any_force(&self, influence: &[SVector<f64, 3>]) -> Vec<SlipEvent> {
        let gradient = |row: &SVector<f64, 3>, by: &dyn Fn(usize) -> SVector<f64, 3>| {
            vector_of(influence.len(), &|k| row.dot(&by(k)))
        };
        let known = |k: usize| influence[k];
        // The force changes the margin by g·e if e is its unit direction; g are the changes of the margin if the force acts along the axes. In the
        // worst direction, against g, the margin decreases by |g|.
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

/// All [`SlipEvent`]s (sticking conditions under loads) and all constraints under the base load of a design point. `most` has the greatest allowed
/// normal force of each contact whose command may change. `parts` are the sets of contact forces of an
/// [`EvaluatedDesign`](super::ascent::EvaluatedDesign). In the first set all idle contacts are open. In each further set the idle contacts that some
/// load closes are closed. `derivatives` has the derivatives of each set with respect to the variables.
pub(super) fn events(
    loaded: &LoadSet,
    most: &[Option<f64>],
    parts: &[StickingForces],
    derivatives: &[Vec<BySource>],
) -> (Vec<SlipEvent>, Vec<Constraint>) {
    let (mut all, mut constraints) = (Vec::new(), Vec::new());
    for (part, sticking) in parts.iter().enumerate() {
        let response = sticking.response();
        let derivatives = derivatives.get(part).map(Vec::as_slice).unwrap_or_default();
        for (number, edges) in response.edges.iter().enumerate() {
            let (law, force) = (response.law(number), sticking.at_rest(number));
            let pressed = PressedContact { number, law, edges, goal: loaded.goal, force, derivatives };
            let is_idle = parts[0].is_open(number);
            if part == 0 && is_idle {
                constraints.push(pressed.keeps_off(sticking.closing_at_rest(number)));
            } else if part == 0 {
                constraints.extend(pressed.constraints(most[number]));
            }
            // An idle contact has no force under the base load, so its force under a load is in proportion to the load. If it sticks under a small
            // load, it sticks under every multiple of it.
            let never_leaves = is_idle && loaded.goal == ImproveGoal::FirstSlip;
            if sticking.is_open(number) || never_leaves {
                continue;
            }
            let rate = |load: usize| sticking.by(LOADS + load, number);
            if loaded.any.is_some() {
                all.extend(pressed.under_any_force(&numbered(sticking.loads(), &rate)));
            } else {
                for &load in &sticking.judged {
                    all.extend(pressed.under(load, rate(load)));
                }
            }
        }
    }
    (all, constraints)
}
