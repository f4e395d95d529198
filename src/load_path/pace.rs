//! How long the steps along a sliding arc are.

#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Where steps die out the error asked for is made larger by this factor, so often: rounding may be what refuses them. The error made
/// is what is reported.
const LOOSER: f64 = 30.0;
const MOST_OFTEN: u8 = 2;
/// From there steps are tried again, as a part of what is left of the leg.
const AGAIN: f64 = 1e-3;

/// The error of a step is of this order in its length.
const ORDER: f64 = 8.0;
/// The next step aims at a sixth of the error asked for: fewer are refused, and errors of many steps add up.
const CAUTION: f64 = 0.8;
/// It is no shorter than this part of the last and no longer than so many times, since the estimate is for small changes.
const SHORTER: f64 = 0.2;
const LONGER: f64 = 5.0;

/// After so many refusals in a row the other kind of steps is tried.
const MOST_REFUSALS: u8 = 4;

/// Explicit steps after an event, and after implicit ones have failed, before implicit ones are tried.
const PATIENCE: u8 = 8;
const LONG_PATIENCE: u8 = 64;
/// An implicit step costs as much as a few explicit ones, and is as long as hundreds.
const MANY_STEPS: f64 = 50.0;

/// How the steps along an arc go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    /// Of the next step, in arclength.
    pub(super) length: Option<f64>,
    /// The displacement that counts in arclength as the whole leg does, m; `None` before the first step from a node.
    pub(super) unit: Option<f64>,
    /// Refusals in a row.
    refused: u8,
    /// Whether directions turn so much faster than the object moves that steps are implicit.
    pub(super) stiff: bool,
    /// So many steps are made before that is looked at again.
    patience: u8,
    pub(super) steps: usize,
    loosened: u8,
    /// The error asked for, over that of the settings.
    pub(super) looser: f64,
}

impl Pace {
    pub(super) fn new() -> Self {
        Self {
            length: None,
            unit: None,
            refused: 0,
            stiff: false,
            patience: PATIENCE,
            steps: 0,
            loosened: 0,
            looser: 1.0,
        }
    }

    /// At an event the next step is looked for anew.
    pub(super) fn at_node(self) -> Self {
        Self { steps: self.steps, ..Self::new() }
    }

    /// A larger error where steps die out, if it may be larger still.
    pub(super) fn loosen(&mut self, rest: f64) -> bool {
        let may = self.loosened < MOST_OFTEN;
        if may {
            (self.loosened, self.looser) = (self.loosened + 1, self.looser * LOOSER);
            (self.length, self.refused) = (Some(AGAIN * rest), 0);
        }
        may
    }

    /// After a step with this part of the error asked for. One that was made to end at an event says nothing against longer ones.
    pub(super) fn accept(&mut self, length: f64, part: f64, cut: bool) {
        let longest = if self.refused > 0 { 1.0 } else { LONGER };
        let next = length * (CAUTION * part.powf(-1.0 / ORDER)).clamp(SHORTER, longest);
        self.length = Some(if cut { next.max(self.length.unwrap_or(0.0)) } else { next });
        self.refused = 0;
        self.patience = self.patience.saturating_sub(1);
        self.steps += 1;
    }

    /// Whether explicit steps so long that more than [`MANY_STEPS`] of them lie ahead have been made for a while.
    pub(super) fn is_cramped(&self, stable: f64, rest: f64) -> bool {
        self.patience == 0 && stable * MANY_STEPS < rest
    }

    /// After a step that had so many times the error asked for.
    pub(super) fn refuse(&mut self, length: f64, times: f64) {
        self.length = Some(length * (CAUTION * times.powf(-1.0 / ORDER)).clamp(SHORTER, CAUTION));
        self.refused += 1;
        // Where an implicit step makes nothing better an explicit one may.
        if self.stiff && self.refused >= MOST_REFUSALS {
            (self.stiff, self.patience) = (false, LONG_PATIENCE);
        }
        self.steps += 1;
    }
}
