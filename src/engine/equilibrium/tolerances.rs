//! The tolerance that decides whether an equilibrium is accurate.

/// Largest residual of an equilibrium. Usual residuals are below 1e-15; only scenes whose numbers lie apart by more than the working precision
/// come near this.
///
/// Smaller, answers of such scenes are refused; larger, answers pass that are wrong in visible digits.
pub(crate) const ACCURATE: f64 = 1e-10;
