//! Tolerances of the warnings about a scene: differences up to which two numbers count as equal.

/// Relative difference up to which the normal force without load counts as the given `pressed_with`.
///
/// With a smaller value, a scene with rounded forces would get a warning. With a larger value, a wrong `pressed_with` would get none.
pub(super) const OTHERWISE_PRESSED: f64 = 0.02;

/// Relative difference up to which two answers with different trial stiffnesses count as equal. If the answers are equal, the stiffness that the
/// scene does not give counts as having no effect.
///
/// With a smaller value, the integration error of load paths on which slip directions turn would count as a difference. With a larger value, answers
/// that depend on the stiffness get no warning.
pub(super) const SAME_ANSWER: f64 = 1e-6;

/// Trial values of a stiffness that the scene does not give lie between the default divided by this factor and the default times this factor. Each
/// direction of each contact has its own trial value.
///
/// With a smaller value, answers that depend on the stiffness would hardly differ between the trials. With a larger value, the trials would have
/// springs that nobody builds.
pub(super) const STIFFNESS_RANGE: f64 = 10.0;
