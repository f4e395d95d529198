//! The numbers below which the elastic solution of an object takes a value for zero or for rounding.
//!
//! All of them are pure numbers: fractions of the forces, work or terms that they are compared with.

/// A load whose work on a unit free motion is below this fraction of its size does no work on it. Loads that were computed to balance carry rounding
/// of about 1e-16.
///
/// If smaller, balanced loads seem to drive the object off; if larger, loads that do are neglected.
pub(super) const NO_WORK: f64 = 1e-13;

/// Forces below this fraction of those that displacements could cause in the springs are rounding. A statically determinate grasp may carry no force
/// at all. Three projections then leave 1e-45 of the forces that its springs could have from displacements of this size. With this fraction such
/// noise is not compared with itself.
///
/// If smaller, that noise counts as forces; if larger, small forces beside large displacements do not count.
pub(crate) const NO_FORCE: f64 = 1e-25;

/// Refinement ends at a correction below this fraction of the largest force: the error that remains is the same fraction of the correction.
///
/// If smaller, well-conditioned pieces take another correction; if larger, forces miss digits that one correction would give.
pub(super) const NEARLY_CORRECTED: f64 = 1e-8;

/// The largest number of corrections. Where the exact force is zero, each correction leaves 1e-16 of the previous value.
pub(super) const MOST_CORRECTIONS: usize = 4;

/// Largest number of steps towards the equilibrium to which the stuck grasp relaxes; ten to thirty suffice as a rule. With fewer, Newton's method may
/// go back to an equilibrium that is not stable, which the steps have passed.
pub(super) const RELAXING_STEPS: usize = 300;

/// The object has nearly relaxed where the estimated rest of its path is below this fraction of the path covered: Newton's method goes the rest. With
/// a fraction twenty times as large, another equilibrium is nearer in one of 240 random scenes (test `needed_amounts`); with a smaller one there are
/// more steps.
pub(super) const NEARLY_RELAXED: f64 = 1e-2;

/// Cosine of the angle between two steps of the relaxation above which the second has nearly the direction of the first, and is made twice as long.
/// If smaller, long steps oscillate; if larger, slow relaxation takes hundreds of steps.
pub(super) const STRAIGHT_ON: f64 = 0.99;

/// The largest factor by which a step of the relaxation is made longer. If larger, a step may pass over an equilibrium; if smaller, slow relaxation
/// takes longer.
pub(super) const LONGEST_PACE: f64 = 64.0;
