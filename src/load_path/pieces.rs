//! Every event of a load program with its exact load, piece by piece: for a few contacts.
//!
//! While every contact keeps its state everything is affine in the fraction of the leg, so the next event is a ratio test; or it turns with
//! the load, and the next event is a root (see [`super::straight`], [`super::turned`]). Where something slides on a round cone its direction
//! turns (see [`super::turning`]).
//! At an event some contacts stand on an edge of their cone, at its apex or at a closed gap. They form a small complementarity
//! problem in rates. Its solution is the next straight piece, and without a solution the path ends.

use nalgebra::SVector;

use super::course::Course;
use super::energy::Energy;
use super::event::{Event, PathEnd};
use super::flow::{Reached, Rule};
use super::follower::{Came, Edge, Follower};
use super::journey::Journey;
use super::leg::Leg;
use super::node::Node;
use super::pace::Pace;
use super::path::Path;
use super::segment::{Here, Segment};
use super::stretch::{Bend, Stretch};
use crate::contact::WEIGHTLESS;
use crate::equilibrium::{ACCURATE, Equilibrium};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::object::{PieceState, Problem};
use crate::search::{Doubt, Settings};

/// A load program being followed: an iterator over its [`Event`]s that keeps the straight pieces behind it. Made by
/// [`Grasp::follow`]; when the iterator has ended, [`end`](Self::end) says how the path did.
///
/// ```
/// use grasp_lcp::planar::{Change, Contact, Grasp, Leg, PathEnd, Wrench};
///
/// // A block of two springs in parallel, the second slides first: pulled, the stiffness halves on the way.
/// let foot = |x: f64, mu: f64| {
///     Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(mu).command([0.1, 0.0])
/// };
/// let guide = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0);
/// let grasp = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.25), guide])?;
/// let mut path = grasp.follow(&Wrench::ZERO, &[Leg::load_to(Wrench::force([0.6, 0.0]))])?;
/// let events: Vec<_> = path.by_ref().collect();
/// assert_eq!(events[0].changes[0].0, 1);
/// // The guide gives way by 1/51: F_n = 50/51 N. Each foot carries half of the pull, up to 0.25 F_n.
/// let slides_at = 2.0 * 0.25 * 50.0 / 51.0;
/// assert!((events[0].load.resultant()[0] - slides_at).abs() < 1e-14);
/// assert!(matches!(path.end(), Some(PathEnd::Completed)));
///
/// // Let go, the second foot sticks at once and keeps what it has slipped: backwards, against the pull.
/// path.continue_with(&[Leg::load_to(Wrench::ZERO)])?;
/// assert!(matches!(path.run()[0].changes[..], [(1, Change::Sticks)]));
/// let end = path.state_at(1, 1.0).expect("has passed");
/// assert!((end.contacts[1].slip[1] + (0.6 - slides_at) / 10.0).abs() < 1e-14);
/// assert!(path.energies()[0].dissipated > 0.0 && path.energies()[1].dissipated == 0.0);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
pub type LoadPath<'g, const D: usize, const C: usize> = Path<'g, D, C, Pieces<'g, D, C>>;

/// The follower of a [`LoadPath`]: keeps the pieces behind it.
#[derive(Debug)]
pub struct Pieces<'g, const D: usize, const C: usize> {
    pub(super) factor: f64,
    pub(super) segment: Segment<'g, D, C>,
    pub(super) node: Node<D, C>,
    /// Whether it has yet to be decided how the path goes on from here.
    pub(super) at_node: bool,
    pub(super) here: Option<Here<D, C>>,
    /// The pieces that the path has passed.
    pub(super) behind: Vec<Stretch<'g, D, C>>,
    pub(super) energy: Vec<Energy>,
    pub(super) stalls: usize,
    pub(super) pace: Pace,
    /// Sum of the estimated errors of the steps along sliding arcs.
    step_error: f64,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Follows a load program from the equilibrium under `start` (that of [`Self::solve`]) with the finger commands of the grasp, on the
    /// exact cone: in space the round one. Nothing is computed beyond the start until the path is asked for an event. See [`LoadPath`],
    /// and [`Leg`] for an example. For hundreds of contacts and more there are [`Self::follow_patch`] and [`Self::follow_in_steps`].
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load, [`Error::Contact`] if a command of a leg is not finite or beyond 1e50; [`Error::Size`] if a leg has more
    /// or fewer commands than there are contacts. That there is no equilibrium to start from is [`PathEnd::NoStart`].
    pub fn follow(&self, start: &Wrench<D, C>, legs: &[Leg<D, C>]) -> Result<LoadPath<'_, D, C>, Error> {
        self.follow_with(start, legs, &Settings::default())
    }

    /// The same with other [`Settings`]: on a polygon, or on the round cone with another error of the steps.
    ///
    /// # Errors
    /// As for [`Self::follow`].
    pub fn follow_with(
        &self,
        start: &Wrench<D, C>,
        legs: &[Leg<D, C>],
        settings: &Settings,
    ) -> Result<LoadPath<'_, D, C>, Error> {
        Path::start(self, (start, legs), settings, Pieces::at_start)
    }
}

impl<const D: usize, const C: usize> LoadPath<'_, D, C> {
    /// Sum of the estimated errors of all steps along sliding arcs on the round cone, each below [`Settings::step_error`] unless
    /// rounding forbids that; zero where nothing had to be integrated, as always in the plane and on polygons.
    ///
    /// An estimate is for forces over the largest force of the step and for displacements over the largest one, whichever is worse. As a
    /// rule the error is smaller. What an earlier error becomes later on is not in it; sliding forgets most of it.
    #[must_use]
    pub fn step_error(&self) -> f64 {
        self.follower.as_ref().map_or(0.0, |pieces| pieces.step_error)
    }

    /// Energies of every leg that was entered, J, up to where the path has been followed.
    #[must_use]
    pub fn energies(&self) -> &[Energy] {
        self.follower.as_ref().map_or(&[], |pieces| &pieces.energy)
    }

    /// The equilibrium at a fraction (0 to 1) of a leg (from 0) that the path has passed or stands at; `None` beyond. Where an event lies
    /// exactly there, the state before it. On a sliding arc the step is made again up to there, to the same error; `None` where
    /// rounding does not allow that.
    #[must_use]
    pub fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<D, C>> {
        let pieces = self.follower.as_ref()?;
        let on = |s: &&Stretch<'_, D, C>| s.leg == leg && fraction >= s.from && fraction <= s.to;
        match pieces.behind.iter().find(on) {
            Some(stretch) => pieces.state_on(stretch, fraction),
            None if self.place() == (leg, fraction) => self.state(),
            None => None,
        }
    }
}

impl<'g, const D: usize, const C: usize> Follower<'g, D, C> for Pieces<'g, D, C> {
    type Told = Event<D, C>;

    fn set_out(&mut self, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<D, C>> {
        self.segment = journey.segment(std::mem::take(&mut self.segment.problem.slips));
        self.factor = 0.0;
        self.pace = Pace::new();
        self.energy.push(Energy::default());
        self.at_node = true;
        Ok(())
    }

    fn go_on(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<Event<D, C>>, PathEnd<D, C>> {
        if std::mem::take(&mut self.at_node) {
            return Ok(self.decide(journey)?.map_or(Came::OnTheWay, Came::To));
        }
        let leg_done =
            if self.node.turns() { self.advance_along_arc(journey) } else { self.advance_straight(journey) };
        Ok(if leg_done? { Came::ToTheEndOfTheLeg } else { Came::OnTheWay })
    }

    fn fraction(&self) -> f64 {
        self.factor
    }

    fn state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<D, C>> {
        match self.behind.last() {
            Some(last) => self.state_on(last, last.to),
            None => self.present_state(journey),
        }
    }

    fn forces(&self, _: &Journey<'g, D, C>) -> Vec<SVector<f64, C>> {
        self.node.at.forces.clone()
    }

    fn edge(&self, _: &Journey<'g, D, C>) -> Edge<'g, D, C> {
        let laws = self.segment.laws_of_rates(&self.node.stands, &self.node.states);
        let rates = self.segment.rates(self.node.ahead, laws);
        Edge { segment: self.segment.clone(), rates, forces: self.node.at.forces.clone() }
    }
}

impl<'g, const D: usize, const C: usize> Pieces<'g, D, C> {
    /// Stands at the equilibrium to start from, if there is one.
    fn at_start(journey: &Journey<'g, D, C>, problem: &Problem<'g, D, C>) -> Result<Self, PathEnd<D, C>> {
        let found = journey.start(problem)?;
        // At rest: nothing changes yet.
        let change = journey.grasp.drive_changes(None, None);
        let course = Course::Straight { from: problem.wrench, rate: SVector::zeros() };
        let (grasp, cone, problem) = (journey.grasp, journey.cone(), problem.clone());
        let mut segment = Segment { grasp, cone, problem, change, course, largest: 0.0 };
        Ok(Self {
            factor: 0.0,
            node: Node::at_start(&mut segment, found),
            segment,
            at_node: false,
            here: None,
            behind: Vec::new(),
            energy: Vec::new(),
            stalls: 0,
            pace: Pace::new(),
            step_error: 0.0,
        })
    }

    fn state_on(&self, stretch: &Stretch<'g, D, C>, fraction: f64) -> Option<Equilibrium<D, C>> {
        stretch.state_at(self.segment.grasp, self.segment.cone, fraction)
    }

    /// Decides how the path goes on from here; an event if a contact changes its state.
    fn decide(&mut self, journey: &Journey<'g, D, C>) -> Result<Option<Event<D, C>>, PathEnd<D, C>> {
        let before = self.behind.last().and_then(|last| self.state_on(last, last.to));
        let onward = self.node.go_on(&mut self.segment, journey, self.factor)?;
        let grasp = journey.grasp;
        let free = self.here.as_ref().map_or(0, |here| here.free_motions.len());
        let set_free = onward.here.free_motions.len() > free;
        let free_motions = onward.here.free_motions.iter().map(|v| grasp.outside(v)).collect();
        self.here = Some(onward.here);
        self.pace = self.pace.at_node();
        let (changes, drives) = grasp.told_apart(onward.changes);
        if changes.is_empty() && drives.is_empty() && !(set_free && before.is_some()) {
            return Ok(None);
        }
        let Some(state) = before.or_else(|| self.present_state(journey)) else { return Ok(None) };
        // Where all forces vanish together what is left of them is no yardstick for their residuals.
        let largest = state.contacts.iter().map(|contact| contact.force.norm()).fold(0.0, f64::max);
        let carries = largest > WEIGHTLESS * self.segment.largest;
        if carries && state.residuals.worst() > ACCURATE {
            return Err(journey.undecided(self.factor, Doubt::Inaccurate));
        }
        Ok(Some(Event {
            leg: journey.program.leg,
            fraction: self.factor,
            load: journey.program.load_at(self.factor),
            changes,
            drives,
            state,
            free_motions,
            other_continuations: onward.other_continuations,
        }))
    }

    /// Where the path stands in its present states.
    fn present_state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<D, C>> {
        let here = match &self.here {
            Some(here) => here.clone(),
            None => self.node.look(&self.segment, self.factor).ok()?,
        };
        let there = self.state_after(&here, 0.0);
        self.state_on(&self.stretch(journey, here, self.factor, there), self.factor)
    }

    pub(super) fn stretch(
        &self,
        journey: &Journey<'g, D, C>,
        here: Here<D, C>,
        to: f64,
        there: PieceState<D, C>,
    ) -> Stretch<'g, D, C> {
        Stretch {
            leg: journey.program.leg,
            from: self.factor,
            to,
            problem: self.segment.problem.clone(),
            change: self.segment.change.clone(),
            course: self.segment.course,
            load: journey.program.course,
            states: self.node.states.clone(),
            here,
            there,
            bend: None,
        }
    }

    /// Takes a step of this length along a sliding arc.
    pub(super) fn take(
        &mut self,
        journey: &Journey<'g, D, C>,
        here: &Here<D, C>,
        (length, rule): (f64, Rule),
        reached: &Reached<D, C>,
    ) {
        let (at, to) = (reached.at(), reached.to);
        if let Some(energy) = self.energy.last_mut() {
            energy.add_part(&reached.energy);
        }
        self.step_error += reached.error;
        let bend = self.pace.unit.map(|unit| Bend { unit, length, rule });
        let stretch = self.stretch(journey, here.clone(), to, at.clone());
        self.behind.push(Stretch { bend, ..stretch });
        self.node.arrive(&mut self.segment, here, to, &at);
        self.factor = to;
    }
}
