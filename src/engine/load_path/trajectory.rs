//! Trajectory of a load as a function of the load factor: a straight line, or a turn.

use core::ops::{Add, Mul, Sub};

use crate::numerics::Harmonic;

/// A trajectory of load wrenches `X`, in the coordinates of the question or in the engine's coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) enum Trajectory<X> {
    Straight {
        from: X,
        /// Rate of the load for one unit of the load factor.
        rate: X,
    },
    Turn {
        load: Harmonic<X>,
        /// Angle of the load for one unit of the load factor, rad.
        angle: f64,
    },
}

impl<X: Clone + Add<Output = X> + Sub<Output = X> + Mul<f64, Output = X>> Trajectory<X> {
    /// The load at a load factor.
    pub(super) fn at(&self, factor: f64) -> X {
        match self {
            Self::Straight { from, rate } => from.clone() + rate.clone() * factor,
            Self::Turn { load, angle } => load.at(angle * factor),
        }
    }

    /// The rate of the load at a load factor, per unit of the load factor.
    pub(super) fn rate_at(&self, factor: f64) -> X {
        match self {
            Self::Straight { rate, .. } => rate.clone(),
            Self::Turn { load, angle } => load.rate_at(angle * factor) * *angle,
        }
    }
}
