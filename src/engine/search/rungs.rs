//! The rungs of the ladder, each a way to find an equilibrium or to prove that none exists.

use super::a_few::propose_of_a_few;
use super::answer::{Doubt, Rung, Settled};
use super::enumerate::search;
use super::polish::polish_from;
use super::proposals::{climb, dense_is_affordable, enumerable, propose_dense, propose_structured};
use super::scene::{Attempt, Log, TrialScene};
use super::tolerances::{MANY_CONTACTS, MOST_WORK};
use super::touching::touching_contacts;
use super::tree::{Tree, has_round_cones, most_cases, search_tree};
use crate::contact::State;
use crate::forms;
use crate::object::{Problem, twist_by_given_limits};
use crate::prelude::*;
use crate::proofs;
use crate::structured::propose_by_newton;

/// Contacts that would pull are open; all others stick.
pub(super) fn touching_contacts_stick(scene: &TrialScene<'_, '_>, _: &mut Log) -> Attempt {
    let found = touching_contacts(scene.problem, scene.unjumped.clone(), scene.state.clone());
    Attempt::by(Rung::EverythingTouchingSticks, found)
}

/// Newton's method on the contacts' forces as functions of the object's motion, for many contacts.
pub(super) fn newton_on_answers(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    if scene.problem.len() < MANY_CONTACTS {
        return Attempt::Nothing;
    }
    let propose = |problem: &Problem, _: &mut Log| propose_by_newton(problem);
    Attempt::by(Rung::Newton, climb(scene.proposing(), &propose, log))
}

/// Lemke's method on the kinematic form, on lists of contact states: a pivot costs a few numbers a contact.
pub(super) fn kinematic_form_on_states(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    // From this many contacts on, the kinematic form is solved on lists of contact states first. Its pivots are cheaper from three contacts on, but
    // with few contacts the dense solver's path is kept. Another covering vector may end in another of several equilibria.
    if scene.problem.len() < 8 {
        return Attempt::Nothing;
    }
    let propose = |problem: &Problem, log: &mut Log| propose_structured(scene, problem, log);
    let found = climb(scene.proposing(), &propose, log).or_else(|| {
        let with_edges = scene.with_edges().filter(|_| !dense_is_affordable(scene.proposing(), 1))?;
        climb(with_edges, &propose, log)
    });
    Attempt::by(Rung::KinematicForm, found)
}

/// Lemke's method on the kinematic form of the few contacts that leave the trial, where the object has many coordinates (banded stiffness).
pub(super) fn kinematic_form_of_a_few(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    if !scene.trial.is_banded() {
        return Attempt::Nothing;
    }
    let propose = |problem: &Problem, log: &mut Log| propose_of_a_few(scene, problem, log);
    Attempt::by(Rung::KinematicForm, climb(scene.proposing(), &propose, log))
}

/// In rates at a limit load: all contacts on an edge slide, and nothing resists a motion on which the load works.
pub(super) fn everything_yields(scene: &TrialScene<'_, '_>, _: &mut Log) -> Attempt {
    if !scene.problem.locals().any(|local| local.is_on_an_edge()) {
        return Attempt::Nothing;
    }
    let proof = proofs::yields(scene.problem);
    proof.map_or(Attempt::Nothing, |escape| Attempt::Proof(Settled::Contradicted { cases: 1, escape }))
}

/// With many coordinates a separating motion is cheaper than any path, and its absence is soon known.
pub(super) fn separating_motion_in_a_band(scene: &TrialScene<'_, '_>, _: &mut Log) -> Attempt {
    let motion = scene.trial.is_banded().then(|| proofs::separating_motion_in_a_band(scene.proposing()));
    motion.flatten().map_or(Attempt::Nothing, |motion| Attempt::Proof(Settled::Separating(motion)))
}

/// With many contacts a separating motion is cheaper than any path.
pub(super) fn separating_motion_of_many(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    if scene.problem.len() < MANY_CONTACTS { Attempt::Nothing } else { separating_motion(scene, log) }
}

/// Contact states from Lemke's method on the dense kinematic form.
fn propose_kinematic(scene: &TrialScene<'_, '_>, problem: &Problem, log: &mut Log) -> Option<Vec<State>> {
    let form = forms::kinematic_form(problem, &scene.trial, &scene.state);
    propose_dense(problem, scene.settings, (form, MOST_WORK), forms::kinematic_states, log)
}

/// Lemke's method on the kinematic form with a dense matrix.
pub(super) fn kinematic_form(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    // With too many contacts the dense form adds nothing to the lists of states.
    if scene.problem.len() >= MANY_CONTACTS && !dense_is_affordable(scene.proposing(), 1) {
        return Attempt::Stop;
    }
    let propose = |problem: &Problem, log: &mut Log| propose_kinematic(scene, problem, log);
    Attempt::by(Rung::KinematicForm, climb(scene.proposing(), &propose, log))
}

/// The kinematic form once more, with facets for infinite friction.
pub(super) fn kinematic_form_with_edges(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    let propose = |problem: &Problem, log: &mut Log| propose_kinematic(scene, problem, log);
    let found = scene.with_edges().and_then(|with_edges| climb(with_edges, &propose, log));
    Attempt::by(Rung::KinematicForm, found)
}

/// Lemke's method on the force form.
pub(super) fn force_form(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    let propose = |problem: &Problem, log: &mut Log| {
        propose_dense(
            problem,
            scene.settings,
            (forms::force_form(problem), MOST_WORK),
            forms::force_states,
            log,
        )
    };
    Attempt::by(Rung::ForceForm, climb(scene.proposing(), &propose, log))
}

/// A motion that separates the load from all admissible contact forces.
pub(super) fn separating_motion(scene: &TrialScene<'_, '_>, _: &mut Log) -> Attempt {
    let motion = proofs::separating_motion(scene.proposing());
    motion.map_or(Attempt::Nothing, |motion| Attempt::Proof(Settled::Separating(motion)))
}

/// Newton's method on the round cone, from the elastic trial state.
pub(super) fn newton_on_the_round_cone(scene: &TrialScene<'_, '_>, _: &mut Log) -> Attempt {
    if !has_round_cones(scene.problem) {
        return Attempt::Nothing;
    }
    let from = |twist| polish_from(scene.problem, twist);
    let found = from(scene.state.twist.clone());
    // With many coordinates Tresca friction leads to a nearer twist.
    Attempt::by(Rung::Newton, found.or_else(|| twist_by_given_limits(scene.problem).and_then(from)))
}

/// On the round cone: branch and bound over contact states and directions of friction.
pub(super) fn every_case(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    let most = most_cases(scene.problem, scene.settings);
    if most == 0 {
        return Attempt::Nothing;
    }
    match search_tree(scene.problem, &scene.trial, &scene.state, most, None) {
        Tree::Found(found) => Attempt::Found(found, Rung::Enumeration),
        Tree::Contradicted { cases, escape } => Attempt::Proof(Settled::Contradicted { cases, escape }),
        Tree::Unresolved(doubt) => {
            log.doubt = doubt;
            Attempt::Nothing
        }
    }
}

/// Every combination of contact states, where they are few.
pub(super) fn every_combination(scene: &TrialScene<'_, '_>, log: &mut Log) -> Attempt {
    let problem = scene.proposing();
    // A proof on the polygon says nothing about the round cone.
    if has_round_cones(problem) || !enumerable(problem, scene.settings) {
        return Attempt::Nothing;
    }
    let search = search(problem, true);
    log.effort.combinations = search.tried;
    if let Some(found) = search.found.into_iter().next() {
        return Attempt::Found(found, Rung::Enumeration);
    }
    if search.doubtful {
        log.doubt = Doubt::OnTheBoundary;
        return Attempt::Stop;
    }
    Attempt::Proof(Settled::NoneOf(search.tried))
}
