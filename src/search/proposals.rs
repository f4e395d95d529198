//! Lemke's method proposes contact states, which are solved and checked; on the round cone Newton's method goes on from there.

use super::answer::{Doubt, Found};
use super::candidate::{Verdict, try_states};
use super::enumerate::combinations;
use super::polish::{polish, solution_near};
use super::scene::{Log, Scene};
use super::settings::Settings;
use crate::contact::{Fit, PolygonCone, State};
use crate::forms::Form;
use crate::lcp::{self, Basis, Outcome};
use crate::object::Problem;
use crate::structured;

/// Covering vectors tried after a ray, where trying every combination of states would come next: each path costs as much as
/// the first.
const OTHER_PATHS: usize = 3;
/// The number of those where there are too many contacts to try every combination.
const OTHER_PATHS_AT_MOST: usize = 16;
/// On the round cone, where Newton's method does not arrive: how often the polygons get more corners, and the angle of the first
/// ones to the friction force.
const REFINEMENTS: usize = 3;
const FIRST_REFINEMENT: f64 = 0.2;
/// Larger problems on other polygons are not made.
const MOST_ROWS: usize = 400;

/// Few enough contacts to try every combination of their states.
pub(super) fn enumerable<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
) -> bool {
    combinations(problem) <= settings.most_states as f64
}

/// Polygons on which Lemke proposes again where those of the settings led to nothing: outside the cone instead of inside,
/// then closer to it.
pub(super) fn finer_polygons<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    cone: PolygonCone,
) -> impl Iterator<Item = PolygonCone> {
    let contacts = problem.len();
    let more = |factor: usize, fit: Fit| PolygonCone::new(factor * cone.facets(), fit).ok();
    [
        more(1, Fit::Circumscribed),
        more(2, Fit::Inscribed),
        more(2, Fit::Circumscribed),
        more(8, Fit::Inscribed),
    ]
    .into_iter()
    .flatten()
    .filter(move |cone| contacts * cone.facets() <= MOST_ROWS)
}

/// One rung: Lemke proposes states, the piece with these states is solved and checked; on the round cone Newton's method goes on
/// from there, and where it does not arrive Lemke proposes again on polygons with more corners where contacts slide.
pub(super) fn climb<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    propose: impl Fn(&Problem<D, C>, &mut Log) -> Option<Vec<State<C>>>,
    log: &mut Log,
) -> Option<Found<D, C>> {
    let proposed = propose(problem, log)?;
    if !problem.round {
        return match try_states(problem, proposed) {
            Verdict::Holds(found) => Some(found),
            Verdict::Violated { doubtful: true } => {
                log.doubt = Doubt::OnTheBoundary;
                None
            }
            Verdict::Violated { doubtful: false } | Verdict::Unbalanced => None,
        };
    }
    let mut near = solution_near(problem, &proposed)?;
    let mut states_near = proposed;
    if let Some(found) = polish(problem, &states_near, &near) {
        return Some(found);
    }
    let mut finer = problem.clone();
    let mut angle = FIRST_REFINEMENT;
    for _ in 0..REFINEMENTS {
        for (i, state) in states_near.iter().enumerate() {
            if state.slides() {
                finer.turned[i] = finer.polygon(i).refined_about(&near.forces[i], angle);
            }
        }
        states_near = propose(&finer, log)?;
        near = solution_near(&finer, &states_near)?;
        if let Some(found) = polish(problem, &states_near, &near) {
            return Some(found);
        }
        angle *= 0.25;
    }
    None
}

/// Contact states from Lemke's method on lists of contact states.
pub(super) fn propose_structured<const D: usize, const C: usize>(
    scene: &Scene<'_, '_, D, C>,
    problem: &Problem<D, C>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let max_pivots = scene.settings.max_pivots;
    let proposal = structured::propose(problem, &scene.trial, &scene.state, OTHER_PATHS, max_pivots);
    log.effort.rows = log.effort.rows.max(proposal.pairs);
    log.effort.pivots += proposal.pivots;
    if proposal.cut_short {
        log.doubt = Doubt::OutOfPivots;
    }
    proposal.states
}

/// Contact states from Lemke's method on a complementarity problem with a dense matrix.
pub(super) fn propose_dense<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
    form: impl Fn(&Problem<D, C>) -> Option<Form>,
    states: impl Fn(&Problem<D, C>, &Form, &Basis) -> Vec<State<C>>,
    log: &mut Log,
) -> Option<Vec<State<C>>> {
    let form = form(problem)?;
    log.effort.rows = log.effort.rows.max(form.rows.len());
    // Bases are better enumerated as contact states, where each costs one d x d system and is checked as physics. On the round
    // cone other polygons come next.
    let few = problem.round || enumerable(problem, settings);
    let lcp_settings = lcp::Settings {
        max_pivots: settings.max_pivots,
        retries: if few { OTHER_PATHS } else { OTHER_PATHS_AT_MOST },
        enumerate_up_to: 0,
        ..lcp::Settings::default()
    };
    match form.lcp.solve_with(&lcp_settings) {
        Outcome::Solved(solution) => {
            log.effort.pivots += solution.pivots;
            return Some(states(problem, &form, &solution.basis));
        }
        Outcome::Ray(ray) => log.effort.pivots += ray.pivots,
        _ => log.doubt = Doubt::OutOfPivots,
    }
    None
}
