//! A sufficient amount beside an insufficient one, and how the bracket between them is narrowed.

use super::search::{Tries, decided};
use super::tolerances::{BESIDE_A_BOUND, FAR_APART, LAST_DIGITS};
use super::trial::Trial;
use crate::error::Error;
use crate::prelude::*;

/// Pairs (steps, width): after that many steps a bracket of at most this width, relative to the larger amount, ends the search. Widths grow with the
/// steps, since rounding or a jump of the carried part can keep the two amounts apart.
pub(super) type Enough = &'static [(usize, f64)];

/// A bracket of the bound: a sufficient amount, and an insufficient one beside it with its trial.
#[derive(Debug)]
pub(super) struct Threshold {
    pub(super) does: f64,
    pub(super) does_not: (f64, Trial),
    /// An amount between both whose trial is undecided, and why.
    pub(super) unknown: Option<(f64, String)>,
}

impl Threshold {
    /// This bracket narrowed to [`BESIDE_A_BOUND`].
    pub(super) fn beside(self, tries: Tries<'_>, carried: Option<f64>) -> Result<Self, Error> {
        self.narrowed(tries, carried, BESIDE_A_BOUND)
    }

    /// This bracket narrowed by secants of the carried part minus 1, and by halving where that is unknown or jumps. `carried` belongs to the
    /// sufficient amount.
    pub(super) fn narrowed(
        mut self,
        tries: Tries<'_>,
        carried: Option<f64>,
        enough: Enough,
    ) -> Result<Self, Error> {
        let short = |trial: &Trial| trial.carried().map(|carried| carried - 1.0).filter(|x| x.is_finite());
        let mut over = carried.map(|carried| carried - 1.0).filter(|x| x.is_finite());
        let mut under = short(&self.does_not.1);
        // The end that the last step moved, the least distance of the next trial from both ends relative to the amount, and the last three widths.
        let (mut kept, mut push, mut widths) = (None, 0.5 * LAST_DIGITS, [f64::INFINITY; 3]);
        // `over` and `under` may be halved below; the last true values measure the fall of the carried part.
        let falls =
            |does: Option<f64>, does_not: Option<f64>| does.zip(does_not).map(|(over, under)| over - under);
        let (mut last_over, mut last_under) = (over, under);
        let (at_first, fall_at_first) = ((self.does_not.0 - self.does).abs(), falls(over, under));
        // Halving a ratio of 4 down to [`EXACT`] takes 40 steps; those past 120 only follow rounding.
        for step in 0..120 {
            let (from, to) = (self.does, self.does_not.0);
            let width = (to - from).abs();
            let close =
                enough.iter().rev().find(|(steps, _)| *steps <= step).map_or(0.0, |(_, close)| *close);
            if width <= close * from.abs().max(to.abs()) {
                break;
            }
            let is_slow = width > 0.125 * widths[step % 3];
            widths[step % 3] = width;
            let secant =
                over.zip(under).filter(|(over, under)| *over >= 0.0 && *under <= 0.0 && over > under);
            let fall = falls(last_over, last_under).zip(fall_at_first);
            // A linear part falls by 1/16 where the bracket is 1/16 as wide as the first. A quarter is a jump
            // at the bound, where only halving helps.
            let jumps = width <= 1.0 / 16.0 * at_first && fall.is_some_and(|(now, first)| now > 0.25 * first);
            let at = match secant {
                Some((over, under)) if !(jumps || step >= 3 && is_slow && kept.is_none()) => {
                    let least = (push * from.abs().max(to.abs()) / width).min(0.5);
                    from + (to - from) * (over / (over - under)).clamp(least, 1.0 - least)
                }
                _ => middle(from, to),
            };
            if at == from || at == to {
                break;
            }
            let (at, now) = decided(tries, at, Some(width))?;
            // Illinois: where the same end moves twice, the value at the other counts half, and the next trial keeps farther from both ends.
            let is_over = now.does();
            let again = kept == Some(is_over);
            push = if again { 16.0 * push } else { 0.5 * LAST_DIGITS };
            kept = if step % 4 == 3 && is_slow { None } else { Some(is_over) };
            match now {
                Trial::Does { .. } => {
                    over = short(&now);
                    last_over = over;
                    under = under.map(|under| if again { 0.5 * under } else { under });
                    self.does = at;
                }
                Trial::DoesNot { .. } => {
                    under = short(&now);
                    last_under = under;
                    over = over.map(|over| if again { 0.5 * over } else { over });
                    self.does_not = (at, now);
                }
                Trial::Unknown(why) => {
                    self.unknown = Some((at, why));
                    break;
                }
            }
        }
        Ok(self)
    }
}

/// The mean of two amounts, geometric where their ratio exceeds [`FAR_APART`].
fn middle(from: f64, to: f64) -> f64 {
    let is_far = from > 0.0 && to > 0.0 && (from / to).max(to / from) > FAR_APART;
    if is_far { (from * to).sqrt() } else { 0.5 * (from + to) }
}
