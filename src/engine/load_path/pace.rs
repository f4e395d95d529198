//! The choice of step lengths along an arc, a piece of the path on which directions of sliding turn. A leg is a section of the load program. A node
//! is an event (a change of contact states) or the start of a leg. Arclength is measured along the curve (q/u, λ), with the twist q, a unit u of
//! displacement and the fraction λ of the leg that is done.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// The estimated error of a step is proportional to this power of the arclength of the step.
const ERROR_ORDER: f64 = 8.0;
/// The length of the next step is this fraction of the length that the error estimate allows. Because 0.8⁸ is about 1/6, the expected error of
/// the next step is then a sixth of the allowed error. So few steps are refused, and the sum of the errors of many steps stays small.
const CAUTION: f64 = 0.8;
/// A step is at least this fraction as long as the step before it. The rule that the error is proportional to a power of the length holds only for
/// small changes of the length.
const LEAST_RATIO: f64 = 0.2;

/// The data of the step control along an arc that pass from step to step: the length of the next step, its kind (explicit or implicit), and
/// counters.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// Arclength of the next step. `None` right after a node: the rates at the node then determine the length.
    pub(super) length: Option<f64>,
    /// The unit u of displacement, m, which counts as much in the arclength as a change of λ by 1. `None` before the first step from a node.
    pub(super) unit: Option<f64>,
    /// Number of steps refused since the last accepted step.
    refused: u8,
    /// Whether steps are implicit, because directions of friction turn much faster than the object moves.
    pub(super) implicit: bool,
    /// Number of explicit steps still to be made before implicit steps are considered.
    explicit_steps_left: u8,
    pub(super) steps: usize,
    /// Number of times that the allowed error of a step was raised since the last node.
    times_raised: u8,
    /// The allowed error of a step divided by the error that the caller's settings allow; 1 until it is raised because steps are too short.
    pub(super) error_factor: f64,
}

impl Pace {
    pub(super) fn new() -> Self {
        Self {
            length: None,
            unit: None,
            refused: 0,
            implicit: false,
            // After an event the first eight steps are explicit.
            explicit_steps_left: 8,
            steps: 0,
            times_raised: 0,
            error_factor: 1.0,
        }
    }

    /// The data of the step control after a node: only the number of steps so far is kept, everything else begins anew.
    pub(super) fn at_node(self) -> Self {
        Self { steps: self.steps, ..Self::new() }
    }

    /// Called when steps have become too short to advance. Raises the allowed error of a step, at most twice between two nodes, and returns
    /// whether it did so. `rest` is the part of the leg that is still to be followed, as a fraction of the leg.
    pub(super) fn allow_larger_error(&mut self, rest: f64) -> bool {
        let may = self.times_raised < 2;
        if may {
            // Rounding errors alone may exceed the allowed error, so that every step is refused, however short. The allowed error therefore grows by
            // the factor 30. Callers still learn the true accuracy, because the estimated error of the path adds up the errors actually made.
            (self.times_raised, self.error_factor) = (self.times_raised + 1, self.error_factor * 30.0);
            // The first step with the larger allowed error is a thousandth of `rest`, the part of the leg that is still to be followed.
            (self.length, self.refused) = (Some(1e-3 * rest), 0);
        }
        may
    }

    /// Records an accepted step of arclength `length`, whose error is the fraction `part` of the allowed error, and chooses the length of the next
    /// step. A step that was shortened (`cut`) to end at an event does not make the next step shorter.
    pub(super) fn accept(&mut self, length: f64, part: f64, cut: bool) {
        // The next step is at most five times as long as this step. It is no longer than this step if a longer step was tried in its place and
        // refused.
        let longest = if self.refused > 0 { 1.0 } else { 5.0 };
        let next = length * (CAUTION * part.powf(-1.0 / ERROR_ORDER)).clamp(LEAST_RATIO, longest);
        self.length = Some(if cut { next.max(self.length.unwrap_or(0.0)) } else { next });
        self.refused = 0;
        self.explicit_steps_left = self.explicit_steps_left.saturating_sub(1);
        self.steps += 1;
    }

    /// Whether explicit steps are so short that implicit steps should be made. Two conditions must hold. No explicit steps are left in
    /// `explicit_steps_left`. The arclength `rest` up to the end of the leg is more than fifty times `stable`, the longest stable explicit step.
    pub(super) fn needs_implicit_steps(&self, stable: f64, rest: f64) -> bool {
        // An implicit step costs the computing time of a few explicit steps, but may cover the arclength of hundreds.
        self.explicit_steps_left == 0 && stable * 50.0 < rest
    }

    /// Records a refused step of arclength `length`, whose error is `times` times the allowed error, and chooses a shorter length.
    pub(super) fn refuse(&mut self, length: f64, times: f64) {
        self.length = Some(length * (CAUTION * times.powf(-1.0 / ERROR_ORDER)).clamp(LEAST_RATIO, CAUTION));
        self.refused += 1;
        // After four refused implicit steps in a row, explicit steps are used instead, for the next sixty-four accepted steps or until an event.
        if self.implicit && self.refused >= 4 {
            (self.implicit, self.explicit_steps_left) = (false, 64);
        }
        self.steps += 1;
    }
}
