//! The numbers below which pivoting on contact states takes a value for zero, a tie or rounding.
//!
//! All of them are pure numbers, parts of the terms or forces that they are compared with.

/// Relative error of a value: variables tie that reach zero within such errors of each other. Smaller, a symmetric scene leaves a tie to its
/// rounding; larger, a variable becomes negative.
pub(super) const TIE: f64 = 1e-12;
