//! One line of the stream's input.

/// Length of the longest line that is accepted, bytes. A longer line is discarded, and its answer is an error.
pub const LONGEST_LINE: usize = 1 << 26;

pub(super) struct InputLine {
    /// The number of the line, from 1.
    pub(super) number: usize,
    /// The text; of a line that is too long, only its beginning.
    pub(super) text: Vec<u8>,
    pub(super) too_long: bool,
}
