//! The numbers below which pivoting on contact states takes a value for zero, a tie or rounding.
//!
//! All of them are pure numbers, parts of the terms or forces that they are compared with.

/// Relative imbalance of forces that counts as balance: the rest is mostly rounding, which another correction would not reduce.
///
/// Smaller, corrections are made on rounding; larger, forces miss digits.
pub(super) const BALANCED_SOLUTION: f64 = 1e-13;

/// Largest residual of a solution: a vertex of a wrong basis violates its conditions by much more.
///
/// Smaller, true solutions of soft springs are refused; larger, wrong bases pass.
pub(super) const ACCURATE_SOLUTION: f64 = 1e-10;

/// Forces below this part of those in the trial state are rounding of the trial state.
///
/// Smaller, rounding of large trial states counts as an imbalance; larger, imbalances of small forces are overlooked.
pub(super) const TRIAL_ROUNDING: f64 = 1e-5;

/// Relative error of a value: variables tie that reach zero within such errors of each other. Smaller, a symmetric scene leaves a tie to its
/// rounding; larger, a variable becomes negative.
pub(super) const TIE: f64 = 1e-12;
