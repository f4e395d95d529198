//! Numbered things wait for their time on a clock that only runs forwards.
//!
//! Most of them are put in line anew before their time comes. So only the next ones are kept in order, few enough for the nearest memory. Behind
//! them the line has tiers without order, each about as many times longer as the one before.

use alloc::collections::BinaryHeap;
use core::cmp::Reverse;

use super::pairwise::in_halves;
use crate::prelude::*;

/// About one part in so many of a tier moves on at a time. A larger part sorts what is never asked for, a
/// smaller one runs over the others too often.
const PARTS: usize = 8;
/// As few as these move on at once: to part them would cost more than to keep them in order.
const FEW: usize = 256;
/// So many of more than a few tell where that part ends. With more, to sort them costs more than it spares.
const SAMPLE: usize = 32;
/// Tiers: with fewer, those in order of a hundred thousand leave the nearest memory; with more, entries are moved more often.
const TIERS: usize = 3;

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

/// Those after a horizon, in no order.
#[derive(Debug, Clone, Default)]
struct Tier {
    waiting: Vec<Entry>,
    horizon: f64,
}

/// A line of numbers with their times.
#[derive(Debug, Clone, Default)]
pub(crate) struct WaitingLine {
    /// Everybody up to the nearest horizon.
    next: BinaryHeap<Reverse<Entry>>,
    /// Everybody else, the farthest tier first; each reaches to the horizon of the one before.
    later: [Tier; TIERS],
    pub(crate) clock: f64,
}

impl WaitingLine {
    /// Nobody waits.
    pub(crate) fn clear(&mut self) {
        self.next.clear();
        for tier in &mut self.later {
            tier.waiting.clear();
            tier.horizon = 0.0;
        }
        self.clock = 0.0;
    }

    /// The first `count` numbers are put in line at once, with the stamp and the time of each.
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

    /// A number waits for so much more time, unless for ever.
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
            if until < self.later[TIERS - 1].horizon {
                return None;
            }
            self.look_further()?;
        }
    }

    /// A part of the nearest tier where anybody waits moves on, tier by tier, until some are put in order.
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

/// The last of about the first part of those in a tier; `None` if nobody is there.
fn last_to_move_on(waiting: &[Entry]) -> Option<Entry> {
    if waiting.len() <= FEW {
        return waiting.iter().copied().max();
    }
    let apart = waiting.len() / SAMPLE;
    let mut sample: [Entry; SAMPLE] = core::array::from_fn(|k| waiting[k * apart]);
    sample.sort_unstable();
    Some(sample[SAMPLE / PARTS])
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
