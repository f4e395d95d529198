//! The search for an amount that does, beside one that does not.

use super::trial::Trial;
use crate::error::Error;
use crate::prelude::*;

/// From what is given amounts are doubled or halved so many times at most.
pub(super) const MOST_DOUBLINGS: usize = 20;
/// Amounts this close together are one, relatively.
const CLOSE: f64 = 1e-13;
/// At the bound itself rounding may keep a verdict from being told: what does not is then looked for this far beyond, relatively.
const BLURRED: f64 = 1e-9;
/// Where no doubled amount does, the best of them is refined in so many steps of a golden section.
const MOST_SECTIONS: usize = 40;

/// Tries an amount.
pub(super) type Tries<'t> = &'t dyn Fn(f64) -> Result<Trial, Error>;

/// An amount that does, and one beside it that does not, with what happens then.
#[derive(Debug)]
pub(super) struct Threshold {
    pub(super) does: f64,
    pub(super) does_not: (f64, Trial),
}

/// What a search has found.
#[derive(Debug)]
pub(super) enum Searched {
    Threshold(Threshold),
    /// All amounts do, as far as this one.
    All(f64),
    /// None of these does; what was given comes first.
    Nothing(Vec<(f64, Trial)>),
}

/// From a start that does towards less of it, from one that does not towards more. Where no more of it does, either, some do perhaps on the other side,
/// or between two of them: asked for with `everywhere`.
pub(super) fn search(
    tries: Tries<'_>,
    start: f64,
    is_least: bool,
    everywhere: bool,
) -> Result<Searched, Error> {
    let (more, less) = if is_least { (2.0, 0.5) } else { (0.5, 2.0) };
    let first = tries(start)?;
    if first == Trial::Does {
        return edge_from(tries, start, less);
    }
    let mut vain = vec![(start, first)];
    if let Some(does) = walk(tries, start, more, &mut vain)? {
        return Ok(vain
            .pop()
            .map_or(Searched::All(does), |does_not| Searched::Threshold(Threshold { does, does_not })));
    }
    if everywhere {
        if let Some(does) = walk(tries, start, less, &mut vain)? {
            return edge_from(tries, does, less);
        }
        if let Some((does, [low, high])) = refined(tries, &mut vain)? {
            let beside = if is_least { low } else { high };
            return Ok(Searched::Threshold(Threshold { does, does_not: (beside, tries(beside)?) }));
        }
    }
    Ok(Searched::Nothing(vain))
}

/// The first amount that does, so many times larger from one to the next; those that do not are put down.
fn walk(
    tries: Tries<'_>,
    start: f64,
    factor: f64,
    vain: &mut Vec<(f64, Trial)>,
) -> Result<Option<f64>, Error> {
    let mut at = start;
    for _ in 0..MOST_DOUBLINGS {
        at *= factor;
        match tries(at)? {
            Trial::Does => return Ok(Some(at)),
            trial => vain.push((at, trial)),
        }
    }
    Ok(None)
}

/// Where an amount that does ends to do, so many times larger from one to the next.
fn edge_from(tries: Tries<'_>, start: f64, factor: f64) -> Result<Searched, Error> {
    let mut does = start;
    for _ in 0..MOST_DOUBLINGS {
        match tries(does * factor)? {
            Trial::Does => does *= factor,
            trial => return Ok(Searched::Threshold(Threshold { does, does_not: (does * factor, trial) })),
        }
    }
    Ok(Searched::All(does))
}

/// An amount that does between amounts of which none does, and the two around it. While the states of contacts and drives are the same, what is
/// carried is a concave function of a squeeze. So its greatest value is looked for around the best of them.
fn refined(tries: Tries<'_>, vain: &mut Vec<(f64, Trial)>) -> Result<Option<(f64, [f64; 2])>, Error> {
    let mut in_order: Vec<_> = vain.iter().map(|(at, trial)| (*at, trial.carried())).collect();
    in_order.sort_by(|one, other| one.0.total_cmp(&other.0));
    let carries_most = |i: &usize, j: &usize| in_order[*i].1.total_cmp(&in_order[*j].1);
    let Some(best) = (0..in_order.len()).max_by(carries_most) else { return Ok(None) };
    // Without a difference there is nothing to follow.
    if in_order.iter().all(|(_, carried)| *carried == in_order[best].1) {
        return Ok(None);
    }
    let [mut low, mut high] =
        [best.saturating_sub(1), (best + 1).min(in_order.len() - 1)].map(|k| in_order[k].0);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let between = |from: f64, to: f64| from * (to / from).powf(golden);
    let mut inner = [between(high, low), between(low, high)];
    let mut parts = [None; 2];
    for _ in 0..MOST_SECTIONS {
        for k in 0..2 {
            if parts[k].is_none() {
                let trial = tries(inner[k])?;
                if trial == Trial::Does {
                    return Ok(Some((inner[k], [low, high])));
                }
                parts[k] = Some(trial.carried());
                vain.push((inner[k], trial));
            }
        }
        if parts[0] < parts[1] {
            low = inner[0];
            (inner, parts) = ([inner[1], between(low, high)], [parts[1], None]);
        } else {
            high = inner[1];
            (inner, parts) = ([between(high, low), inner[0]], [None, parts[0]]);
        }
    }
    Ok(None)
}

impl Threshold {
    /// This edge to the last digits; where rounding keeps it from being told, what does not lies a little beyond.
    pub(super) fn halved(mut self, tries: Tries<'_>) -> Result<Self, Error> {
        while (self.does - self.does_not.0).abs() > CLOSE * self.does.abs() {
            let middle = 0.5 * (self.does + self.does_not.0);
            if middle == self.does || middle == self.does_not.0 {
                break;
            }
            match tries(middle)? {
                Trial::Does => self.does = middle,
                trial => self.does_not = (middle, trial),
            }
        }
        if let Trial::Unknown(_) = self.does_not.1 {
            let mut gap = self.does_not.0 - self.does;
            while gap.abs() <= 0.25 * BLURRED * self.does.abs() {
                gap *= 4.0;
                let at = self.does + gap;
                if let trial @ Trial::DoesNot { .. } = tries(at)? {
                    self.does_not = (at, trial);
                    break;
                }
            }
        }
        Ok(self)
    }
}
