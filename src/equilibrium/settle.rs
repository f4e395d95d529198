//! The ladder: elastic trial state, kinematic form, force form, proofs, every combination.

use nalgebra::SVector;

use super::candidate::{Found, Verdict, admit, try_states};
use super::climb::{climb, enumerable, on_polygons, other_polygons};
use super::enumerate::search;
use super::sectors::{Sectors, search_sectors};
use super::settings::Settings;
use super::wrench_cone::separating_motion;
use crate::formulation::{
    Law, Piece, PieceState, Problem, State, force_form, force_states, kinematic_form, kinematic_states,
};

/// By which rule a solution was found; with several equilibria this says which one it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Rung {
    /// Everything rolls: the elastic trial state satisfies every condition. No complementarity problem was made.
    EverythingRolls,
    /// Everything that touches rolls: with the contacts open that would pull, the rest satisfies every condition stuck. No
    /// complementarity problem was made.
    EverythingTouchingRolls,
    /// Lemke's method on the kinematic form: the end of a path of jumps from the trial state.
    KinematicForm,
    /// Lemke's method on the force form: the end of a path of forces from none.
    ForceForm,
    /// The first combination of contact states that satisfies every condition.
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
#[non_exhaustive]
pub enum Doubt {
    /// Lemke ended on rays that prove nothing and there are too many contacts to try every combination of states.
    RayWithoutProof,
    /// Some combination of contact states fails so narrowly that rounding may have decided: the load is on the
    /// boundary of what the grasp can hold, as far as the working precision can tell.
    OnTheBoundary,
    /// Contact states were found, but the numbers of the scene lie so far apart (arms or stiffnesses by more than the working
    /// precision) that forces and twist cannot be written down accurately: their residuals exceed 1e-10.
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
    let state = match trial.solve(&problem.drives, &problem.wrench) {
        Ok(state) => state,
        Err(unbalanced) => {
            let settled =
                unbalanced.motion.map_or(Settled::Undecided(Doubt::OnTheBoundary), Settled::FreeMotion);
            return (settled, effort);
        }
    };
    if let Verdict::Holds(found) = admit(problem, unjumped.clone(), &trial, state.clone()) {
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
    let kinematic = |problem: &Problem<D, C>| kinematic_form(problem, &trial, &state);
    if let Some(found) = climb(problem, settings, kinematic, kinematic_states, &mut effort, &mut doubt) {
        return (Settled::Found(found, Rung::KinematicForm), effort);
    }
    if problem.sites.iter().any(|site| site.mu.is_infinite()) {
        // A contact with infinite friction has to let go of its tangential force when it opens; only facets do that.
        let with_facets = Problem { infinite_friction_has_facets: true, ..problem.clone() };
        if let Some(found) =
            climb(&with_facets, settings, kinematic, kinematic_states, &mut effort, &mut doubt)
        {
            return (Settled::Found(found, Rung::KinematicForm), effort);
        }
    }
    if let Some(found) = climb(problem, settings, force_form, force_states, &mut effort, &mut doubt) {
        return (Settled::Found(found, Rung::ForceForm), effort);
    }
    if let Some(motion) = separating_motion(problem) {
        return (Settled::Separating(motion), effort);
    }
    if problem.round {
        for cone in other_polygons(problem, settings.cone) {
            let other = on_polygons(problem, cone, &state.forces);
            if let Some(found) = climb(&other, settings, kinematic, kinematic_states, &mut effort, &mut doubt)
            {
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
    mut solved: PieceState<D, C>,
) -> Option<Found<D, C>> {
    let mut changed = false;
    // Every contact usually changes once; the bound ends those that would go in circles.
    for _ in 0..2 * states.len() + 2 {
        // One at a time, since what pulls makes others pull that will not when it has let go: first the one that is farthest
        // from the object before anything moves.
        let reach = |i: usize| problem.drives[i][0];
        let closed = |i: &usize| problem.may_open(*i) && states[*i] != State::Open;
        let pulls = (0..states.len()).filter(closed).filter(|&i| solved.forces[i][0] < 0.0);
        let (i, next) = if let Some(i) = pulls.min_by(|&i, &j| reach(i).total_cmp(&reach(j))) {
            (i, State::Open)
        } else {
            let depth = |i: usize| reach(i) - problem.sites[i].map.tr_mul(&solved.twist)[0];
            let open = |i: &usize| problem.may_open(*i) && states[*i] == State::Open;
            let penetrates = (0..states.len()).filter(open).filter(|&i| depth(i) > 0.0);
            let Some(i) = penetrates.max_by(|&i, &j| depth(i).total_cmp(&depth(j))) else {
                // Unchanged it has been tried before.
                let Verdict::Holds(found) = changed.then(|| try_states(problem, states))? else {
                    return None;
                };
                return Some(found);
            };
            (i, State::Rolling)
        };
        states[i] = next;
        changed = true;
        solved = Piece::new(problem, &states).solve(&problem.drives, &problem.wrench).ok()?;
    }
    None
}

/// Whether some contact has the round cone: with others the polygons say all there is to say. Rates on an edge have no sectors.
fn has_round_cones<const D: usize, const C: usize>(problem: &Problem<D, C>) -> bool {
    (0..problem.len()).any(|i| problem.may_slide(i))
        && !problem.laws.iter().any(|law| matches!(law, Law::Edge(_)))
}
