//! Narrows a bracket in a difficult case: equilibria at rest (before the loads act) are found beyond the bound only by trying all combinations of
//! contact states.
//!
//! An amount of squeeze, friction, load, arm or angle is sufficient if with it the grasp holds the loads as the question demands. The bound is the
//! least or greatest sufficient amount. A bracket of it is a sufficient and a neighbouring insufficient amount.
//!
//! Several equilibria at rest may exist, and rounding determines which of them is found. Neighbouring amounts are then sufficient and insufficient in
//! turn.

use super::search::TrialFunctions;
use super::threshold::{Threshold, WidthSchedule};
use super::trial::Trial;
use crate::error::Error;
use crate::numerics::sort_by_number;

/// Number of amounts tried beyond the last one for which an equilibrium at rest is found without enumerating the contact states.
///
/// If smaller, amounts whose verdicts depend on rounding are called sufficient. If larger, the answer takes longer: each amount costs an enumeration
/// of contact states.
const BEYOND_PRESUMED: u32 = 6;

impl Threshold {
    /// Narrows this bracket, a sufficient and an insufficient amount, by trials that enumerate the contact states. `presumed` is the last amount for
    /// which an equilibrium at rest is found without this enumeration. If an insufficient amount lies between `presumed` and a sufficient one, the
    /// verdicts alternate. Then `presumed` becomes the sufficient amount of the bracket, and the nearest insufficient amount its other end.
    pub(super) fn beyond(
        mut self,
        presumed: f64,
        tries: TrialFunctions<'_>,
        enough: WidthSchedule,
    ) -> Result<Self, Error> {
        let step = (self.insufficient.0 - presumed) / f64::from(BEYOND_PRESUMED + 1);
        let mut list = vec![(self.sufficient, tries.at(self.sufficient)?)];
        for k in 1..=BEYOND_PRESUMED {
            let at = presumed + step * f64::from(k);
            list.push((at, tries.at(at)?));
        }
        sort_by_number(&mut list, &|(at, _)| (at - presumed).abs());
        let fails = list.iter().find(|(_, trial)| matches!(trial, Trial::Insufficient { .. })).cloned();
        let Some((sufficient, trial)) = list.into_iter().rfind(|(_, trial)| trial.is_sufficient()) else {
            return Ok(self);
        };
        match fails {
            Some(fails) if (fails.0 - presumed).abs() < (sufficient - presumed).abs() => {
                return Ok(Self { sufficient: presumed, insufficient: fails, unknown: None });
            }
            Some(fails) => self.insufficient = fails,
            None => {}
        }
        self.sufficient = sufficient;
        self.by(tries, false, (trial.measures(), enough))
    }
}
