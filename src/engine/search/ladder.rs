//! The ladder: methods, called rungs, that find an equilibrium or prove that none exists. They are tried in order until a method finds an equilibrium
//! or a proof that none exists.
//!
//! The elastic trial, in which everything sticks, is tried before the first rung. A rung costs more than the rungs before it, or ends the search less
//! often. Some rungs look for a separating motion: a virtual motion along which the load does positive work and no admissible contact force does
//! negative work. Others solve complementarity problems: the kinematic form, whose unknowns are gaps and slips, and the force form, whose unknowns
//! are contact forces.

use super::answer::{Doubt, FoundBy, SearchCounts, SearchOutcome, SearchSolution};
use super::candidate::{RejectedStates, admit};
use super::elastic_trial::{Attempt, ElasticTrial, SearchLog};
use super::enumerate::search;
use super::least_motion::at_the_least_motion;
use super::leaving::{propose_near_a_similar_one, propose_of_the_leaving};
use super::polish::polish_from;
use super::proposals::{dense_is_affordable, enumerable, equilibrium_by_proposals, propose_dense};
#[cfg(feature = "std")]
use super::record::record;
use super::settings::Settings;
use super::tolerances::{MANY_CONTACTS, MOST_WORK, NEAR_THE_RELAXED_STATE, SEVERAL_CONTACTS};
use super::touching::touching_contacts;
use super::tree::{BranchAndBound, has_round_cones, most_cases, search_tree};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{WHOLE, mapped};
use crate::object::{Problem, SpringDashpotRelaxation, newton_on_cones, twist_by_tresca};
use crate::prelude::*;
use crate::{forms, proofs};

/// A rung: one method of the search. The method is tried if its condition `applies` is true, and `climb` runs it.
pub(super) struct Rung {
    #[cfg_attr(
        not(feature = "std"),
        allow(dead_code, reason = "the record of the report `rungs` needs std")
    )]
    pub(super) name: &'static str,
    pub(super) applies: fn(&ElasticTrial<'_, '_>) -> bool,
    pub(super) climb: fn(&ElasticTrial<'_, '_>, &mut SearchLog) -> Attempt,
    /// The [`FoundBy`] of the method's equilibria; `None` for a method that can only prove that no equilibrium exists.
    finds: Option<FoundBy>,
}

pub(super) const LADDER: [Rung; 9] = [
    Rung {
        name: "states of a similar grasp",
        applies: |scene| scene.trial.is_banded() && !scene.problem.round && !scene.problem.near.is_empty(),
        climb: near_those_of_a_similar_grasp,
        finds: Some(FoundBy::KinematicForm),
    },
    Rung {
        name: "touching contacts",
        applies: |_| true,
        climb: touching_contacts_stick,
        finds: Some(FoundBy::EverythingTouchingSticks),
    },
    Rung {
        name: "Newton's method",
        applies: |scene| has_round_cones(scene.problem) || seldom_cycles(scene) && !is_on_an_edge(scene),
        climb: newton,
        finds: Some(FoundBy::Newton),
    },
    Rung { name: "everything yields", applies: is_on_an_edge, climb: everything_yields, finds: None },
    Rung {
        // With many contacts or coordinates, the search for a separating motion takes less time than Lemke's method, so it comes first. It ends early
        // if no such motion exists.
        name: "separating motion of many",
        applies: is_large,
        climb: separating_motion,
        finds: None,
    },
    Rung {
        name: "kinematic form",
        applies: |_| true,
        climb: kinematic_form,
        finds: Some(FoundBy::KinematicForm),
    },
    Rung { name: "force form", applies: may_be_dense, climb: force_form, finds: Some(FoundBy::ForceForm) },
    Rung {
        name: "separating motion of few",
        // This method is also tried with few contacts and many coordinates, after `separating motion of many` has failed. The augmented Lagrangian of
        // that method takes small residuals for zero; this method distinguishes them from zero.
        applies: |scene| !has_many_contacts(scene),
        climb: separating_motion_of_few,
        finds: None,
    },
    Rung {
        name: "every case",
        applies: |scene| !scene.settings.is_quick || scene.problem.trial.is_none(),
        climb: every_case,
        finds: Some(FoundBy::Enumeration),
    },
];

/// Tries the elastic trial, in which everything sticks, and then the methods of the ladder in order. It ends with the first equilibrium, or the first
/// proof that none exists. Otherwise the result is undecided.
pub(crate) fn settle(problem: &Problem, settings: &Settings) -> (SearchOutcome, SearchCounts) {
    let effort = SearchCounts { facets: problem.polygon.normals.len(), ..SearchCounts::default() };
    let mut log = SearchLog { effort, doubt: Doubt::RayWithoutProof, is_infeasible: false };
    let trial_states = problem.trial_states();
    let trial = problem.trial();
    let state = match trial.solve(problem.sites, &problem.offsets, problem.load()) {
        Ok(state) => state,
        Err(unbalanced) => {
            let on_the_boundary = SearchOutcome::Undecided(Doubt::OnTheBoundary);
            return (unbalanced.motion.map_or(on_the_boundary, SearchOutcome::FreeMotion), log.effort);
        }
    };
    let (trial_states, state) = match admit(problem, trial_states, &trial, state) {
        Ok(found) => {
            let found = at_the_least_motion(problem, found);
            return (SearchOutcome::Found(found, FoundBy::EverythingSticks), log.effort);
        }
        Err(RejectedStates { states, at, .. }) => (states, at),
    };
    let scene = ElasticTrial::new(problem, settings, trial_states, trial, state);
    let mut decided = None;
    for (number, rung) in LADDER.iter().enumerate().filter(|(_, rung)| (rung.applies)(&scene)) {
        let settled = match (rung.climb)(&scene, &mut log) {
            Attempt::Found(found) => {
                let found_by = rung.finds.unwrap_or(FoundBy::Enumeration);
                SearchOutcome::Found(at_the_least_motion(problem, found), found_by)
            }
            Attempt::Proof(proof) => proof,
            Attempt::Nothing => continue,
        };
        decided = Some((number, settled));
        break;
    }
    #[cfg(feature = "std")]
    record(&scene, decided.as_ref().map(|(number, _)| *number));
    (decided.map_or(SearchOutcome::Undecided(log.doubt), |(_, settled)| settled), log.effort)
}

fn has_many_contacts(scene: &ElasticTrial<'_, '_>) -> bool {
    scene.problem.len() >= MANY_CONTACTS
}

/// Whether Newton's method on polygonal friction cones seldom cycles between the same contact states, so that it is worth a try. This is so with many
/// contacts, and with several contacts if there are few coordinates.
fn seldom_cycles(scene: &ElasticTrial<'_, '_>) -> bool {
    let several = || scene.problem.len() >= SEVERAL_CONTACTS && scene.problem.size().count() <= WHOLE;
    has_many_contacts(scene) || several()
}

/// Whether the problem is a rate problem (for derivatives along a load path) with contacts on the boundary of their cone (`edge` in code names).
fn is_on_an_edge(scene: &ElasticTrial<'_, '_>) -> bool {
    scene.problem.locals().any(|local| local.is_on_an_edge())
}

fn is_large(scene: &ElasticTrial<'_, '_>) -> bool {
    has_many_contacts(scene) || scene.trial.is_banded()
}

/// Whether a complementarity problem may be solved with a dense matrix. With few contacts this is always allowed, with many contacts only if the
/// pivots take acceptable time.
fn may_be_dense(scene: &ElasticTrial<'_, '_>) -> bool {
    !has_many_contacts(scene) || dense_is_affordable(scene.proposing(), 1)
}

/// Lemke's method from the contact states of a similar grasp, in which only the contacts that break a condition may change their states.
fn near_those_of_a_similar_grasp(scene: &ElasticTrial<'_, '_>, log: &mut SearchLog) -> Attempt {
    let propose = |problem: &Problem, log: &mut SearchLog| propose_near_a_similar_one(scene, problem, log);
    Attempt::of(equilibrium_by_proposals(scene.problem, &propose, log))
}

/// Tries contact states in which some contacts are open and all others stick. It starts from the elastic trial, opens contacts that pull, and closes
/// contacts that penetrate the object.
fn touching_contacts_stick(scene: &ElasticTrial<'_, '_>, _: &mut SearchLog) -> Attempt {
    Attempt::of(touching_contacts(scene.problem, scene.trial_states.clone(), scene.state.clone()))
}

/// Newton's method for the motion of the object, of which each contact force is a function. On polygonal cones it starts at the elastic trial only.
/// On round cones it has three starts, one after the other. With few contacts the first starts are points of the relaxation, an artificial viscous
/// motion of the object (`object/relaxing`). The next start is the elastic trial. The last is the twist of an equilibrium with Tresca friction, i.e.
/// with friction limits that do not depend on the normal forces.
fn newton(scene: &ElasticTrial<'_, '_>, log: &mut SearchLog) -> Attempt {
    if !has_round_cones(scene.problem) {
        let propose = |problem: &Problem, _: &mut SearchLog| {
            let mut contacts = Vec::new();
            newton_on_cones(problem, (scene.state.twist.clone(), NEGLIGIBLE), &mut contacts)?;
            Some(mapped(&contacts, &|contact| contact.state))
        };
        return Attempt::of(equilibrium_by_proposals(scene.proposing(), &propose, log));
    }
    let from = |twist| polish_from(scene.problem, twist);
    // With many contacts the steps of relaxation take longer than Newton's method from the elastic trial.
    let relaxed = if has_many_contacts(scene) { None } else { where_it_relaxes_to(scene) };
    let found = relaxed.or_else(|| from(scene.state.twist.clone()));
    // With many coordinates the twist from Tresca friction is nearer to the solution than the twist of the elastic trial.
    Attempt::of(found.or_else(|| twist_by_tresca(scene.problem).and_then(from)))
}

/// The equilibrium to which the relaxation leads. The relaxation is an artificial viscous motion of the object from the elastic trial
/// (`object/relaxing`). Newton's method starts from points of this motion. If its result is far from its start, the next point is tried. If no point
/// leads to an equilibrium near that point, the first distant equilibrium is returned. `None` if Newton's method finds no equilibrium.
fn where_it_relaxes_to(scene: &ElasticTrial<'_, '_>) -> Option<SearchSolution> {
    let mut relaxation = SpringDashpotRelaxation::from_stuck(scene.problem, &scene.state.twist)?;
    let mut another = None;
    while let Some(twist) = relaxation.next() {
        let Some(found) = polish_from(scene.problem, twist) else { continue };
        if relaxation.relative_distance_from(&found.twist) <= NEAR_THE_RELAXED_STATE {
            return Some(found);
        }
        another = another.or(Some(found));
    }
    another
}

/// Searches for a proof that a rate problem (for derivatives along a load path) has no solution, as at a limit load. The proof is a virtual motion.
/// Every contact that may slide or open is assumed to do so. The work of the contacts along the virtual motion then does not depend on the motion of
/// the object. The proof is accepted if in no contact states the work of the contacts can balance that of the load.
fn everything_yields(scene: &ElasticTrial<'_, '_>, _: &mut SearchLog) -> Attempt {
    let proof = proofs::yields(scene.problem);
    proof.map_or(Attempt::Nothing, |escape| Attempt::Proof(SearchOutcome::Contradicted { cases: 1, escape }))
}

/// Searches for a proof with many contacts or coordinates: a separating motion. With many coordinates an augmented Lagrangian finds it. Otherwise it
/// is the residual wrench of the admissible forces nearest to the load.
fn separating_motion(scene: &ElasticTrial<'_, '_>, _: &mut SearchLog) -> Attempt {
    let motion = proofs::separating_motion(scene.proposing());
    motion.map_or(Attempt::Nothing, |motion| Attempt::Proof(SearchOutcome::Separating(motion)))
}

/// Searches for a proof with few contacts: a separating motion. It is the residual wrench of the admissible forces nearest to the load.
fn separating_motion_of_few(scene: &ElasticTrial<'_, '_>, _: &mut SearchLog) -> Attempt {
    let motion = proofs::separating_motion_of_few(scene.proposing());
    motion.map_or(Attempt::Nothing, |motion| Attempt::Proof(SearchOutcome::Separating(motion)))
}

/// Lemke's method on the kinematic form. With many coordinates it pivots first only on the contacts that break a condition in the elastic trial. If
/// that fails, it pivots on all contacts, provided that this takes acceptable time. Last it tries the kinematic form in which contacts with infinite
/// friction have facets of a friction cone.
fn kinematic_form(scene: &ElasticTrial<'_, '_>, log: &mut SearchLog) -> Attempt {
    let of_the_leaving = |problem: &Problem, log: &mut SearchLog| propose_of_the_leaving(scene, problem, log);
    let on_a_matrix = |problem: &Problem, log: &mut SearchLog| {
        let form = forms::kinematic_form(problem, &scene.trial, &scene.state);
        propose_dense(problem, scene.settings, (form, MOST_WORK), forms::kinematic_states, log)
    };
    let mut found = None;
    if scene.trial.is_banded() {
        found = equilibrium_by_proposals(scene.proposing(), &of_the_leaving, log);
    }
    if found.is_none() && !may_be_dense(scene) {
        log.doubt = Doubt::OutOfPivots;
        return Attempt::Nothing;
    }
    if found.is_none() {
        found = equilibrium_by_proposals(scene.proposing(), &on_a_matrix, log);
        log.effort.no_slips = log.is_infeasible && !scene.proposing().round;
    }
    if found.is_none()
        && let Some(with_edges) = scene.with_edges()
    {
        found = equilibrium_by_proposals(with_edges, &on_a_matrix, log);
    }
    Attempt::of(found)
}

/// Proposes contact states by Lemke's method on the force form, and checks them.
fn force_form(scene: &ElasticTrial<'_, '_>, log: &mut SearchLog) -> Attempt {
    let propose = |problem: &Problem, log: &mut SearchLog| {
        let form = forms::force_form(problem);
        propose_dense(problem, scene.settings, (form, MOST_WORK), forms::force_states, log)
    };
    Attempt::of(equilibrium_by_proposals(scene.proposing(), &propose, log))
}

/// Tries every case, if there are not too many. In the plane and on polygonal cones a case is a combination of contact states. On round cones a case
/// restricts the state of each contact or the direction of its friction, and branch and bound divides cases into smaller ones.
fn every_case(scene: &ElasticTrial<'_, '_>, log: &mut SearchLog) -> Attempt {
    let (most, problem) = (most_cases(scene.problem, scene.settings), scene.proposing());
    if most > 0 {
        return match search_tree(scene.problem, &scene.trial, &scene.state, most, None) {
            BranchAndBound::Found(found) => Attempt::Found(found),
            BranchAndBound::Contradicted { cases, escape } => {
                Attempt::Proof(SearchOutcome::Contradicted { cases, escape })
            }
            BranchAndBound::Unresolved(doubt) => {
                log.doubt = doubt;
                Attempt::Nothing
            }
        };
    }
    // On the round cone no combinations of contact states are tried, since a proof for the polygonal cone proves nothing for the round cone.
    if has_round_cones(problem) || !enumerable(problem, scene.settings) {
        return Attempt::Nothing;
    }
    let search = search(problem, true);
    log.effort.combinations = search.tried;
    if let Some(found) = search.found.into_iter().next() {
        return Attempt::Found(found);
    }
    if search.doubtful {
        log.doubt = Doubt::OnTheBoundary;
        return Attempt::Nothing;
    }
    Attempt::Proof(SearchOutcome::NoneOf(search.tried))
}
