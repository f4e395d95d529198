//! The value of each condition of each contact under each load, and its derivative.
//!
//! A condition of a force is `a·F >= 0`. With friction `a = (μ, ∓1)` in the plane, and `a = (μ, -cos φ, -sin φ)` for every angle φ in space. With
//! zero or infinite friction `a = (1, 0…)`.

use core::f64::consts::{PI, TAU};

use nalgebra::{DVector, SVector};

use super::goal::ImproveGoal;
use super::sticking::{BySource, FrameForces, StickingForces};
use crate::grasp::{Contact, Hold};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{mapped, numbered};
use crate::prelude::*;

/// One condition of one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ConeRow<const C: usize> {
    /// Index of the load; `None` for a force of any direction.
    pub(super) load: Option<usize>,
    pub(super) contact: usize,
    /// Number of the condition among those of this contact and load.
    pub(super) number: usize,
    row: SVector<f64, C>,
}

impl<const C: usize> ConeRow<C> {
    /// Whether both are the same condition, at places that may differ.
    pub(super) fn is(&self, other: &Self) -> bool {
        (self.load, self.contact, self.number) == (other.load, other.contact, other.number)
    }
}

/// A condition, its value (the factor of the loads at which it is broken, or the reserve, N) and the derivatives of the value by each variable.
#[derive(Debug, Clone)]
pub(super) struct SlipEvent<const C: usize> {
    pub(super) condition: ConeRow<C>,
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

/// The conditions of a contact that do not depend on its force; `None` for a round cone, where they do.
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

/// The condition of a round cone with the least margin for a force. Without friction force, eight conditions all around.
fn worst<const C: usize>(mu: f64, force: &SVector<f64, C>) -> Vec<SVector<f64, C>> {
    let friction = force.rows(1, C - 1).norm();
    if friction > NEGLIGIBLE * force[0].abs() {
        vec![SVector::from_fn(|k, _| if k == 0 { mu } else { -force[k] / friction })]
    } else {
        // All conditions are equally close at the tip, so that some of them all around represent the cone.
        let around = 8;
        numbered(around, &|k| round(mu, TAU * k as f64 / around as f64))
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

/// The value to compute from forces, and the kind of loads.
#[derive(Debug, Clone, Copy)]
pub(super) struct AskedOfForces {
    pub(super) goal: ImproveGoal,
    pub(super) acts: Acts,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Acts {
    /// Each load, one at a time.
    Each,
    /// A force of any direction: the loads are its components along the axes.
    AnyForce,
}

/// A contact with its force at rest, and the derivatives of all forces by one unit of each variable.
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

    /// The change of its force at rest by one unit of a variable.
    fn change(&self, d: &BySource<FrameForces<C>>) -> SVector<f64, C> {
        d.rest[self.number] + d.squeeze[self.number]
    }

    /// The constraints on the contact at rest.
    fn constraints(&self, most: Option<f64>) -> Vec<Constraint> {
        let constraint = |kind, row: &SVector<f64, C>, left| {
            let gradient = self.by_variable(&|d| row.dot(&self.change(d)));
            Constraint { contact: self.number, kind, left, gradient }
        };
        let at_rest = rows(self.contact).unwrap_or_else(|| worst(self.contact.friction, &self.force));
        let sticks = |row: &SVector<f64, C>| constraint(ConstraintKind::Sticks, row, row.dot(&self.force));
        let mut all: Vec<_> = mapped(&at_rest, &sticks);
        if let Some(most) = most {
            let row = SVector::from_fn(|k, _| if k == 0 { -1.0 } else { 0.0 });
            all.push(constraint(ConstraintKind::Force, &row, most - self.force[0]));
        }
        all
    }

    /// An event for each condition that the load can break. `added` is the part that the load adds to its margin, `added_changes` the change of that
    /// by one unit of a variable.
    fn events(
        &self,
        load: Option<usize>,
        rows: Vec<SVector<f64, C>>,
        added: &dyn Fn(&SVector<f64, C>) -> f64,
        added_changes: &dyn Fn(&SVector<f64, C>, &BySource<FrameForces<C>>) -> f64,
    ) -> Vec<SlipEvent<C>> {
        let mut events = Vec::new();
        for (number, row) in rows.into_iter().enumerate() {
            let added = added(&row);
            let Some(value) = self.goal.counts(row.dot(&self.force), added) else { continue };
            let gradient = self.by_variable(&|d| {
                self.goal.change(value, added, [row.dot(&self.change(d)), added_changes(&row, d)])
            });
            let condition = ConeRow { load, contact: self.number, number, row };
            events.push(SlipEvent { condition, value, gradient });
        }
        events
    }

    /// Events under one load, under which the force changes by `rate`.
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

    /// Events under a force of any direction, whose components along the axes are `loads`.
    fn under_any_force(&self, loads: &[FrameForces<C>]) -> Vec<SlipEvent<C>> {
        let felt = |row: &SVector<f64, C>, loads: &[FrameForces<C>]| {
            SVector::<f64, C>::from_fn(|k, _| row.dot(&loads[k][self.number]))
        };
        // The worst direction reduces the margin by the norm of its gradient.
        let added = |row: &SVector<f64, C>| -felt(row, loads).norm();
        let mu = self.contact.friction;
        let rows = rows(self.contact).unwrap_or_else(|| {
            let at = |row: SVector<f64, C>| self.goal.counts(row.dot(&self.force), added(&row));
            let angles = worst_angles(&|angle| at(round(mu, angle)).unwrap_or(f64::INFINITY));
            mapped(&angles, &|angle| round(mu, *angle))
        });
        self.events(None, rows, &added, &|row, d| {
            let v = felt(row, loads);
            let size = v.norm();
            if size > 0.0 { -v.dot(&felt(row, &d.loads)) / size } else { 0.0 }
        })
    }
}

/// All events and constraints of a placing; `most` has the greatest allowed normal force of each contact, if it has one.
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
                for (load, rates) in loads.iter().enumerate() {
                    all.extend(pressed.under(load, &rates[number]));
                }
            }
            Acts::AnyForce => all.extend(pressed.under_any_force(loads)),
        }
    }
    (all, constraints)
}

/// The angles of all local minima of a periodic function of an angle.
fn worst_angles(of: &dyn Fn(f64) -> f64) -> Vec<f64> {
    // Fewer samples can pass over a narrow minimum.
    let count = 36;
    let step = TAU / count as f64;
    let values: Vec<f64> = numbered(count, &|k| of(step * k as f64));
    let lowest =
        |k: &usize| values[*k] <= values[(k + count - 1) % count] && values[*k] < values[(k + 1) % count];
    let refine = |k: usize| {
        // The neighbours enclose the minimum for a golden section.
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut from, mut to) = (step * (k as f64 - 1.0), step * (k as f64 + 1.0));
        for _ in 0..60 {
            let (a, b) = (to - golden * (to - from), from + golden * (to - from));
            if of(a) < of(b) { to = b } else { from = a }
        }
        0.5 * (from + to)
    };
    let mut angles: Vec<f64> = (0..count).filter(lowest).map(refine).collect();
    if angles.is_empty() {
        angles = numbered(4, &|k| PI * 0.5 * k as f64);
    }
    angles
}
