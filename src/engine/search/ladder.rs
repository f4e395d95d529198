//! The ladder: a list of rungs, the cheapest first, and a loop that climbs it until one rung finds an equilibrium or proves that none exists.

use super::answer::{Doubt, Effort, Rung, Settled};
use super::candidate::{Refused, admit};
use super::least_motion::at_the_least_motion;
use super::rungs::{
    every_case, every_combination, everything_yields, force_form, kinematic_form, kinematic_form_of_a_few,
    kinematic_form_on_states, kinematic_form_with_edges, newton_on_answers, newton_on_the_round_cone,
    separating_motion, separating_motion_in_a_band, separating_motion_of_many, touching_contacts_stick,
};
use super::scene::{Attempt, Log, TrialScene};
use super::settings::Settings;
use crate::object::Problem;

type TryRung = fn(&TrialScene<'_, '_>, &mut Log) -> Attempt;

/// Tries the elastic trial, then rung by rung until a solution or a proof is found.
pub(crate) fn settle(problem: &Problem, settings: &Settings) -> (Settled, Effort) {
    let ladder: [TryRung; 14] = [
        touching_contacts_stick,
        newton_on_answers,
        newton_on_the_round_cone,
        everything_yields,
        separating_motion_in_a_band,
        kinematic_form_of_a_few,
        separating_motion_of_many,
        kinematic_form_on_states,
        kinematic_form,
        kinematic_form_with_edges,
        force_form,
        separating_motion,
        every_case,
        every_combination,
    ];
    let effort = Effort { facets: problem.polygon.normals.len(), ..Effort::default() };
    let mut log = Log { effort, doubt: Doubt::RayWithoutProof };
    let unjumped = problem.unjumped();
    let trial = problem.trial();
    let state = match trial.solve(problem.sites, &problem.drives, problem.load()) {
        Ok(state) => state,
        Err(unbalanced) => {
            let on_the_boundary = Settled::Undecided(Doubt::OnTheBoundary);
            return (unbalanced.motion.map_or(on_the_boundary, Settled::FreeMotion), log.effort);
        }
    };
    // The lowest rung: everything sticks.
    let (unjumped, state) = match admit(problem, unjumped, &trial, state) {
        Ok(found) => {
            let found = at_the_least_motion(problem, found);
            return (Settled::Found(found, Rung::EverythingSticks), log.effort);
        }
        Err(Refused { states, at, .. }) => (states, at),
    };
    let scene = TrialScene::new(problem, settings, unjumped, trial, state);
    for attempt in ladder {
        match attempt(&scene, &mut log) {
            Attempt::Found(found, rung) => {
                return (Settled::Found(at_the_least_motion(problem, found), rung), log.effort);
            }
            Attempt::Proof(settled) => return (settled, log.effort),
            Attempt::Nothing => {}
            Attempt::Stop => break,
        }
    }
    (Settled::Undecided(log.doubt), log.effort)
}
