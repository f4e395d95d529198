//! An event queue: numbered items with times on a clock that only runs forwards.
//!
//! Most items are rescheduled before their time comes. So only the next ones are kept in order, few enough for the nearest cache. Behind
//! them the queue has unordered tiers, each longer than the one before by about the same factor.

use alloc::collections::BinaryHeap;
use core::cmp::Reverse;

use super::pairwise::in_halves;
use crate::prelude::*;

/// Number of items of a longer tier that are sampled to find the end of that part. With more, sorting them costs more than it spares.
const SAMPLED: usize = 32;
/// Number of tiers: with fewer, the ordered items of a queue of a hundred thousand exceed the nearest cache; with more, items are moved more often.
const TIERS: usize = 3;

/// An item as one integer, which takes one comparison: the bits of its time, then its number and its stamp. Times are not negative, so
/// their bits have the order of the times.
type Entry = u128;

fn entry(time: f64, number: u32, stamp: u32) -> Entry {
    (Entry::from(time.to_bits()) << 64) | (Entry::from(number) << 32) | Entry::from(stamp)
}

#[expect(clippy::cast_possible_truncation, reason = "its parts one by one")]
fn parts(entry: Entry) -> (f64, u32, u32) {
    (f64::from_bits((entry >> 64) as u64), (entry >> 32) as u32, entry as u32)
}

/// The items up to a horizon, without order.
#[derive(Debug, Clone, Default)]
struct Tier {
    waiting: Vec<Entry>,
    horizon: f64,
}

/// A queue of numbers with their times.
#[derive(Debug, Clone, Default)]
pub(crate) struct EventQueue {
    /// The items up to the nearest horizon.
    next: BinaryHeap<Reverse<Entry>>,
    /// All other items, the farthest tier first; each reaches up to the horizon of the one before.
    later: [Tier; TIERS],
    pub(crate) clock: f64,
}

impl EventQueue {
    /// Empties the queue and resets the clock.
    pub(crate) fn clear(&mut self) {
        self.next.clear();
        for tier in &mut self.later {
            tier.waiting.clear();
            tier.horizon = 0.0;
        }
        self.clock = 0.0;
    }

    /// Refills the queue with the first `count` numbers; `time` returns the stamp and the time of each.
    pub(crate) fn line_up(&mut self, count: usize, time: &(impl Fn(u32) -> (u32, f64) + Sync)) {
        self.clear();
        self.next.reserve(count);
        self.later.iter_mut().for_each(|tier| tier.waiting.reserve(count));
        let all = &mut self.later[0].waiting;
        for number in (0..).take(count) {
            all.push(entry(0.0, number, 0));
        }
        each_time(all, time);
        all.retain(|entry| parts(*entry).0.is_finite());
    }

    /// Schedules a number after `time` from now; an infinite time schedules nothing.
    pub(crate) fn wait(&mut self, number: u32, stamp: u32, time: f64) {
        if !time.is_finite() {
            return;
        }
        let due = self.clock + time.max(0.0);
        let entry = entry(due, number, stamp);
        match self.later.iter_mut().find(|tier| due > tier.horizon) {
            Some(tier) => tier.waiting.push(entry),
            None => self.next.push(Reverse(entry)),
        }
    }

    /// Whether a number is due later than `than` from now; if so, it is scheduled.
    pub(crate) fn waits_longer(&mut self, than: f64, number: u32, stamp: u32, time: f64) -> bool {
        // Compared as in `next_within`: the number must not come back within the same time.
        let longer = self.clock + time > self.clock + than;
        if longer {
            self.wait(number, stamp, time);
        }
        longer
    }

    /// The next number that is due within `time` from now, with its stamp.
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
            if until < self.later[TIERS - 1].horizon {
                return None;
            }
            self.look_further()?;
        }
    }

    /// Moves a part of the nearest tier with items on, tier by tier, until some items are in order.
    fn look_further(&mut self) -> Option<()> {
        let nearest = self.later.iter().rposition(|tier| !tier.waiting.is_empty())?;
        for at in nearest..TIERS {
            let (farther, nearer) = self.later.split_at_mut(at + 1);
            let Tier { waiting, horizon } = &mut farther[at];
            let last = last_to_move_on(waiting)?;
            *horizon = parts(last).0;
            for k in (0..waiting.len()).rev() {
                if waiting[k] <= last {
                    let entry = waiting.swap_remove(k);
                    match nearer.first_mut() {
                        Some(tier) => tier.waiting.push(entry),
                        None => self.next.push(Reverse(entry)),
                    }
                }
            }
        }
        Some(())
    }
}

/// The last item of about the first part of a tier; `None` if the tier is empty.
fn last_to_move_on(waiting: &[Entry]) -> Option<Entry> {
    // A short tier moves on as a whole: to part it would cost more than to keep it in order.
    if waiting.len() <= 256 {
        return waiting.iter().copied().max();
    }
    let apart = waiting.len() / SAMPLED;
    let mut sample: [Entry; SAMPLED] = core::array::from_fn(|k| waiting[k * apart]);
    sample.sort_unstable();
    // An eighth of the tier moves on. A larger part sorts items that are then rescheduled; a smaller one
    // scans the others too often.
    Some(sample[SAMPLED / 8])
}

/// Fills in the stamp and the time of each item.
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
