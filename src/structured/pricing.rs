//! Lazy pricing: which contacts can block the next step at all.
//!
//! While a contact keeps its state every w and active z of it is affine in (y, z₀), so Lemke's path is a piecewise straight
//! curve in d + 1 dimensions. A contact cannot block before the path has run as far as its slack, the least of value / |gradient|
//! over its pairs. Contacts wait in a heap by the arc length at which their slack is used up; a step looks only at those whose time
//! has come.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Fewer contacts than this are all looked at in every step.
const FEW: usize = 24;

#[derive(Debug, Clone, Default)]
pub(super) struct Pricing {
    /// Arc length as the bits of a number that is not negative (their order is that of the numbers), contact.
    waiting: BinaryHeap<Reverse<(u64, u32)>>,
    /// Those that the present step has looked at.
    pub(super) looked: Vec<u32>,
    /// Arc length of the path so far.
    pub(super) travelled: f64,
    pub(super) lazy: bool,
}

impl Pricing {
    /// Nobody waits.
    pub(super) fn clear(&mut self, contacts: usize) {
        self.waiting.clear();
        self.looked.clear();
        self.waiting.reserve(contacts);
        self.looked.reserve(contacts);
        self.travelled = 0.0;
        self.lazy = contacts >= FEW;
    }

    /// A contact that cannot block before this much more arc length.
    pub(super) fn wait(&mut self, contact: u32, slack: f64) {
        self.waiting.push(Reverse(((self.travelled + slack.max(0.0)).to_bits(), contact)));
    }

    /// The next contact that may block within a step of this length; it counts as looked at.
    pub(super) fn next(&mut self, step: f64) -> Option<u32> {
        let Reverse((due, contact)) = *self.waiting.peek()?;
        if f64::from_bits(due) > self.travelled + step {
            return None;
        }
        self.waiting.pop();
        self.looked.push(contact);
        Some(contact)
    }
}
