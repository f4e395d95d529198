//! Contact states for the ladder of `equilibrium`, which solves and checks them.

use super::newton::Newton;
use super::path::{End, Path};
use crate::formulation::{Law, Piece, PieceState, Problem, State};

/// What a search for contact states took, and its end.
#[derive(Debug, Clone)]
pub(crate) struct Proposal {
    pub(crate) states: Option<Vec<State>>,
    pub(crate) pivots: usize,
    /// Pairs of the kinematic form.
    pub(crate) pairs: usize,
    /// Whether a path has ended otherwise than on a ray.
    pub(crate) cut_short: bool,
}

/// Contact states by Newton's method on the return maps, if it arrives.
pub(crate) fn propose_by_newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
) -> Option<Vec<State>> {
    let mut newton = Newton::default();
    newton.run(problem).then(|| newton.states(problem))
}

/// Follows Lemke's path on the kinematic form from the trial state, and those of as many other covering vectors after a ray.
pub(crate) fn propose<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    trial: &Piece<D, C>,
    state: &PieceState<D, C>,
    other_paths: usize,
    max_pivots: Option<usize>,
) -> Proposal {
    let mut path = Path::default();
    let x: Vec<f64> = (problem.sites.iter().zip(&problem.laws).zip(&state.forces))
        .filter(|((_, law), _)| **law != Law::Absent)
        .flat_map(|((site, _), force)| (0..site.axes).map(move |axis| force[axis] / site.k[axis].sqrt()))
        .collect();
    path.form.assign(problem, trial.factor(), &x);
    let mut proposal = Proposal { states: None, pivots: 0, pairs: path.form.pairs, cut_short: false };
    for attempt in 0..=other_paths {
        let limit = max_pivots.unwrap_or_else(|| path.pivots + path.pivot_limit());
        let end = path.run_from_trial(attempt, limit);
        proposal.pivots = path.pivots;
        match end {
            End::Complementary => {
                proposal.states = Some(path.states(problem));
                return proposal;
            }
            End::Ray => {}
            End::PivotLimit | End::Breakdown => proposal.cut_short = true,
        }
    }
    proposal
}

impl<const D: usize, const C: usize> Path<D, C> {
    /// The contact states of the present basis.
    fn states(&self, problem: &Problem<D, C>) -> Vec<State> {
        let state = |contact: usize| {
            let gap = self.form.opens(contact);
            let active = &self.basis.active[contact];
            if gap && active.position(0).is_some() {
                return State::Open;
            }
            if active.len() == 0 {
                return problem.unjumped(contact);
            }
            let mut facets: Vec<usize> = active.iter().map(|pair| pair - usize::from(gap)).collect();
            facets.sort_unstable();
            problem.slipping_state(contact, &facets)
        };
        (0..self.form.len()).map(state).collect()
    }
}
