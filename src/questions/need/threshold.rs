//! The bracket of the bound, and how it is narrowed. An amount (of squeeze, friction, load, arm or angle) is sufficient if the grasp meets the demand
//! with it; the bound is the least or greatest sufficient amount. A bracket consists of one sufficient and one insufficient amount. The carried part
//! of the load is the load factor up to which the demand is met with an amount. At rest means under the loads that act before the loads of the
//! question. A trial finds out whether one amount is sufficient. It also computes two measures, numbers that are zero at the bound unless they jump
//! at the bound. The first measure is the carried part less 1. The second measure (second margin) is 1 less the largest ratio of a motion to its
//! limit of small motions; if nothing may slide, it is the margin of sticking at rest. Full trials enumerate contact states in the search for
//! equilibria, quick trials do not.

use super::search::{TrialFunctions, decided};
use super::tolerances::{AT_A_JUMP, BESIDE_A_BOUND, FAR_APART, LAST_DIGITS, NEAR_A_PREDICTION};
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::Each;
use crate::prelude::*;

/// The relative widths at which a bracket is narrow enough, as pairs: a number of steps, and the width that is enough from this step on. Widths grow
/// with the number of steps, because rounding or a jump of the carried part of the load can keep the two amounts of the bracket apart.
pub(super) type WidthSchedule = &'static [(usize, f64)];

/// A bracket of the bound of the sufficient amounts: a sufficient amount, and a neighbouring insufficient one with its trial.
#[derive(Debug, Clone)]
pub(super) struct Threshold {
    pub(super) sufficient: f64,
    pub(super) insufficient: (f64, Trial),
    /// An amount between the sufficient and the insufficient one whose trial is undecided, and the reason.
    pub(super) unknown: Option<(f64, String)>,
}

impl Threshold {
    /// This bracket narrowed to the relative widths [`BESIDE_A_BOUND`]: 1e-10 at first, and 1e-4 from step 20 on. The bracket belongs to a change
    /// between sufficient and insufficient amounts that is not the bound, so fewer digits are enough.
    pub(super) fn beside(
        self,
        tries: TrialFunctions<'_>,
        sufficient: [Option<f64>; 2],
    ) -> Result<Self, Error> {
        // A scan is repeated once it finds another change. In space a bracket as narrow as after a jump is then left as it is: nearer to a fold,
        // load paths take a thousand times as long.
        let width = (self.insufficient.0 - self.sufficient).abs();
        if !tries.is_planar && width <= AT_A_JUMP * self.sufficient {
            return Ok(self);
        }
        self.narrowed(tries, sufficient, BESIDE_A_BOUND)
    }

    /// This bracket narrowed by secants of a [measure](Trial::measures), a number that vanishes at the bound. If the measure is unknown, jumps, or
    /// changes across the bracket by rounding alone, the bracket is halved. The argument `sufficient` has the two measures at the sufficient amount
    /// of the bracket.
    ///
    /// The first measure is the carried part of the load less 1. If it jumps at the bound, the second margin of the trial is used.
    pub(super) fn narrowed(
        mut self,
        tries: TrialFunctions<'_>,
        sufficient: [Option<f64>; 2],
        enough: WidthSchedule,
    ) -> Result<Self, Error> {
        let mut presumed = self.clone().by(tries, true, (sufficient, enough))?;
        let mut here = tries.at(presumed.sufficient)?;
        // The bracket `presumed` was found with quick trials. With a force of any direction, a full trial may find a direction in which the
        // sufficient amount of `presumed` is insufficient. Later quick trials include this direction, and each further direction changes the bound
        // less. Therefore the amount `easier` is tried, too. It is nearer to the sufficient amount of the bracket `self` by the fraction
        // [`AT_A_JUMP`] (1e-6). If `easier` is sufficient, it is the answer.
        let mut enough = enough;
        for _ in 0..6 {
            if !tries.learns || !matches!(here, Trial::Insufficient { .. }) {
                break;
            }
            (self.insufficient, enough) = ((presumed.sufficient, here), WHERE_DIRECTIONS_ARE_FOUND);
            let easier = presumed.sufficient
                + (self.sufficient - presumed.sufficient).signum() * AT_A_JUMP * presumed.sufficient.abs();
            if (easier - presumed.sufficient).abs() >= (self.sufficient - presumed.sufficient).abs() {
                return Ok(self);
            }
            if tries.at(easier)?.is_sufficient() {
                self.sufficient = easier;
                return Ok(self);
            }
            presumed = self.clone().by(tries, true, (sufficient, enough))?;
            here = tries.at(presumed.sufficient)?;
        }
        let beside = presumed.insufficient.0;
        if !here.is_sufficient() {
            return self.by(tries, false, (sufficient, enough));
        }
        self.sufficient = presumed.sufficient;
        // In space, some amounts are shown to be insufficient only by the enumeration of contact states. The enumeration takes the longer, the nearer
        // the amount is to the bound, and right at the bound it does not end. Therefore the insufficient amount of the answer keeps a distance to the
        // bound.
        let is_hard = presumed.insufficient.1.needs_enumeration();
        let far = self.insufficient.0;
        let at_a_distance = |part: f64| beside + (far - beside).signum() * part * beside.abs();
        let distances: &[f64] = if is_hard && !tries.is_planar { &APART_WHERE_HARD } else { &HARDLY_APART };
        let mut presumed_in_vain = None;
        for part in distances {
            let at = at_a_distance(*part);
            if (at - beside).abs() >= (far - beside).abs() {
                break;
            }
            match tries.at(at)? {
                now @ Trial::Insufficient { .. } => {
                    self.insufficient = (at, now);
                    break;
                }
                Trial::Unknown(why) => self.unknown = Some((at, why)),
                now @ Trial::Sufficient { .. } => {
                    self.sufficient = at;
                    presumed_in_vain = Some(now.measures());
                }
            }
        }
        if let now @ Trial::Insufficient { .. } = tries.at(self.insufficient.0)? {
            self.insufficient.1 = now;
        }
        match presumed_in_vain {
            Some(_) if is_hard => self.beyond(presumed.sufficient, tries, enough),
            Some(measures) => self.by(tries, false, (measures, enough)),
            None => Ok(self),
        }
    }

    /// Narrows the bracket. If `presumes`, trials are quick (without the enumeration of contact states), and undecided amounts are taken as
    /// insufficient. Otherwise trials are full, and an undecided trial ends the narrowing.
    pub(super) fn by(
        self,
        tries: TrialFunctions<'_>,
        presumes: bool,
        (sufficient, enough): ([Option<f64>; 2], WidthSchedule),
    ) -> Result<Self, Error> {
        let mut bracket = Narrowing::of(self, tries.is_planar, sufficient, enough);
        // Halving a bracket of two amounts with the ratio 4, down to the relative width 1e-12, takes 40 steps. More than 120 steps would only follow
        // rounding.
        for step in 0..120 {
            let close =
                enough.iter().rev().find(|(steps, _)| *steps <= step).map_or(0.0, |(_, close)| *close);
            if bracket.is_within(close) {
                break;
            }
            let is_slow = bracket.is_slow(step);
            let halves = bracket.choose_measure();
            // If the measure in use jumps at the bound, or has no known zero in the bracket, no secant guides the search. In space, moreover, load
            // paths have step errors larger than rounding, so verdicts on amounts very close to the jump may be wrong. Therefore the relative width
            // [`AT_A_JUMP`] (1e-6) is accepted.
            let is_blind = halves || bracket.fall().is_none();
            if !tries.is_planar && is_blind && bracket.is_within(AT_A_JUMP) {
                break;
            }
            let at = bracket.next(&tries, (step, is_slow, halves));
            if at == bracket.edge.sufficient || at == bracket.edge.insufficient.0 {
                break;
            }
            // If the second measure guides the next trial, or the carried part at the insufficient end is unknown, load paths end at the whole load
            // (`short`). Otherwise they are followed up to the load factor at which equilibrium is lost. This load factor is the carried part, which
            // the first measure needs.
            let is_guided = bracket.which == 1 && bracket.fall().is_some();
            let short = is_guided || bracket.edge.insufficient.1.carried().is_none();
            let (at, now) = if presumes {
                (at, (tries.quick)(at, short)?)
            } else {
                decided(tries.whole, at, Some(bracket.width()))?
            };
            bracket.moved_by(at, &now, step % 4 == 3 && is_slow);
            match now {
                Trial::Sufficient { .. } => bracket.edge.sufficient = at,
                Trial::Unknown(why) if !presumes => {
                    bracket.edge.unknown = Some((at, why));
                    break;
                }
                now => bracket.edge.insufficient = (at, now),
            }
        }
        Ok(bracket.edge)
    }
}

/// A bracket that is being narrowed, and the data from which the next amount to try is determined.
struct Narrowing {
    edge: Threshold,
    sides: [BracketEnd; 2],
    /// Index of the measure in use: 0 for the carried part of the load less 1, 1 for the second margin of the trial ([`Trial::measures`]).
    which: usize,
    /// The width of the bracket, and the change of the measure in use across the bracket, when this measure was chosen or last found to be smooth.
    /// Later values are compared with them to find out whether the measure jumps at the bound.
    at_first: (f64, Option<f64>),
    /// The end of the bracket that the last step moved: 0 for the sufficient end, 1 for the insufficient end. `None` before the first step, and after
    /// every fourth step if the search is slow.
    kept: Option<usize>,
    /// Every trial keeps at least a distance from both ends of the bracket. The first entry is this distance, as a fraction of the larger amount. It
    /// grows while steps move the same end; once a step moves the other end, it is reset to the second entry.
    push: [f64; 2],
    /// The widths of the bracket after the last three steps.
    widths: [f64; 3],
    last_root: Option<f64>,
    /// The bound that was last predicted from the margins of contacts at rest.
    predicted: Option<f64>,
}

impl Narrowing {
    fn of(edge: Threshold, is_planar: bool, sufficient: [Option<f64>; 2], enough: WidthSchedule) -> Self {
        let sides = [
            BracketEnd::of(edge.sufficient, sufficient),
            BracketEnd::of(edge.insufficient.0, edge.insufficient.1.measures()),
        ];
        let is_at_rest = edge.insufficient.1.carried().is_some_and(|carried| carried <= 0.0);
        let which = usize::from(is_at_rest && signs_differ(&sides, 1).is_some());
        // In space a load path that begins right at the bound begins at a fold, where equilibria vanish, and takes a hundred times as long. Therefore
        // trials keep a larger distance from the ends of the bracket.
        let push = [if is_planar { 0.5 * LAST_DIGITS } else { 0.25 * enough[0].1 }; 2];
        let (widths, at_first) = ([f64::INFINITY; 3], (0.0, None));
        let mut new =
            Self { edge, sides, which, at_first, kept: None, push, widths, last_root: None, predicted: None };
        new.watch(which);
        new
    }

    fn width(&self) -> f64 {
        (self.edge.insufficient.0 - self.edge.sufficient).abs()
    }

    /// Whether the width of the bracket is at most the fraction `close` of its larger amount.
    fn is_within(&self, close: f64) -> bool {
        self.width() <= close * self.largest()
    }

    fn largest(&self) -> f64 {
        self.edge.sufficient.abs().max(self.edge.insufficient.0.abs())
    }

    /// Whether the width of the bracket is still more than an eighth of its width three steps before.
    fn is_slow(&mut self, step: usize) -> bool {
        let width = self.width();
        width > 0.125 * core::mem::replace(&mut self.widths[step % 3], width)
    }

    /// The decrease of the measure in use (a number that vanishes at the bound) from the sufficient to the insufficient end of the bracket. `None`
    /// unless its signs at the two ends differ.
    fn fall(&self) -> Option<f64> {
        signs_differ(&self.sides, self.which).map(|[over, under]| over - under)
    }

    /// Uses the measure with the index `which` (0: carried part of the load less 1; 1: second margin). The measure is watched for a jump from the
    /// present width of the bracket on.
    fn watch(&mut self, which: usize) {
        self.which = which;
        self.at_first = (self.width(), self.fall());
    }

    /// Chooses the measure (carried part of the load less 1, or second margin) that guides the next trial. Returns whether it jumps at the bound, so
    /// that the bracket has to be halved.
    fn choose_measure(&mut self) -> bool {
        let is_known = |sides: &[BracketEnd; 2], which: usize| signs_differ(sides, which).is_some();
        // If the present measure has no known zero in the bracket, the other measure is used, provided that it has one.
        if !is_known(&self.sides, self.which) && is_known(&self.sides, 1 - self.which) {
            self.watch(1 - self.which);
        }
        // If the object moves too far already at rest, the carried part of the load is zero or negative, whatever the distance from the bound. The
        // other measure then guides the search.
        let rests_too_far = matches!(self.edge.insufficient.1, Trial::Insufficient { is_too_far: true, carried, .. } if carried <= 0.0);
        if rests_too_far && self.which == 0 && is_known(&self.sides, 1) {
            self.watch(1);
        }
        if self.width() > self.at_first.0 / 16.0 {
            return false;
        }
        // As the bracket shrinks to 1/16 of its width, the change of a smooth measure across the bracket decreases to 1/16, too. If more than a
        // quarter of the change is left, the measure jumps at the bound.
        let jumps = self.fall().zip(self.at_first.1).is_some_and(|(now, first)| now > 0.25 * first);
        let has_other = self.which == 0 && is_known(&self.sides, 1);
        if !jumps || has_other {
            self.watch(if jumps { 1 } else { self.which });
        }
        jumps && !has_other
    }

    /// The next amount to try. It lies next to the amount at which the measure in use (a number that vanishes at the bound) is predicted to vanish.
    /// Without such a prediction it is near the amount at which contacts at rest are predicted to leave their states. Without either prediction it is
    /// the middle of the bracket.
    fn next(&mut self, tries: &TrialFunctions<'_>, (step, is_slow, halves): (usize, bool, bool)) -> f64 {
        let (from, to, width) = (self.edge.sufficient, self.edge.insufficient.0, self.width());
        let is_used = !(halves || step >= 3 && is_slow && self.kept.is_none());
        let mut root = self.root().filter(|_| is_used);
        // If the carried part jumps because no equilibrium at rest exists beyond the bound, contacts at rest leave their states at the bound. The
        // amount at which they are predicted to do so is then tried. In every second step of a slow search the bracket is halved instead.
        let stalls = step >= 3 && is_slow && step % 2 == 1;
        if root.is_none() && !stalls {
            root = self.where_rest_ends(tries);
        }
        let last = core::mem::replace(&mut self.last_root, root);
        let Some(root) = root else { return middle(from, to) };
        let moves = last.map_or(0.0, |last: f64| 1e-2 * (root - last).abs());
        let least = (self.push[0] * self.largest() / width).min(0.5);
        // The next trial lies beyond the root, seen from the end that moved last, so that it probably moves the other end. Its distance from the root
        // is 1 % of the last change of the root, but at least the distance `push` that every trial keeps from the ends.
        let beyond = (moves / width).max(least) * if self.kept == Some(1) { -1.0 } else { 1.0 };
        let beyond = if self.kept.is_some() { beyond } else { 0.0 };
        from + (to - from) * ((root - from) / (to - from) + beyond).clamp(least, 1.0 - least)
    }

    /// The amount at which the measure in use (a number that vanishes at the bound) is predicted to vanish: extrapolated from the end that the last
    /// step moved, or else by a secant.
    fn root(&self) -> Option<f64> {
        let [over, under] = signs_differ(&self.sides, self.which)?;
        let (from, to) = (self.edge.sufficient, self.edge.insufficient.0);
        let secant = || from + (to - from) * (over / (over - under));
        let is_inside = |root: &f64| (root - from) * (root - to) < 0.0;
        let root = self.kept.and_then(|side| self.sides[side].root(self.which)).filter(is_inside);
        // If the measures at the two ends differ by rounding alone, a secant through them has no meaning.
        (over - under >= ROUNDING).then(|| root.unwrap_or_else(secant))
    }

    /// The amount at which contacts at rest are predicted to leave their states. The prediction is moved towards an end of the bracket by its own
    /// estimated error.
    fn where_rest_ends(&mut self, tries: &TrialFunctions<'_>) -> Option<f64> {
        let (from, to) = (self.edge.sufficient, self.edge.insufficient.0);
        let is_near = |at: f64, end: f64| (at - end).abs() <= NEAR_A_PREDICTION * end.abs();
        let last = self.predicted.filter(|at| is_near(*at, from) || is_near(*at, to));
        let new = (tries.rest_ends)(from, to);
        let next = new.or(last);
        // The difference `off` of this prediction from the previous prediction exceeds the error of this prediction. The trial is moved away from the
        // prediction by `off`: to the sufficient side while `off` exceeds a quarter of [`AT_A_JUMP`] (1e-6), relative to the amount, afterwards to
        // the insufficient side.
        let off = next.zip(self.predicted).map_or(0.0, |(next, last): (f64, f64)| (next - last).abs());
        let end = if off > 0.25 * AT_A_JUMP * to.abs() { from } else { to };
        let moved = |at: f64| at + off.min(0.5 * (end - at).abs()).copysign(end - at);
        // In the plane margins are linear in the amount, so that predictions are exact: the last prediction is kept while there is no new one. In
        // space the last prediction is used only once more.
        self.predicted = if tries.is_planar { next.or(self.predicted) } else { new };
        next.map(|at| moved(at).clamp(from.min(to), from.max(to)))
    }

    /// Notes the result `trial` of the amount `at`, to which one end of the bracket moves. If the same end moves twice, the next trial keeps a larger
    /// distance from both ends. If `forgets` is true, the end that moved is not remembered.
    fn moved_by(&mut self, at: f64, trial: &Trial, forgets: bool) {
        let side = usize::from(!trial.is_sufficient());
        self.push[0] = if self.kept == Some(side) { 16.0 * self.push[0] } else { self.push[1] };
        self.kept = if forgets { None } else { Some(side) };
        self.sides[side].moves_to(at, trial.measures());
    }
}

/// One end of a bracket: the [measures](Trial::measures) at its amount, and its last amounts with their measures.
struct BracketEnd {
    measures: [Option<f64>; 2],
    /// The last three amounts of this end with their measures, the present one first.
    last: [Option<(f64, [Option<f64>; 2])>; 3],
}

impl BracketEnd {
    const fn of(at: f64, measures: [Option<f64>; 2]) -> Self {
        Self { measures, last: [Some((at, measures)), None, None] }
    }

    fn moves_to(&mut self, at: f64, measures: [Option<f64>; 2]) {
        let [one, other, _] = self.last;
        (self.measures, self.last) = (measures, [Some((at, measures)), one, other]);
    }

    /// The amount at which a measure is predicted to be zero, extrapolated from the last two or three amounts at this end of the bracket. Only one
    /// end is used, because the derivative of the measure may jump at the bound.
    fn root(&self, which: usize) -> Option<f64> {
        let points = self.last.each(|point| point.and_then(|(at, measures)| Some((at, measures[which]?))));
        where_it_vanishes(points)
    }
}

/// The amount at which a margin vanishes, extrapolated from two or three amounts, each with its margin, the nearest amount first. `None` unless the
/// margin decreases towards zero.
///
/// The amount is a linear or quadratic function of the margin. Near a fold, where an equilibrium ends, the margin changes like a square root of the
/// distance. The amount, as a function of the margin, then has its extreme value at the fold, before the margin vanishes; this amount is returned.
pub(super) fn where_it_vanishes(points: [Option<(f64, f64)>; 3]) -> Option<f64> {
    let [(x0, m0), (x1, m1)] = [points[0]?, points[1]?];
    let falls = |now: f64, then: f64| now * then > 0.0 && now.abs() < then.abs();
    if !falls(m0, m1) {
        return None;
    }
    let slope = (x1 - x0) / (m1 - m0);
    let Some((x2, m2)) = points[2].filter(|(_, m2)| falls(m1, *m2)) else { return Some(x0 - slope * m0) };
    let bend = ((x2 - x1) / (m2 - m1) - slope) / (m2 - m0);
    let fold = 0.5 * (m0 + m1 - slope / bend);
    let end = if falls(fold, m0) { fold } else { 0.0 };
    Some(x0 + (end - m0) * (slope + bend * (end - m1)))
}

/// The measure of index `which` at both ends of the bracket, the sufficient end first. `None` unless the measure is at least zero at the sufficient
/// end and at most zero at the insufficient end, and not zero at both ends. At the sufficient end a negative value within rounding counts as zero.
fn signs_differ(sides: &[BracketEnd; 2], which: usize) -> Option<[f64; 2]> {
    let (over, under) = (sides[0].measures[which]?, sides[1].measures[which]?);
    let (over, under) = (if over > -ROUNDING { over.max(0.0) } else { over }, under);
    (over >= 0.0 && under <= 0.0 && over > under).then_some([over, under])
}

/// Relative distances from the bound at which full trials are made in space, if quick trials leave amounts next to the bound undecided. The distances
/// are used in turn until a trial shows an insufficient amount.
///
/// With smaller distances the enumeration of contact states takes longer, or is undecided. With larger ones the insufficient amount of the answer is
/// farther from the bound than necessary.
const APART_WHERE_HARD: [f64; 3] = [1e-4, 1e-3, 1e-1];

/// The width at which a bracket is narrow enough while full trials still find weaker directions of a force (directions in which less of the force is
/// carried). If narrower, trials are spent on directions that do not change the answer; if wider, the width shows in the answer.
const WHERE_DIRECTIONS_ARE_FOUND: WidthSchedule = &[(0, AT_A_JUMP)];

/// Relative distances from the bound at which full trials are made in the plane, and in space if quick trials next to the bound are decided. The
/// distances are used in turn until a trial shows an insufficient amount.
///
/// The small distances keep the bracket narrow. The large ones are needed only if full trials find equilibria that quick trials have missed.
const HARDLY_APART: [f64; 6] = [0.0, 1e-9, 1e-7, 1e-5, 1e-3, 1e-1];

/// A difference of a measure between two amounts is taken as rounding if it is smaller than this number. With a smaller number secants follow
/// rounding errors; with a larger one the bracket is halved although a secant would still gain digits.
const ROUNDING: f64 = 1e-11;

/// The mean of two amounts. If their ratio exceeds [`FAR_APART`], 4, it is the geometric mean, since arithmetic means approach the smaller amount
/// slowly.
fn middle(from: f64, to: f64) -> f64 {
    let is_far = from > 0.0 && to > 0.0 && (from / to).max(to / from) > FAR_APART;
    if is_far { (from * to).sqrt() } else { 0.5 * (from + to) }
}

#[cfg(test)]
mod tests {
    use super::where_it_vanishes;

    #[test]
    fn where_margins_vanish_or_turn_back() {
        let line = |m: f64| Some((2.0 + 3.0 * m, m));
        assert_eq!(where_it_vanishes([line(0.5), line(1.0), None]), Some(2.0));
        assert_eq!(where_it_vanishes([line(1.0), line(0.5), None]), None);
        // The margin 0.5 + √(x - 1) ends at a fold, at x = 1.
        let fold = |m: f64| Some((1.0 + (m - 0.5) * (m - 0.5), m));
        let end = where_it_vanishes([fold(0.6), fold(0.8), fold(1.1)]).expect("the margin falls");
        assert!((end - 1.0).abs() < 1e-12, "{end}");
    }
}
