//! How long the steps along a sliding arc are, and by which rule they are made.

use super::arc::Rule;

/// With at most so many sweeps the next step may be twice as long, with one more it may be a little longer.
const FEW_SWEEPS: usize = 4;

/// Where steps die out the error asked for is made larger by this factor, so often: rounding may be what refuses them. The error made
/// is what is reported.
const LOOSER: f64 = 30.0;
const MOST_OFTEN: u8 = 2;
/// From there steps are tried again, as a part of what is left of the leg.
const AGAIN: f64 = 1e-3;

/// A step shorter than this part of the intended one was cut short. Lengths are differences of two factors and lose their last digits,
/// which cuts nothing short.
const WHOLE: f64 = 0.999;

/// How the steps along an arc go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    pub(super) length: Option<f64>,
    pub(super) rule: Rule,
    refused: bool,
    pub(super) steps: usize,
    loosened: u8,
    /// The error asked for, over that of the settings.
    pub(super) looser: f64,
}

impl Pace {
    pub(super) fn new() -> Self {
        Self { length: None, rule: Rule::Reflection, refused: false, steps: 0, loosened: 0, looser: 1.0 }
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
            (self.length, self.refused) = (Some(AGAIN * rest), false);
        }
        may
    }

    pub(super) fn accept(&mut self, length: f64, sweeps: usize) {
        let grow = if self.refused || sweeps > FEW_SWEEPS + 1 {
            1.0
        } else if sweeps > FEW_SWEEPS {
            1.3
        } else {
            2.0
        };
        // A step that was cut short by the end of the leg or an apex says nothing against longer ones.
        let before = self.length.unwrap_or(length);
        self.length = Some(if length < WHOLE * before { before } else { length * grow });
        self.refused = false;
        self.steps += 1;
    }

    pub(super) fn refuse(&mut self, length: f64) {
        self.length = Some(0.5 * length);
        self.refused = true;
        self.steps += 1;
    }
}
