//! How fast the object moves as the load grows, towards the end of a path.
//!
//! Towards a load that is never exceeded the speed grows without bound, as a power of the distance that is left:
//!
//! ```text
//! a maximum of the load      q ~ δ^{1/2}                  dq/dδ ~ δ^{-1/2}
//! an asymptote               q ~ ln(1/δ),  δ^{-p}         dq/dδ ~ δ^{-1},  δ^{-1-p}
//! ```
//!
//! The distance is too small in the end to tell one power from the other.

use crate::prelude::*;

/// The speed has grown if by this factor, and is noted each time that it has.
const GROWN: f64 = 2.0;
/// Speeds are compared at distances that differ by this factor.
const APART: f64 = 1e3;
/// The path does not end at a corner if the speed grows by more than this over them.
const RUNS: f64 = 8.0;
/// A speed that has not grown over this last part of the leg does not grow without bound.
const TO_THE_END: f64 = 1e-8;

/// Fractions of a leg and the speeds there, each larger than the one before.
#[derive(Debug, Clone, Default)]
pub(super) struct Speeds(Vec<[f64; 2]>);

impl Speeds {
    /// Nothing has moved yet.
    pub(super) fn forget(&mut self) {
        self.0.clear();
    }

    /// A step has arrived at a fraction with this speed on the way.
    pub(super) fn note(&mut self, fraction: f64, speed: f64) {
        if self.0.last().is_none_or(|[_, fastest]| speed > GROWN * fastest) {
            self.0.push([fraction, speed]);
        }
    }

    /// Whether the object goes ever faster to where the path ends.
    pub(super) fn run_to(&self, end: f64) -> bool {
        let mut before = self.0.iter().rev().filter(|[fraction, _]| *fraction < end);
        let Some([near, fast]) = before.next() else { return false };
        let far = before.find(|[fraction, _]| end - fraction >= APART * (end - near));
        end - near < TO_THE_END && far.is_some_and(|[_, slow]| *fast > RUNS * slow)
    }
}
