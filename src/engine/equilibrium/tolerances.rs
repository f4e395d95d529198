//! The tolerance that decides whether an equilibrium is accurate.

/// Largest relative residual of an equilibrium, for example an imbalance relative to the forces that should balance. An answer with a larger residual
/// is not called an equilibrium. Usual residuals are below 1e-15. Only grasps with stiffnesses or lever arms that differ by many orders of magnitude,
/// near the limit of double precision, come near this tolerance.
///
/// If smaller, answers for such grasps are refused; if larger, answers are accepted that are wrong in visible digits.
pub(crate) const ACCURATE: f64 = 1e-10;
