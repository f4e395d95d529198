//! The load path: every event of a load program with its exact load, with slip memory.
//!
//! While every contact keeps its state everything is affine in the fraction of the leg, so the next event is a ratio test; or it turns with
//! the load, and the next event is a root (see [`super::straight`], [`super::turned`]). Where something slides on a round cone its direction
//! turns (see [`super::turning`]).
//! At an event some contacts stand on an edge of their cone, at its apex or at a closed gap. They form a small complementarity
//! problem in rates. Its solution is the next straight piece, and without a solution the path ends.

use super::beyond::{Beyond, End, beyond_end};
use super::energy::Energy;
use super::event::{Event, PathEnd};
use super::flow::{Reached, Rule};
use super::leg::{Leg, Program};
use super::node::Node;
use super::pace::Pace;
use super::segment::{Here, Segment};
use super::stretch::{Bend, Stretch};
use crate::contact::{Polygon, WEIGHTLESS};
use crate::equilibrium::{ACCURATE, Cone, Equilibrium};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::object::{Load, PieceState};
use crate::search::{Doubt, Settings, Settled, settle};

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
pub struct LoadPath<'g, const D: usize, const C: usize> {
    pub(super) grasp: &'g Grasp<D, C>,
    pub(super) settings: Settings,
    pub(super) program: Program<D, C>,
    pub(super) factor: f64,
    pub(super) segment: Segment<'g, D, C>,
    pub(super) node: Node<D, C>,
    /// Whether it has yet to be decided how the path goes on from here.
    pub(super) at_node: bool,
    pub(super) here: Option<Here<D, C>>,
    pub(super) pieces: Vec<Stretch<'g, D, C>>,
    pub(super) energy: Vec<Energy>,
    pub(super) stalls: usize,
    pub(super) pace: Pace,
    /// Sum of the estimated errors of the steps along sliding arcs.
    step_error: f64,
    pub(super) end: Option<PathEnd<D, C>>,
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
        let polygon = Polygon::shared(&settings.cone);
        let (round, wrench) = (settings.is_round::<C>(), self.load_alone(start, "start load")?);
        let problem = self.problem(polygon, round, self.drives(), &Load::from(&wrench));
        let mut program = Program::new(self, *start);
        program.extend(self, legs)?;
        let (settled, effort) = settle(&problem, settings);
        let cone = Cone::of::<C>(settings);
        let (start_state, end) = match settled {
            Settled::Found(found, _) => (Some(found), None),
            lost => {
                let outcome = self.outcome(&problem, start, lost, &effort, cone);
                (None, Some(PathEnd::NoStart(Box::new(outcome))))
            }
        };
        let (change, course) = (self.drive_changes(None, None), program.inside_course(self));
        let mut segment = Segment { grasp: self, cone, problem, change, course, largest: 0.0 };
        let mut path = LoadPath {
            grasp: self,
            settings: *settings,
            program,
            factor: 0.0,
            node: Node::at_start(&mut segment, start_state),
            segment,
            at_node: false,
            here: None,
            pieces: Vec::new(),
            energy: Vec::new(),
            stalls: 0,
            pace: Pace::new(),
            step_error: 0.0,
            end,
        };
        if path.end.is_none() {
            path.begin_leg();
        }
        Ok(path)
    }
}

impl<'g, const D: usize, const C: usize> LoadPath<'g, D, C> {
    /// How the path ended; `None` while there is more to follow. `Completed` may become `None` again, see [`Self::continue_with`].
    #[must_use]
    pub fn end(&self) -> Option<&PathEnd<D, C>> {
        self.end.as_ref()
    }

    /// Whether another equilibrium exists just beyond where this one was lost; `None` where the path has not been lost.
    /// See [`Self::beyond_with`].
    #[must_use]
    pub fn beyond(&self) -> Option<Beyond<D, C>> {
        self.beyond_with(&self.settings)
    }

    /// Whether another equilibrium exists just beyond where this one was lost, with the slip so far, sought as far as these [`Settings`]
    /// allow. That takes longer than the path as a rule, in space up to a proof over all contact states. `None` where the path has not been
    /// lost.
    #[must_use]
    pub fn beyond_with(&self, settings: &Settings) -> Option<Beyond<D, C>> {
        let loss = self.end.as_ref()?.loss()?;
        let laws = self.segment.laws_of_rates(&self.node.stands, &self.node.states);
        let rates = self.segment.rates(self.node.ahead, laws);
        let motion = loss.motion.map(|motion| self.grasp.inside_twist(&motion));
        let end = End { factor: loss.fraction, forces: &self.node.at.forces, motion };
        let (settled, effort) = settle(&rates, settings);
        Some(beyond_end(&self.segment, &rates, (settled, &effort), &end, settings))
    }

    /// Follows the path to its end and returns the events on the way.
    pub fn run(&mut self) -> Vec<Event<D, C>> {
        self.by_ref().collect()
    }

    /// Appends legs to the program; a completed path goes on, one that has ended otherwise does not.
    ///
    /// # Errors
    /// As for [`Grasp::follow`].
    pub fn continue_with(&mut self, legs: &[Leg<D, C>]) -> Result<(), Error> {
        self.program.extend(self.grasp, legs)?;
        if matches!(self.end, Some(PathEnd::Completed)) && !legs.is_empty() {
            self.end = None;
            self.begin_leg();
        }
        Ok(())
    }

    /// Sum of the estimated errors of all steps along sliding arcs on the round cone, each below [`Settings::step_error`] unless
    /// rounding forbids that; zero where nothing had to be integrated, as always in the plane and on polygons.
    ///
    /// An estimate is for forces over the largest force of the step and for displacements over the largest one, whichever is worse. As a
    /// rule the error is smaller. What an earlier error becomes later on is not in it; sliding forgets most of it.
    #[must_use]
    pub fn step_error(&self) -> f64 {
        self.step_error
    }

    /// Energies of every leg that was entered, J, up to where the path has been followed.
    #[must_use]
    pub fn energies(&self) -> &[Energy] {
        &self.energy
    }

    /// The equilibrium at a fraction (0 to 1) of a leg (from 0) that the path has passed; `None` beyond. Where an event lies
    /// exactly there, the state before it. On a sliding arc the step is made again up to there, to the same error; `None` where
    /// rounding does not allow that.
    #[must_use]
    pub fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<D, C>> {
        let on = |s: &&Stretch<D, C>| s.leg == leg && fraction >= s.from && fraction <= s.to;
        self.pieces.iter().find(on).and_then(|stretch| self.state_on(stretch, fraction))
    }

    /// Where the path stands: leg, fraction and the equilibrium there; `None` before its first piece.
    #[must_use]
    pub fn position(&self) -> Option<(usize, f64, Equilibrium<D, C>)> {
        let last = self.pieces.last()?;
        Some((last.leg, last.to, self.state_on(last, last.to)?))
    }

    fn state_on(&self, stretch: &Stretch<'g, D, C>, fraction: f64) -> Option<Equilibrium<D, C>> {
        stretch.state_at(self.grasp, self.segment.cone, fraction)
    }

    /// Sets out on the present leg, or completes the path.
    pub(super) fn begin_leg(&mut self) {
        if !self.program.begin_leg() {
            self.end = Some(PathEnd::Completed);
            return;
        }
        let course = self.program.inside_course(self.grasp);
        let [base, change] = self.program.drives(self.grasp);
        self.segment.course = course;
        self.segment.change = change;
        self.segment.largest = 0.0;
        // Counted anew from the goal of the last leg, so that rounding does not add up over many legs.
        self.segment.problem.wrench = course.at(0.0);
        self.segment.problem.drives =
            base.iter().zip(&self.segment.problem.slips).map(|(a, slip)| a - slip).collect();
        self.factor = 0.0;
        self.pace = Pace::new();
        self.energy.push(Energy::default());
        self.at_node = true;
    }

    /// Decides how the path goes on from here; an event if a contact changes its state.
    fn decide(&mut self) -> Option<Event<D, C>> {
        let before = self.pieces.last().and_then(|last| self.state_on(last, last.to));
        let (leg, load) = (self.program.leg, self.program.load_at(self.factor));
        match self.node.go_on(&mut self.segment, leg, self.factor, load, &self.settings) {
            Err(end) => {
                self.end = Some(end);
                None
            }
            Ok(onward) => {
                let free = self.here.as_ref().map_or(0, |here| here.free_motions.len());
                let set_free = onward.here.free_motions.len() > free;
                let free_motions = onward.here.free_motions.iter().map(|v| self.grasp.outside(v)).collect();
                self.here = Some(onward.here);
                self.pace = self.pace.at_node();
                let (changes, drives) = self.grasp.told_apart(onward.changes);
                if changes.is_empty() && drives.is_empty() && !(set_free && before.is_some()) {
                    return None;
                }
                let state = before.or_else(|| self.present_state())?;
                // Where all forces vanish together what is left of them is no yardstick for their residuals.
                let largest = state.contacts.iter().map(|contact| contact.force.norm()).fold(0.0, f64::max);
                let carries = largest > WEIGHTLESS * self.segment.largest;
                if carries && state.residuals.worst() > ACCURATE {
                    let doubt = Doubt::Inaccurate;
                    self.end = Some(PathEnd::Undecided { leg, fraction: self.factor, doubt });
                    return None;
                }
                Some(Event {
                    leg,
                    fraction: self.factor,
                    load,
                    changes,
                    drives,
                    state,
                    free_motions,
                    other_continuations: onward.other_continuations,
                })
            }
        }
    }

    fn present_state(&self) -> Option<Equilibrium<D, C>> {
        let here = self.here.clone()?;
        let there = self.state_after(&here, 0.0);
        self.state_on(&self.stretch(here, self.factor, there), self.factor)
    }

    pub(super) fn stretch(&self, here: Here<D, C>, to: f64, there: PieceState<D, C>) -> Stretch<'g, D, C> {
        Stretch {
            leg: self.program.leg,
            from: self.factor,
            to,
            problem: self.segment.problem.clone(),
            change: self.segment.change.clone(),
            course: self.segment.course,
            load: self.program.course,
            states: self.node.states.clone(),
            here,
            there,
            bend: None,
        }
    }

    /// Takes a step of this length along a sliding arc.
    pub(super) fn take(&mut self, here: &Here<D, C>, (length, rule): (f64, Rule), reached: &Reached<D, C>) {
        let (at, to) = (reached.at(), reached.to);
        if let Some(energy) = self.energy.last_mut() {
            energy.add_part(&reached.energy);
        }
        self.step_error += reached.error;
        let bend = self.pace.unit.map(|unit| Bend { unit, length, rule });
        let stretch = self.stretch(here.clone(), to, at.clone());
        self.pieces.push(Stretch { bend, ..stretch });
        self.node.arrive(&mut self.segment, here, to, &at);
        self.factor = to;
    }
}

impl<const D: usize, const C: usize> Iterator for LoadPath<'_, D, C> {
    type Item = Event<D, C>;

    fn next(&mut self) -> Option<Event<D, C>> {
        while self.end.is_none() {
            if std::mem::take(&mut self.at_node) {
                if let Some(event) = self.decide() {
                    return Some(event);
                }
            } else if self.node.turns() {
                self.advance_along_arc();
            } else {
                self.advance_straight();
            }
        }
        None
    }
}
