//! Tolerances of a grasp, and of the words for its motions.

/// Cholesky factorisation of a stiffness or compliance matrix reduces its entries to remainders. A negative remainder of a diagonal entry counts as a
/// rounding error if its magnitude is at most this fraction of the original entry. Where only zero diagonal entries are left, the offdiagonal entries
/// between them must be zero, too, in a semidefinite matrix. Their remainders count as rounding errors up to this fraction of the geometric mean of
/// the two original diagonal entries.
///
/// If this number is smaller, rounding makes a semidefinite matrix indefinite; if it is larger, an indefinite matrix is accepted.
pub(super) const NEGATIVE_REMAINDER: f64 = 1e-10;

/// The sentence for a motion begins with the translation if the rotation contributes little. Little means: the displacements of the points of the
/// object due to rotation are at most this fraction of their mean displacement. Otherwise it begins with the rotation. In a sentence for several
/// bodies, a body is named only if it moves faster than this fraction of the speed of the fastest body.
///
/// If this number is smaller, sentences describe motions that are hardly visible; if it is larger, they omit bodies that move.
pub(super) const SEEN_MOTION: f64 = 0.05;

/// A component of a load counts as a rounding error if it is at most this fraction of the largest component. So does a coordinate of a point on an
/// axis of rotation, if no points of the object are known; the number is then in m.
///
/// If this number is smaller, sentences show rounding errors; if it is larger, they omit small components.
pub(super) const LITTLE_ROUNDING: f64 = 1e-13;
