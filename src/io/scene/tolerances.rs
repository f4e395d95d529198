//! The differences below which warnings of a scene take two answers for one.

/// Relative difference up to which a force at rest counts as the stated one.
///
/// Smaller, a scene with rounded forces gets a warning. Larger, squeezes that act otherwise than stated go unnoticed.
pub(super) const OTHERWISE_PRESSED: f64 = 0.02;

/// Relative difference below which two answers are the same, so that a stiffness that was left out does not matter.
///
/// Smaller, the error of sliding arcs counts as a difference. Larger, answers that depend on the stiffness get no warning.
pub(super) const SAME_ANSWER: f64 = 1e-6;

/// Largest factor, up or down, on a stiffness that was left out; every direction of a trial has a factor of its own.
///
/// Smaller, answers that depend on the stiffness look alike. Larger, springs are tried that nobody builds.
pub(super) const STIFFNESS_RANGE: f64 = 10.0;
