//! How long the steps along a sliding arc are, and by which rule they are made.

use super::arc::Rule;

/// With at most so many sweeps the next step may be twice as long, with one more it may be a little longer.
const FEW_SWEEPS: usize = 4;

/// How the steps along an arc go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pace {
    pub(super) length: Option<f64>,
    pub(super) rule: Rule,
    refused: bool,
    pub(super) steps: usize,
}

impl Pace {
    pub(super) fn new() -> Self {
        Self { length: None, rule: Rule::Reflection, refused: false, steps: 0 }
    }

    /// At an event the next step is looked for anew.
    pub(super) fn at_node(self) -> Self {
        Self { steps: self.steps, ..Self::new() }
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
        self.length = Some(if length < before { before } else { length * grow });
        self.refused = false;
        self.steps += 1;
    }

    pub(super) fn refuse(&mut self, length: f64) {
        self.length = Some(0.5 * length);
        self.refused = true;
        self.steps += 1;
    }
}
