//! Every contact state and every direction of sliding, by sectors: a proof that no equilibrium exists on the round cone, or the
//! equilibrium that Newton's method missed.
//!
//! A contact is undecided, open, rolling, or slides in a direction within a sector between unit tangents d₁ and d₂. For each
//! of these the contact law implies linear conditions on twist and forces,
//!
//! ```text
//! undecided    N >= 0,  N >= k_n v_n,  h·F_t <= μ N                         with tangents h of the circle
//! open         F = 0,   v_n <= 0
//! rolling      F = K v, v_n >= 0,      h·F_t <= μ N
//! sliding      N = k_n v_n >= 0,       F_t = α d₁ + β d₂,  α, β >= 0,  α + β >= μ N,  d₁·F_t, d₂·F_t <= μ N,
//!              v_t - K_t⁻¹F_t between d₁ and d₂
//! ```
//!
//! weaker than the law, and the weaker the wider the sector. Where they contradict equilibrium (by the multipliers of a least-squares
//! problem, found by Lemke's method) no equilibrium has these states. Where they do not, a contact is decided or the
//! widest sector halved, until nothing is left or Newton's method arrives.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::answer::Found;
use super::candidate::{Verdict, try_states};
use super::polish::polish;
use super::sector_conditions::{Conditions, Label};
use crate::contact::{LocalLaw, Mode, tangential_norm};
use crate::object::{PieceState, Problem};

/// Sectors are not halved below this width: directions as close as that are told apart by Newton's method or not at all.
const NARROWEST: f64 = 1e-3;
/// Tangents of the circle at first; more are added where a rolling force lies outside.
const TANGENTS: usize = 8;
const MOST_TANGENTS: usize = 24;
/// A rolling force may lie outside its cone by this part before a tangent is added for the cases to come.
const NEARLY: f64 = 1e-3;
/// With more contacts that may slide the cases are too many.
const MOST_CONTACTS: usize = 5;

/// How the search ends.
#[derive(Debug, Clone)]
pub(super) enum Sectors<const D: usize, const C: usize> {
    Found(Found<D, C>),
    /// Each of so many cases contradicts equilibrium.
    NoneOf(usize),
    Unresolved,
}

/// Searches every case, at most so many.
pub(super) fn search_sectors<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    most_cases: usize,
) -> Sectors<D, C> {
    let mut tangents =
        vec![(0..TANGENTS).map(|j| TAU * j as f64 / TANGENTS as f64).collect::<Vec<_>>(); problem.len()];
    if problem.locals().filter(LocalLaw::may_slide).count() > MOST_CONTACTS {
        return Sectors::Unresolved;
    }
    let mut cases = vec![vec![Label::Undecided; problem.len()]];
    let (mut tried, mut unresolved) = (0, false);
    while let Some(labels) = cases.pop() {
        tried += 1;
        if tried > most_cases {
            return Sectors::Unresolved;
        }
        let Some(near) = conditions_met(problem, &labels, &mut tangents) else { continue };
        if let Some(contact) = labels.iter().position(|label| *label == Label::Undecided) {
            cases.extend(
                decisions(&problem.local(contact)).into_iter().map(|label| with(&labels, contact, label)),
            );
            continue;
        }
        let width = |label: &Label| if let Label::Sector(from, to) = label { to - from } else { 0.0 };
        let widest = (0..labels.len()).max_by(|&i, &j| width(&labels[i]).total_cmp(&width(&labels[j])));
        let Some(contact) = widest.filter(|&i| width(&labels[i]) > 0.0) else {
            // Nothing slides: one linear system decides.
            let states = labels.iter().map(|l| if *l == Label::Open { Mode::Open } else { Mode::Rolling });
            match try_states(problem, states.collect()) {
                Verdict::Holds(found) => return Sectors::Found(found),
                Verdict::Violated { doubtful } => unresolved |= doubtful,
                Verdict::Unbalanced => {}
            }
            continue;
        };
        let states = labels.iter().map(|label| match label {
            Label::Open => Mode::Open,
            Label::Sector(..) => Mode::Facet(0),
            _ => Mode::Rolling,
        });
        if let Some(found) = polish(problem, &states.collect::<Vec<_>>(), &near) {
            return Sectors::Found(found);
        }
        let Label::Sector(from, to) = labels[contact] else { continue };
        if to - from <= NARROWEST {
            unresolved = true;
            continue;
        }
        let middle = 0.5 * (from + to);
        cases.push(with(&labels, contact, Label::Sector(from, middle)));
        cases.push(with(&labels, contact, Label::Sector(middle, to)));
    }
    if unresolved { Sectors::Unresolved } else { Sectors::NoneOf(tried) }
}

fn with(labels: &[Label], contact: usize, label: Label) -> Vec<Label> {
    let mut labels = labels.to_vec();
    labels[contact] = label;
    labels
}

/// What an undecided contact can be.
fn decisions<const C: usize>(local: &LocalLaw<'_, C>) -> Vec<Label> {
    let mut labels = Vec::new();
    if local.may_slide() {
        let quarter = |k: usize| FRAC_PI_2 * k as f64 - PI;
        labels.extend((0..4).map(|k| Label::Sector(quarter(k), quarter(k + 1))));
    }
    if local.may_open() {
        labels.push(Label::Open);
    }
    labels.push(Label::Rolling);
    labels
}

/// Twist and forces that meet the conditions, unless they contradict each other. Where a rolling force would lie
/// outside its cone the circle gets a tangent more.
fn conditions_met<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    labels: &[Label],
    tangents: &mut [Vec<f64>],
) -> Option<PieceState<D, C>> {
    let near = Conditions::new(problem, labels, tangents).meet()?;
    for (i, label) in labels.iter().enumerate() {
        let (force, list) = (&near.forces[i], &mut tangents[i]);
        let local = problem.local(i);
        let outside = tangential_norm(force) > local.cone().limit(force[0]) * (1.0 + NEARLY);
        if *label == Label::Rolling && local.may_slide() && outside && list.len() < MOST_TANGENTS {
            list.push(force[2].atan2(force[1]));
        }
    }
    Some(near)
}
