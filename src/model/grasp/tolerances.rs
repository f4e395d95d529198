//! The numbers below which a grasp and the words for its motions take a value for zero or for rounding.

/// Remainder of a diagonal entry, over the entry, that is too far below zero to be rounding. Remainders beside the diagonal have the same
/// bound.
///
/// Smaller, rounding makes a matrix indefinite; larger, an indefinite one passes.
pub(super) const NEGATIVE_REMAINDER: f64 = 1e-10;

/// Displacement by rotation, over the mean displacement of the points, up to which the words begin with the translation. Above it they begin with
/// the rotation about its axis. Also the least speed of a body, over the fastest, at which it is named.
///
/// Smaller, sentences name motions that hardly show; larger, they leave out bodies that move.
pub(super) const SEEN_MOTION: f64 = 0.05;

/// Rounding of a way to an axis where only the motion is known, in m, and of components of a load over the largest one.
///
/// Smaller, sentences show numbers made of rounding; larger, they leave out small components.
pub(super) const LITTLE_ROUNDING: f64 = 1e-13;
