//! Limits of sentences: the relative difference up to which numbers count as equal, and the length of lists.

/// Relative difference up to which a sentence treats two forces, lengths or values of a sought quantity as equal. Six digits do not show such a
/// difference.
///
/// If this limit is smaller, a sentence prints two numbers with the same digits. If it is larger, a sentence hides a difference that its digits would
/// show.
pub(crate) const ALIKE_IN_WORDS: f64 = 1e-6;

/// A list of names is written in full if it has at most this number of names. A longer list would bury the number that the sentence reports.
pub(crate) const MOST_NAMES: usize = 8;
