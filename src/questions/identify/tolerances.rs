//! The numbers below which a fit to slips takes a value for zero.
//!
//! All of them are pure numbers: logarithms of unknowns, or parts of the largest value of their kind.

/// Forces, velocities, singular values and shares of a direction below this part of the largest are zero.
///
/// Derivatives from differences are exact to about 1e-8. Smaller, combinations that no slip determines get numbers with errors made of
/// rounding. Larger, combinations that slips determine weakly are left out.
pub(super) const INDISTINCT: f64 = 1e-6;

/// Components of a free direction below this part of the largest are zero, so that the sentence names fewer unknowns.
///
/// Smaller, unknowns appear with powers made of rounding. Larger, unknowns that share the direction are not named.
pub(super) const NO_COMPONENT: f64 = 1e-4;

/// A step with no logarithm above this is zero, and the search has converged.
///
/// Smaller, the search goes on at the error of sliding arcs, 1e-9. Larger, digits of the unknowns are lost.
pub(super) const CONVERGED_STEP: f64 = 1e-10;

/// Relative decrease of the loss below which a step is too small: with n slips it is √n 1e-4 standard errors long.
///
/// Sliding arcs have errors of 1e-9, so that the last digits of the loss are not known. Larger, the search ends early.
pub(super) const CONVERGED_GAIN: f64 = 1e-8;
