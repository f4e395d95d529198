//! Lazy pricing: which contacts can block the next step at all.
//!
//! While a contact keeps its state every w and active z of it is affine in (y, z₀), so Lemke's path is a piecewise straight
//! curve in d + 1 dimensions, and as a rule its direction e changes little from one pivot to the next. Split what the path runs in two: a along e, and b,
//! the length of what it runs across e. A variable of value v and gradient g is not used up as long as
//! `max(-g·e, 0) a + |g| b < v`, and with the clock t = a + b/ε that holds until
//!
//! ```text
//! t = min over the pairs of   v / max(-g·e, ε |g|)
//! ```
//!
//! Contacts wait in a heap until their time has come; a step looks only at those. When the path has turned away from e, so that the clock runs
//! fast, all of them are put in line again for its new direction.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::collections::binary_heap::PeekMut;

use super::form::Point;

/// Fewer contacts than this are all looked at in every step.
const FEW: usize = 24;
/// The line is not made anew before one pivot for this many contacts.
const AGAIN: usize = 16;
/// A clock that runs this much faster than the path is long: time for another e.
const TURNED: f64 = 1.6;

/// ε: deviations from e count this much more.
pub(super) const ACROSS: f64 = 0.1;

#[derive(Debug, Clone)]
pub(super) struct Pricing<const D: usize> {
    /// Time as the bits of a number that is not negative (their order is that of the numbers), contact.
    waiting: BinaryHeap<Reverse<(u64, u32)>>,
    /// Those that the present step has looked at.
    pub(super) looked: Vec<u32>,
    /// e, a unit vector.
    pub(super) reference: Point<D>,
    clock: f64,
    /// Length of the path since the heap was made.
    length: f64,
    steps: usize,
    pub(super) lazy: bool,
}

impl<const D: usize> Default for Pricing<D> {
    fn default() -> Self {
        Self {
            waiting: BinaryHeap::new(),
            looked: Vec::new(),
            reference: Point::default(),
            clock: 0.0,
            length: 0.0,
            steps: 0,
            lazy: false,
        }
    }
}

impl<const D: usize> Pricing<D> {
    /// Nobody waits; the path goes in this direction.
    pub(super) fn clear(&mut self, contacts: usize, along: &Point<D>) {
        self.waiting.clear();
        self.looked.clear();
        self.lazy = contacts >= FEW;
        if self.lazy {
            self.waiting.reserve(contacts);
            self.looked.reserve(contacts);
        }
        (self.clock, self.length, self.steps) = (0.0, 0.0, 0);
        let size = along.size();
        self.reference = if size > 0.0 { along.scaled(1.0 / size) } else { *along };
    }

    /// How fast the clock runs along a direction.
    pub(super) fn speed(&self, along: &Point<D>) -> f64 {
        let e = &self.reference;
        let forward = (along.y.dot(&e.y) + along.z0 * e.z0).max(0.0);
        let across = Point { y: along.y - e.y * forward, z0: along.z0 - e.z0 * forward };
        forward + across.size() / ACROSS
    }

    /// The path goes on by so many times a direction. Whether it has turned so far from e that it is time for another.
    pub(super) fn advance(&mut self, times: f64, along: &Point<D>) -> bool {
        self.clock += times * self.speed(along);
        self.length += times * along.size();
        self.steps += 1;
        self.clock > TURNED * self.length && self.steps * AGAIN > self.waiting.len()
    }

    /// A contact that cannot block before so much more time.
    pub(super) fn wait(&mut self, contact: u32, slack: f64) {
        self.waiting.push(Reverse(((self.clock + slack.max(0.0)).to_bits(), contact)));
    }

    /// The next contact whose time comes within this time; unless it turns out to have so much slack that it goes on waiting, it
    /// counts as looked at.
    pub(super) fn next(&mut self, time: f64, slack: impl Fn(u32) -> f64) -> Option<u32> {
        let until = self.clock + time;
        loop {
            let mut first = self.waiting.peek_mut()?;
            let Reverse((due, contact)) = *first;
            if f64::from_bits(due) > until {
                return None;
            }
            let due = self.clock + slack(contact);
            if due > until {
                first.0.0 = due.to_bits();
            } else {
                PeekMut::pop(first);
                self.looked.push(contact);
                return Some(contact);
            }
        }
    }
}
