//! Numbered things wait for their time on a clock that only runs forwards.
//!
//! Most of them are put in line anew before their time comes, so that only the next ones are kept
//! in order.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::pairwise::in_halves;

/// One part in so many of those that wait is put in order at a time. A larger part sorts what is
/// never asked for, a smaller one runs over the others too often.
const PARTS: usize = 8;
/// And at least so many, which cost less to sort than to look for.
const AT_LEAST: usize = 32;

/// Time as the bits of a number that is not negative (their order is that of the numbers), number,
/// stamp: in one integer, which takes one comparison.
type Entry = u128;

fn entry(time: f64, number: u32, stamp: u32) -> Entry {
    (Entry::from(time.to_bits()) << 64) | (Entry::from(number) << 32) | Entry::from(stamp)
}

#[expect(clippy::cast_possible_truncation, reason = "its parts one by one")]
fn parts(entry: Entry) -> (f64, u32, u32) {
    (f64::from_bits((entry >> 64) as u64), (entry >> 32) as u32, entry as u32)
}

/// A line of numbers with their times.
#[derive(Debug, Clone, Default)]
pub(crate) struct WaitingLine {
    next: BinaryHeap<Reverse<Entry>>,
    /// Everybody after the horizon, in no order.
    later: Vec<Entry>,
    horizon: f64,
    pub(crate) clock: f64,
}

impl WaitingLine {
    /// Nobody waits.
    pub(crate) fn clear(&mut self) {
        self.next.clear();
        self.later.clear();
        (self.clock, self.horizon) = (0.0, 0.0);
    }

    /// The first `count` numbers are put in line at once, with the stamp and the time of each.
    pub(crate) fn line_up(&mut self, count: usize, time: &(impl Fn(u32) -> (u32, f64) + Sync)) {
        self.clear();
        self.next.reserve(count);
        self.later.extend((0_u32..).take(count).map(|number| entry(0.0, number, 0)));
        each_time(&mut self.later, time);
        self.later.retain(|entry| parts(*entry).0.is_finite());
    }

    /// A number waits for so much more time, unless for ever.
    pub(crate) fn wait(&mut self, number: u32, stamp: u32, time: f64) {
        if !time.is_finite() {
            return;
        }
        let due = self.clock + time.max(0.0);
        if due <= self.horizon {
            self.next.push(Reverse(entry(due, number, stamp)));
        } else {
            self.later.push(entry(due, number, stamp));
        }
    }

    /// Whether a number has to wait for longer than so much time; then it does.
    pub(crate) fn waits_longer(&mut self, than: f64, number: u32, stamp: u32, time: f64) -> bool {
        // Compared as `next_within` does: it must not come back within the same time.
        let longer = self.clock + time > self.clock + than;
        if longer {
            self.wait(number, stamp, time);
        }
        longer
    }

    /// The next number whose time comes within so much time, with its stamp.
    pub(crate) fn next_within(&mut self, time: f64) -> Option<(u32, u32)> {
        let until = self.clock + time;
        loop {
            if let Some(Reverse(first)) = self.next.peek() {
                let (due, number, stamp) = parts(*first);
                if due > until {
                    return None;
                }
                self.next.pop();
                return Some((number, stamp));
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

/// Fills in stamps and times.
fn each_time(entries: &mut [Entry], time: &(impl Fn(u32) -> (u32, f64) + Sync)) {
    let fill = |entries: &mut [Entry]| {
        for slot in entries {
            let number = parts(*slot).1;
            let (stamp, time) = time(number);
            *slot = entry(time.max(0.0), number, stamp);
        }
    };
    in_halves(entries, &fill, &|(), ()| ());
}
