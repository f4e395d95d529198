//! Limits below which a fit to observed slips takes a value for zero.
//!
//! All of them are dimensionless: they apply to logarithms of unknowns, or to fractions of the largest value of a kind.

/// Forces, velocities, singular values and components of a direction below this fraction of the largest count as zero.
///
/// Derivatives from differences are exact to about 1e-8. If smaller, combinations that no slip determines get values whose errors are due to
/// rounding. If larger, combinations that slips determine weakly are left out.
pub(super) const INDISTINCT: f64 = 1e-6;

/// Components below this fraction of the largest count as zero in a combination that slips do not determine. The sentence then names fewer unknowns.
///
/// If smaller, unknowns appear with powers due to rounding. If larger, unknowns that belong to the combination are not named.
pub(super) const NO_COMPONENT: f64 = 1e-4;

/// The search has converged once a step changes no logarithm of an unknown by more than this.
///
/// If smaller, the search continues where predictions along sliding arcs are exact to 1e-9 only. If larger, digits of the unknowns are lost.
pub(super) const CONVERGED_STEP: f64 = 1e-10;

/// The search has converged once a step promises to decrease the loss by less than this fraction: with n slips such a step is √n 1e-4 standard errors
/// long.
///
/// If smaller, errors of 1e-9 along sliding arcs decide the last steps. If larger, the search ends early.
pub(super) const CONVERGED_GAIN: f64 = 1e-8;
