//! The form of answers: number of digits, and whether points of soft fingertips are printed one by one.

use grasp_lcp::words::Words;

/// Printed for kinds of answers that a later version of the library may add.
pub(crate) const NO_WORDS: &str = "an answer for which this program has no words yet; --json prints it";

/// The form of answers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) words: Words,
    /// Whether points of soft fingertips are printed one by one.
    pub(crate) points: bool,
}

impl Style {
    /// Number of significant digits in all lines of an answer.
    pub(crate) fn digits(self) -> usize {
        self.words.digits()
    }
}
