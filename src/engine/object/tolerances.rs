//! The numbers below which the elastic solution of an object takes a value for zero or for rounding.
//!
//! All of them are pure numbers, parts of the forces, work or terms that they are compared with.

/// A load that does less work than this part of its size on a unit free motion does none. Loads that were computed to balance carry rounding
/// of about 1e-16.
///
/// Smaller, balanced loads seem to drive the object off; larger, loads that do are neglected.
pub(super) const NO_WORK: f64 = 1e-13;

/// ε of the clock that says when a contact is evaluated: deviations from e count 1/ε times. With a smaller ε, a clock that turns away runs too
/// fast; with a larger one, contacts are evaluated too early.
pub(super) const PRICED_ACROSS: f64 = 0.25;

/// Values are reduced by this part of their terms, which exceeds their rounding: a contact that waits too long would be missed.
///
/// Smaller, such contacts are missed; larger, contacts are evaluated too early.
pub(crate) const PRICING_MARGIN: f64 = 1e-13;

/// Part of the springs' possible forces that counts as a force. A statically determinate grasp may carry no force at all. Three projections then
/// leave 1e-45 of the forces that its springs could have from displacements of this size. With this part, noise is not compared with itself.
///
/// Smaller, that noise counts as forces; larger, small forces beside large displacements do not count.
pub(crate) const NO_FORCE: f64 = 1e-25;

/// A correction by less than this part of the largest force is the last: its own error is this part of it.
///
/// Smaller, well-conditioned pieces take another correction; larger, forces miss digits that one correction would give.
pub(super) const NEARLY_CORRECTED: f64 = 1e-8;

/// Most corrections: where a force is exactly zero, each correction leaves 1e-16 of the previous value.
pub(super) const MOST_CORRECTIONS: usize = 4;

/// Largest number of steps towards the equilibrium to which the stuck grasp relaxes; ten to thirty suffice as a rule. With fewer, Newton's method may
/// go back to an equilibrium that is not stable, which the steps have passed.
pub(super) const RELAXING_STEPS: usize = 300;

/// The object has nearly relaxed where the way that is left is shorter than this part of the way gone: Newton's method takes it. With twenty times as much
/// another equilibrium is nearer in one of 240 random scenes (`needed_amounts`); with less the steps take longer.
pub(super) const NEARLY_RELAXED: f64 = 1e-2;

/// Cosine of the angle between two steps above which the second goes straight on, and is made twice as long. Smaller, long steps oscillate; larger, slow
/// relaxation takes hundreds of steps.
pub(super) const STRAIGHT_ON: f64 = 0.99;

/// The largest factor by which a step is made longer. Larger, a step may pass over an equilibrium; smaller, slow relaxation takes longer.
pub(super) const LONGEST_PACE: f64 = 64.0;
