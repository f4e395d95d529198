//! The onset (the load factor at which the first contact ceases to stick), found without stepping. The base load acts from the start, and the load of
//! the question grows in addition. The drives of a hand (the springs of its joints and tendons, with their force limits) are treated like contacts.
//!
//! While everything sticks, forces are affine in the load factor, `F(τ) = F⁰ + τ F¹`. Two linear solves give the forces F⁰ under the base load and
//! their rate F¹. The onset is the smallest τ at which a contact reaches the boundary of its cone. Each facet of a polygonal cone gives a linear
//! equation for τ, the round cone a quadratic one. The onset is the first pivot of Lemke's method with the load as covering vector. An open contact
//! may close before the onset. Such a contact starts with F_t = 0, and sticks if the rate of its force lies in its cone.

use super::beyond::{Beyond, EquilibriumEnd, beyond_end, continuation};
use super::end_of_path::leaving_motions;
use super::first_to_leave::first_to_leave;
use super::onset::{Onset, OnsetEvent};
use super::onset_workspace::OnsetMemory;
use super::program_run::SearchAtRest;
use super::ramp::Ramp;
use super::segment::Segment;
use super::sticking_path::StickingPath;
use super::trajectory::Trajectory;
use super::turn::EdgeTouch;
use crate::contact::State;
use crate::equilibrium::{AnswerFor, Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{IntoList, Memory};
use crate::object::{Load, Problem};
use crate::prelude::*;
use crate::search::{FoundBy, SearchCounts, SearchOutcome, SearchSolution, Settings, settle, settle_at_rest};

impl Engine {
    pub(crate) fn onset(&self, ramp: &Ramp<3>, settings: &Settings) -> Result<Onset<3>, Error> {
        self.onset_in_memory(ramp, settings, &mut OnsetMemory::default())
    }

    /// The onset along `ramp`, computed in the scratch buffers `memory`. The storage of the caller's last answer `returned` is used again for the new
    /// answer.
    pub(crate) fn onset_in(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
        memory: &mut Memory,
        returned: Option<Onset<3>>,
    ) -> Result<Onset<3>, Error> {
        let memory = memory.of(OnsetMemory::default);
        if let Some(returned) = returned {
            memory.reclaim(returned);
        }
        self.onset_in_memory(ramp, settings, memory)
    }

    /// The onset along `ramp`, and the result of the search for the equilibrium under the base load, so that a load path can start from this
    /// equilibrium. This result is `None` if the onset was found without the search.
    pub(crate) fn onset_from_rest(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
    ) -> Result<(Onset<3>, Option<SearchAtRest>), Error> {
        let mut memory = OnsetMemory::default();
        let onset = self.onset_in_memory(ramp, settings, &mut memory)?;
        Ok((onset, memory.rest))
    }

    fn onset_in_memory(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
        memory: &mut OnsetMemory,
    ) -> Result<Onset<3>, Error> {
        let base = self.load_alone(&ramp.base, "base load")?;
        let direction = self.inside(&ramp.direction, "load direction")?;
        ramp.offset_changes_into(self, &mut memory.change)?;
        let segment = memory.segment(self, settings, Trajectory::Straight { from: base, rate: direction });
        memory.rest = None;
        if let Some(first) = first_to_leave(&segment, memory) {
            let load = ramp.load_at(first.factor);
            return Ok(first.onset(segment, load, memory));
        }
        let trajectory = Trajectory::Straight { from: ramp.base, rate: ramp.direction };
        let rest = settle_at_rest(&segment.problem, settings);
        let onset = self.onset_with_closing(segment, &rest, (trajectory, f64::INFINITY), settings).0;
        memory.rest = Some(rest);
        Ok(onset)
    }

    /// The onset as the load follows `trajectory` up to the load factor `end`, in the general case in which contacts may close before the onset.
    /// `rest` is the result of the search for the equilibrium at load factor 0. Also returns the contacts and drives that touch their limit before.
    pub(super) fn onset_with_closing<'a>(
        &'a self,
        segment: Segment<'a>,
        rest: &SearchAtRest,
        (trajectory, end): (Trajectory<Wrench<3>>, f64),
        settings: &'a Settings,
    ) -> (Onset<3>, Vec<EdgeTouch>) {
        let (found, rule) = match self.sticking_base(&segment, &trajectory, rest) {
            Ok(base) => base,
            Err(onset) => return (*onset, Vec::new()),
        };
        let mut walk =
            StickingPath { segment, trajectory, end, settings, rule, factor: 0.0, touches: Vec::new() };
        let onset = walk.run(found.states);
        let touch = |(site, angle)| Some(EdgeTouch { of: self.edge_of(site)?, angle });
        (onset, walk.touches.into_iter().filter_map(touch).list())
    }

    /// The equilibrium at the onset `event`; `None` if `event` and the grasp have different numbers of contacts and drives.
    pub(crate) fn state_at_onset(
        &self,
        event: &OnsetEvent<3>,
        settings: &Settings,
    ) -> Option<Equilibrium<3>> {
        let problem = self.problem_at_onset(event)?;
        let (found, rule) = (event.local.found.found(), event.local.rule);
        let answer_for = AnswerFor { cone: event.cone, small: settings.small_motions };
        Some(self.equilibrium(&problem, &event.load, found, rule, &SearchCounts::default(), answer_for))
    }

    /// The situation just beyond the onset `event`; `None` if `event` and the grasp have different numbers of contacts and drives.
    pub(crate) fn beyond(&self, event: &OnsetEvent<3>, settings: &Settings) -> Option<Beyond<3>> {
        let problem = self.problem_at_onset(event)?;
        let local = &event.local;
        let answer_for = AnswerFor { cone: event.cone, small: settings.small_motions };
        let change = local.offset_rates.clone();
        let trajectory = Trajectory::Straight { from: local.wrench.to(), rate: local.wrench_rate.to() };
        let segment = Segment { grasp: self, answer_for, problem, change, trajectory, largest: 0.0 };
        let rates = segment.rates(0.0, segment.laws_of_rates(&local.active_sets, &local.found.states));
        let (settled, effort) = match settle(&rates, settings) {
            (SearchOutcome::Found(found, rule), _) => return Some(continuation(self, &rates, found, rule)),
            lost => lost,
        };
        let motions = leaving_motions(&rates, &segment.problem.wrench, &rates.yielding());
        let motion = motions.map(|[_, against]| against);
        let end = EquilibriumEnd { factor: 0.0, forces: &local.found.forces, motion };
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, settings))
    }

    /// The static problem at the onset `event`; `None` if `event` and the grasp have different numbers of contacts and drives.
    pub(super) fn problem_at_onset(&self, event: &OnsetEvent<3>) -> Option<Problem<'_>> {
        let local = &event.local;
        if local.found.states.len() != self.sites().len() {
            return None;
        }
        let problem = self.problem_on(event.cone, local.offsets.clone(), &Load::from(&local.wrench.to()));
        Some(Problem { slips: local.slips.clone(), ..problem })
    }

    /// The equilibrium at load factor 0, if no contact slides in it; otherwise the error is the [`Onset`] to return.
    fn sticking_base(
        &self,
        segment: &Segment<'_>,
        trajectory: &Trajectory<Wrench<3>>,
        (settled, effort): &SearchAtRest,
    ) -> Result<(SearchSolution, FoundBy), Box<Onset<3>>> {
        let (problem, answer_for) = (&segment.problem, segment.answer_for);
        let slides = |found: &SearchSolution| found.states.iter().any(State::slides);
        match settled {
            SearchOutcome::Found(found, rule) if !slides(found) => {
                return Ok((found.clone(), *rule));
            }
            _ => {}
        }
        Err(Box::new(match self.outcome(problem, &trajectory.at(0.0), settled.clone(), effort, answer_for) {
            Outcome::Equilibrium(equilibrium) => Onset::AlreadySliding(equilibrium),
            Outcome::NoEquilibrium(none) => Onset::NoBase(none),
            Outcome::Undecided(doubt) => Onset::Undecided(doubt),
        }))
    }
}
