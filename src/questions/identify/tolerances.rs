//! Limits of the estimation of parameters from observed slip: a value below one of them is taken as zero, or the search stops. A parameter is a
//! number of the grasp that is sought, such as a coefficient of friction. An observation is a load or angle at which slip was observed. The loss is
//! the function of the residuals that the search minimises.
//!
//! All these limits are dimensionless: they apply to logarithms of parameters, or to fractions of the largest value of the same kind.

/// Forces, velocities, singular values and derivatives below this fraction of the largest are taken as zero.
///
/// Difference quotients are accurate to about 1e-8. If this fraction were smaller, combinations of parameters (such as products) that no observation
/// determines would get values that are only rounding. If it were larger, combinations that observations determine weakly would be taken as
/// undetermined.
pub(super) const INDISTINCT: f64 = 1e-6;

/// Components below this fraction of the largest are taken as zero in a combination of parameters that observations do not determine. The answer then
/// names fewer parameters.
///
/// If it were smaller, parameters would appear with powers due to rounding. If it were larger, some parameters of the combination would not be named.
pub(super) const NO_COMPONENT: f64 = 1e-4;

/// The search for the parameters has converged once a step changes the logarithm of each parameter by at most this number.
///
/// If it were smaller, some searches would not end: on the round cone directions of slip turn along the load path, and predictions are accurate to
/// 1e-9 only. If it were larger, digits of the parameters would be lost.
pub(super) const CONVERGED_STEP: f64 = 1e-10;

/// The search has converged once a step is predicted to decrease the loss by at most this fraction. With n observations such a step is √n 1e-4
/// standard errors long.
///
/// If it were smaller, the last steps would only follow errors of the predictions (1e-9 on the round cone, where directions of slip turn along the
/// load path). If it were larger, the search would end before the minimum.
pub(super) const CONVERGED_GAIN: f64 = 1e-8;
