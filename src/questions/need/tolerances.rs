//! When a search for an amount ends, and the limits of its range.
//!
//! All numbers are relative: to the amount, or to the end of a range.

use super::threshold::Enough;

/// Two amounts at this relative distance differ by rounding alone.
///
/// A guess of the bound is moved across it by this distance, so that trials on both sides leave a bracket within [`EXACT`]. An end of the range is
/// final once it moves by less. If smaller, rounding decides the side. From 5e-13 on, the bracket needs more trials.
pub(super) const LAST_DIGITS: f64 = 1e-13;

/// The search for the least coefficient of friction ends at an interval of this relative width.
///
/// If smaller, rounding decides whether a proof exists. If larger, the end of the range is looser, though still proved.
pub(super) const SAME_COEFFICIENT: f64 = 1e-10;

/// Distances from a proved end of the range, relative to it, at which amounts inside and outside are tried.
///
/// If the end is exact, the first distance gives a bracket within [`EXACT`]. The others exceed the error that proofs leave; without them both trials
/// beside an inaccurate end would fall on one side.
pub(super) const NEAR_AN_END: [f64; 3] = [4e-13, 1e-8, 1e-5];

/// Ratio of successive amounts in a short search, and in the first steps from a sufficient amount to an insufficient one.
///
/// A bracket whose ends have a larger ratio is halved in logarithms, since arithmetic means approach the smaller end slowly.
pub(super) const FAR_APART: f64 = 4.0;

/// As long as the ratio of an amount to the start is below this, the search takes small steps. Beyond, it multiplies the amount by this ratio.
///
/// If smaller, intervals of sufficient amounts a little away from the start are skipped. If larger, a search without a sufficient amount takes
/// longer.
pub(super) const FAR_FROM_START: f64 = (1u32 << NEAR_DOUBLINGS) as f64;

/// The small steps of the search end after this many doublings, at [`FAR_FROM_START`].
pub(super) const NEAR_DOUBLINGS: u32 = 4;

/// An answer says how many amounts were tried. Amounts that are nearer to each other than this relative distance count once.
///
/// If smaller, amounts that only narrow a bracket count as well, and a scan seems closer than it is.
pub(super) const APART_IN_A_SCAN: f64 = 1e-2;

/// When the bracket of the amount itself is narrow enough: at the last digits that rounding leaves.
///
/// If narrower, further steps follow rounding only. If wider, the width shows in the answer.
pub(super) const EXACT: Enough = &[(0, 1e-12), (64, 5e-10)];

/// In space, a bracket of this relative width is enough where the carried part jumps at the bound.
///
/// If smaller, halvings take most of the time of an answer. If larger, the bracket shows in the answer.
pub(super) const AT_A_JUMP: f64 = 1e-6;

/// When the bracket of the amount is narrow enough in space, where the paths that decide are known to the error of their steps.
///
/// If narrower, trials follow paths that begin at a fold, with hundreds of short steps. If wider, the width shows in the answer.
pub(super) const EXACT_IN_SPACE: Enough = &[(0, 1e-10), (64, 5e-10)];

/// When the bracket of a second amount, `sticks` or `safe`, is narrow enough. If narrower, an answer needs many more trials.
pub(super) const SECOND: Enough = &[(0, 2e-12), (5, 1e-8)];

/// When the brackets at other changes of verdict around a bound are narrow enough. There may be eight of them, so narrower ones would cost most of
/// the trials.
pub(super) const BESIDE_A_BOUND: Enough = &[(0, 1e-10), (16, 1e-8), (20, 1e-4)];

/// Largest ratio between an amount that is tried and the start of the search, upwards and downwards.
///
/// If the load is sought, it is followed up to this multiple. If larger, a search without a sufficient amount takes longer.
pub(super) const MOST_LOADS: f64 = (1u32 << 20) as f64;

/// Relative distance from an end of a bracket up to which a predicted bound may lie outside the bracket.
///
/// If smaller, rounding drops a prediction that is right. If larger, one that is wrong costs more trials.
pub(super) const NEAR_A_PREDICTION: f64 = 1e-9;

/// Two neighbouring amounts whose contacts rest in different states have a further one tried between them only if their ratio exceeds this.
///
/// If smaller, intervals of other verdicts are sought that hardly matter. If larger, more of them are missed.
pub(super) const BETWEEN_STATES: f64 = 1.05;

/// At most this many amounts are tried between neighbours whose contacts rest in different states.
///
/// With fewer, intervals of other verdicts are missed. Each costs a verdict.
pub(super) const BETWEEN: usize = 5;

/// Ratio of the bound to the first amount tried above which amounts beyond the first one are tried as well, since those around the bound do not
/// reach it.
///
/// If smaller, answers take more verdicts. If larger, an end of the sufficient amounts just beyond the first one is missed.
pub(super) const FAR_BEHIND: f64 = 4.0;

/// Number of amounts tried beyond the first one in this case, up to a ratio of 4.
///
/// With fewer, narrow intervals of other verdicts are missed. Each costs a verdict.
pub(super) const NEAR_THE_START: usize = 3;

/// Ratios of the first amount tried to those tried far below it, where a greatest amount is sought. An arm from which a load jams may be far shorter
/// than the grasp.
///
/// Without them such an end is missed. Each costs a verdict.
pub(super) const TOWARDS_ZERO: [f64; 3] = [16.0, 256.0, 65536.0];
