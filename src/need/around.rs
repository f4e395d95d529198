//! What lies around a bound: whether amounts beyond it do throughout, and whether others do.

use super::answer::AmountWindow;
use super::search::{Threshold, Tries};
use super::trial::Trial;
use crate::error::Error;
use crate::prelude::*;

/// Amounts are looked at so many times below and above the bound.
const SCANNED: f64 = 4.0;
/// A squeeze is looked at in doublings beyond, to 4000 times the bound and to as small a part of it: drives reach their limits far from there, too.
const DOUBLINGS_BEYOND: i32 = 10;
/// So many changes of verdict are told by their amounts.
const MOST_CHANGES: usize = 8;

/// What lies around a bound.
#[derive(Debug)]
pub(super) struct Around {
    /// How often the verdict changes, the bound included.
    pub(super) changes: usize,
    /// Where the amounts from the bound on do no longer.
    pub(super) until: Option<Threshold>,
    /// Amounts apart from them that do.
    pub(super) elsewhere: Vec<AmountWindow>,
}

impl Around {
    /// Looks at so many amounts on both sides of a bound, and `far` beyond.
    pub(super) fn of(
        bound: &Threshold,
        scan: usize,
        is_least: bool,
        far: bool,
        tries: Tries<'_>,
    ) -> Result<Self, Error> {
        let mut around = Self { changes: 1, until: None, elsewhere: Vec::new() };
        let half = scan / 2;
        for (up, count) in [(false, half), (true, scan - half)] {
            let is_beyond = up == is_least;
            let fine = (1..=count).map(|k| SCANNED.powf(k as f64 / count as f64));
            let coarse = (1..=DOUBLINGS_BEYOND).map(|k| SCANNED * 2.0_f64.powi(k));
            let parts = fine.chain(coarse.filter(|_| far && count > 0));
            let amounts = parts.map(|part| if up { bound.does * part } else { bound.does / part });
            let from = if is_beyond {
                (bound.does, Trial::Does)
            } else {
                (bound.does_not.0, bound.does_not.1.clone())
            };
            around.side(from, up, is_beyond, amounts, tries)?;
        }
        around.elsewhere.sort_by(|one, other| low(one).total_cmp(&low(other)));
        Ok(around)
    }

    /// Goes from the bound to one side.
    fn side(
        &mut self,
        from: (f64, Trial),
        up: bool,
        mut is_bounds_own: bool,
        amounts: impl Iterator<Item = f64>,
        tries: Tries<'_>,
    ) -> Result<(), Error> {
        let (mut at, mut trial) = from;
        let mut window = None;
        for amount in amounts {
            let now = tries(amount)?;
            let (did, does) = (trial == Trial::Does, now == Trial::Does);
            if did != does {
                self.changes += 1;
                if self.changes <= MOST_CHANGES {
                    let edge = if did {
                        Threshold { does: at, does_not: (amount, now.clone()) }
                    } else {
                        Threshold { does: amount, does_not: (at, trial) }
                    };
                    let edge = edge.halved(tries)?;
                    match (did, is_bounds_own) {
                        (true, true) => (self.until, is_bounds_own) = (Some(edge), false),
                        (true, false) => {
                            self.elsewhere
                                .extend(window.take().map(|near| between(near, Some(edge.does), up)));
                        }
                        (false, _) => window = Some(edge.does),
                    }
                }
            }
            (at, trial) = (amount, now);
        }
        self.elsewhere.extend(window.map(|near| between(near, None, up)));
        Ok(())
    }
}

fn between(near: f64, far: Option<f64>, up: bool) -> AmountWindow {
    if up { AmountWindow { from: Some(near), to: far } } else { AmountWindow { from: far, to: Some(near) } }
}

fn low(window: &AmountWindow) -> f64 {
    window.from.unwrap_or(0.0)
}
