//! When each condition of each contact is broken under each load, and how that changes.
//!
//! A condition of a force is `a·F >= 0`: of friction `a = (μ, ∓1)` in the plane, `(μ, -cos φ, -sin φ)` at every angle φ in space; without
//! friction, or with friction without limit, `a = (1, 0…)`.

use std::f64::consts::{PI, TAU};

use nalgebra::{DVector, SVector};

use super::sticking::{BySource, FrameForces, StickingForces};
use crate::grasp::{Contact, Hold};

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

/// All events and bounds of a placing; `most` has the greatest normal force of each contact that has one.
pub(super) fn events<const C: usize>(
    contacts: &[Contact<C>],
    asked: &Grows,
    most: &[Option<f64>],
    sticking: &StickingForces<C>,
    derivatives: &[BySource<FrameForces<C>>],
) -> (Vec<SlipEvent<C>>, Vec<Constraint>) {
    let (mut all, mut bounds) = (Vec::new(), Vec::new());
    for (i, contact) in contacts.iter().enumerate() {
        let force = sticking.at_rest(i);
        let by_variable = |f: &dyn Fn(&BySource<FrameForces<C>>) -> f64| {
            DVector::from_iterator(derivatives.len(), derivatives.iter().map(f))
        };
        let change = |d: &BySource<FrameForces<C>>| d.rest[i] + d.squeeze[i];
        let bound = |kind, row: &SVector<f64, C>, left| {
            let gradient = by_variable(&|d| row.dot(&change(d)));
            Constraint { contact: i, kind, left, gradient }
        };
        let own = rows(contact);
        let at_rest = own.clone().unwrap_or_else(|| worst(contact.friction, &force));
        bounds.extend(at_rest.iter().map(|row| bound(ConstraintKind::Sticks, row, row.dot(&force))));
        if let Some(most) = most[i] {
            let row = SVector::from_fn(|k, _| if k == 0 { -1.0 } else { 0.0 });
            bounds.push(bound(ConstraintKind::Force, &row, most - force[0]));
        }
        match asked {
            Grows::Each => {
                for (load, rates) in sticking.forces.loads.iter().enumerate() {
                    let rate = rates[i];
                    let rows = own.clone().unwrap_or_else(|| {
                        let exit = leaves(contact.friction, &force, &rate);
                        exit.map_or(Vec::new(), |exit| worst(contact.friction, &(force + rate * exit)))
                    });
                    for (number, row) in rows.into_iter().enumerate() {
                        let falls = row.dot(&rate);
                        if falls < 0.0 {
                            let factor = -row.dot(&force) / falls;
                            let gradient =
                                by_variable(&|d| -row.dot(&(change(d) + d.loads[load][i] * factor)) / falls);
                            let condition = ConeRow { load: Some(load), contact: i, number, row };
                            all.push(SlipEvent { condition, factor, gradient });
                        }
                    }
                }
            }
            Grows::AnyForce => {
                let felt = |row: &SVector<f64, C>, loads: &[FrameForces<C>]| {
                    SVector::<f64, C>::from_fn(|k, _| row.dot(&loads[k][i]))
                };
                let factor =
                    |row: &SVector<f64, C>| row.dot(&force) / felt(row, &sticking.forces.loads).norm();
                let rows = own.unwrap_or_else(|| {
                    worst_angles(&|angle| factor(&round(contact.friction, angle)))
                        .into_iter()
                        .map(|angle| round(contact.friction, angle))
                        .collect()
                });
                for (number, row) in rows.into_iter().enumerate() {
                    let (factor, v) = (factor(&row), felt(&row, &sticking.forces.loads));
                    if factor.is_finite() {
                        let gradient = by_variable(&|d| {
                            let turned = v.dot(&felt(&row, &d.loads)) / v.norm();
                            (row.dot(&change(d)) - factor * turned) / v.norm()
                        });
                        let condition = ConeRow { load: None, contact: i, number, row };
                        all.push(SlipEvent { condition, factor, gradient });
                    }
                }
            }
        }
    }
    (all, bounds)
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
