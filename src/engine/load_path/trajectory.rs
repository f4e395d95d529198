//! A load as a function of the load factor: linear, or a turn. The load factor is the multiple of the growing load on a ramp, the fraction of the leg
//! that is done on a leg, and the angle on a turn without a leg.

use core::ops::{Add, Mul, Sub};

use crate::numerics::Harmonic;

/// A load as a function of the load factor. `X` is the caller's `Wrench`, or a `Vector` in the engine's coordinates (moments about the centroid of
/// the contacts).
#[derive(Debug, Clone, Copy)]
pub(super) enum Trajectory<X> {
    Straight {
        from: X,
        /// Change of the load for one unit of the load factor; `from` is the load at load factor 0.
        rate: X,
    },
    Turn {
        load: Harmonic<X>,
        /// Angle, rad, by which the load turns in one unit of the load factor; the angle is zero at load factor 0.
        angle: f64,
    },
}

impl<X: Clone + Add<Output = X> + Sub<Output = X> + Mul<f64, Output = X>> Trajectory<X> {
    pub(super) fn at(&self, factor: f64) -> X {
        match self {
            Self::Straight { from, rate } => from.clone() + rate.clone() * factor,
            Self::Turn { load, angle } => load.at(angle * factor),
        }
    }

    pub(super) fn rate_at(&self, factor: f64) -> X {
        match self {
            Self::Straight { rate, .. } => rate.clone(),
            Self::Turn { load, angle } => load.rate_at(angle * factor) * *angle,
        }
    }
}
