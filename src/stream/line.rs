//! One line of the stream.

/// A longer line is not kept; it is answered by an error.
pub const LONGEST_LINE: usize = 1 << 26;

/// One line.
pub(super) struct InputLine {
    /// From 1.
    pub(super) number: usize,
    /// What is kept of it: of a line that is too long, its beginning.
    pub(super) text: Vec<u8>,
    pub(super) too_long: bool,
}
