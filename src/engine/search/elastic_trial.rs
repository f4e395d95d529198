//! Input and result of one method (rung) of the ladder. The ladder is the sequence of methods that search for an equilibrium.

use alloc::sync::Arc;
use core::cell::OnceCell;

use nalgebra::SVector;

use super::answer::{Doubt, SearchCounts, SearchOutcome, SearchSolution};
use super::settings::Settings;
use crate::contact::{Polygon, PolygonCone, State, tangential_norm};
use crate::numerics::mapped;
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;

/// Input of a method of the search (a rung of the ladder): the equilibrium problem, and the solution of its elastic trial, in which every contact
/// sticks. In this solution some contact breaks a condition of sticking, for example by a force outside its cone.
pub(super) struct ElasticTrial<'s, 'g> {
    pub(super) problem: &'s Problem<'g>,
    pub(super) settings: &'s Settings,
    /// The contact states of the elastic trial: every contact sticks, except that contacts whose law is [`Law::Absent`](crate::contact::Law::Absent)
    /// are open.
    pub(super) trial_states: Vec<State>,
    pub(super) trial: Arc<LinearProblem>,
    pub(super) state: ForcesAndTwist,
    proposing: OnceCell<Problem<'g>>,
    with_edges: OnceCell<Option<Problem<'g>>>,
}

impl<'s, 'g> ElasticTrial<'s, 'g> {
    pub(super) fn new(
        problem: &'s Problem<'g>,
        settings: &'s Settings,
        trial_states: Vec<State>,
        trial: Arc<LinearProblem>,
        state: ForcesAndTwist,
    ) -> Self {
        let (proposing, with_edges) = (OnceCell::new(), OnceCell::new());
        Self { problem, settings, trial_states, trial, state, proposing, with_edges }
    }

    /// The problem for methods that need polygonal friction cones, such as Lemke's method. Each round cone is replaced by a polygon with a corner
    /// along the friction force of the elastic trial.
    pub(super) fn proposing(&self) -> &Problem<'g> {
        if !self.problem.round {
            return self.problem;
        }
        self.proposing.get_or_init(|| on_polygons(self.problem, self.settings.cone, &self.state.forces))
    }

    /// The problem for methods that need polygonal friction cones ([`Self::proposing`]), in which contacts with infinite friction have facets, too.
    /// `None` if no contact has infinite friction. Such a contact loses its tangential force when it opens. A complementarity problem without its
    /// facets keeps this force.
    pub(super) fn with_edges(&self) -> Option<&Problem<'g>> {
        let infinite = || self.problem.locals().any(|local| local.never_slides());
        let make =
            || infinite().then(|| Problem { infinite_friction_has_edges: true, ..self.proposing().clone() });
        self.with_edges.get_or_init(make).as_ref()
    }
}

/// Result of one method of the search (a rung of the ladder) for one problem.
pub(super) enum Attempt {
    Found(SearchSolution),
    /// A proof that no equilibrium exists.
    Proof(SearchOutcome),
    /// Neither an equilibrium nor a proof; the next method is tried.
    Nothing,
}

impl Attempt {
    pub(super) fn of(found: Option<SearchSolution>) -> Self {
        found.map_or(Self::Nothing, Self::Found)
    }
}

/// Record of the search so far: its effort, and the reason to give if its result is undecided.
pub(super) struct SearchLog {
    pub(super) effort: SearchCounts,
    /// The reason why the result is undecided, to be returned if no method finds an equilibrium or a proof.
    pub(super) doubt: Doubt,
    /// True if the last complementarity problem that was solved with a dense matrix was proved to have no solution.
    pub(super) is_infeasible: bool,
}

/// The problem with each contact's polygon rotated so that one corner lies along the friction force of the elastic trial. While friction keeps this
/// direction, an inscribed polygon limits the friction force exactly like the round cone.
pub(super) fn on_polygons<'g>(
    problem: &Problem<'g>,
    cone: PolygonCone,
    trial: &[SVector<f64, 3>],
) -> Problem<'g> {
    let polygon = Polygon::new(problem.space(), &cone);
    let turn = |traction: &SVector<f64, 3>| {
        if polygon.is_interval() || tangential_norm(traction) == 0.0 {
            polygon.clone()
        } else {
            polygon.turned_to(traction)
        }
    };
    Problem { turned: mapped(trial, &turn), ..problem.clone() }
}
