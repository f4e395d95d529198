//! Speeds of the object as the load grows, towards the end of a path.
//!
//! Towards a load that is never exceeded the speed grows without bound, as a power of the remaining distance:
//!
//! ```text
//! a maximum of the load      q ~ δ^{1/2}                  dq/dδ ~ δ^{-1/2}
//! an asymptote               q ~ ln(1/δ),  δ^{-p}         dq/dδ ~ δ^{-1},  δ^{-1-p}
//! ```
//!
//! In the end the distance is too small to distinguish one power from the other.

use crate::prelude::*;

/// Growth of the speed from which it is recorded anew.
const GROWN: f64 = 2.0;
/// Least ratio of the distances at which speeds are compared.
const APART: f64 = 1e3;
/// Growth of the speed between them beyond which the path does not end at a corner.
const RUNS: f64 = 8.0;
/// Last part of the leg over which a speed must have grown if it grows without bound.
const TO_THE_END: f64 = 1e-8;

/// Fractions of a leg and the speeds there, each larger than the one before.
#[derive(Debug, Clone, Default)]
pub(super) struct Speeds(Vec<[f64; 2]>);

impl Speeds {
    /// Removes all records.
    pub(super) fn forget(&mut self) {
        self.0.clear();
    }

    /// Records the speed of a step that has arrived at a fraction.
    pub(super) fn note(&mut self, fraction: f64, speed: f64) {
        if self.0.last().is_none_or(|[_, fastest]| speed > GROWN * fastest) {
            self.0.push([fraction, speed]);
        }
    }

    /// Whether the object moves ever faster towards the end of the path.
    pub(super) fn run_to(&self, end: f64) -> bool {
        let mut before = self.0.iter().rev().filter(|[fraction, _]| *fraction < end);
        let Some([near, fast]) = before.next() else { return false };
        let far = before.find(|[fraction, _]| end - fraction >= APART * (end - near));
        end - near < TO_THE_END && far.is_some_and(|[_, slow]| *fast > RUNS * slow)
    }
}
