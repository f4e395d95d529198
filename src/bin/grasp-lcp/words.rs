//! How answers are told: with how many digits, and whether point by point.

use grasp_lcp::words::Words;

/// Of what the library may come to say some day.
pub(crate) const NO_WORDS: &str = "an answer for which this program has no words yet; --json prints it";

/// How answers are told.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) words: Words,
    /// Points of soft fingertips one by one.
    pub(crate) points: bool,
}

impl Style {
    /// Digits of a whole answer.
    pub(crate) fn digits(self) -> usize {
        self.words.digits()
    }
}
