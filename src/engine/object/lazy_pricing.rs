//! Lazy pricing of a pivoting path: a step evaluates only the contacts whose present state may end within the step.
//!
//! While every contact keeps its state, every condition of a state is affine in the object's motion y and the parameter s that drives the path. So
//! the path is a piecewise straight curve in d + 1 dimensions, whose direction e mostly changes little from one event to the next. The path's length
//! has two parts: a along e, and b across e. A condition of value v and gradient g stays positive as long as `max(-g·e, 0) a + |g| b < v`. With the
//! clock t = a + b/ε and a small number ε this is certain until
//!
//! ```text
//! t = min over the conditions of   v / max(-g·e, ε |g|)
//! ```
//!
//! Each contact waits in an event queue until this clock time of its conditions; a step evaluates only contacts whose time has come. Once the path
//! has turned away from e the clock runs fast, and all contacts are queued again for the new direction.

use super::tolerances::PRICED_ACROSS;
use crate::numerics::Vector;

use crate::numerics::EventQueue;
use crate::prelude::*;

/// A point (y, s) of the pivoting path, or a direction of this path.
#[derive(Debug, Clone)]
pub(crate) struct Point {
    /// Motion y of the object in energy coordinates, beyond the elastic trial.
    pub(crate) y: Vector,
    /// The parameter that drives the path, such as z₀ in Lemke's method, scaled so that its unit weighs as much as a unit of the motion `y`.
    pub(crate) s: f64,
}

impl Default for Point {
    fn default() -> Self {
        Self { y: Vector::zeros(), s: 0.0 }
    }
}

impl Point {
    pub(crate) fn size(&self) -> f64 {
        (self.y.norm_squared() + self.s * self.s).sqrt()
    }

    /// The point `self + times · direction`.
    pub(crate) fn plus(&self, times: f64, direction: &Self) -> Self {
        Self { y: &self.y + &direction.y * times, s: self.s + direction.s * times }
    }

    /// This direction scaled to length one; a zero direction stays zero.
    pub(crate) fn direction(&self) -> Self {
        let size = self.size();
        if size > 0.0 { Self { y: &self.y / size, s: self.s / size } } else { self.clone() }
    }
}

/// The clock time during which a condition is certain to stay positive. `rate` is its rate per length along the reference direction e, and `gradient`
/// the norm of its gradient. Infinite for a constant condition.
#[inline]
pub(crate) fn slack(value: f64, rate: f64, gradient: f64) -> f64 {
    let fastest = (-rate).max(PRICED_ACROSS * gradient);
    if fastest > 0.0 { value.max(0.0) / fastest } else { f64::INFINITY }
}

/// Contacts in a queue, ordered by the clock time until which all conditions of their present states are certain to hold.
#[derive(Debug, Clone, Default)]
pub(crate) struct LazyPricing {
    pub(crate) line: EventQueue,
    /// The reference direction e of the path, along which waiting times are computed.
    pub(crate) towards: Point,
    contacts: usize,
    /// Length of the path since all contacts were queued; `steps` counts the steps of the path since then.
    length: f64,
    steps: usize,
    /// Contacts that are not in the queue: those evaluated in the present step, and those that the caller adds. They have to be queued again.
    pub(crate) looked: Vec<u32>,
}

impl LazyPricing {
    /// Queues all contacts for a path in the direction `along`, and resets the clock. For the unit direction e, `slack(contact, e)` returns a stamp
    /// and the clock time until which the contact waits. By the stamp the caller recognises an outdated entry.
    pub(crate) fn line_up(
        &mut self,
        contacts: usize,
        along: &Point,
        slack: &(impl Fn(u32, &Point) -> (u32, f64) + Sync),
    ) {
        let e = along.direction();
        self.line.refill(contacts, &|contact| slack(contact, &e));
        self.looked.clear();
        self.looked.reserve(contacts);
        (self.towards, self.contacts, self.length, self.steps) = (e, contacts, 0.0, 0);
    }

    /// The advance of the clock a + b/ε if the path moves once by `along`: its component a along e, and b across e.
    pub(crate) fn speed(&self, along: &Point) -> f64 {
        let e = &self.towards;
        let forward = (along.y.dot(&e.y) + along.s * e.s).max(0.0);
        forward + along.plus(-forward, e).size() / PRICED_ACROSS
    }

    /// Advances the clock and the length of the path by `times` times the vector `along`, and counts one step.
    pub(crate) fn advance(&mut self, times: f64, along: &Point) {
        self.line.clock += times * self.speed(along);
        self.length += times * along.size();
        self.steps += 1;
    }

    /// Whether queueing all contacts for the present direction is worthwhile: the path has turned from its reference direction and made enough steps.
    pub(crate) fn has_turned(&self) -> bool {
        // The clock runs faster than the path's length where the path deviates from its reference direction. Beyond this ratio a new reference
        // direction is due.
        let turned = 1.25;
        // Queueing all contacts evaluates each of them. This is worthwhile only after more steps than a sixteenth of the number of contacts.
        let again = 16;
        self.line.clock > turned * self.length && self.steps * again > self.contacts
    }

    /// Queues a contact again if its clock time `slack` exceeds the clock time `within` of this step. Otherwise adds it to `looked`, since the step
    /// must evaluate it. Returns whether the contact is queued.
    pub(crate) fn puts_off(&mut self, within: f64, contact: u32, stamp: u32, slack: f64) -> bool {
        let waits = self.line.schedule_if_later(within, contact, stamp, slack);
        if !waits {
            self.looked.push(contact);
        }
        waits
    }
}
