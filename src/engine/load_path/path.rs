//! [`Path`]: a load program being followed, from event to event or in numerical steps. The program consists of legs (sections); a piece is a part of
//! a leg on which all contacts keep their states. A place is the index of a leg and the fraction of it that is done. If the path of equilibria ends,
//! and the object moves to another equilibrium under nearly the same load, the object snaps over. Motions are small within the limits up to which the
//! linear theory is trusted. The engine computes with vectors of three components, also in the plane.

use crate::numerics::IntoList;
use core::fmt;

use nalgebra::SVector;

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::{Event, PathEnd};
use super::following::AnyPath;
use super::leg::Leg;
use super::small_motions::EndOfSmallMotions;
use super::stepped::Step;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Face, outside};
use crate::prelude::*;
use crate::search::Settings;

/// A load program being followed: an iterator over its events or steps. The caller can inspect each event or step, and stop after it. When the
/// iterator has ended, [`end`](Self::end) says how the path ended.
///
/// `T` is the type of the items: events of a [`LoadPath`], or steps of a [`SteppedPath`]. A [`LoadPath`] takes acceptable time for some hundreds of
/// contacts, a [`SteppedPath`] for 10⁵. The contact law is the same for both: contacts stick, slide (their slips accumulate), open and close again.
#[derive(Debug)]
pub struct Path<'g, const C: usize, T>(pub(super) Box<dyn AnyPath<C, T> + 'g>);

/// A load program being followed: an iterator over its [`Event`]s that keeps the pieces already passed. Made by
/// [`Grasp::follow`](crate::ask::Grasp::follow); when the iterator has ended, [`end`](Self::end) says how the path ended.
///
/// ```
/// use grasp_lcp::planar::{Change, Contact, Grasp, Leg, PathEnd, Wrench};
///
/// // A block on two feet that act as parallel springs. The second foot slides first, which halves the stiffness against the pull.
/// let foot = |x: f64, mu: f64| {
///     Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(10.0, 10.0).friction(mu).command([0.1, 0.0])
/// };
/// let guide = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0);
/// let grasp = Grasp::new([foot(-1.0, 0.5), foot(1.0, 0.25), guide])?;
/// let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([0.6, 0.0]))])?;
/// let events: Vec<_> = path.by_ref().collect();
/// assert_eq!(events[0].changes[0].contact.index, 1);
/// // The guide gives way by 1/51: F_n = 50/51 N. Each foot carries half of the pull, up to 0.25 F_n.
/// let slides_at = 2.0 * 0.25 * 50.0 / 51.0;
/// assert!((events[0].load.resultant()[0] - slides_at).abs() < 1e-14);
/// assert!(matches!(path.end(), Some(PathEnd::Completed)));
///
/// // As the pull is released, the second foot sticks at once and keeps its slip, which is directed against the pull.
/// path.continue_with(&[Leg::load_to(Wrench::ZERO)])?;
/// assert!(path.run()[0].changes[0].what == Change::Sticks);
/// let end = path.state_at(1, 1.0).expect("has passed");
/// assert!((end.contacts[1].slip[1] + (0.6 - slides_at) / 10.0).abs() < 1e-14);
/// assert!(path.energies()[0].dissipated > 0.0 && path.energies()[1].dissipated == 0.0);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
pub type LoadPath<'g, const C: usize> = Path<'g, C, Event<C>>;

/// A load program being followed in steps: an iterator over its [`Step`]s, so that the caller can inspect each step and stop after any. Made by
/// [`Grasp::follow_in_steps`](crate::ask::Grasp::follow_in_steps); when the iterator has ended, [`end`](Self::end) says how the path ended.
///
/// The path obeys the contact law with the round friction cone, as a [`LoadPath`] does: contacts stick, slide in directions that turn (their slips
/// accumulate), open and close again. The path does not return the events of contacts one by one; [`state`](Self::state) returns the equilibrium at
/// the present place.
pub type SteppedPath<'g, const C: usize> = Path<'g, C, Step<C>>;

/// A path of the engine, whose vectors have three components, for a caller whose vectors have `C` components.
struct ConvertedPath<'g, const C: usize, T: Face> {
    inside: Box<dyn AnyPath<3, T::Inside> + 'g>,
    end: Option<PathEnd<C>>,
    /// Scratch buffer in which legs added by the caller are converted to three components.
    legs: Vec<Leg<3>>,
}

impl<const C: usize, T: Face> fmt::Debug for ConvertedPath<'_, C, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.inside.fmt(f)
    }
}

impl<const C: usize, T: Face> ConvertedPath<'_, C, T> {
    /// Converts and stores the end of the path, once it has ended.
    fn keep_end(&mut self) {
        if self.end.is_none() {
            self.end = self.inside.end().cloned().map(outside);
        }
    }
}

impl<const C: usize, T: Face> AnyPath<C, T> for ConvertedPath<'_, C, T> {
    fn next(&mut self) -> Option<T> {
        let next = self.inside.next();
        self.keep_end();
        next.map(outside)
    }

    fn end(&self) -> Option<&PathEnd<C>> {
        self.end.as_ref()
    }

    fn place(&self) -> (usize, f64) {
        self.inside.place()
    }

    fn state(&self) -> Option<Equilibrium<C>> {
        self.inside.state().map(outside)
    }

    fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<C>> {
        self.inside.state_at(leg, fraction).map(outside)
    }

    fn forces(&self) -> Vec<SVector<f64, C>> {
        outside(self.inside.forces())
    }

    fn continue_with(&mut self, legs: &[Leg<C>]) -> Result<(), Error> {
        self.legs.clear();
        self.legs.extend(legs.iter().cloned().map(Face::into_inside));
        self.inside.continue_with(&self.legs)?;
        self.end = None;
        self.keep_end();
        Ok(())
    }

    fn beyond(&self, settings: Option<&Settings>) -> Option<Beyond<C>> {
        self.inside.beyond(settings).map(outside)
    }

    fn step_error(&self) -> f64 {
        self.inside.step_error()
    }

    fn energies(&self) -> &[LegEnergy] {
        self.inside.energies()
    }

    fn next_small(&mut self) -> Option<T> {
        let next = self.inside.next_small();
        self.keep_end();
        next.map(outside)
    }

    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        self.inside.end_of_small_motions()
    }

    fn farthest(&self) -> f64 {
        self.inside.farthest()
    }

    fn all_slide_from(&self, until: (usize, f64)) -> Option<(usize, f64)> {
        self.inside.all_slide_from(until)
    }

    fn sticks_until(&self) -> Vec<(usize, f64)> {
        self.inside.sticks_until()
    }

    fn left_out(&self) -> Option<f64> {
        self.inside.left_out()
    }
}

/// Converts a path of the engine for a caller with vectors of `C` components.
pub(crate) fn path_outside<const C: usize, T: Face>(path: Path<'_, 3, T::Inside>) -> Path<'_, C, T> {
    let mut path = ConvertedPath { inside: path.0, end: None, legs: Vec::new() };
    path.keep_end();
    Path(Box::new(path))
}

impl<'g, const C: usize, T> Path<'g, C, T> {
    pub(crate) fn new(path: Box<dyn AnyPath<C, T> + 'g>) -> Self {
        Self(path)
    }

    /// The least fraction [`Verdict::left_out`](crate::hold::Verdict::left_out) of the resistance at the ends of the legs so far, and along turns; `None`
    /// if it is small.
    #[must_use]
    pub fn left_out(&self) -> Option<f64> {
        self.0.left_out()
    }

    /// The end of the path; `None` while there is more to follow. `Completed` becomes `None` again if [`Self::continue_with`] appends legs.
    #[must_use]
    pub fn end(&self) -> Option<&PathEnd<C>> {
        self.0.end()
    }

    /// The present place: the leg, from 0, and the fraction of the leg that is done, from 0 to 1. A completed path is at the end of its last leg.
    #[must_use]
    pub fn place(&self) -> (usize, f64) {
        self.0.place()
    }

    /// The equilibrium at the present place, with residuals recomputed from the grasp, the load and the slip so far. `None` if the path had no
    /// equilibrium to start from, or if the equilibrium cannot be computed because of rounding. It is returned even if its residuals are large: check
    /// them. If an event lies exactly at this place, the contact states may be those before or after the event.
    #[must_use]
    pub fn state(&self) -> Option<Equilibrium<C>> {
        self.0.state()
    }

    /// Contact forces on the object at the present place, in the contact frames, N: (`F_n`, `F_t`…), in the order of the grasp. Empty if the path had
    /// no equilibrium to start from. Cheaper than [`Self::state`].
    #[must_use]
    pub fn forces(&self) -> Vec<SVector<f64, C>> {
        self.0.forces()
    }

    /// Follows the path to its end and returns all its events, or all its steps.
    pub fn run(&mut self) -> Vec<T> {
        self.by_ref().list()
    }

    /// Appends legs to the program. A completed path then continues along them; a path that has ended in another way does not continue.
    ///
    /// # Errors
    /// The errors of the method that has made the path, for legs that do not fit the grasp or have data out of range.
    pub fn continue_with(&mut self, legs: &[Leg<C>]) -> Result<(), Error> {
        self.0.continue_with(legs)
    }

    /// Whether another equilibrium exists at loads just beyond the load at which this path lost its equilibrium; `None` if the path has not ended in
    /// a loss. The search stays within the limits (steps, combinations of states) of the settings of this path; [`Self::beyond_with`] takes other
    /// limits.
    #[must_use]
    pub fn beyond(&self) -> Option<Beyond<C>> {
        self.0.beyond(None)
    }

    /// Whether another equilibrium exists at loads just beyond the load at which this path lost its equilibrium, with the slip so far. The search
    /// stays within the limits of `settings`. It usually takes longer than following the path, since it may have to exclude all combinations of
    /// contact states. If there are too many combinations, a limit load (no equilibrium beyond) can only be proved by a virtual motion. Along it the
    /// load does more work than contact forces can take up. `None` if the path has not ended in a loss.
    #[must_use]
    pub fn beyond_with(&self, settings: &Settings) -> Option<Beyond<C>> {
        self.0.beyond(Some(settings))
    }
}

impl<const C: usize, T> Iterator for Path<'_, C, T> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        self.0.next()
    }
}

impl<const C: usize> LoadPath<'_, C> {
    /// Sum of the estimated errors of all integration steps so far. Only where directions of sliding turn on the round cone are steps integrated;
    /// without such steps, as in the plane and on polygonal friction cones, the sum is zero. The estimated error of each step is below
    /// [`Settings::step_error`], unless rounding prevents so small an error.
    ///
    /// If events follow each other ever more closely, small gaps, and small distances of contact forces from the boundaries of their cones, are set
    /// to zero. The largest of them, relative to the terms from which it is computed, is added to the sum.
    ///
    /// The estimate for a step is the larger of two ratios: error of forces to largest force, and error of displacements to largest displacement. The
    /// true error is usually smaller. The estimate does not include that an earlier error may grow on later steps, but sliding damps most errors.
    #[must_use]
    pub fn step_error(&self) -> f64 {
        self.0.step_error()
    }

    /// The first point of the path so far at which a rotation, slip or opening exceeds its limit in [`Settings::small_motions`], or a suction cup
    /// [leaks](crate::equilibrium::TooFar::Leaks). Beyond it the answers are computed for the undeformed geometry and say little about the object.
    /// `None` if all motions are small.
    #[must_use]
    pub fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        self.0.end_of_small_motions()
    }

    /// The largest ratio of a rotation, slip or opening to its limit of small motions. Only the ends of the path's pieces so far are examined.
    pub(crate) fn farthest(&self) -> f64 {
        self.0.farthest()
    }

    /// Follows the path to the end of the first piece on which a motion exceeds its limit of small motions, or to the end of the path. Returns the
    /// events up to there.
    pub fn run_while_small(&mut self) -> Vec<Event<C>> {
        core::iter::from_fn(|| self.0.next_small()).list()
    }

    /// The place from which on, up to the place `until`, every contact with friction that carries a force slides without interruption. A place is the
    /// index of a leg, from 0, and the fraction of this leg that is done. `None` if such a contact sticks just before `until`.
    #[must_use]
    pub fn everything_slides_from(&self, until: (usize, f64)) -> Option<(usize, f64)> {
        self.0.all_slide_from(until)
    }

    /// Energies of each leg entered so far, J; for the present leg, the energies up to the present place.
    #[must_use]
    pub fn energies(&self) -> &[LegEnergy] {
        self.0.energies()
    }

    /// The equilibrium at a fraction (0 to 1) of a leg (from 0) that the path has passed or has reached; `None` for a place that it has not reached.
    /// If an event lies exactly at this place, the equilibrium before the event is returned. If directions of sliding turn, the integration step is
    /// repeated up to this fraction with the same error bound. `None` if that fails because of rounding. `None` also while the object snaps over,
    /// i.e. moves to another equilibrium: between the load at which it leaves the path and the slightly larger load at which it rests again.
    #[must_use]
    pub fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<C>> {
        self.0.state_at(leg, fraction)
    }
}

impl<const C: usize> SteppedPath<'_, C> {
    /// Estimated error of the forces, relative to the largest force, everywhere on the path so far. It is the largest difference of a contact force
    /// between this path and a second path. The second path makes one step where this path makes two half steps. For contacts that stop sliding, open
    /// or close, an estimate of the errors that both paths have in common is added. The true error is usually a third of the estimate.
    #[must_use]
    pub fn step_error(&self) -> f64 {
        self.0.step_error()
    }
}
