//! The tolerance that decides whether an equilibrium is accurate.

/// Tolerance of residuals: an answer with a larger residual is not called an equilibrium. Usual residuals are below 1e-15. Only grasps whose
/// stiffnesses or arms differ by more than the working precision resolves come near this tolerance.
///
/// If smaller, answers for such grasps are refused; if larger, answers are accepted that are wrong in visible digits.
pub(crate) const ACCURATE: f64 = 1e-10;
