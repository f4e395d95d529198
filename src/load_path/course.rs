//! The way that a load takes from where the question for an onset starts.

use super::ramp::Ramp;
use super::turn::{InsideTurn, Turn};
use crate::grasp::Wrench;

/// A ramp, or a turn with its parts in inside coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) enum Course<'a, const D: usize, const C: usize> {
    Ramp(&'a Ramp<D, C>),
    Turn(&'a Turn<D, C>, InsideTurn<D>),
}

impl<const D: usize, const C: usize> Course<'_, D, C> {
    /// The load at a factor, which is the angle of a turn.
    pub(super) fn load_at(&self, factor: f64) -> Wrench<D, C> {
        match self {
            Self::Ramp(ramp) => ramp.load_at(factor),
            Self::Turn(turn, _) => turn.load_at(factor),
        }
    }
}
