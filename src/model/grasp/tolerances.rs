//! Tolerances of a grasp, and of the words for its motions.

/// In the Cholesky factorisation of a stiffness or compliance matrix, a negative remainder of a diagonal entry counts as rounding up to this fraction
/// of the original entry. So do remainders of offdiagonal entries in the block that should vanish.
///
/// If smaller, rounding makes a semidefinite matrix indefinite; if larger, an indefinite matrix is accepted.
pub(super) const NEGATIVE_REMAINDER: f64 = 1e-10;

/// The sentence for a motion begins with the translation if the displacement due to rotation is at most this fraction of the mean displacement of the
/// points. Otherwise it begins with the rotation. In a sentence for several bodies, a body is named only if it moves faster than this fraction of the
/// speed of the fastest body.
///
/// If smaller, sentences describe motions that are hardly visible; if larger, they omit bodies that move.
pub(super) const SEEN_MOTION: f64 = 0.05;

/// Magnitude up to which a component counts as rounding. For a load this number is relative to the largest component. For a point on an axis of
/// rotation it is in m, if no points of the object are known.
///
/// If smaller, sentences show rounding errors; if larger, they omit small components.
pub(super) const LITTLE_ROUNDING: f64 = 1e-13;
