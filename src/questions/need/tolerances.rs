//! Stopping tolerances of the search for an amount, and the ratios and numbers of the amounts that it tries. An amount (of squeeze, friction, load,
//! arm or angle) is sufficient if the grasp meets the demand with it; the bound is the least or greatest sufficient amount. At rest means under the
//! loads that act before the loads of the question.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought. The far end is the last sufficient amount on the
//! easier side of the bound. A scan tries further amounts on both sides of a bound that is already found.
//!
//! Distances and widths of brackets are relative to the amount, or to the end of the range of amounts that no proof excludes. A [`WidthSchedule`] has
//! pairs of a number of steps and a width: from this step on, a bracket of this width is narrow enough. The carried part of the load is the load
//! factor up to which the demand is met.

use super::threshold::WidthSchedule;

/// Two amounts at this relative distance differ by rounding alone.
///
/// The search estimates the bound from both sides. Each time it tries an amount at this distance beyond the estimate; two such trials leave a bracket
/// within [`EXACT`]. The search for an end of the range stops once a step moves the end by less than this distance. If smaller, rounding determines
/// on which side of the bound the trial is. From 5e-13 on, the bracket needs more trials.
pub(super) const LAST_DIGITS: f64 = 1e-13;

/// The search for the least coefficient of friction ends at an interval of this relative width.
///
/// If smaller, rounding determines whether a proof exists. If larger, the end of the range is less accurate, though still proved.
pub(super) const SAME_COEFFICIENT: f64 = 1e-10;

/// Distances from a proved end of the range, relative to it, at which amounts inside and outside are tried.
///
/// If the end is exact, the first distance gives a bracket within [`EXACT`]. The other distances exceed the error of the proved end. Without them
/// both trials next to an inaccurate end would be on the same side of the bound of the sufficient amounts.
pub(super) const NEAR_AN_END: [f64; 3] = [4e-13, 1e-8, 1e-5];

/// Ratio of successive amounts in a search that tries only a few easier amounts, and in the first steps from a sufficient amount to an insufficient
/// one.
///
/// A bracket whose ends have a larger ratio is halved in logarithms, since arithmetic means approach the smaller end slowly.
pub(super) const FAR_APART: f64 = 4.0;

/// While the ratio of the tried amount to the first amount is below this number, the search takes small steps. From this ratio on, each step
/// multiplies the amount by this number.
///
/// If smaller, intervals of sufficient amounts a little away from the start are missed. If larger, a search without a sufficient amount takes longer.
pub(super) const FAR_FROM_START: f64 = (1u32 << NEAR_DOUBLINGS) as f64;

/// The small steps of the search end after this many doublings, at [`FAR_FROM_START`].
pub(super) const NEAR_DOUBLINGS: u32 = 4;

/// Two tried amounts that are nearer to each other than this relative distance are counted as one amount in the number of tried amounts that an
/// answer contains.
///
/// If smaller, amounts that only narrow a bracket are counted as well, and the tried amounts seem closer together than they are.
pub(super) const APART_IN_A_SCAN: f64 = 1e-2;

/// The relative widths at which the bracket of the sought amount is narrow enough, as a schedule of steps and widths. A bracket of such a width
/// leaves open only digits that are due to rounding.
///
/// If narrower, further steps depend on rounding only. If wider, the width shows in the answer.
pub(super) const EXACT: WidthSchedule = &[(0, 1e-12), (64, 5e-10)];

/// The relative width at which a bracket is narrow enough in space if the carried part of the load jumps at the bound.
///
/// If smaller, halvings take most of the time of an answer. If larger, the width shows in the answer.
pub(super) const AT_A_JUMP: f64 = 1e-6;

/// The relative width at which the bracket of the sought amount is narrow enough in space. There verdicts come from load paths with step errors.
///
/// If narrower, load paths begin where equilibria vanish (a fold), with hundreds of short steps. If wider, the width shows in the answer.
pub(super) const EXACT_IN_SPACE: WidthSchedule = &[(0, 1e-9)];

/// The relative widths at which the bracket of an additional amount, `sticks` or `safe`, is narrow enough, as a schedule of steps and widths. If
/// narrower, an answer needs many more trials.
pub(super) const SECOND: WidthSchedule = &[(0, 2e-12), (5, 1e-8)];

/// The relative widths at which a bracket that is not the bracket of the bound is narrow enough, as a schedule of steps and widths. An answer may
/// have eight such brackets, so narrower ones would cost most of the trials.
pub(super) const BESIDE_A_BOUND: WidthSchedule = &[(0, 1e-10), (16, 1e-8), (20, 1e-4)];

/// Upper limit of the ratio of a tried amount to the first amount of the search, and of the first amount to a tried one.
///
/// If the load is sought, load paths are followed up to this multiple. If larger, a search without a sufficient amount takes longer.
pub(super) const MOST_LOADS: f64 = (1u32 << 20) as f64;

/// Relative distance from an end of a bracket up to which a predicted bound may lie outside the bracket.
///
/// If smaller, rounding drops a prediction that is right. If larger, a wrong prediction costs more trials.
pub(super) const NEAR_A_PREDICTION: f64 = 1e-9;

/// Between two neighbouring amounts with different contact states at rest, a further amount is tried only if their ratio exceeds this number.
///
/// If smaller, narrow intervals of other verdicts are sought that hardly matter. If larger, more of them are missed.
pub(super) const BETWEEN_STATES: f64 = 1.05;

/// After a scan, two margins are extrapolated linearly from neighbouring sufficient amounts: the carried part of the load less 1, and the distance to
/// the limit of small motions or of sticking at rest. If a margin is predicted to be zero at an amount x before the next sufficient amount, an amount
/// beyond x is tried. The tried amount lies at this fraction of the way from x to that next amount.
///
/// If smaller, rounding or a curved margin may hide insufficient amounts beyond x. If larger, a narrow interval of insufficient amounts is stepped
/// over.
pub(super) const BEYOND_A_MARGIN: f64 = 0.1;

/// Upper limit of the number of amounts that are tried after a scan, between its amounts. They are tried where a margin is predicted to be zero (see
/// [`BEYOND_A_MARGIN`]), and between neighbouring amounts with different contact states at rest.
///
/// With fewer, intervals of other verdicts are missed. Each amount costs a verdict.
pub(super) const BETWEEN: usize = 5;

/// Of the [`BETWEEN`] amounts, at most this number are tried because a margin is predicted to be zero (see [`BEYOND_A_MARGIN`]), or because the whole
/// load might be carried.
///
/// A margin that falls less and less steeply is zero farther on than its first extrapolation predicts. If 1, insufficient amounts there are missed.
/// If larger, too few amounts are left to try between different contact states at rest.
pub(super) const WHERE_MARGINS_VANISH: usize = 2;

/// If the first amount of the search is easier (such as more squeeze or less load) than the bound by more than this ratio, still easier amounts are
/// tried as well. The scan around the bound does not extend that far.
///
/// If smaller, answers take more verdicts. If larger, the end of the sufficient amounts is missed if it is little easier than the first amount.
pub(super) const FAR_BEHIND: f64 = 4.0;

/// Number of tried amounts that are easier than the first amount of the search (such as more squeeze or less load), in the case of [`FAR_BEHIND`].
/// The easiest of them has the ratio 4 to the first amount.
///
/// With fewer, narrow intervals of other verdicts are missed. Each amount costs a verdict.
pub(super) const NEAR_THE_START: usize = 3;

/// If a greatest amount is sought, amounts far below the bound are tried, too: the bound, or the first amount of the search if it is smaller, divided
/// by these numbers. For example, a force beside the fingers may turn the object out with an arm that is far shorter than the grasp.
///
/// Without these amounts, the least arm that suffices is missed if it is very short. Each costs a verdict.
pub(super) const TOWARDS_ZERO: [f64; 3] = [16.0, 256.0, 65536.0];

/// An interval of sufficient amounts is narrow if its ends differ by less than this fraction. If there is a wider interval, the bound in the answer
/// is an end of a wider one.
///
/// If smaller, the answer may be an amount whose neighbours on both sides are insufficient. If larger, an interval that a user could set is passed
/// over.
pub(super) const NARROW: f64 = 0.01;

/// A scan around the bound of a safe amount is made if this bound is easier (such as more squeeze or less load) than the first amount of the search
/// by more than this ratio.
///
/// If smaller, most safe amounts take the trials of a scan. If larger, an interval of sufficient amounts that the search stepped over stays unseen.
pub(super) const STEPPED_OVER: f64 = 1.25;

/// Coefficient of friction up to which the search asks whether more friction fails; few surfaces have more.
///
/// If smaller, a wedge whose real friction is above the scene's is said to hold. If larger, a change between the scene's coefficient and this one is
/// stepped over more easily.
pub(super) const USUAL_FRICTION: f64 = 1.0;
