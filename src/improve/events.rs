//! When each condition of each contact is broken under each load, or what is left of it, and how that changes.
//!
//! A condition of a force is `a·F >= 0`: of friction `a = (μ, ∓1)` in the plane, `(μ, -cos φ, -sin φ)` at every angle φ in space; without
//! friction, or with friction without limit, `a = (1, 0…)`.

use core::f64::consts::{PI, TAU};

use nalgebra::{DVector, SVector};

use super::goal::ImproveGoal;
use super::sticking::{BySource, FrameForces, StickingForces};
use crate::grasp::{Contact, Hold};
use crate::prelude::*;

/// A friction force below this part of the normal force has no direction.
const NO_FRICTION: f64 = 1e-9;
/// At the tip of the round cone so many of its conditions stand for all of them.
const AT_THE_TIP: usize = 8;
/// Of a force of any direction the worst angle of a round cone is looked for among so many, and found in so many steps of halving.
const ANGLES: usize = 36;
const HALVINGS: usize = 60;

/// One condition of one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ConeRow<const C: usize> {
    /// From 0; `None` for a force of any direction.
    pub(super) load: Option<usize>,
    pub(super) contact: usize,
    /// Which of the conditions of this contact and load.
    pub(super) number: usize,
    row: SVector<f64, C>,
}

impl<const C: usize> ConeRow<C> {
    /// Whether both are of one kind, at places nearby.
    pub(super) fn is(&self, other: &Self) -> bool {
        (self.load, self.contact, self.number) == (other.load, other.contact, other.number)
    }
}

/// A condition, what the goal counts of it – the factor of the loads at which it is broken, or what is left, N –, and its derivative by each variable.
#[derive(Debug, Clone)]
pub(super) struct SlipEvent<const C: usize> {
    pub(super) condition: ConeRow<C>,
    pub(super) value: f64,
    pub(super) gradient: DVector<f64>,
}

/// Something that has to stay from 0, N, and its derivative by each variable.
#[derive(Debug, Clone)]
pub(super) struct Constraint {
    pub(super) contact: usize,
    pub(super) kind: ConstraintKind,
    pub(super) left: f64,
    pub(super) gradient: DVector<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ConstraintKind {
    /// At rest it sticks.
    Sticks,
    /// At rest it does not press harder than it may.
    Force,
}

/// The conditions of a contact that do not depend on its force; `None` of a round cone.
fn rows<const C: usize>(contact: &Contact<C>) -> Option<Vec<SVector<f64, C>>> {
    let row = |tangential: f64| SVector::from_fn(|k, _| [contact.friction, tangential][k.min(1)]);
    let normal = SVector::from_fn(|k, _| if k == 0 { 1.0 } else { 0.0 });
    let never_opens = contact.hold != Hold::Unilateral;
    match contact.friction {
        _ if contact.hold == Hold::Bonded => Some(Vec::new()),
        mu if mu == 0.0 || mu.is_infinite() => Some(if never_opens { Vec::new() } else { vec![normal] }),
        _ if C == 2 => Some(vec![row(1.0), row(-1.0)]),
        _ => None,
    }
}

fn round<const C: usize>(mu: f64, angle: f64) -> SVector<f64, C> {
    let (sin, cos) = angle.sin_cos();
    SVector::from_fn(|k, _| [mu, -cos, -sin][k])
}

/// The condition of a round cone that a force is nearest to breaking, or some of all around where it has no friction.
fn worst<const C: usize>(mu: f64, force: &SVector<f64, C>) -> Vec<SVector<f64, C>> {
    let friction = force.rows(1, C - 1).norm();
    if friction > NO_FRICTION * force[0].abs() {
        vec![SVector::from_fn(|k, _| if k == 0 { mu } else { -force[k] / friction })]
    } else {
        (0..AT_THE_TIP).map(|k| round(mu, TAU * k as f64 / AT_THE_TIP as f64)).collect()
    }
}

/// The first τ > 0 at which `F + τ G` leaves the round cone.
fn leaves<const C: usize>(mu: f64, force: &SVector<f64, C>, rate: &SVector<f64, C>) -> Option<f64> {
    let product = |a: &SVector<f64, C>, b: &SVector<f64, C>| {
        mu * mu * a[0] * b[0] - (1..C).map(|k| a[k] * b[k]).sum::<f64>()
    };
    // c + 2 b τ + a τ² falls below zero.
    let (a, b, c) = (product(rate, rate), product(force, rate), product(force, force).max(0.0));
    let root = (b * b - a * c).max(0.0).sqrt();
    let first = if b < 0.0 { c / (root - b) } else { (b + root) / -a };
    (first >= 0.0 && first.is_finite() && (a < 0.0 || b * b >= a * c && b < 0.0)).then_some(first)
}

/// What is asked of the forces.
#[derive(Debug, Clone, Copy)]
pub(super) struct AskedOfForces {
    pub(super) goal: ImproveGoal,
    pub(super) acts: Acts,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Acts {
    /// Each load, one at a time.
    Each,
    /// A force of any direction: loads are its parts along the axes.
    AnyForce,
}

/// A contact with its force at rest, and how forces change for one unit of each variable.
struct Pressed<'a, const C: usize> {
    number: usize,
    contact: &'a Contact<C>,
    goal: ImproveGoal,
    force: SVector<f64, C>,
    derivatives: &'a [BySource<FrameForces<C>>],
}

impl<const C: usize> Pressed<'_, C> {
    fn by_variable(&self, f: &dyn Fn(&BySource<FrameForces<C>>) -> f64) -> DVector<f64> {
        DVector::from_iterator(self.derivatives.len(), self.derivatives.iter().map(f))
    }

    /// How its force at rest changes.
    fn change(&self, d: &BySource<FrameForces<C>>) -> SVector<f64, C> {
        d.rest[self.number] + d.squeeze[self.number]
    }

    /// What has to stay at rest.
    fn constraints(&self, most: Option<f64>) -> Vec<Constraint> {
        let constraint = |kind, row: &SVector<f64, C>, left| {
            let gradient = self.by_variable(&|d| row.dot(&self.change(d)));
            Constraint { contact: self.number, kind, left, gradient }
        };
        let at_rest = rows(self.contact).unwrap_or_else(|| worst(self.contact.friction, &self.force));
        let sticks = |row: &SVector<f64, C>| constraint(ConstraintKind::Sticks, row, row.dot(&self.force));
        let mut all: Vec<_> = at_rest.iter().map(sticks).collect();
        if let Some(most) = most {
            let row = SVector::from_fn(|k, _| if k == 0 { -1.0 } else { 0.0 });
            all.push(constraint(ConstraintKind::Force, &row, most - self.force[0]));
        }
        all
    }

    /// An event of each condition, if the load breaks it, which adds so much to what is left; how that changes, for one unit of a variable.
    fn events(
        &self,
        load: Option<usize>,
        rows: Vec<SVector<f64, C>>,
        added: &dyn Fn(&SVector<f64, C>) -> f64,
        added_changes: &dyn Fn(&SVector<f64, C>, &BySource<FrameForces<C>>) -> f64,
    ) -> Vec<SlipEvent<C>> {
        let event = |(number, row): (usize, SVector<f64, C>)| {
            let added = added(&row);
            let value = self.goal.counts(row.dot(&self.force), added)?;
            let gradient = self.by_variable(&|d| {
                self.goal.change(value, added, [row.dot(&self.change(d)), added_changes(&row, d)])
            });
            let condition = ConeRow { load, contact: self.number, number, row };
            Some(SlipEvent { condition, value, gradient })
        };
        rows.into_iter().enumerate().filter_map(event).collect()
    }

    /// Under one load, of which it has this rate.
    fn under(&self, load: usize, rate: &SVector<f64, C>) -> Vec<SlipEvent<C>> {
        let rows = rows(self.contact).unwrap_or_else(|| {
            let mu = self.contact.friction;
            let at = match self.goal {
                ImproveGoal::FirstSlip => leaves(mu, &self.force, rate),
                ImproveGoal::Reserve => Some(1.0),
            };
            at.map_or(Vec::new(), |at| worst(mu, &(self.force + rate * at)))
        });
        self.events(Some(load), rows, &|row| row.dot(rate), &|row, d| row.dot(&d.loads[load][self.number]))
    }

    /// Under a force of any direction, whose parts along the axes are these loads.
    fn under_any_force(&self, loads: &[FrameForces<C>]) -> Vec<SlipEvent<C>> {
        let felt = |row: &SVector<f64, C>, loads: &[FrameForces<C>]| {
            SVector::<f64, C>::from_fn(|k, _| row.dot(&loads[k][self.number]))
        };
        // In the worst direction it takes all that is felt of it.
        let added = |row: &SVector<f64, C>| -felt(row, loads).norm();
        let mu = self.contact.friction;
        let rows = rows(self.contact).unwrap_or_else(|| {
            let at = |row: SVector<f64, C>| self.goal.counts(row.dot(&self.force), added(&row));
            let angles = worst_angles(&|angle| at(round(mu, angle)).unwrap_or(f64::INFINITY));
            angles.into_iter().map(|angle| round(mu, angle)).collect()
        });
        self.events(None, rows, &added, &|row, d| {
            let v = felt(row, loads);
            let size = v.norm();
            if size > 0.0 { -v.dot(&felt(row, &d.loads)) / size } else { 0.0 }
        })
    }
}

/// All events and constraints of a placing; `most` has the greatest normal force of each contact that has one.
pub(super) fn events<const C: usize>(
    contacts: &[Contact<C>],
    asked: AskedOfForces,
    most: &[Option<f64>],
    sticking: &StickingForces<C>,
    derivatives: &[BySource<FrameForces<C>>],
) -> (Vec<SlipEvent<C>>, Vec<Constraint>) {
    let (mut all, mut constraints) = (Vec::new(), Vec::new());
    let loads = &sticking.forces.loads;
    for (number, contact) in contacts.iter().enumerate() {
        let force = sticking.at_rest(number);
        let pressed = Pressed { number, contact, goal: asked.goal, force, derivatives };
        constraints.extend(pressed.constraints(most[number]));
        match asked.acts {
            Acts::Each => {
                let each = loads.iter().enumerate();
                all.extend(each.flat_map(|(load, rates)| pressed.under(load, &rates[number])));
            }
            Acts::AnyForce => all.extend(pressed.under_any_force(loads)),
        }
    }
    (all, constraints)
}

/// Angles of all minima of a function of an angle.
fn worst_angles(of: &dyn Fn(f64) -> f64) -> Vec<f64> {
    let step = TAU / ANGLES as f64;
    let values: Vec<f64> = (0..ANGLES).map(|k| of(step * k as f64)).collect();
    let lowest =
        |k: &usize| values[*k] <= values[(k + ANGLES - 1) % ANGLES] && values[*k] < values[(k + 1) % ANGLES];
    let refine = |k: usize| {
        // Between its neighbours, by the golden section.
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut from, mut to) = (step * (k as f64 - 1.0), step * (k as f64 + 1.0));
        for _ in 0..HALVINGS {
            let (a, b) = (to - golden * (to - from), from + golden * (to - from));
            if of(a) < of(b) { to = b } else { from = a }
        }
        0.5 * (from + to)
    };
    let mut angles: Vec<f64> = (0..ANGLES).filter(lowest).map(refine).collect();
    if angles.is_empty() {
        angles = (0..4).map(|k| PI * 0.5 * f64::from(k)).collect();
    }
    angles
}
