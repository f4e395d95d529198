//! What sentences take for equal, and how much they list.

/// Relative difference up to which a sentence takes two forces, amounts or lengths for one. Six digits do not show it.
///
/// Smaller, a sentence repeats a number. Larger, it hides a difference that its digits would show.
pub(crate) const ALIKE_IN_WORDS: f64 = 1e-6;

/// Longest list of names that is written in full; a longer one buries the number that the sentence is about.
pub(crate) const MOST_NAMES: usize = 8;
