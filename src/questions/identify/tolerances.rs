//! The numbers below which a fit to slips takes a value for zero.
//!
//! All of them are dimensionless: logarithms of unknowns, or fractions of the largest value of their kind.

/// Forces, velocities, singular values and shares of a direction below this fraction of the largest are zero.
///
/// Derivatives from differences are exact to about 1e-8. If smaller, combinations that no slip determines get values whose errors are due to rounding.
/// If larger, combinations that slips determine weakly are left out.
pub(super) const INDISTINCT: f64 = 1e-6;

/// Components of a free direction below this fraction of the largest are zero, so that the sentence names fewer unknowns.
///
/// If smaller, unknowns appear with powers due to rounding. If larger, unknowns that share the direction are not named.
pub(super) const NO_COMPONENT: f64 = 1e-4;

/// A step with no logarithm above this is zero, and the search has converged.
///
/// If smaller, the search continues at the error of sliding arcs, 1e-9. If larger, digits of the unknowns are lost.
pub(super) const CONVERGED_STEP: f64 = 1e-10;

/// Relative decrease of the loss below which a step is too small: with n slips it is √n 1e-4 standard errors long.
///
/// Sliding arcs have errors of 1e-9, so that the last digits of the loss are not known. If larger, the search ends early.
pub(super) const CONVERGED_GAIN: f64 = 1e-8;
