//! When each condition of each contact is broken under each load, and how that changes.
//!
//! A condition of a force is `a·F >= 0`: of friction `a = (μ, ∓1)` in the plane, `(μ, -cos φ, -sin φ)` at every angle φ in space; without
//! friction, or with friction without limit, `a = (1, 0…)`.

use core::f64::consts::{PI, TAU};

use nalgebra::{DVector, SVector};

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

/// A condition, the factor of the loads at which it is broken, and its derivative by each variable.
#[derive(Debug, Clone)]
pub(super) struct SlipEvent<const C: usize> {
    pub(super) condition: ConeRow<C>,
    pub(super) factor: f64,
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
pub(super) enum Grows {
    /// That each load grows.
    Each,
    /// A force of any direction: loads are its parts along the axes.
    AnyForce,
}

/// A contact with its force at rest, and how forces change for one unit of each variable.
struct Pressed<'a, const C: usize> {
    number: usize,
    contact: &'a Contact<C>,
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

    /// When it leaves as one load grows, of which it has this rate.
    fn under(&self, load: usize, rate: &SVector<f64, C>) -> Vec<SlipEvent<C>> {
        let rows = rows(self.contact).unwrap_or_else(|| {
            let exit = leaves(self.contact.friction, &self.force, rate);
            exit.map_or(Vec::new(), |exit| worst(self.contact.friction, &(self.force + rate * exit)))
        });
        let event = |(number, row): (usize, SVector<f64, C>)| {
            let falls = row.dot(rate);
            (falls < 0.0).then(|| {
                let factor = -row.dot(&self.force) / falls;
                let gradient = self.by_variable(&|d| {
                    -row.dot(&(self.change(d) + d.loads[load][self.number] * factor)) / falls
                });
                let condition = ConeRow { load: Some(load), contact: self.number, number, row };
                SlipEvent { condition, factor, gradient }
            })
        };
        rows.into_iter().enumerate().filter_map(event).collect()
    }

    /// When it leaves under a force of any direction, whose parts along the axes are these loads.
    fn under_any_force(&self, loads: &[FrameForces<C>]) -> Vec<SlipEvent<C>> {
        let felt = |row: &SVector<f64, C>, loads: &[FrameForces<C>]| {
            SVector::<f64, C>::from_fn(|k, _| row.dot(&loads[k][self.number]))
        };
        let factor = |row: &SVector<f64, C>| row.dot(&self.force) / felt(row, loads).norm();
        let mu = self.contact.friction;
        let rows = rows(self.contact).unwrap_or_else(|| {
            let angles = worst_angles(&|angle| factor(&round(mu, angle)));
            angles.into_iter().map(|angle| round(mu, angle)).collect()
        });
        let event = |(number, row): (usize, SVector<f64, C>)| {
            let (factor, v) = (factor(&row), felt(&row, loads));
            factor.is_finite().then(|| {
                let gradient = self.by_variable(&|d| {
                    let turned = v.dot(&felt(&row, &d.loads)) / v.norm();
                    (row.dot(&self.change(d)) - factor * turned) / v.norm()
                });
                let condition = ConeRow { load: None, contact: self.number, number, row };
                SlipEvent { condition, factor, gradient }
            })
        };
        rows.into_iter().enumerate().filter_map(event).collect()
    }
}

/// All events and constraints of a placing; `most` has the greatest normal force of each contact that has one.
pub(super) fn events<const C: usize>(
    contacts: &[Contact<C>],
    asked: &Grows,
    most: &[Option<f64>],
    sticking: &StickingForces<C>,
    derivatives: &[BySource<FrameForces<C>>],
) -> (Vec<SlipEvent<C>>, Vec<Constraint>) {
    let (mut all, mut constraints) = (Vec::new(), Vec::new());
    let loads = &sticking.forces.loads;
    for (number, contact) in contacts.iter().enumerate() {
        let pressed = Pressed { number, contact, force: sticking.at_rest(number), derivatives };
        constraints.extend(pressed.constraints(most[number]));
        match asked {
            Grows::Each => {
                let each = loads.iter().enumerate();
                all.extend(each.flat_map(|(load, rates)| pressed.under(load, &rates[number])));
            }
            Grows::AnyForce => all.extend(pressed.under_any_force(loads)),
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
