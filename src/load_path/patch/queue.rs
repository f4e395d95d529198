//! Contacts wait for their time: only those are looked at whose conditions can have been used up.
//!
//! A condition with value v and gradient g is not used up before the point of which it is a linear function has gone v/|g|.
//! With a clock that runs at least as fast as the point, a contact that is put in line with the least v/|g| of its
//! conditions need not be looked at before its time has come.
//!
//! A clock along a reference direction e tells more, as long as the point goes more or less along e: it runs by `a + b/ε` where the point
//! goes a along e and b across it, and contacts wait for `v / max(-g·e, ε|g|)`.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use nalgebra::SVector;

use crate::numerics::{SUMMED_IN_TURN, both};

/// ε: deviations from e count this much more.
pub(super) const ACROSS: f64 = 0.25;

/// A direction of y and of the time along the leg, in a unit in which both weigh alike.
#[derive(Debug, Clone, Copy)]
pub(super) struct Course<const D: usize> {
    pub(super) y: SVector<f64, D>,
    pub(super) time: f64,
}

impl<const D: usize> Default for Course<D> {
    fn default() -> Self {
        Self { y: SVector::zeros(), time: 0.0 }
    }
}

impl<const D: usize> Course<D> {
    pub(super) fn new(y: &SVector<f64, D>, time: f64) -> Self {
        Self { y: *y, time }
    }

    pub(super) fn size(&self) -> f64 {
        (self.y.norm_squared() + self.time * self.time).sqrt()
    }

    /// Of length one, or zero.
    pub(super) fn direction(&self) -> Self {
        let size = self.size();
        if size > 0.0 { Self { y: self.y / size, time: self.time / size } } else { *self }
    }

    /// As much further as this is from another, times a part.
    pub(super) fn beyond(&self, last: &Self, part: f64) -> Self {
        Self { y: self.y + (self.y - last.y) * part, time: self.time + (self.time - last.time) * part }
    }

    pub(super) fn distance(&self, other: &Self) -> f64 {
        Self { y: self.y - other.y, time: self.time - other.time }.size()
    }

    /// How fast a clock along the unit direction e runs on this course.
    pub(super) fn speed_along(&self, e: &Self) -> f64 {
        let forward = (self.y.dot(&e.y) + self.time * e.time).max(0.0);
        let across = Self { y: self.y - e.y * forward, time: self.time - e.time * forward };
        forward + across.size() / ACROSS
    }
}

/// Time as the bits of a number that is not negative (their order is that of the numbers), contact, stamp, in one number: one comparison.
type Entry = u128;

fn entry(time: f64, contact: u32, stamp: u32) -> Entry {
    (Entry::from(time.to_bits()) << 64) | (Entry::from(contact) << 32) | Entry::from(stamp)
}

#[expect(clippy::cast_possible_truncation, reason = "its parts one by one")]
fn parts(entry: Entry) -> (f64, u32, u32) {
    (f64::from_bits((entry >> 64) as u64), (entry >> 32) as u32, entry as u32)
}

/// A line of contacts with their times. Most of them will be put in line anew before their time comes: only the next ones are kept in order.
#[derive(Debug, Clone, Default)]
pub(super) struct Queue {
    next: BinaryHeap<Reverse<Entry>>,
    /// Everybody after the horizon, in no order.
    later: Vec<Entry>,
    horizon: f64,
    pub(super) clock: f64,
}

/// So many parts of those that wait are put in order at a time.
const PARTS: usize = 8;
/// And at least so many contacts.
const AT_LEAST: usize = 32;

impl Queue {
    /// Nobody waits.
    pub(super) fn clear(&mut self) {
        self.next.clear();
        self.later.clear();
        (self.clock, self.horizon) = (0.0, 0.0);
    }

    /// Everybody is put in line at once, with stamp and slack of each.
    pub(super) fn line_up(&mut self, contacts: usize, slack: &(impl Fn(usize) -> (u32, f64) + Sync)) {
        self.clear();
        self.later.resize(contacts, 0);
        each_slack(&mut self.later, 0, slack);
        self.later.retain(|entry| parts(*entry).0.is_finite());
    }

    /// A contact that cannot block before so much more time.
    pub(super) fn wait(&mut self, contact: u32, stamp: u32, slack: f64) {
        if !slack.is_finite() {
            return;
        }
        let due = self.clock + slack.max(0.0);
        if due <= self.horizon {
            self.next.push(Reverse(entry(due, contact, stamp)));
        } else {
            self.later.push(entry(due, contact, stamp));
        }
    }

    /// The next contact whose time comes within so much time, with its stamp.
    pub(super) fn next_within(&mut self, time: f64) -> Option<(u32, u32)> {
        let until = self.clock + time;
        loop {
            if let Some(Reverse(first)) = self.next.peek() {
                let (due, contact, stamp) = parts(*first);
                if due > until {
                    return None;
                }
                self.next.pop();
                return Some((contact, stamp));
            }
            if until < self.horizon || self.later.is_empty() {
                return None;
            }
            self.look_further();
        }
    }

    /// The next of those that wait behind the horizon are put in order.
    fn look_further(&mut self) {
        let count = (self.later.len() / PARTS).max(AT_LEAST).min(self.later.len());
        self.later.select_nth_unstable(count - 1);
        self.horizon = parts(self.later[count - 1]).0;
        self.next.extend(self.later.drain(..count).map(Reverse));
    }
}

/// Fills in the entries of the contacts from number `first` on.
fn each_slack(entries: &mut [Entry], first: usize, slack: &(impl Fn(usize) -> (u32, f64) + Sync)) {
    if entries.len() > SUMMED_IN_TURN {
        let (count, middle) = (entries.len(), entries.len() / 2);
        let (near, far) = entries.split_at_mut(middle);
        both(count, || each_slack(near, first, slack), || each_slack(far, first + middle, slack));
        return;
    }
    for (i, slot) in (first..).zip(entries) {
        let (stamp, slack) = slack(i);
        // There are fewer than 2^32 contacts in memory.
        *slot = entry(slack.max(0.0), u32::try_from(i).unwrap_or(u32::MAX), stamp);
    }
}
