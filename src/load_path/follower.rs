//! What every follower of a load program answers, however it finds its way.

use super::event::PathEnd;
use super::journey::Journey;
use super::segment::Segment;
use crate::equilibrium::Equilibrium;
use crate::object::Problem;
use nalgebra::SVector;

/// How far a follower has come.
#[derive(Debug)]
pub enum Came<T> {
    /// There is something to tell.
    To(T),
    /// Nothing yet.
    OnTheWay,
    /// The leg is done, all of it told.
    ToTheEndOfTheLeg,
}

/// Contacts at the place where they stand, and the rates of what stands on an edge there.
#[derive(Debug)]
pub struct Edge<'g, const D: usize, const C: usize> {
    pub(super) segment: Segment<'g, D, C>,
    pub(super) rates: Problem<'g, D, C>,
    pub(super) forces: Vec<SVector<f64, C>>,
}

/// A way to follow a program: piece by piece for a few contacts, one event at a time for thousands, in steps. It stands on a leg, and keeps the slip so
/// far; which leg, and what comes after it, is for the path to say.
pub trait Follower<'g, const D: usize, const C: usize> {
    /// What there is to tell on the way.
    type Told;

    /// The method that takes straight legs alone, if this is its follower.
    const STRAIGHT_ONLY: Option<&'static str> = None;

    /// Sets out on the present leg of the journey.
    ///
    /// # Errors
    /// How the path ends if there is no way to go.
    fn set_out(&mut self, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<D, C>>;

    /// Goes on to the next place to look at.
    ///
    /// # Errors
    /// How the path ends here.
    fn go_on(&mut self, journey: &Journey<'g, D, C>) -> Result<Came<Self::Told>, PathEnd<D, C>>;

    /// The fraction of the leg that has been gone.
    fn fraction(&self) -> f64;

    /// The equilibrium there; `None` where rounding does not allow it to be told.
    fn state(&self, journey: &Journey<'g, D, C>) -> Option<Equilibrium<D, C>>;

    /// Forces there, N, in the contact frames.
    fn forces(&self, journey: &Journey<'g, D, C>) -> Vec<SVector<f64, C>>;

    /// What stands on an edge there.
    fn edge(&self, journey: &Journey<'g, D, C>) -> Edge<'g, D, C>;
}
