//! The way that a load takes while a factor grows: straight on, or round.

use core::ops::{Add, Mul, Sub};

use crate::numerics::Harmonic;

/// A way, of wrenches as the question has them or in inside coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) enum Trajectory<X> {
    Straight {
        from: X,
        /// For one unit of the factor.
        rate: X,
    },
    Turn {
        load: Harmonic<X>,
        /// For one unit of the factor, rad.
        angle: f64,
    },
}

impl<X: Clone + Add<Output = X> + Sub<Output = X> + Mul<f64, Output = X>> Trajectory<X> {
    /// The load at a factor.
    pub(super) fn at(&self, factor: f64) -> X {
        match self {
            Self::Straight { from, rate } => from.clone() + rate.clone() * factor,
            Self::Turn { load, angle } => load.at(angle * factor),
        }
    }

    /// Its rate there, for one unit of the factor.
    pub(super) fn rate_at(&self, factor: f64) -> X {
        match self {
            Self::Straight { rate, .. } => rate.clone(),
            Self::Turn { load, angle } => load.rate_at(angle * factor) * *angle,
        }
    }
}
