//! Tolerances of a grasp, and of the words for its motions.

/// In the Cholesky factorisation of a stiffness or compliance matrix, a negative remainder of a diagonal entry counts as rounding up to this fraction
/// of the original entry. So do remainders of offdiagonal entries in the block that should vanish.
///
/// If smaller, rounding makes a semidefinite matrix indefinite; if larger, an indefinite matrix is accepted.
pub(super) const NEGATIVE_REMAINDER: f64 = 1e-10;

/// Displacement due to rotation, divided by the mean displacement of the points, up to which the sentence for a motion begins with the translation.
/// Above it the sentence begins with the rotation. Also the least speed of a body, relative to the fastest, at which the sentence names it.
///
/// If smaller, sentences describe motions that are hardly visible; if larger, they omit bodies that move.
pub(super) const SEEN_MOTION: f64 = 0.05;

/// Magnitude up to which a component counts as rounding. For a load this number is relative to the largest component. For a point on an axis of
/// rotation it is in m, if no points of the object are known.
///
/// If smaller, sentences show rounding errors; if larger, they omit small components.
pub(super) const LITTLE_ROUNDING: f64 = 1e-13;
