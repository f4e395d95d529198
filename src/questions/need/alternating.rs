//! Bounds beyond which only the enumeration of contact states finds an equilibrium at rest.
//!
//! Several such equilibria may exist, and rounding determines which one is found. Verdicts on neighbouring amounts then alternate.

use super::search::Tries;
use super::threshold::{Enough, Threshold};
use super::trial::Trial;
use crate::error::Error;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Number of amounts tried beyond the last one for which an equilibrium at rest is found without the enumeration.
///
/// If smaller, amounts whose verdicts depend on rounding are called sufficient. Each costs an enumeration.
const BEYOND_PRESUMED: u32 = 6;

impl Threshold {
    /// This bracket narrowed by full trials. The amount `presumed` is the last one for which an equilibrium at rest is found without the enumeration;
    /// if verdicts beyond it alternate, the bracket ends there.
    pub(super) fn beyond(mut self, presumed: f64, tries: Tries<'_>, enough: Enough) -> Result<Self, Error> {
        let step = (self.does_not.0 - presumed) / f64::from(BEYOND_PRESUMED + 1);
        let mut list = vec![(self.does, tries.at(self.does)?)];
        for k in 1..=BEYOND_PRESUMED {
            let at = presumed + step * f64::from(k);
            list.push((at, tries.at(at)?));
        }
        list.sort_by(|(one, _), (other, _)| (one - presumed).abs().total_cmp(&(other - presumed).abs()));
        let fails = list.iter().find(|(_, trial)| matches!(trial, Trial::DoesNot { .. })).cloned();
        let Some((does, trial)) = list.into_iter().rfind(|(_, trial)| trial.does()) else { return Ok(self) };
        match fails {
            Some(fails) if (fails.0 - presumed).abs() < (does - presumed).abs() => {
                return Ok(Self { does: presumed, does_not: fails, unknown: None });
            }
            Some(fails) => self.does_not = fails,
            None => {}
        }
        self.does = does;
        self.by(tries, false, (trial.measures(), enough))
    }
}
