//! Tolerances of pivoting on contact states: below them a value counts as zero, as a tie or as rounding.
//!
//! All of them are pure numbers: fractions of the terms or forces that they are compared with.

/// Relative rounding error of a variable: variables that reach zero within this error of each other are tied. If smaller, rounding decides the ties of
/// symmetric grasps; if larger, a variable becomes negative.
pub(super) const TIE: f64 = 1e-12;
