//! Tolerances of equilibria: the residual of an accurate one, and the steps from small motions to finite rotations ([`super::snap_through`]).

/// Largest relative residual of an equilibrium, for example an imbalance relative to the forces that should balance. An answer with a larger residual
/// is not called an equilibrium. Usual residuals are below 1e-15. Only grasps with stiffnesses or lever arms that differ by many orders of magnitude,
/// near the limit of double precision, come near this tolerance.
///
/// If smaller, answers for such grasps are refused; if larger, answers are accepted that are wrong in visible digits.
pub(crate) const ACCURATE: f64 = 1e-10;

/// Part of the elastic work below which the change of arms is neglected. At a snap-through it is near a fifth. If larger, a part that snaps through
/// beside much softer ones would be missed; if smaller, ordinary grasps would take longer.
pub(super) const WORK_OF_ARMS: f64 = 0.01;

/// The first step of the share of exact rotations. If larger, first steps often fail; if smaller, there are more steps than needed.
pub(super) const FIRST_SHARE: f64 = 0.25;

/// Least step of the share of exact rotations: if none as long succeeds, the load is lost. If larger, loads are called lost that are a little smaller
/// than those lost in truth; if smaller, the search takes longer.
pub(super) const LEAST_SHARE: f64 = 1e-4;

/// Number of steps that are tried, with or without success. Ten to forty are usual. If none leads to the end, the load counts as lost.
pub(super) const MOST_SHARES: usize = 200;

/// Length of the longest motion in a step, as a part of the whole motion. If larger, a step may pass over the loss, to an equilibrium beyond.
pub(super) const FARTHEST_MOTION: f64 = 0.1;

/// Number of Newton's steps in which an equilibrium has to be found. Three are usual.
pub(super) const NEWTON_STEPS_OF_A_SHARE: usize = 12;

/// Length of the last of Newton's steps, as a part of the whole motion. The method converges quadratically, so that the next step is rounding.
pub(super) const LAST_NEWTON_STEP: f64 = 1e-9;
