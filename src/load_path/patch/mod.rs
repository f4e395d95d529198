//! Load programs followed for thousands of contacts: each event costs about as much as the contacts that it concerns.
//!
//! [`LoadPath`](super::LoadPath) keeps every piece of a path as a whole and asks every contact at every event: n events of n contacts. Here
//! contacts are in known states, all that couples them is the motion of the object, and everything is affine in that motion and the
//! fraction of the leg, a straight line in d + 1 dimensions from event to event. So
//!
//! * an event changes one or two terms of the d x d stiffness `T = Σ G K^t Gᵀ`, and one d x d system gives the next piece (see `balance`);
//! * a contact need not be looked at before the path has gone as far as it takes to use up one of its conditions (see `queue`, `ratio`);
//! * at an event only what stands on an edge is asked what comes next, and what slides elsewhere only when the direction of the path has
//!   turned far enough to stop it (see `decide`). Where that does not arrive the ladder of the equilibrium is asked about all contacts.

mod balance;
mod decide;
mod event;
mod ladder;
mod layout;
mod local;
mod queue;
mod ratio;
mod standing;
mod start;
mod write_out;

use std::sync::Arc;

use nalgebra::SVector;

pub use event::PatchEvent;

use self::balance::Sums;
use self::layout::Springs;
use self::local::Local;
use self::queue::{Course, Queue};
use self::ratio::{Exit, Piece};
use self::standing::Stand;
use super::event::PathEnd;
use super::leg::{Leg, Program};
use crate::contact::{Polygon, PolygonCone, PolygonState};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::numerics::Factors;
use crate::search::Settings;

/// Zero steps in a row that are still events of one node and not rounding that goes in circles.
const MOST_STALLS: usize = 64;

/// A load program being followed for many contacts: an iterator over its [`PatchEvent`]s, one contact at a time. Made by
/// [`Grasp::follow_patch`]; when the iterator has ended, [`end`](Self::end) says how the path did.
///
/// The law is that of [`LoadPath`](super::LoadPath), with slip memory, in space **on the polygonal cone**; legs are the same. Between
/// events [`state`](Self::state) tells the equilibrium where the path stands, [`next_before`](Self::next_before) stops anywhere on the way.
/// It does not say whether the continuation is unique, and keeps neither the pieces behind it nor energies.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// // A pad of a thousand springs under a rigid block, pressed most in the middle, dragged and let go.
/// let n = 1000;
/// let xi = |i: usize| (2 * i + 1) as f64 / n as f64 - 1.0;
/// let spring = |i: usize| {
///     let press = 1.0 - xi(i) * xi(i);
///     Contact::new([xi(i), 0.0], [0.0, 1.0]).series_stiffness(1.0, 0.8).friction(0.3).command([press, 0.0])
/// };
/// let grasp = Grasp::new((0..n).map(spring))?;
/// let pressed: f64 = (0..n).map(|i| 1.0 - xi(i) * xi(i)).sum();
/// let pull = |part: f64| Wrench::new([part * 0.3 * pressed, -pressed], 0.0);
///
/// let mut path = grasp.follow_patch(pull(0.0), &[Leg::load_to(pull(0.5)), Leg::load_to(pull(0.0))])?;
/// let events: Vec<_> = path.by_ref().collect();
/// assert!(matches!(path.end(), Some(grasp_lcp::load_path::PathEnd::Completed)));
/// // The rim slides on the way there and stays displaced: letting go is not the way back.
/// assert!(events.len() > 300);
/// assert!(path.state().unwrap().twist.translation()[0] > 0.0);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug)]
pub struct PatchPath<'g, const D: usize, const C: usize> {
    grasp: &'g Grasp<D, C>,
    settings: Settings,
    polygon: Arc<Polygon<C>>,
    program: Program<D, C>,
    springs: Springs<D>,
    locals: Vec<Local<D, C>>,
    facets: Vec<SVector<f64, C>>,
    /// What the sums over scaled Q are multiplied with.
    weight: f64,
    sums: Sums<D>,
    /// Changes since the sums were made.
    age: usize,
    factors: Factors<D>,
    /// Motion in the elastic trial state at the beginning of the leg, and its change along it.
    travelled: SVector<f64, D>,
    travel_rate: SVector<f64, D>,
    tau: f64,
    /// Motion on top of the trial state where the path stands, scaled as Q is, and its rate.
    y: SVector<f64, D>,
    y_rate: SVector<f64, D>,
    /// A unit of time along the leg that weighs as much as one of y.
    pace: f64,
    /// Contacts in line for their conditions, and the direction in which their clock runs.
    ahead: Queue,
    reference: Course<D>,
    /// The direction of the path when they were put in line.
    last_heading: Option<Course<D>>,
    /// Length and steps of the path since then.
    gone: f64,
    steps: usize,
    /// About how far it is to the next event.
    stride: f64,
    /// Sliding contacts in line for their slip rates, on the clock of the direction of the path.
    slipping: Queue,
    heading: Course<D>,
    /// Of these, those that were looked at and slip on.
    resting: Vec<(u32, u32, f64)>,
    looked: Vec<u32>,
    exits: Vec<Exit>,
    stands: Vec<Stand>,
    /// States and slips before the event of what stands there.
    before: Vec<(PolygonState, SVector<f64, C>)>,
    /// Whether it has yet to be decided how the path goes on from here.
    at_node: bool,
    sets_out: bool,
    stalls: usize,
    /// Events that have happened and were not told yet, the next one last.
    told: Vec<PatchEvent<D, C>>,
    looked_at: usize,
    end: Option<PathEnd<D, C>>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Follows a load program from the equilibrium under `start` with the finger commands of the grasp, for any number of
    /// contacts: an event costs about as much as the contacts that it concerns. In space on the default polygonal cone, 8 facets inside the
    /// round one. See [`PatchPath`].
    ///
    /// # Errors
    /// As for [`Self::follow`].
    pub fn follow_patch(&self, start: Wrench<D>, legs: &[Leg<D, C>]) -> Result<PatchPath<'_, D, C>, Error> {
        self.follow_patch_on(start, legs, PolygonCone::default())
    }

    /// The same on another polygonal cone; in the plane it is not looked at.
    ///
    /// # Errors
    /// As for [`Self::follow`].
    pub fn follow_patch_on(
        &self,
        start: Wrench<D>,
        legs: &[Leg<D, C>],
        cone: PolygonCone,
    ) -> Result<PatchPath<'_, D, C>, Error> {
        let wrench = self.inside(&start, "start load")?;
        let mut program = Program::new(self, start);
        program.extend(self, legs)?;
        let polygon = Polygon::shared(&cone);
        let mut path =
            PatchPath::new(self, program, polygon, Settings::default().with_cone(cone).on_the_polygon());
        path.start(&wrench);
        Ok(path)
    }
}

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// How the path ended; `None` while there is more to follow. Where equilibrium is lost among more than 32 contacts only a
    /// limit load that a motion proves is told from the rest ([`PathEnd::Ends`]: a limit load or a snap).
    #[must_use]
    pub fn end(&self) -> Option<&PathEnd<D, C>> {
        self.end.as_ref()
    }

    /// Where the path stands: leg, from 0, and fraction of it, from 0 to 1. Once completed the leg is the number of legs.
    #[must_use]
    pub fn position(&self) -> (usize, f64) {
        (self.program.leg, self.tau)
    }

    /// How often a contact has been looked at so far: a measure of the work that does not depend on the machine.
    #[must_use]
    pub fn contacts_looked_at(&self) -> usize {
        self.looked_at
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

    /// The next event up to a fraction (0 to 1) of a leg (from 0); `None` when the path stands there, or has ended before. To look at a state on
    /// the way, take events until there are none, then ask for [`state`](Self::state).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
    ///
    /// // A body of 2 N on two feet of 1 N: the second slides when each carries 0.25 N.
    /// let foot = |x: f64, mu: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(mu);
    /// let grasp = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.25)])?;
    /// let mut path = grasp.follow_patch(Wrench::force([0.0, -2.0]), &[Leg::load_by(Wrench::force([0.6, 0.0]))])?;
    ///
    /// assert!(path.next_before(0, 0.5).is_none());
    /// assert!((path.state().expect("on the way").contacts[1].tangential_force() + 0.15).abs() < 1e-15);
    /// let event = path.next_before(0, 1.0).expect("slides");
    /// assert!(event.contact == 1 && (event.load.resultant()[0] - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn next_before(&mut self, leg: usize, fraction: f64) -> Option<PatchEvent<D, C>> {
        while self.told.is_empty() && self.end.is_none() {
            if std::mem::take(&mut self.at_node) {
                let sets_out = self.sets_out;
                if let Err(end) = self.decide() {
                    self.end = Some(end);
                } else if sets_out {
                    self.last_heading = None;
                    self.looked.clear();
                    self.line_up();
                } else {
                    self.requeue();
                }
                continue;
            }
            let past = self.program.leg > leg || (self.program.leg == leg && self.tau >= fraction);
            if past {
                return None;
            }
            let most = if self.program.leg == leg { fraction.min(1.0) } else { 1.0 };
            self.advance(most);
        }
        self.told.pop()
    }

    /// Goes on to the next event of the leg, or up to this fraction of it.
    fn advance(&mut self, most: f64) {
        let before = self.tau;
        match self.first_exits(most - before) {
            Piece::ToAnEdge(step) => {
                self.go_to(before + step);
                self.correct(before);
                self.stalls = if self.tau > before { 0 } else { self.stalls + 1 };
                if self.stalls > MOST_STALLS {
                    self.end = Some(self.undecided());
                    return;
                }
                self.stand_where_it_ends();
                self.at_node = true;
            }
            Piece::ToTheEnd => {
                self.go_to(most);
                if most < 1.0 {
                    self.requeue();
                    return;
                }
                self.program.leg += 1;
                self.begin_leg();
            }
        }
    }
}

impl<const D: usize, const C: usize> Iterator for PatchPath<'_, D, C> {
    type Item = PatchEvent<D, C>;

    fn next(&mut self) -> Option<PatchEvent<D, C>> {
        self.next_before(usize::MAX, 0.0)
    }
}
