//! The range of amounts for which contact forces inside their cones could balance all loads. With an amount outside this range the object is not
//! held. An amount is a multiple of the squeeze or load, a coefficient of friction, or an arm. At rest means before the other loads act.
//!
//! The loads W(x) are affine in an amount x of load, arm, squeeze or force, and cones are convex, so the range is an interval. A motion v may prove
//! that W(x) is unbalanced. Along v no contact force does negative work, but the load does positive work, W(x)·v > 0. Then v proves the same for
//! every other amount y with W(y)·v > 0, so the range ends at the latest where this work vanishes. For friction there is a least coefficient, because
//! friction widens the cones.

use super::checked_need::{CheckedNeed, SafetyDeviations, Sought};
use super::loading::Loading;
use super::tolerances::{LAST_DIGITS, SAME_COEFFICIENT};
use crate::ask::Grasp;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::squeeze::Loads;

/// The amounts for which contact forces may balance the loads. If an end is given, it is proved that with an amount beyond it no contact forces
/// balance the loads; beyond an end that is `None` nothing is proved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    pub(super) low: Option<f64>,
    pub(super) high: Option<f64>,
    pub(super) is_empty: bool,
    /// Whether the range is empty because no contact forces balance the load at rest alone.
    pub(super) is_empty_at_rest: bool,
    /// The single amount that proofs leave, if they exclude all others.
    only: Option<f64>,
    /// For friction only: an estimate of the lower end from secants, which is more accurate than the proved end.
    pub(super) likely: Option<f64>,
}

impl Range {
    /// The range, limited to the least and the greatest amount that the search would try.
    pub(super) fn of(
        grasp: &Grasp<3>,
        need: &CheckedNeed,
        safety: SafetyDeviations,
        [least, most]: [f64; 2],
    ) -> Result<Self, Error> {
        let mut range = Self {
            low: None,
            high: None,
            is_empty: false,
            is_empty_at_rest: false,
            only: None,
            likely: None,
        };
        let loading = |amount: f64| Loading::of(grasp, need, amount, safety);
        match need.sought {
            Sought::Angle { .. } => {}
            Sought::Friction { .. } => range.least_friction(&loading, [least, most])?,
            _ => {
                for which in 0..loading(least)?.to_balance().len() {
                    for up in [true, false] {
                        if !range.is_empty {
                            range.cut(&loading, which, up, [least, most])?;
                            range.is_empty_at_rest =
                                range.is_empty && which == 0 && !matches!(need.loads, Loads::Turn(_));
                        }
                    }
                }
            }
        }
        Ok(range)
    }

    /// The only amount that proofs leave, up to rounding; `None` if they leave several amounts or none.
    pub(super) fn point(&self) -> Option<f64> {
        match (self.low, self.high) {
            _ if self.is_empty => self.only,
            (Some(low), Some(high)) if high - low <= NEGLIGIBLE * high => Some(0.5 * (low + high)),
            _ => None,
        }
    }

    /// Moves one end of the range inwards: the lower end if `up`, else the upper end. The end moves on as long as it is proved that, with the amount
    /// at this end, no contact forces balance the load of index `which`.
    fn cut(
        &mut self,
        loading: &dyn Fn(f64) -> Result<Loading, Error>,
        which: usize,
        up: bool,
        [least, most]: [f64; 2],
    ) -> Result<(), Error> {
        let (low, high) = (self.low.unwrap_or(least), self.high.unwrap_or(most));
        let (mut at, end) = if up { (low, high) } else { (high, low) };
        // On round cones each step of this loop shortens the distance to the true end by a constant factor. With fewer steps the end would be less
        // accurate, though still proved.
        for _ in 0..60 {
            let here = loading(at)?;
            let load = here.to_balance()[which];
            let Some(motion) = here.grasp.engine.unbalanced_along(&load, here.grasp.settings())? else {
                break;
            };
            let there = loading(end)?;
            let works = |of: &Loading| of.grasp.engine.work_along(&of.to_balance()[which], &motion);
            let (work, beyond) = (works(&here)?, works(&there)?);
            // The load does positive work along the motion that proves it unbalanced at both ends of the range, so no contact forces balance the load
            // at any amount between these ends.
            if beyond >= 0.0 || at == end {
                // If proofs from both sides exclude all amounts down to a single amount, this last amount may be excluded due to rounding only.
                let root = at + (end - at) * (work / (work - beyond));
                self.only = (at == end || (root - end).abs() <= NEGLIGIBLE * end).then_some(end);
                self.is_empty = true;
                return Ok(());
            }
            let next = at + (end - at) * (work / (work - beyond));
            let is_last = (next - at).abs() <= LAST_DIGITS * at.abs().max(next.abs());
            at = next;
            *(if up { &mut self.low } else { &mut self.high }) = Some(at);
            if is_last {
                break;
            }
        }
        Ok(())
    }

    /// The least coefficient of friction with which contact forces balance all loads. For a smaller coefficient, a motion along which a load does
    /// positive work, and no contact force negative work, proves that no contact forces balance this load. This work vanishes at the least
    /// coefficient. Secants of the work give this coefficient more accurately than a bisection on whether such a motion exists.
    fn least_friction(
        &mut self,
        loading: &dyn Fn(f64) -> Result<Loading, Error>,
        [least, most]: [f64; 2],
    ) -> Result<(), Error> {
        // The work of a load along the motion that proves this load unbalanced; `None` if no load has such a proof.
        let left = |amount: f64| {
            let here = loading(amount)?;
            let mut loads = here.to_balance();
            loads.dedup();
            for load in loads {
                if let Some(motion) = here.grasp.engine.unbalanced_along(&load, here.grasp.settings())? {
                    return Ok::<_, Error>(Some(here.grasp.engine.work_along(&load, &motion)?));
                }
            }
            Ok(None)
        };
        if left(most)?.is_some() {
            self.is_empty = true;
            return Ok(());
        }
        let (Some(mut last), mut low, mut high) = (left(least)?, least, most) else { return Ok(()) };
        let mut secant = None;
        // If the ratio of the limits `high` and `low` is 2⁴⁰, about 40 halvings are needed, of which the first halve the logarithm of this ratio.
        // With fewer than eighty steps allowed, the end of the range might be less accurate.
        for _ in 0..80 {
            if high - low <= SAME_COEFFICIENT * high {
                break;
            }
            let middle = if high > 2.0 * low { (low * high).sqrt() } else { 0.5 * (low + high) };
            // In a wide interval the work is far from linear in the coefficient, so the interval is halved. Secants are used once the interval is
            // narrow.
            let is_near = high - low <= 1e-2 * high;
            let at = secant.filter(|at| is_near && low < *at && *at < high).unwrap_or(middle);
            if let Some(now) = left(at)? {
                secant = (now < last).then(|| at + now * (at - low) / (last - now));
                (low, last) = (at, now);
            } else {
                high = at;
                // At the root of the secant no load is proved unbalanced, so this root is the least coefficient to the accuracy of the proofs.
                if secant == Some(at) {
                    break;
                }
            }
        }
        (self.low, self.likely) = (Some(low), secant);
        Ok(())
    }
}
