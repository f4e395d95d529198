//! The amounts for which contact forces inside their cones could balance everything that acts: none of the others holds.
//!
//! Loads are affine in an amount of load, arm, squeeze or force, and cones are convex, so that these amounts are an interval. A motion v that proves that
//! nothing balances the loads W(x) proves it of every amount with W(x)·v > 0: it cuts the interval where that work vanishes. Friction widens the cones, so that
//! of a coefficient there is a least one.

use super::question::{Need, Safety, Sought};
use super::trial::Loading;
use crate::ask::Grasp;
use crate::error::Error;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Each cut passes the one before; near an end of round cones they come closer by parts.
const MOST_CUTS: usize = 60;
/// Cuts this close together, relatively, are one.
const SAME: f64 = 1e-13;
/// Coefficients this close together, relatively, are one, and so many halvings lead there from any two.
const SAME_FRICTION: f64 = 1e-10;
const HALVINGS: usize = 80;
/// Where coefficients are this close, relatively, what is left of the load changes evenly.
const NEAR: f64 = 1e-2;

/// An interval of amounts; what lies beyond an end that is given is refuted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    pub(super) low: Option<f64>,
    pub(super) high: Option<f64>,
    pub(super) is_empty: bool,
    /// Where the lower end is likely to be, closer than proofs tell.
    pub(super) likely: Option<f64>,
}

impl Range {
    /// Among amounts between two.
    pub(super) fn of<const C: usize>(
        grasp: &Grasp<C>,
        need: &Need<C>,
        safety: Safety,
        [least, most]: [f64; 2],
    ) -> Result<Self, Error> {
        let mut range = Self { low: None, high: None, is_empty: false, likely: None };
        let loading = |amount: f64| Loading::of(grasp, need, amount, safety);
        match need.sought {
            Sought::Angle { .. } => {}
            Sought::Friction { .. } => range.least_friction(&loading, [least, most])?,
            _ => {
                for which in 0..loading(least)?.to_balance().len() {
                    for up in [true, false] {
                        if !range.is_empty {
                            range.cut(&loading, which, up, [least, most])?;
                        }
                    }
                }
            }
        }
        Ok(range)
    }

    /// Moves one end inwards, as far as one of the loads asks for it.
    fn cut<const C: usize>(
        &mut self,
        loading: &dyn Fn(f64) -> Result<Loading<C>, Error>,
        which: usize,
        up: bool,
        [least, most]: [f64; 2],
    ) -> Result<(), Error> {
        let (low, high) = (self.low.unwrap_or(least), self.high.unwrap_or(most));
        let (mut at, end) = if up { (low, high) } else { (high, low) };
        for _ in 0..MOST_CUTS {
            let here = loading(at)?;
            let load = here.to_balance()[which];
            let Some(motion) = here.grasp.unbalanced_along(&load)? else { break };
            let there = loading(end)?;
            let works = |of: &Loading<C>| of.grasp.work_along(&of.to_balance()[which], &motion);
            let (work, beyond) = (works(&here)?, works(&there)?);
            // The load works along it at both ends, so that nothing balances it between them.
            if beyond >= 0.0 || at == end {
                self.is_empty = true;
                return Ok(());
            }
            let next = at + (end - at) * (work / (work - beyond));
            let is_last = (next - at).abs() <= SAME * at.abs().max(next.abs());
            at = next;
            *(if up { &mut self.low } else { &mut self.high }) = Some(at);
            if is_last {
                break;
            }
        }
        Ok(())
    }

    /// The least coefficient with which forces balance all loads. What they leave vanishes there, and secants of that lead closer to it than proofs do.
    fn least_friction<const C: usize>(
        &mut self,
        loading: &dyn Fn(f64) -> Result<Loading<C>, Error>,
        [least, most]: [f64; 2],
    ) -> Result<(), Error> {
        // How much of a load is left, as its work along the motion that proves it.
        let left = |amount: f64| {
            let here = loading(amount)?;
            for load in here.to_balance() {
                if let Some(motion) = here.grasp.unbalanced_along(&load)? {
                    return Ok::<_, Error>(Some(here.grasp.work_along(&load, &motion)?));
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
        for _ in 0..HALVINGS {
            if high - low <= SAME_FRICTION * high {
                break;
            }
            let middle = if high > 2.0 * low { (low * high).sqrt() } else { 0.5 * (low + high) };
            let is_near = high - low <= NEAR * high;
            let at = secant.filter(|at| is_near && low < *at && *at < high).unwrap_or(middle);
            if let Some(now) = left(at)? {
                secant = (now < last).then(|| at + now * (at - low) / (last - now));
                (low, last) = (at, now);
            } else {
                high = at;
                // Beyond the end of what proofs tell apart the secant has found it.
                if secant == Some(at) {
                    break;
                }
            }
        }
        (self.low, self.likely) = (Some(low), secant);
        Ok(())
    }
}
