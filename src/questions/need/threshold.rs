//! The bracket of the least or greatest sufficient amount (the bound): one amount that suffices and one that does not, and how the bracket is
//! narrowed.

use super::search::{Tries, decided};
use super::tolerances::{AT_A_JUMP, BESIDE_A_BOUND, FAR_APART, LAST_DIGITS, NEAR_A_PREDICTION};
use super::trial::Trial;
use crate::error::Error;
use crate::prelude::*;

/// The relative widths at which a bracket is narrow enough, as pairs: a number of steps, and the width that is enough from this step on. Widths grow
/// with the steps, since rounding or a jump of the carried part of the load can keep the two amounts apart.
pub(super) type Enough = &'static [(usize, f64)];

/// A bracket of the bound of the sufficient amounts: an amount that suffices, and a neighbouring one that does not, with the trial of the latter.
#[derive(Debug, Clone)]
pub(super) struct Threshold {
    pub(super) does: f64,
    pub(super) does_not: (f64, Trial),
    /// An amount between `does` and the amount of `does_not` whose trial is undecided, and the reason.
    pub(super) unknown: Option<(f64, String)>,
}

impl Threshold {
    /// This bracket narrowed to the widths [`BESIDE_A_BOUND`].
    pub(super) fn beside(self, tries: Tries<'_>, does: [Option<f64>; 2]) -> Result<Self, Error> {
        self.narrowed(tries, does, BESIDE_A_BOUND)
    }

    /// This bracket narrowed by secants of a [measure](Trial::measures) of the distance to the bound. Where the measure is unknown, jumps, or is at
    /// the level of rounding, the bracket is halved. `does` contains the two measures at the sufficient amount.
    ///
    /// The first measure is the carried part of the load. Where it jumps, the second margin of the trial is used.
    pub(super) fn narrowed(
        mut self,
        tries: Tries<'_>,
        does: [Option<f64>; 2],
        enough: Enough,
    ) -> Result<Self, Error> {
        let mut presumed = self.clone().by(tries, true, (does, enough))?;
        let mut here = tries.at(presumed.does)?;
        // A full trial may find a weaker direction of a force, which later quick trials include. Such directions differ less and less. So an
        // amount that is easier by 1e-6 is tried, too.
        let mut enough = enough;
        for _ in 0..6 {
            if !tries.learns || !matches!(here, Trial::DoesNot { .. }) {
                break;
            }
            (self.does_not, enough) = ((presumed.does, here), WHERE_DIRECTIONS_ARE_FOUND);
            let easier =
                presumed.does + (self.does - presumed.does).signum() * AT_A_JUMP * presumed.does.abs();
            if (easier - presumed.does).abs() >= (self.does - presumed.does).abs() {
                return Ok(self);
            }
            if tries.at(easier)?.does() {
                self.does = easier;
                return Ok(self);
            }
            presumed = self.clone().by(tries, true, (does, enough))?;
            here = tries.at(presumed.does)?;
        }
        let beside = presumed.does_not.0;
        if !here.does() {
            return self.by(tries, false, (does, enough));
        }
        self.does = presumed.does;
        // In space, some amounts are shown to be insufficient only by the enumeration of contact states. This takes the longer, the nearer the amount
        // is to the bound, and right beside the bound it does not end. So the insufficient amount of the answer keeps a distance to the bound there.
        let is_hard = presumed.does_not.1.needs_enumeration();
        let far = self.does_not.0;
        let at_a_distance = |part: f64| beside + (far - beside).signum() * part * beside.abs();
        let distances: &[f64] = if is_hard && !tries.is_planar { &APART_WHERE_HARD } else { &HARDLY_APART };
        let mut presumed_in_vain = None;
        for part in distances {
            let at = at_a_distance(*part);
            if (at - beside).abs() >= (far - beside).abs() {
                break;
            }
            match tries.at(at)? {
                now @ Trial::DoesNot { .. } => {
                    self.does_not = (at, now);
                    break;
                }
                Trial::Unknown(why) => self.unknown = Some((at, why)),
                now @ Trial::Does { .. } => {
                    self.does = at;
                    presumed_in_vain = Some(now.measures());
                }
            }
        }
        if let now @ Trial::DoesNot { .. } = tries.at(self.does_not.0)? {
            self.does_not.1 = now;
        }
        match presumed_in_vain {
            Some(measures) => self.by(tries, false, (measures, enough)),
            None => Ok(self),
        }
    }

    /// Narrows the bracket. If `presumes`, trials are quick and undecided amounts count as insufficient. Otherwise trials are full, and an undecided
    /// trial ends the narrowing.
    fn by(
        mut self,
        tries: Tries<'_>,
        presumes: bool,
        (does, enough): ([Option<f64>; 2], Enough),
    ) -> Result<Self, Error> {
        let mut sides = [Side::of(self.does, does), Side::of(self.does_not.0, self.does_not.1.measures())];
        let is_at_rest = self.does_not.1.carried().is_some_and(|carried| carried <= 0.0);
        let mut which = usize::from(is_at_rest && signs_differ(&sides, 1).is_some());
        // `kept` is the end of the bracket that the last step moved. `push` is the least distance of the next trial from both ends, relative to the
        // amount. `widths` are the last three widths of the bracket, `last_root` the last zero of a secant, `predicted` the last predicted bound. For
        // amounts within rounding of a bound in space, load paths begin where equilibria vanish (a fold) and take a hundred times as long.
        let first_push = if tries.is_planar { 0.5 * LAST_DIGITS } else { 0.25 * enough[0].1 };
        let (mut kept, mut push, mut widths) = (None, first_push, [f64::INFINITY; 3]);
        let (mut last_root, mut predicted) = (None, None);
        let first = |sides: &[Side; 2], which: usize| {
            let fall = signs_differ(sides, which).map(|[over, under]| over - under);
            ((sides[1].at - sides[0].at).abs(), fall)
        };
        let mut at_first = first(&sides, which);
        // Halving a ratio of 4 down to [`EXACT`] takes 40 steps; after the 120th step only rounding would change the bracket.
        for step in 0..120 {
            let (from, to) = (self.does, self.does_not.0);
            let width = (to - from).abs();
            let close =
                enough.iter().rev().find(|(steps, _)| *steps <= step).map_or(0.0, |(_, close)| *close);
            let is_within = |close: f64| width <= close * from.abs().max(to.abs());
            if is_within(close) {
                break;
            }
            let is_slow = width > 0.125 * widths[step % 3];
            widths[step % 3] = width;
            // If the present measure is unknown at one end of the bracket, the other measure is used, provided that it is known at both ends.
            if signs_differ(&sides, which).is_none() && signs_differ(&sides, 1 - which).is_some() {
                which = 1 - which;
                at_first = first(&sides, which);
            }
            // As the bracket shrinks to 1/16 of its width, the difference of a smooth measure between its ends falls to 1/16, too. If more than a
            // quarter is left, the measure jumps at the bound of the sufficient amounts.
            let jumps = |sides: &[Side; 2], which: usize| {
                let now = signs_differ(sides, which).map(|[over, under]| over - under);
                let falls = now.zip(at_first.1).is_some_and(|(now, first)| now > 0.25 * first);
                width <= at_first.0 / 16.0 && falls
            };
            let mut halves = jumps(&sides, which);
            if halves && which == 0 && signs_differ(&sides, 1).is_some() {
                (which, halves) = (1, false);
                at_first = first(&sides, which);
            }
            // Where the measures jump, no secant finds the bound of the sufficient amounts. In space, moreover, load paths are less accurate than
            // rounding about the side of the jump on which an amount lies. So a wider bracket is enough.
            if !tries.is_planar && (halves || signs_differ(&sides, which).is_none()) && is_within(AT_A_JUMP) {
                break;
            }
            if !halves && width <= at_first.0 / 16.0 {
                at_first = first(&sides, which);
            }
            let root = signs_differ(&sides, which).and_then(|[over, under]| {
                let secant = || from + (to - from) * (over / (over - under));
                let is_inside = |root: &f64| (root - from) * (root - to) < 0.0;
                let root = kept.and_then(|side: usize| sides[side].root(which)).filter(is_inside);
                // A secant through measures at the level of rounding is meaningless.
                (over - under >= ROUNDING).then(|| root.unwrap_or_else(secant))
            });
            let mut root = root.filter(|_| !(halves || step >= 3 && is_slow && kept.is_none()));
            // The carried part jumps where no equilibrium at rest exists beyond the bound of the sufficient amounts. The bound is then where a
            // contact at rest changes its state.
            let stalls = step >= 3 && is_slow && step % 2 == 1;
            if root.is_none() && !stalls {
                let is_near = |at: f64, end: f64| (at - end).abs() <= NEAR_A_PREDICTION * end.abs();
                let last = predicted.filter(|at| is_near(*at, from) || is_near(*at, to));
                let next = (tries.rest_ends)(from, to).or(last);
                // `off` is the difference between the last two predictions of the bound, an estimate of their error. The next trial lies this far
                // from the prediction, first on the side of the sufficient amount, then on the other side.
                let off = next.zip(predicted).map_or(0.0, |(next, last): (f64, f64)| (next - last).abs());
                let end = if off > 0.25 * AT_A_JUMP * to.abs() { from } else { to };
                let moved = |at: f64| at + off.min(0.5 * (end - at).abs()).copysign(end - at);
                root = next.map(|at| moved(at).clamp(from.min(to), from.max(to)));
                predicted = next.or(predicted);
            }
            let at = match root {
                Some(root) => {
                    let moves = last_root.map_or(0.0, |last: f64| 1e-2 * (root - last).abs());
                    let least = (push * from.abs().max(to.abs()) / width).min(0.5);
                    // The next trial lies a little beyond the zero of the secant, so that the other end of the bracket moves this time.
                    let beyond = (moves / width).max(least) * if kept == Some(1) { -1.0 } else { 1.0 };
                    let beyond = if kept.is_some() { beyond } else { 0.0 };
                    from + (to - from) * ((root - from) / (to - from) + beyond).clamp(least, 1.0 - least)
                }
                None => middle(from, to),
            };
            last_root = root;
            if at == from || at == to {
                break;
            }
            let (at, now) = if presumes {
                (at, (tries.quick)(at, halves)?)
            } else {
                decided(tries.whole, at, Some(width))?
            };
            // If the same end of the bracket moves twice, the next trial is farther away from both ends.
            let side = usize::from(!now.does());
            push = if kept == Some(side) { 16.0 * push } else { first_push };
            kept = if step % 4 == 3 && is_slow { None } else { Some(side) };
            sides[side].moves_to(at, now.measures());
            match now {
                Trial::Does { .. } => self.does = at,
                Trial::DoesNot { .. } => self.does_not = (at, now),
                Trial::Unknown(_) if presumes => self.does_not = (at, now),
                Trial::Unknown(why) => {
                    self.unknown = Some((at, why));
                    break;
                }
            }
        }
        Ok(self)
    }
}

/// One end of a bracket: the amount and its measures, and the amount and measures before this end moved last.
struct Side {
    at: f64,
    measures: [Option<f64>; 2],
    before: Option<(f64, [Option<f64>; 2])>,
}

impl Side {
    const fn of(at: f64, measures: [Option<f64>; 2]) -> Self {
        Self { at, measures, before: None }
    }

    fn moves_to(&mut self, at: f64, measures: [Option<f64>; 2]) {
        self.before = Some((self.at, self.measures));
        (self.at, self.measures) = (at, measures);
    }

    /// The amount at which a measure would vanish, extrapolated from the last two amounts at this end. On the other side of the bound of the
    /// sufficient amounts the measure may have another slope.
    fn root(&self, which: usize) -> Option<f64> {
        let (before, measures) = self.before?;
        let (now, then) = (self.measures[which]?, measures[which]?);
        let is_nearer = now * then > 0.0 && now.abs() < then.abs();
        is_nearer.then(|| self.at + (self.at - before) * (now / (then - now)))
    }
}

/// A measure at both ends of the bracket, the sufficient end first; `None` unless its sign differs by more than rounding.
fn signs_differ(sides: &[Side; 2], which: usize) -> Option<[f64; 2]> {
    let (over, under) = (sides[0].measures[which]?, sides[1].measures[which]?);
    let (over, under) = (if over > -ROUNDING { over.max(0.0) } else { over }, under);
    (over >= 0.0 && under <= 0.0 && over > under).then_some([over, under])
}

/// Relative distances from the bound at which full trials are made where quick trials leave amounts beside the bound undecided. The next distance is
/// used if the trial at the one before is undecided.
///
/// If smaller, the enumeration of contact states takes longer, or is undecided. If larger, the insufficient amount of the answer is farther from the
/// bound than necessary.
const APART_WHERE_HARD: [f64; 3] = [1e-5, 1e-3, 1e-1];

/// The width at which a bracket is narrow enough while weaker directions of a force are found. If narrower, trials are spent on directions that do not
/// decide; if wider, the width shows in the answer.
const WHERE_DIRECTIONS_ARE_FOUND: Enough = &[(0, AT_A_JUMP)];

/// Relative distances from the bound of the sufficient amounts for full trials in the plane, and in space if quick trials are decided beside the
/// bound.
const HARDLY_APART: [f64; 6] = [0.0, 1e-9, 1e-7, 1e-5, 1e-3, 1e-1];

/// Differences of a measure between two amounts below this are due to rounding.
const ROUNDING: f64 = 1e-11;

/// The mean of two amounts, geometric where their ratio exceeds [`FAR_APART`].
fn middle(from: f64, to: f64) -> f64 {
    let is_far = from > 0.0 && to > 0.0 && (from / to).max(to / from) > FAR_APART;
    if is_far { (from * to).sqrt() } else { 0.5 * (from + to) }
}
