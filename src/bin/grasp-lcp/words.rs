//! The form of answers: number of digits, unit of lengths, and whether points of soft fingertips are printed one by one.

use grasp_lcp::words::Words;

/// The text for answers of a kind that this program does not know, since a later version of the library may add kinds.
pub(crate) const NO_WORDS: &str = "an answer for which this program has no words yet; --json prints it";

/// The form of answers: digits and unit of lengths, and how vectors and soft fingertips are printed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style {
    pub(crate) words: Words,
    /// The number of axes of the scene, 2 or 3.
    pub(crate) axes: usize,
    /// Whether points of soft fingertips are printed one by one.
    pub(crate) points: bool,
}

impl Style {
    /// Number of digits, unit of lengths and number of components of vectors, packed into one number for `format!("{answer:.0$}", …)`.
    pub(crate) fn precision(self) -> usize {
        self.words.precision()
    }
}
