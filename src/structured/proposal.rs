//! Contact states for the ladder of `equilibrium`, which solves and checks them.

use super::newton::Newton;
use super::path::{End, Path};
use crate::contact::{Mode, State};
use crate::object::{Piece, PieceState, Problem};

/// What a search for contact states took, and its end.
#[derive(Debug, Clone)]
pub(crate) struct Proposal<const C: usize> {
    pub(crate) states: Option<Vec<State<C>>>,
    pub(crate) pivots: usize,
    /// Pairs of the kinematic form.
    pub(crate) pairs: usize,
    /// Whether a path has ended otherwise than on a ray.
    pub(crate) cut_short: bool,
}

/// Contact states by Newton's method on the return maps, if it arrives.
pub(crate) fn propose_by_newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
) -> Option<Vec<State<C>>> {
    let mut newton = Newton::default();
    newton.run(problem).then(|| newton.states.iter().map(|state| State::from(*state)).collect())
}

/// Follows Lemke's path on the kinematic form from the trial state, and those of as many other covering vectors after a ray.
pub(crate) fn propose<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    trial: &Piece<D, C>,
    state: &PieceState<D, C>,
    other_paths: usize,
    max_pivots: Option<usize>,
) -> Proposal<C> {
    let mut path = Path::default();
    let mut x = Vec::with_capacity(C * problem.len());
    for (local, force) in problem.locals().zip(&state.forces).filter(|(local, _)| !local.is_absent()) {
        x.extend((0..local.springs.axes()).map(|axis| force[axis] / local.springs.root_along(axis)));
    }
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
    fn states(&self, problem: &Problem<D, C>) -> Vec<State<C>> {
        let state = |contact: usize| {
            let (gap, local) = (self.form.locals[contact].contact.gap, problem.local(contact));
            let active = &self.basis.active[contact];
            if gap && active.position(0).is_some() {
                return Mode::Open;
            }
            if active.len() == 0 {
                return local.unjumped();
            }
            let mut facets: Vec<u16> = active.facets(gap).collect();
            facets.sort_unstable();
            local.slipping_state(&facets).into()
        };
        (0..self.form.len()).map(state).collect()
    }
}
