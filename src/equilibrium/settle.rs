//! The ladder: elastic trial state, kinematic form, force form, proofs, every combination.

use std::sync::Arc;

use nalgebra::SVector;

use super::candidate::{Found, Verdict, admit, try_states};
use super::climb::{climb, enumerable, on_polygons, other_polygons, propose_dense};
use super::enumerate::search;
use super::many::{MANY, climb_on_states, dense_is_affordable};
use super::sectors::{Sectors, search_sectors};
use super::settings::Settings;
use super::wrench_cone::separating_motion;
use crate::formulation::{
    Law, Piece, PieceState, Problem, State, force_form, force_states, kinematic_form, kinematic_states,
};

/// By which rule a solution was found; with several equilibria this says which one it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Rung {
    /// Everything rolls: the elastic trial state satisfies every condition. No complementarity problem was made.
    EverythingRolls,
    /// Everything that touches rolls: with the contacts open that would pull, the rest satisfies every condition stuck. No
    /// complementarity problem was made.
    EverythingTouchingRolls,
    /// Lemke's method on the kinematic form: the end of a path of jumps from the trial state.
    KinematicForm,
    /// Newton's method on the forces with which the contacts answer a motion of the object, from the trial state. Tried with many
    /// contacts only.
    Newton,
    /// Lemke's method on the force form: the end of a path of forces from none.
    ForceForm,
    /// The first combination of contact states that satisfies every condition; on the round cone, the first case of sectors of sliding
    /// directions in which Newton's method arrives. Also what [`Grasp::equilibria`](crate::grasp::Grasp::equilibria) finds that way.
    Enumeration,
    /// Following a load path: the states come from the path's history.
    LoadPath,
}

/// What it took.
#[derive(Debug, Clone, Default)]
pub(crate) struct Effort {
    pub(crate) pivots: usize,
    /// Rows of the largest complementarity problem that was made.
    pub(crate) rows: usize,
    pub(crate) combinations: usize,
    /// Facets of the polygons that a contact would have.
    pub(crate) facets: usize,
}

/// With more contacts all that pull let go together.
const ONE_BY_ONE: usize = 64;
/// How often they may.
const TOGETHER: usize = 20;
/// A case of [`search_sectors`] counts as so many combinations of contact states.
const CASE: usize = 100;

/// How the ladder ended.
#[derive(Debug, Clone)]
pub(crate) enum Settled<const D: usize, const C: usize> {
    Found(Found<D, C>, Rung),
    /// The load works on a motion that no spring resists.
    FreeMotion(SVector<f64, D>),
    /// No admissible forces balance the load: this motion separates it from the friction wrench cone.
    Separating(SVector<f64, D>),
    /// All combinations of contact states were tried and fail clearly.
    NoneOf(usize),
    /// Nothing found, nothing proved.
    Undecided(Doubt),
}

/// Why nothing could be said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Doubt {
    /// Lemke ended on rays that prove nothing, and not every combination of states could be tried: there are too many contacts for
    /// [`Settings::most_states`], or on the round cone the cases that were tried did not decide.
    RayWithoutProof,
    /// Some combination of contact states fails so narrowly that rounding may have decided: the load is on the
    /// boundary of what the grasp can hold, as far as the working precision can tell.
    OnTheBoundary,
    /// Contact states were found, but the numbers of the scene lie so far apart (arms or stiffnesses by more than the working
    /// precision) that forces and twist cannot be written down accurately: their residuals exceed 1e-10 (1e-12 on the round
    /// cone).
    Inaccurate,
    /// The pivot limit was reached or a factorisation broke down, with too many contacts to try every combination.
    OutOfPivots,
}

/// Climbs the ladder.
pub(crate) fn settle<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
) -> (Settled<D, C>, Effort) {
    let mut effort = Effort { facets: problem.polygon.normals.len(), ..Effort::default() };
    let unjumped: Vec<State> = (0..problem.len()).map(|i| problem.unjumped(i)).collect();
    let trial = Piece::new(problem, &unjumped);
    let state = match trial.solve(problem.sites, &problem.drives, problem.load()) {
        Ok(state) => state,
        Err(unbalanced) => {
            let settled =
                unbalanced.motion.map_or(Settled::Undecided(Doubt::OnTheBoundary), Settled::FreeMotion);
            return (settled, effort);
        }
    };
    if let Verdict::Holds(found) = admit(problem, unjumped.clone(), &trial, state.clone()) {
        let found = Found { piece: Some(Arc::new(trial)), ..found };
        return (Settled::Found(found, Rung::EverythingRolls), effort);
    }
    if let Some(found) = touching_contacts_roll(problem, unjumped, state.clone()) {
        return (Settled::Found(found, Rung::EverythingTouchingRolls), effort);
    }
    let turned;
    let problem = if problem.round {
        turned = on_polygons(problem, settings.cone, &state.forces);
        &turned
    } else {
        problem
    };
    let mut doubt = Doubt::RayWithoutProof;
    let kinematic = |problem: &Problem<D, C>, effort: &mut Effort, doubt: &mut Doubt| {
        let form = |problem: &Problem<D, C>| kinematic_form(problem, &trial, &state);
        propose_dense(problem, settings, form, kinematic_states, effort, doubt)
    };
    // A contact with infinite friction has to let go of its tangential force when it opens; only facets do that.
    let with_facets = (problem.sites.iter().any(|site| site.mu.is_infinite()))
        .then(|| Problem { infinite_friction_has_facets: true, ..problem.clone() });
    let on_states = (&trial, &state);
    if let Some((found, rung)) =
        climb_on_states(problem, with_facets.as_ref(), settings, on_states, &mut effort, &mut doubt)
    {
        return (Settled::Found(found, rung), effort);
    }
    if problem.len() >= MANY {
        // A proof is cheaper than the paths that are left.
        if let Some(motion) = separating_motion(problem) {
            return (Settled::Separating(motion), effort);
        }
        if !dense_is_affordable(problem) {
            return (Settled::Undecided(doubt), effort);
        }
    }
    if let Some(found) = climb(problem, kinematic, &mut effort, &mut doubt) {
        return (Settled::Found(found, Rung::KinematicForm), effort);
    }
    if let Some(with_facets) = &with_facets
        && let Some(found) = climb(with_facets, kinematic, &mut effort, &mut doubt)
    {
        return (Settled::Found(found, Rung::KinematicForm), effort);
    }
    let force = |problem: &Problem<D, C>, effort: &mut Effort, doubt: &mut Doubt| {
        propose_dense(problem, settings, force_form, force_states, effort, doubt)
    };
    if let Some(found) = climb(problem, force, &mut effort, &mut doubt) {
        return (Settled::Found(found, Rung::ForceForm), effort);
    }
    if let Some(motion) = separating_motion(problem) {
        return (Settled::Separating(motion), effort);
    }
    if problem.round {
        for cone in other_polygons(problem, settings.cone) {
            let other = on_polygons(problem, cone, &state.forces);
            if let Some(found) = climb(&other, kinematic, &mut effort, &mut doubt) {
                return (Settled::Found(found, Rung::KinematicForm), effort);
            }
        }
    }
    if problem.round && has_round_cones(problem) {
        let settled = match search_sectors(problem, settings.most_states / CASE) {
            Sectors::Found(found) => Settled::Found(found, Rung::Enumeration),
            Sectors::NoneOf(cases) => Settled::NoneOf(cases),
            Sectors::Unresolved if enumerable(problem, settings) => {
                let search = search(problem, true);
                effort.combinations = search.tried;
                let first = search.found.into_iter().next();
                first.map_or(Settled::Undecided(doubt), |found| Settled::Found(found, Rung::Enumeration))
            }
            Sectors::Unresolved => Settled::Undecided(doubt),
        };
        return (settled, effort);
    }
    if enumerable(problem, settings) {
        let search = search(problem, true);
        effort.combinations = search.tried;
        let settled = match search.found.into_iter().next() {
            Some(found) => Settled::Found(found, Rung::Enumeration),
            None if search.doubtful => Settled::Undecided(Doubt::OnTheBoundary),
            None => Settled::NoneOf(search.tried),
        };
        return (settled, effort);
    }
    (Settled::Undecided(doubt), effort)
}

/// From these states and their solution: opens what pulls and closes what penetrates while everything closed sticks, until
/// neither is left, and accepts the result if it satisfies every condition. A finger far out of reach is thus no reason to
/// return another equilibrium than without it.
fn touching_contacts_roll<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    mut states: Vec<State>,
    trial: PieceState<D, C>,
) -> Option<Found<D, C>> {
    let mut solved = trial;
    let mut changed = Vec::new();
    // Every contact usually changes once; the bound ends those that would go in circles.
    let rounds = if states.len() > ONE_BY_ONE { TOGETHER } else { 2 * states.len() + 2 };
    for round in 0..rounds {
        if round > 0 {
            solved =
                Piece::new(problem, &states).solve(problem.sites, &problem.drives, problem.load()).ok()?;
        }
        // Of few contacts one at a time, since what pulls makes others pull that will not when it has let go: first the one that is
        // farthest from the object before anything moves.
        let reach = |i: usize| problem.drives[i][0];
        let depth = |i: usize| reach(i) - problem.sites[i].map.tr_mul(&solved.twist)[0];
        let may_open = |i: &usize| problem.may_open(*i);
        let pulls = |i: &usize| states[*i] != State::Open && solved.forces[*i][0] < 0.0;
        let penetrates = |i: &usize| states[*i] == State::Open && depth(*i) > 0.0;
        changed.clear();
        changed.extend((0..states.len()).filter(may_open).filter(pulls));
        if states.len() <= ONE_BY_ONE
            && let Some(first) = changed.iter().copied().min_by(|&i, &j| reach(i).total_cmp(&reach(j)))
        {
            changed = vec![first];
        }
        let next = if changed.is_empty() { State::Rolling } else { State::Open };
        if changed.is_empty() {
            changed.extend((0..states.len()).filter(may_open).filter(penetrates));
            if states.len() <= ONE_BY_ONE
                && let Some(first) = changed.iter().copied().max_by(|&i, &j| depth(i).total_cmp(&depth(j)))
            {
                changed = vec![first];
            }
        }
        if changed.is_empty() {
            // In the first round these are the states that have failed before.
            return match (round, try_states(problem, states)) {
                (1.., Verdict::Holds(found)) => Some(found),
                _ => None,
            };
        }
        for &i in &changed {
            states[i] = next;
        }
    }
    None
}

/// Whether some contact has the round cone: with others the polygons say all there is to say. Rates on an edge have no sectors.
fn has_round_cones<const D: usize, const C: usize>(problem: &Problem<D, C>) -> bool {
    (0..problem.len()).any(|i| problem.may_slide(i))
        && !problem.laws.iter().any(|law| matches!(law, Law::Edge(_)))
}
