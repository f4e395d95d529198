//! Speeds of the object as the load grows, towards the end of a path. A leg is a section of the load program.
//!
//! If no equilibrium exists beyond some load, the speed of the object may grow without bound towards this load. It grows as a power of the
//! distance δ of the load from this limit. With the displacement q and some p > 0:
//!
//! ```text
//! a maximum of the load      q ~ δ^{1/2}                  dq/dδ ~ δ^{-1/2}
//! an asymptote               q ~ ln(1/δ),  δ^{-p}         dq/dδ ~ δ^{-1},  δ^{-1-p}
//! ```
//!
//! Near the end of the path the distance δ is too small to distinguish one power from the other.

use crate::prelude::*;

/// Pairs of a fraction of the leg and the speed of the object at this fraction, N per unit of the fraction. A speed is the force by which the motion
/// stretches the springs if all contacts stick. Each speed is more than twice the speed before.
#[derive(Debug, Clone, Default)]
pub(super) struct Speeds(Vec<[f64; 2]>);

impl Speeds {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Records the speed of the object in a step that has ended at this fraction of the leg. The speed is the force by which its motion stretches the
    /// springs if all contacts stick, N per unit of the fraction.
    pub(super) fn note(&mut self, fraction: f64, speed: f64) {
        // A speed is recorded if it is more than twice the last recorded speed.
        if self.0.last().is_none_or(|[_, fastest]| speed > 2.0 * fastest) {
            self.0.push([fraction, speed]);
        }
    }

    /// Whether the recorded speeds grow as if without bound towards the end of the path, at the fraction `end` of the leg.
    pub(super) fn grow_without_bound_at(&self, end: f64) -> bool {
        let mut before = self.0.iter().rev().filter(|[fraction, _]| *fraction < end);
        let Some([near, fast]) = before.next() else { return false };
        // Speeds are compared at two fractions of the leg whose distances from the end of the path differ at least by this factor.
        let far = before.find(|[fraction, _]| end - fraction >= 1e3 * (end - near));
        // If the speed grows without bound, the last recorded speed is within this fraction of the leg from the end of the path.
        let to_the_end = 1e-8;
        // If the speed grows by more than this factor between the two fractions `far` and `near`, it is taken as unbounded. A speed without bound
        // grows at least like δ^{-1/2}, with the distance δ from the end of the path, so here by at least √1000, about 32. A path may also end at a
        // corner, where no contact states continue it; there the speed is bounded.
        let runs = 8.0;
        end - near < to_the_end && far.is_some_and(|[_, slow]| *fast > runs * slow)
    }
}
