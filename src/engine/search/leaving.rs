//! Lemke's method for many contacts of which few leave the elastic trial, in which everything sticks. A contact leaves the trial if it breaks a
//! condition of its state there. Only these few contacts pivot, i.e. may change their states.
//!
//! A contact that breaks a condition is added to the pivoting contacts; all others keep their states. The new contact states may make other contacts
//! break a condition. These contacts are added, too, until no contact breaks a condition. If many contacts leave the trial, Lemke's method starts
//! instead from an approximate solution with Tresca friction (friction limits that do not depend on the normal forces). In its contact states few
//! contacts break a condition.

use crate::numerics::{IntoList, chosen, highest};
use alloc::sync::Arc;

use super::candidate::breaking;
use super::elastic_trial::{ElasticTrial, SearchLog};
use super::proposals::propose_dense;
use super::settings::Settings;
use super::tolerances::MOST_WORK;
use crate::contact::{Mode, State};
use crate::forms::{UnitDisplacements, kinematic_form_among, kinematic_states};
use crate::object::{ForcesAndTwist, LinearProblem, Problem, states_by_tresca};
use crate::prelude::*;

/// The start of a run of Lemke's method: contact states, `linear_problem` in these states, and its solution `at`. The contacts that pivot, i.e. may
/// change their states in the run, stick in these states.
struct PivotStart {
    states: Vec<State>,
    linear_problem: Arc<LinearProblem>,
    at: ForcesAndTwist,
}

impl PivotStart {
    /// The start of Lemke's method in these contact states; `None` if no forces balance the load in these states.
    fn of(problem: &Problem, states: Vec<State>) -> Option<Self> {
        let linear_problem = problem.linear_problem(&states);
        let at = linear_problem.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
        Some(Self { states, linear_problem, at })
    }

    /// This start of Lemke's method, changed so that the contacts with the indices `among` stick. `moved` stores displacements of the object per unit
    /// gap or slip of a contact; if a contact state changes, they are no longer valid and are cleared. `None` if the tangent stiffness is then
    /// singular, or if no forces balance the load.
    fn sticking_at(self, problem: &Problem, among: &[usize], moved: &mut UnitDisplacements) -> Option<Self> {
        let mut states = self.states.clone();
        for i in among {
            states[*i] = problem.local(*i).trial_state();
        }
        if states == self.states {
            return Some(self);
        }
        *moved = UnitDisplacements::default();
        problem.tangent_in_a_band(&|i| states[i])?.is_regular().then(|| Self::of(problem, states))?
    }
}

/// Proposes contact states by Lemke's method, in which at first only contacts that break a condition in the elastic trial may change their states. In
/// the contact states returned no contact breaks a condition. `None` if the method finds no such contact states.
pub(super) fn propose_of_the_leaving(
    scene: &ElasticTrial<'_, '_>,
    problem: &Problem,
    log: &mut SearchLog,
) -> Option<Vec<State>> {
    let leaving = breaking(problem, &scene.trial_states, &scene.state);
    // If at least 128 contacts leave the elastic trial, Lemke's method starts from the contact states of a solution with Tresca friction, in which
    // fewer contacts break a condition. The cost of a run grows with the cube of the number of contacts that pivot.
    if leaving.len() >= 128
        && let Some(near) = states_by_tresca(problem).and_then(|near| regular(problem, near))
        && let Some(base) = PivotStart::of(problem, near)
    {
        let among = breaking(problem, &base.states, &base.at);
        if among.is_empty() {
            return Some(base.states);
        }
        // In a run that starts from Tresca friction, at most 400 contacts pivot. The 400 include neighbours: contacts that share coordinates with
        // contacts that break a condition.
        if let Some(states) = pivoted(problem, scene.settings, (base, among, 400), log) {
            return Some(states);
        }
    }
    let (states, linear_problem, at) = (scene.trial_states.clone(), scene.trial.clone(), scene.state.clone());
    pivoted(problem, scene.settings, (PivotStart { states, linear_problem, at }, leaving, 0), log)
}

/// Proposes contact states by Lemke's method that starts at the contact states of a similar grasp. In the contact states returned no contact breaks a
/// condition. `None` if the method finds no such contact states, or if in those of the similar grasp more than 24 contacts break a condition.
pub(super) fn propose_near_a_similar_one(
    scene: &ElasticTrial<'_, '_>,
    problem: &Problem,
    log: &mut SearchLog,
) -> Option<Vec<State>> {
    let base = PivotStart::of(problem, regular(problem, problem.near.to_vec())?)?;
    let leaving = breaking(problem, &base.states, &base.at);
    match leaving.len() {
        0 => Some(base.states),
        // If at most 24 contacts break a condition in the contact states of the similar grasp, pivots start from them. This takes less time than
        // pivots from the elastic trial.
        1..=24 => pivoted(problem, scene.settings, (base, leaving, 0), log),
        _ => None,
    }
}

/// Contact states from Lemke's method on the contacts `among`, by index. If the method finds no solution, the neighbours of these contacts (contacts
/// that share coordinates with them) pivot as well, up to `most` contacts altogether. `None` if the method still finds no solution.
fn pivoted(
    problem: &Problem,
    settings: &Settings,
    (mut base, mut among, most): (PivotStart, Vec<usize>, usize),
    log: &mut SearchLog,
) -> Option<Vec<State>> {
    let mut moved = UnitDisplacements::default();
    // Upper limit of the number of rounds. In each round the contacts that now break a condition begin to pivot (may change their states). As a rule
    // there are fewer of them in each round.
    for _ in 0..32 {
        among.sort_unstable();
        base = base.sticking_at(problem, &among, &mut moved)?;
        let form = kinematic_form_among(problem, &base.linear_problem, &base.at, &among, &mut moved)?;
        // Each run of Lemke's method may take 20 times the usual number of multiplications, if the caller sets no limit on pivots. That takes
        // some seconds, whereas every other method would take minutes. A quick search may stay undecided and stops earlier.
        let work = MOST_WORK.saturating_mul(if settings.is_quick { 5 } else { 20 });
        let proposed = propose_dense(problem, settings, (Some(form), work), kinematic_states, log);
        let Some(mut states) = proposed else {
            among = with_neighbours(problem, &among);
            if among.len() > most {
                return None;
            }
            continue;
        };
        let is_among = |i: &usize| among.binary_search(i).is_ok();
        (0..states.len()).filter(|i| !is_among(i)).for_each(|i| states[i] = base.states[i]);
        let at = LinearProblem::new(problem, &states)
            .solve(problem.sites, &problem.offsets, problem.load())
            .ok()?;
        let joins: Vec<_> = breaking(problem, &states, &at).into_iter().filter(|i| !is_among(i)).list();
        if joins.is_empty() {
            return Some(states);
        }
        among.extend(joins);
    }
    None
}

/// The indices `among` of contacts and those of their neighbours, in ascending order. A neighbour is a contact that moves with one of the coordinates
/// that move one of these contacts.
fn with_neighbours(problem: &Problem, among: &[usize]) -> Vec<usize> {
    let mut is_near = vec![false; problem.size().count()];
    for i in among {
        for range in problem.sites[*i].support.ranges() {
            is_near[range].fill(true);
        }
    }
    let feels = |i: &usize| {
        problem.sites[*i].support.ranges().iter().any(|range| is_near[range.clone()].contains(&true))
    };
    chosen(problem.len(), &feels)
}

/// Makes further contacts stick until the tangent stiffness is regular. For each motion along which it is singular, one contact begins to stick: of
/// those that do not stick yet, the contact that moves most. `None` if the tangent stiffness is still singular after eight rounds.
fn regular(problem: &Problem, mut states: Vec<State>) -> Option<Vec<State>> {
    for _ in 0..8 {
        let loose = problem.tangent_in_a_band(&|i| states[i])?.loose_motions();
        if loose.is_empty() {
            return Some(states);
        }
        for motion in &loose {
            let moved = |i: usize| {
                let moved = problem.sites[i].map.tr_mul(motion);
                if states[i].is_open() {
                    moved.norm()
                } else {
                    (moved[1] * moved[1] + moved[2] * moved[2]).sqrt()
                }
            };
            let may_stick = |i: &usize| !states[*i].is_sticking() && !problem.local(*i).is_absent();
            let most = *highest(&chosen(states.len(), &may_stick), &|i| moved(*i))?;
            states[most] = Mode::Sticking;
        }
    }
    None
}
