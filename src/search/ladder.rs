//! The ladder: a list of rungs, the cheapest first, and a loop that climbs it until one rung finds an equilibrium or proves that there
//! is none.

use std::cell::OnceCell;

use super::answer::{Doubt, Effort, Found, Rung, Settled};
use super::proposals::on_polygons;
use super::rungs::{
    every_case, every_combination, everything_rolls, force_form, kinematic_form, kinematic_form_on_states,
    kinematic_form_with_edges, newton_on_answers, other_polygons, separating_motion,
    separating_motion_of_many, touching_contacts_roll,
};
use super::settings::Settings;
use crate::contact::State;
use crate::object::{Piece, PieceState, Problem};

/// A question for an equilibrium, with its elastic trial state.
pub(super) struct Scene<'s, 'g, const D: usize, const C: usize> {
    pub(super) problem: &'s Problem<'g, D, C>,
    pub(super) settings: &'s Settings,
    /// The states of the trial: everything that is there sticks.
    pub(super) unjumped: Vec<State<C>>,
    pub(super) trial: Piece<D, C>,
    pub(super) state: PieceState<D, C>,
    proposing: OnceCell<Problem<'g, D, C>>,
    with_edges: OnceCell<Option<Problem<'g, D, C>>>,
}

impl<'g, const D: usize, const C: usize> Scene<'_, 'g, D, C> {
    /// The problem that Lemke's method proposes on: for the round cone that with polygons turned to the trial tractions.
    pub(super) fn proposing(&self) -> &Problem<'g, D, C> {
        if !self.problem.round {
            return self.problem;
        }
        self.proposing.get_or_init(|| on_polygons(self.problem, self.settings.cone, &self.state.forces))
    }

    /// The same with facets for infinite friction, if any contact has it. Such a contact has to let go of its tangential force when it
    /// opens, and only facets do that.
    pub(super) fn with_edges(&self) -> Option<&Problem<'g, D, C>> {
        let infinite = || self.problem.locals().any(|local| local.never_slides());
        let make =
            || infinite().then(|| Problem { infinite_friction_has_edges: true, ..self.proposing().clone() });
        self.with_edges.get_or_init(make).as_ref()
    }
}

/// What one rung has to say.
pub(super) enum Attempt<const D: usize, const C: usize> {
    Found(Found<D, C>, Rung),
    /// No equilibrium, and why.
    Proof(Settled<D, C>),
    /// Neither; the next rung has its turn.
    Nothing,
    /// Neither, and the rungs above cost more than the answer is worth.
    Stop,
}

impl<const D: usize, const C: usize> Attempt<D, C> {
    pub(super) fn by(rung: Rung, found: Option<Found<D, C>>) -> Self {
        found.map_or(Self::Nothing, |found| Self::Found(found, rung))
    }
}

/// What the rungs leave behind for those above, and for the answer.
pub(super) struct Log {
    pub(super) effort: Effort,
    /// Why nothing could be said, if nothing can be said in the end.
    pub(super) doubt: Doubt,
}

type TryRung<const D: usize, const C: usize> = fn(&Scene<'_, '_, D, C>, &mut Log) -> Attempt<D, C>;

/// Climbs the ladder.
pub(crate) fn settle<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    settings: &Settings,
) -> (Settled<D, C>, Effort) {
    let ladder: [TryRung<D, C>; 12] = [
        everything_rolls,
        touching_contacts_roll,
        newton_on_answers,
        kinematic_form_on_states,
        separating_motion_of_many,
        kinematic_form,
        kinematic_form_with_edges,
        force_form,
        separating_motion,
        other_polygons,
        every_case,
        every_combination,
    ];
    let effort = Effort { facets: problem.polygon.normals.len(), ..Effort::default() };
    let mut log = Log { effort, doubt: Doubt::RayWithoutProof };
    let unjumped = problem.unjumped();
    let trial = Piece::new(problem, &unjumped);
    let state = match trial.solve(problem.sites, &problem.drives, problem.load()) {
        Ok(state) => state,
        Err(unbalanced) => {
            let on_the_boundary = Settled::Undecided(Doubt::OnTheBoundary);
            return (unbalanced.motion.map_or(on_the_boundary, Settled::FreeMotion), log.effort);
        }
    };
    let (proposing, with_edges) = (OnceCell::new(), OnceCell::new());
    let scene = Scene { problem, settings, unjumped, trial, state, proposing, with_edges };
    for attempt in ladder {
        match attempt(&scene, &mut log) {
            Attempt::Found(found, rung) => return (Settled::Found(found, rung), log.effort),
            Attempt::Proof(settled) => return (settled, log.effort),
            Attempt::Nothing => {}
            Attempt::Stop => break,
        }
    }
    (Settled::Undecided(log.doubt), log.effort)
}
