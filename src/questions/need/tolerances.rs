//! Stopping tolerances of the search for an amount, and the ratios and numbers of the amounts that it tries. An amount (of squeeze, friction, load,
//! arm or angle) is sufficient if the grasp meets the demand with it, for example holds the object. The result for one amount, sufficient or not, is
//! a verdict. The bound is the least or greatest sufficient amount. A safe amount is sufficient also with less friction and squeeze, or with larger
//! loads. At rest means under the loads that act before the loads of the question.
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
/// that is narrower than [`EXACT`] (1e-12) requires. The search for an end of the range stops once a step moves the end by less than this distance.
/// With a smaller distance rounding determines on which side of the bound the trial is. From 5e-13 on, the bracket needs more trials.
pub(super) const LAST_DIGITS: f64 = 1e-13;

/// The search for the least coefficient of friction ends at an interval of this relative width.
///
/// If smaller, rounding determines whether it is proved that contact forces do not balance the loads. If larger, the end of the range is less
/// accurate, though still proved.
pub(super) const SAME_COEFFICIENT: f64 = 1e-10;

/// Distances from a proved end of the range, relative to it, at which amounts inside and outside are tried.
///
/// If the end is exact, the first distance gives a bracket that is narrow enough for [`EXACT`] (1e-12). The other distances exceed the error of the
/// proved end. Without them both trials next to an inaccurate end would be on the same side of the bound of the sufficient amounts.
pub(super) const NEAR_AN_END: [f64; 3] = [4e-13, 1e-8, 1e-5];

/// A search that tries easier amounts only, in wide steps, has this ratio of successive amounts. A search for an insufficient amount beyond a
/// sufficient one begins with this ratio; from step to step the ratio grows by this factor.
///
/// A bracket whose ends have a larger ratio is halved in logarithms, since arithmetic means approach the smaller end slowly.
pub(super) const FAR_APART: f64 = 4.0;

/// While the ratio of the tried amount to the first amount is below this number, the search takes small steps. From this ratio on, each step
/// multiplies the amount by this number.
///
/// If smaller, large steps begin nearer to the first amount, and may step over an interval of sufficient amounts. If larger, a search without a
/// sufficient amount takes longer.
pub(super) const FAR_FROM_START: f64 = (1u32 << NEAR_DOUBLINGS) as f64;

/// The small steps of the search end after this many doublings, at [`FAR_FROM_START`].
pub(super) const NEAR_DOUBLINGS: u32 = 4;

/// An answer states how many amounts were tried. Tried amounts that are nearer to each other than this relative distance count as one amount in this
/// number.
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

/// The relative width at which the bracket of the sought amount is narrow enough in space. In space verdicts come from load paths, which have step
/// errors.
///
/// If narrower, load paths begin so close to a fold (where equilibria vanish) that they take hundreds of short steps. If wider, the width shows in
/// the answer.
pub(super) const EXACT_IN_SPACE: WidthSchedule = &[(0, 1e-9)];

/// The relative widths at which the bracket of an additional amount in the answer is narrow enough, as a schedule of steps and widths. With the
/// amount `sticks` nothing slides; `safe` is the safe amount. If narrower, an answer needs many more trials.
pub(super) const SECOND: WidthSchedule = &[(0, 2e-12), (5, 1e-8)];

/// Beside the bound there may be further changes between sufficient and insufficient amounts. These are the relative widths at which a bracket of
/// such a change is narrow enough, as a schedule of steps and widths. An answer may have eight such brackets, so narrower ones would cost most of the
/// trials.
pub(super) const BESIDE_A_BOUND: WidthSchedule = &[(0, 1e-10), (16, 1e-8), (20, 1e-4)];

/// No amount is tried that is more than this number of times larger or smaller than the first amount of the search.
///
/// If the load is sought, load paths are followed up to this multiple. With a larger number a search without a sufficient amount takes longer.
pub(super) const MOST_LOADS: f64 = (1u32 << 20) as f64;

/// Relative distance from an end of a bracket up to which a predicted bound may lie outside the bracket.
///
/// If smaller, rounding drops a prediction that is right. If larger, a wrong prediction costs more trials.
pub(super) const NEAR_A_PREDICTION: f64 = 1e-9;

/// Between two neighbouring amounts with different paths to their verdicts, a further amount is tried only if their ratio exceeds this number.
///
/// If smaller, the search spends verdicts on intervals too narrow to matter. If larger, it misses more intervals in which the verdict differs.
pub(super) const BETWEEN_STATES: f64 = 1.05;

/// Between two neighbouring amounts with different paths to their verdicts, a further amount is tried only from this slope on. The slope is the
/// logarithm of their ratio, at most of 2, times the sum of their inverse margins. Margins are distances from another verdict, from 0 to 1.
///
/// If smaller, verdicts are spent on pairs between which the verdict hardly ever differs. If larger, more intervals with another verdict are missed.
pub(super) const STEEP: f64 = 0.6;

/// After a scan, two margins are extrapolated linearly from neighbouring sufficient amounts. One is the carried part of the load less 1. The other is
/// the distance to the limit of small motions, or of sticking at rest. If a margin is predicted to be zero at an amount x before the next sufficient
/// amount, an amount beyond x is tried. The tried amount lies at this fraction of the way from x to that next amount.
///
/// If smaller, rounding or a curved margin may hide insufficient amounts beyond x. If larger, a narrow interval of insufficient amounts is stepped
/// over.
pub(super) const BEYOND_A_MARGIN: f64 = 0.1;

/// Upper limit of the number of amounts that are tried after a scan, between its amounts. They are tried where a margin is predicted to be zero (see
/// [`BEYOND_A_MARGIN`]), and between neighbouring amounts with different paths to their verdicts.
///
/// With fewer, intervals in which the verdict differs are missed. Each amount costs a verdict.
pub(super) const BETWEEN: usize = 6;

/// Upper limit of the number of amounts that are tried after a scan because a margin is predicted to be zero (see [`BEYOND_A_MARGIN`]), or because
/// the whole load might be carried. They are among the at most [`BETWEEN`] amounts that are tried between the amounts of the scan.
///
/// A margin that falls less and less steeply becomes zero beyond the amount that its first extrapolation predicts. With the limit 1 no second
/// extrapolation is made, and insufficient amounts beyond this zero are missed. With a limit above 2 too few amounts are left to try between
/// different contact states at rest.
pub(super) const WHERE_MARGINS_VANISH: usize = 2;

/// The first amount of the search may be easier than the bound, such as more squeeze or less load. If it is easier by more than this ratio, still
/// easier amounts are tried, too: the scan around the bound does not extend that far.
///
/// If smaller, answers take more verdicts. If larger, the far end of the sufficient amounts is missed if it lies just beyond the first amount.
pub(super) const FAR_BEHIND: f64 = 4.0;

/// Number of tried amounts that are easier than the first amount of the search (such as more squeeze or less load). They are tried if the first
/// amount is easier than the bound by more than the ratio [`FAR_BEHIND`]. The easiest of them has the ratio 4 to the first amount.
///
/// With fewer, more intervals of insufficient amounts are missed. Each amount costs a verdict.
pub(super) const NEAR_THE_START: usize = 3;

/// If a greatest amount is sought, amounts far below the bound are tried, too. They are the bound, or the first amount of the search if that is
/// smaller, divided by these numbers. For example, a force beside the fingers may turn the object out with an arm that is far shorter than the grasp.
///
/// Without these amounts the search misses that very short arms are insufficient. Each costs a verdict.
pub(super) const TOWARDS_ZERO: [f64; 3] = [16.0, 256.0, 65536.0];

/// An interval of sufficient amounts is narrow if its ends differ by less than this fraction. If there is a wider interval, the bound in the answer
/// is an end of a wider one.
///
/// If smaller, the answer may be an amount whose neighbours on both sides are insufficient. If larger, the search passes over an interval that is
/// wide enough for a user to set an amount in it.
pub(super) const NARROW: f64 = 0.01;

/// The bound of the safe amounts may be easier than the first amount of the search, such as more squeeze or less load. A scan around this bound is
/// made if it is easier by more than this ratio.
///
/// If smaller, most safe amounts take the trials of a scan. If larger, an interval of sufficient amounts that the search stepped over stays unseen.
pub(super) const STEPPED_OVER: f64 = 1.25;

/// In a search for friction this coefficient is tried, too, if it is larger than the least sufficient one: a wedge may fail with more friction. Few
/// surfaces have more friction.
///
/// If smaller, a wedge is said to hold although it fails with the real friction, which may be larger than that of the scene. If larger, the search
/// more easily steps over an interval of insufficient amounts between the scene's coefficient and this one.
pub(super) const USUAL_FRICTION: f64 = 1.0;

/// The answer gives the fraction of the springs' resistance that forces take away as they turn with the parts they act on. It is computed not at the
/// bound, but for a sufficient amount whose ratio to the bound is this number (its inverse if the least amount is sought).
///
/// If nearer to 1, contacts that open at the bound may count as open because of rounding. If smaller, the computed fraction is too small.
pub(super) const WITHIN_THE_BOUND: f64 = 0.99;
