//! An equilibrium on the round cone, or a proof that none exists: branch and bound over contact states. The elastic trial is the solution in which
//! every contact sticks.
//!
//! A case restricts each contact by a [`Label`], for example to being closed, or to friction directions between two angles. The first case restricts
//! no contact. In the relaxation of a case each contact law is replaced by its convex hull ([`super::relaxed`]). The relaxation either contradicts
//! the case, or gives every contact a stretch of its springs and a force. In some cases Newton's method starts from these stretches and forces.
//! Unless it converges, the label of the contact whose force is farthest from its law is divided into two labels, which make two cases. Every
//! division brings the relaxation closer to the law, until cases are contradicted or Newton's method converges.

use alloc::rc::Rc;

use nalgebra::SVector;

use super::answer::{Doubt, SearchSolution};
use super::polish::polish_from;
use super::relaxed::{BalanceEquation, GeneratorIndex, Relaxed};
use super::settings::Settings;
use crate::contact::{HullRay, Label, LocalLaw};
use crate::numerics::{IntoList, NearestPoint, Vector, paired};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;
use crate::proofs::ProofStep;

/// The result of branch and bound over the states of contacts on the round cone.
#[derive(Debug, Clone)]
pub(super) enum BranchAndBound {
    Found(SearchSolution),
    /// Each case was proved to have no equilibrium. Rounding can hide from this proof only an equilibrium that is larger than the elastic trial by at
    /// least the factor `escape`.
    Contradicted {
        cases: usize,
        escape: f64,
    },
    Unresolved(Doubt),
}

type Hull = Rc<[HullRay]>;

struct Case {
    labels: Vec<Label>,
    hulls: Vec<Hull>,
    nearest: Rc<NearestPoint<GeneratorIndex>>,
    /// The contact whose label was divided into two labels to make this case and its sibling; `None` for the first case.
    divided: Option<usize>,
}

/// Whether branch and bound is needed because some contact has a round cone. Without round cones it suffices to try all combinations of contact
/// states. False in a rate problem (for derivatives along a load path) with a contact on the boundary of its cone (`edge` in code names). The law of
/// such a contact has a plane facet in place of the cone.
pub(super) fn has_round_cones(problem: &Problem) -> bool {
    problem.locals().any(|local| local.is_round()) && !problem.locals().any(|local| local.is_on_an_edge())
}

/// The number of cases that costs as much as [`Settings::most_states`] combinations of contact states. Zero if no contact has a round cone, or there
/// are more than 32 contacts.
pub(super) fn most_cases(problem: &Problem, settings: &Settings) -> usize {
    // With more than 32 contacts branch and bound reaches its limit of cases without a result.
    if problem.len() > 32 || !has_round_cones(problem) {
        return 0;
    }
    // A case of n contacts takes as long as n³/400 combinations of contact states.
    let by_size = settings.most_states.saturating_mul(400) / problem.len().pow(3);
    // However few contacts there are, a case costs at least as much as five combinations.
    by_size.min(settings.most_states / 5)
}

/// Branch and bound over at most `most_cases` cases of contact states, on the round cone. `state` is the solution of the elastic trial `trial`, in
/// which everything sticks. If the result is `Contradicted`, `record` has received the steps of the proof.
pub(super) fn search_tree(
    problem: &Problem,
    trial: &LinearProblem,
    state: &ForcesAndTwist,
    most_cases: usize,
    mut record: Option<&mut Vec<ProofStep>>,
) -> BranchAndBound {
    let Some(balance) = BalanceEquation::new(problem, trial, state) else {
        return BranchAndBound::Unresolved(Doubt::RayWithoutProof);
    };
    let hull = |local: LocalLaw<'_>, label: &Label| Hull::from(local.hull(label));
    let labels = problem.each(|local| local.first_label());
    let hulls = problem.locals().zip(&labels).map(|(local, label)| hull(local, label)).list();
    let mut open = vec![Case { labels, hulls, nearest: Rc::new(balance.start()), divided: None }];
    let (mut cases, mut least_escape, mut narrow) = (0, f64::INFINITY, false);
    while let Some(Case { labels, hulls, nearest, divided }) = open.pop() {
        if cases == most_cases {
            return BranchAndBound::Unresolved(Doubt::RayWithoutProof);
        }
        cases += 1;
        let mut nearest = Rc::unwrap_or_clone(nearest);
        nearest.remove_tags(|(contact, _)| divided == Some(contact));
        let (stretches, forces) = match balance.relax(&hulls, &mut nearest) {
            Relaxed::Met(stretches, forces) => (stretches, forces),
            Relaxed::Contradicted { escape } => {
                least_escape = least_escape.min(escape);
                if let Some(steps) = &mut record {
                    let (motion, forces) = balance.contradiction(trial, &nearest);
                    steps.push(ProofStep::Contradicted { motion, forces });
                }
                continue;
            }
        };
        if !stretches.iter().chain(&forces).all(|x| x.iter().all(|x| x.is_finite())) {
            return BranchAndBound::Unresolved(Doubt::Inaccurate);
        }
        let (contact, error) = farthest_from_the_law(problem, &balance, &labels, &stretches, &forces);
        // Newton's method starts from every fourth case only, since it takes as long as a few cases.
        let every = 4;
        // If the forces of a case deviate from the contact laws by at most 1e-10 of the norm of the elastic trial forces, the case is a solution up
        // to rounding. Newton's method then starts from it even if it is not a fourth case.
        let at_the_law = 1e-10;
        if (cases - 1) % every == 0 || error <= at_the_law {
            let from: Vec<_> = paired(&problem.offsets, &stretches, &|(a, v)| a - v);
            let twist = trial.solve_roughly(&from, &Vector::zeros()).twist;
            if let Some(found) = polish_from(problem, twist) {
                return BranchAndBound::Found(found);
            }
        }
        let local = problem.local(contact);
        let Some(halves) = local.divide(&labels[contact], &stretches[contact], &forces[contact]) else {
            narrow = true;
            continue;
        };
        if let Some(steps) = &mut record {
            steps.push(ProofStep::Divided { contact, halves });
        }
        let nearest = Rc::new(nearest);
        for label in halves {
            let (mut labels, mut hulls) = (labels.clone(), hulls.clone());
            (labels[contact], hulls[contact]) = (label, hull(local, &label));
            open.push(Case { labels, hulls, nearest: nearest.clone(), divided: Some(contact) });
        }
    }
    if narrow {
        BranchAndBound::Unresolved(Doubt::OnTheBoundary)
    } else {
        BranchAndBound::Contradicted { cases, escape: least_escape }
    }
}

/// Searches for a proof that no equilibrium exists on the round cone. Returns the steps of the proof (divisions into cases, and contradictions) and
/// the number of all cases. `None` if the search finds an equilibrium, or reaches its limit of cases. `None` also if no contact has a round cone, or
/// there are more than 32 contacts.
pub(crate) fn refute(problem: &Problem, settings: &Settings) -> Option<(Vec<ProofStep>, usize)> {
    let most = most_cases(problem, settings);
    if most == 0 {
        return None;
    }
    let trial = problem.trial();
    let state = trial.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
    let mut steps = Vec::new();
    match search_tree(problem, &trial, &state, most, Some(&mut steps)) {
        BranchAndBound::Contradicted { cases, .. } => Some((steps, cases)),
        BranchAndBound::Found(_) | BranchAndBound::Unresolved(_) => None,
    }
}

/// The contact whose label is to be divided next, and the largest distance from the law. The distance of a contact from its law is the difference
/// between its force and the force that the law gives at its stretch. It is in energy units, divided by the norm of the elastic trial forces. The
/// label of the contact with the largest distance is divided. The distance of a contact whose label restricts nothing yet counts three times.
fn farthest_from_the_law(
    problem: &Problem,
    balance: &BalanceEquation,
    labels: &[Label],
    stretches: &[SVector<f64, 3>],
    forces: &[SVector<f64, 3>],
) -> (usize, f64) {
    let (mut farthest, mut worst) = (0, -1.0);
    let mut error = 0.0_f64;
    for (contact, local) in problem.locals().enumerate() {
        let answer = local.answer(&stretches[contact], 0.0);
        let imbalance = balance.part(contact, &(forces[contact] - answer.force));
        error = error.max(imbalance);
        // Labels that restrict nothing yet are preferred, by the factor 3. As long as a contact has such a label, divisions of the labels of other
        // contacts contribute little to a contradiction.
        let weighed = if labels[contact] == Label::Anything { 3.0 * imbalance } else { imbalance };
        if weighed > worst {
            (farthest, worst) = (contact, weighed);
        }
    }
    (farthest, error)
}
