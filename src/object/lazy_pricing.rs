//! Lazy pricing: which contacts can reach the end of their state within a step at all.
//!
//! While every contact keeps its state, all is affine in the motion y of the object and the
//! parameter s that drives the path. So the path is a piecewise straight curve in d + 1 dimensions.
//! As a rule its direction e changes little from one event to the next. Split what the path runs in
//! two: a along e, and b, the length of what it runs across e. A condition of value v and gradient
//! g is not used up as long as `max(-g·e, 0) a + |g| b < v`, and with the clock t = a + b/ε that
//! holds until
//!
//! ```text
//! t = min over the conditions of   v / max(-g·e, ε |g|)
//! ```
//!
//! Contacts wait until their time has come, and a step looks only at those. When the path has
//! turned away from e, so that the clock runs fast, all of them are put in line again for its new
//! direction.

use crate::numerics::{Size, Vector};

use crate::numerics::WaitingLine;
use crate::prelude::*;

/// ε: deviations from e count this much more. With less, a clock that turns away runs too fast;
/// with more, contacts are looked at too early.
const ACROSS: f64 = 0.25;
/// A clock that runs this much faster than the path is long: time for another e.
const TURNED: f64 = 1.25;
/// Values are taken smaller by this part of their terms, which is more than their rounding: a contact
/// that waits too long would be missed.
pub(crate) const MARGIN: f64 = 1e-13;
/// The line is not made anew before one step for this many contacts: that costs a look at each.
const AGAIN: usize = 16;

/// A point of a path, or a direction in which it goes.
#[derive(Debug, Clone)]
pub(crate) struct Point<D: Size> {
    /// Motion of the object in energy coordinates.
    pub(crate) y: Vector<D>,
    /// What drives the path, in a unit that weighs as much as one of y.
    pub(crate) s: f64,
}

impl<D: Size> Default for Point<D> {
    fn default() -> Self {
        Self { y: Vector::zeros(), s: 0.0 }
    }
}

impl<D: Size> Point<D> {
    pub(crate) fn size(&self) -> f64 {
        (self.y.norm_squared() + self.s * self.s).sqrt()
    }

    /// `self + times direction`.
    pub(crate) fn plus(&self, times: f64, direction: &Self) -> Self {
        Self { y: &self.y + &direction.y * times, s: self.s + direction.s * times }
    }

    /// The direction of length one, or zero.
    pub(crate) fn direction(&self) -> Self {
        let size = self.size();
        if size > 0.0 { Self { y: &self.y / size, s: self.s / size } } else { self.clone() }
    }
}

/// The time until a condition can be used up, from its value, its rate along e and the size of its
/// gradient.
#[inline]
pub(crate) fn slack(value: f64, rate: f64, gradient: f64) -> f64 {
    let fastest = (-rate).max(ACROSS * gradient);
    if fastest > 0.0 { value.max(0.0) / fastest } else { f64::INFINITY }
}

/// Contacts in line for their conditions.
#[derive(Debug, Clone, Default)]
pub(crate) struct LazyPricing<D: Size> {
    pub(crate) line: WaitingLine,
    /// e.
    pub(crate) towards: Point<D>,
    contacts: usize,
    /// Length and steps of the path since all were put in line.
    length: f64,
    steps: usize,
    /// Contacts that the present step has looked at, and others that have to be put in line.
    pub(crate) looked: Vec<u32>,
}

impl<D: Size> LazyPricing<D> {
    /// Puts all contacts in line for a path that goes this way; `slack` gives stamp and time of
    /// each for e.
    pub(crate) fn line_up(
        &mut self,
        contacts: usize,
        along: &Point<D>,
        slack: &(impl Fn(u32, &Point<D>) -> (u32, f64) + Sync),
    ) {
        let e = along.direction();
        self.line.line_up(contacts, &|contact| slack(contact, &e));
        self.looked.clear();
        self.looked.reserve(contacts);
        (self.towards, self.contacts, self.length, self.steps) = (e, contacts, 0.0, 0);
    }

    /// How fast the clock runs along a direction.
    pub(crate) fn speed(&self, along: &Point<D>) -> f64 {
        let e = &self.towards;
        let forward = (along.y.dot(&e.y) + along.s * e.s).max(0.0);
        forward + along.plus(-forward, e).size() / ACROSS
    }

    /// The path goes on by so many times a direction.
    pub(crate) fn advance(&mut self, times: f64, along: &Point<D>) {
        self.line.clock += times * self.speed(along);
        self.length += times * along.size();
        self.steps += 1;
    }

    /// Whether the path has turned so far from e that it is time for another.
    pub(crate) fn has_turned(&self) -> bool {
        self.line.clock > TURNED * self.length && self.steps * AGAIN > self.contacts
    }

    /// Whether a contact turns out to have so much slack that it goes on waiting; else it is looked
    /// at.
    pub(crate) fn puts_off(&mut self, within: f64, contact: u32, stamp: u32, slack: f64) -> bool {
        let waits = self.line.waits_longer(within, contact, stamp, slack);
        if !waits {
            self.looked.push(contact);
        }
        waits
    }
}
