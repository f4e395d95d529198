//! Input and result of a rung of the ladder.

use alloc::sync::Arc;
use core::cell::OnceCell;

use nalgebra::SVector;

use super::answer::{Doubt, Effort, Found, Rung, Settled};
use super::settings::Settings;
use crate::contact::{Polygon, PolygonCone, State};
use crate::numerics::Size;
use crate::object::{Piece, PieceState, Problem};
use crate::prelude::*;

/// A search for an equilibrium, with its elastic trial state.
pub(super) struct TrialScene<'s, 'g, D: Size, const C: usize> {
    pub(super) problem: &'s Problem<'g, D, C>,
    pub(super) settings: &'s Settings,
    /// The states of the trial: every contact that is present sticks.
    pub(super) unjumped: Vec<State<C>>,
    pub(super) trial: Arc<Piece<D, C>>,
    pub(super) state: PieceState<D, C>,
    proposing: OnceCell<Problem<'g, D, C>>,
    with_edges: OnceCell<Option<Problem<'g, D, C>>>,
}

impl<'s, 'g, D: Size, const C: usize> TrialScene<'s, 'g, D, C> {
    pub(super) fn new(
        problem: &'s Problem<'g, D, C>,
        settings: &'s Settings,
        unjumped: Vec<State<C>>,
        trial: Arc<Piece<D, C>>,
        state: PieceState<D, C>,
    ) -> Self {
        let (proposing, with_edges) = (OnceCell::new(), OnceCell::new());
        Self { problem, settings, unjumped, trial, state, proposing, with_edges }
    }

    /// The problem on which Lemke's method proposes. For the round cone its polygons are turned to the trial tractions.
    pub(super) fn proposing(&self) -> &Problem<'g, D, C> {
        if !self.problem.round {
            return self.problem;
        }
        self.proposing.get_or_init(|| on_polygons(self.problem, self.settings.cone, &self.state.forces))
    }

    /// [`Self::proposing`] with facets for infinite friction, if any contact has it. Such a contact loses its tangential force when it
    /// opens, which only facets can express.
    pub(super) fn with_edges(&self) -> Option<&Problem<'g, D, C>> {
        let infinite = || self.problem.locals().any(|local| local.never_slides());
        let make =
            || infinite().then(|| Problem { infinite_friction_has_edges: true, ..self.proposing().clone() });
        self.with_edges.get_or_init(make).as_ref()
    }
}

/// Result of one rung.
pub(super) enum Attempt<D: Size, const C: usize> {
    Found(Found<D, C>, Rung),
    /// A proof that no equilibrium exists.
    Proof(Settled<D, C>),
    /// Neither; the next rung follows.
    Nothing,
    /// Neither, and the rungs above cost more than the answer is worth.
    Stop,
}

impl<D: Size, const C: usize> Attempt<D, C> {
    pub(super) fn by(rung: Rung, found: Option<Found<D, C>>) -> Self {
        found.map_or(Self::Nothing, |found| Self::Found(found, rung))
    }
}

/// Effort so far, and the reason if the search stays undecided.
pub(super) struct Log {
    pub(super) effort: Effort,
    /// The reason that is reported if no rung decides.
    pub(super) doubt: Doubt,
}

/// The problem with each contact's polygon turned so that one corner lies along the trial traction. While the traction
/// keeps this direction, the polygon is as good as the round cone.
pub(super) fn on_polygons<'g, D: Size, const C: usize>(
    problem: &Problem<'g, D, C>,
    cone: PolygonCone,
    trial: &[SVector<f64, C>],
) -> Problem<'g, D, C> {
    let polygon = Polygon::new(&cone);
    let turn = |traction: &SVector<f64, C>| {
        if traction[1] == 0.0 && traction[2] == 0.0 { polygon.clone() } else { polygon.turned_to(traction) }
    };
    Problem { turned: trial.iter().map(turn).collect(), ..problem.clone() }
}
