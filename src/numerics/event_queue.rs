//! An event queue: numbered items with times, and a clock that only moves forwards.
//!
//! Most items are rescheduled before their time. Therefore only the earliest items are kept sorted, few enough for the first-level cache. All
//! later items are in unsorted tiers, each longer than the previous one by about the same factor.

use alloc::collections::BinaryHeap;
use core::cmp::Reverse;

use super::pairwise::in_halves;
use crate::prelude::*;

/// Number of sampled items of a long tier, from which the end of its first part is estimated. Sorting more would cost more than it saves.
const SAMPLED: usize = 32;
/// Number of tiers. With fewer, the sorted items of a queue of a hundred thousand exceed the first-level cache; with more, items are moved more
/// often.
const TIERS: usize = 3;

/// An item as one integer, so that one comparison suffices: the bits of its time, then its number and its stamp, by which the caller recognises an
/// outdated entry. Times are not negative, so their bits have the order of the times.
type Entry = u128;

fn entry(time: f64, number: u32, stamp: u32) -> Entry {
    (Entry::from(time.to_bits()) << 64) | (Entry::from(number) << 32) | Entry::from(stamp)
}

#[expect(clippy::cast_possible_truncation, reason = "its parts one by one")]
fn parts(entry: Entry) -> (f64, u32, u32) {
    (f64::from_bits((entry >> 64) as u64), (entry >> 32) as u32, entry as u32)
}

/// The unsorted items later than a horizon in time.
#[derive(Debug, Clone, Default)]
struct Tier {
    waiting: Vec<Entry>,
    horizon: f64,
}

/// A queue of item numbers, each with the time at which the item is due.
#[derive(Debug, Clone, Default)]
pub(crate) struct EventQueue {
    /// The sorted items up to the earliest horizon.
    next: BinaryHeap<Reverse<Entry>>,
    /// All other items, the latest tier first. Each tier ends at the horizon of the tier before it in this list.
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

    /// Refills the queue with items numbered from 0 to `count` − 1; `time` returns the stamp and the time of each.
    pub(crate) fn refill(&mut self, count: usize, time: &(impl Fn(u32) -> (u32, f64) + Sync)) {
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

    /// Schedules an item `time` after the present clock. An infinite time is not scheduled.
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

    /// Schedules an item if its waiting time `time` exceeds `than`, and returns whether it does. Both times are measured from the present clock.
    pub(crate) fn schedule_if_later(&mut self, than: f64, number: u32, stamp: u32, time: f64) -> bool {
        // The times are compared as in `next_within`. Rounding thus cannot make `next_within(than)` return this item.
        let longer = self.clock + time > self.clock + than;
        if longer {
            self.wait(number, stamp, time);
        }
        longer
    }

    /// Removes the earliest item if its time is at most `time` after the present clock, and returns its number and stamp; `None` if no item is due by
    /// then.
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
            self.refill_next()?;
        }
    }

    /// Moves the earliest eighth of the earliest nonempty tier to the next tier, and so on down to the sorted items. `None` if all tiers are empty.
    fn refill_next(&mut self) -> Option<()> {
        let nearest = self.later.iter().rposition(|tier| !tier.waiting.is_empty())?;
        for at in nearest..TIERS {
            let (farther, nearer) = self.later.split_at_mut(at + 1);
            let Tier { waiting, horizon } = &mut farther[at];
            let last = last_of_first_part(waiting)?;
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

/// The last entry of the first part of a tier, about an eighth of it; `None` if the tier is empty.
fn last_of_first_part(waiting: &[Entry]) -> Option<Entry> {
    // A short tier is moved as a whole, since dividing it would cost more than sorting it.
    if waiting.len() <= 256 {
        return waiting.iter().copied().max();
    }
    let apart = waiting.len() / SAMPLED;
    let mut sample: [Entry; SAMPLED] = core::array::from_fn(|k| waiting[k * apart]);
    sample.sort_unstable();
    // The first part is an eighth of the tier. A larger part sorts items that are later rescheduled; a smaller one scans the remaining items too
    // often.
    Some(sample[SAMPLED / 8])
}

/// Computes the stamp and the time of each item, and stores them in its entry.
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
