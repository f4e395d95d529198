//! Limits of the identification of unknowns from observed slips: a value below one of them is taken as zero, or the search stops. An unknown is a
//! number of the grasp, such as a coefficient of friction. The loss is the function of the residuals that the search minimises.
//!
//! All these limits are dimensionless: they apply to logarithms of unknowns, or to fractions of the largest value of the same kind.

/// Forces, velocities, singular values and derivatives below this fraction of the largest are taken as zero.
///
/// Difference quotients are accurate to about 1e-8. If this fraction were smaller, combinations of unknowns (such as products) that no slip
/// determines would get values that are only rounding. If larger, combinations that slips determine weakly would be taken as undetermined.
pub(super) const INDISTINCT: f64 = 1e-6;

/// Components below this fraction of the largest are taken as zero in a combination of unknowns that slips do not determine. The answer then names
/// fewer unknowns.
///
/// If smaller, unknowns appear with powers due to rounding. If larger, some unknowns of the combination are not named.
pub(super) const NO_COMPONENT: f64 = 1e-4;

/// The search for the unknowns has converged once a step changes the logarithm of each unknown by at most this number.
///
/// If smaller, some searches do not end: on the round cone directions of slip turn along the load path, and predictions are accurate to 1e-9 only. If
/// larger, digits of the unknowns are lost.
pub(super) const CONVERGED_STEP: f64 = 1e-10;

/// The search has converged once a step is predicted to decrease the loss by at most this fraction. With n slips such a step is √n 1e-4 standard
/// errors long.
///
/// If smaller, the last steps only follow errors of the predictions (1e-9 on the round cone, where directions of slip turn along the load path). If
/// larger, the search ends before the minimum.
pub(super) const CONVERGED_GAIN: f64 = 1e-8;
