//! The distances of amounts at which a search ends, and the limits of its range.
//!
//! All of them are relative: to the amount, or to the end of a range.

use super::threshold::Enough;

/// Relative distance of two amounts that differ by rounding alone.
///
/// A guess is moved across the bound by this distance, so that trials on both sides leave a bracket within [`EXACT`]. An end of the range is final once
/// successive cuts differ by less. If smaller, rounding decides the side. From 5e-13 on, the bracket needs more trials.
pub(super) const LAST_DIGITS: f64 = 1e-13;

/// Width, relative to the coefficient of friction, that ends the search for the least one.
///
/// If smaller, rounding decides whether a proof exists. If larger, the end is looser, though still proved.
pub(super) const SAME_COEFFICIENT: f64 = 1e-10;

/// Distances of trials inside and outside an end of the range, relative to the end.
///
/// Where the end is exact, the first pair is a bracket within [`EXACT`]. The others exceed the error that proofs leave; without them both
/// trials beside a loose end fall on one side.
pub(super) const NEAR_AN_END: [f64; 3] = [4e-13, 1e-8, 1e-5];

/// Ratio of successive amounts in a short search, and of the first steps from a sufficient amount to an insufficient one.
///
/// A bracket beyond it is halved in logarithms, since means of amounts that far apart approach the smaller one slowly.
pub(super) const FAR_APART: f64 = 4.0;

/// Ratio of an amount to the start up to which the search takes small steps. Beyond it, successive amounts have this ratio to each other.
///
/// If smaller, windows of sufficient amounts a little away from the start are passed over. If larger, a search of an insufficient grasp takes longer.
pub(super) const FAR_FROM_START: f64 = (1u32 << NEAR_DOUBLINGS) as f64;

/// Number of doublings from the start up to [`FAR_FROM_START`].
pub(super) const NEAR_DOUBLINGS: u32 = 4;

/// Relative distance from which two amounts count as two in an answer that says how many were tried.
///
/// If smaller, amounts that only narrow a bracket count as well, and a scan seems closer than it is.
pub(super) const APART_IN_A_SCAN: f64 = 1e-2;

/// Widths for the amount itself: the last digits that rounding leaves.
///
/// Narrower ones cost steps that only rounding decides; wider ones show in the answer.
pub(super) const EXACT: Enough = &[(0, 1e-12), (64, 5e-10)];

/// Width that is enough in space where the carried part jumps at the bound.
///
/// If smaller, halvings take most of the time of an answer; if larger, the bracket shows in the answer.
pub(super) const AT_A_JUMP: f64 = 1e-6;

/// The same in space, where the paths that decide are known to the error of their steps.
///
/// Narrower ones cost paths that begin at a fold, with hundreds of short steps; wider ones show in the answer.
pub(super) const EXACT_IN_SPACE: Enough = &[(0, 1e-10), (64, 5e-10)];

/// Widths for an amount reported beside the first, `sticks` or `safe`. Narrower ones multiply the trials of an answer.
pub(super) const SECOND: Enough = &[(0, 2e-12), (5, 1e-8)];

/// Widths for other changes of verdict around a bound. There may be eight of them, so that narrower ones cost the most trials.
pub(super) const BESIDE_A_BOUND: Enough = &[(0, 1e-10), (16, 1e-8), (20, 1e-4)];

/// Largest ratio of an amount to the start of the search, and of the start to an amount.
///
/// Where the load is sought it is followed up to this multiple. If larger, a search of an insufficient grasp takes longer.
pub(super) const MOST_LOADS: f64 = (1u32 << 20) as f64;

/// Most contact states that a quick trial enumerates.
///
/// With fewer, quick trials leave amounts open that they would decide as fast as they give up; with more, those that refute an amount take longer.
pub(super) const FEW_STATES: usize = 256;

/// Relative distance from an end of a bracket up to which a predicted bound may lie outside the bracket.
///
/// Smaller, rounding drops a prediction that is right; larger, one that is wrong costs more trials.
pub(super) const NEAR_A_PREDICTION: f64 = 1e-9;

/// Ratio of two amounts up to which none is tried between them where contacts rest in other states.
///
/// If smaller, windows are sought that hardly matter; if larger, more of them are missed.
pub(super) const BETWEEN_STATES: f64 = 1.05;

/// Most amounts tried between neighbours whose contacts rest in different states.
///
/// Fewer miss windows of other verdicts; more cost a verdict each.
pub(super) const BETWEEN: usize = 5;
