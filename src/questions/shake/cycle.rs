//! One cycle of loads: the cycle states at its beginning and end, and the slips between them, i.e. the relative tangential displacements of the two
//! surfaces of each contact. A cycle state has the contact forces, gaps and slips at an instant between two cycles. A jump is a motion under constant
//! load from one equilibrium to another. An object walks if it moves on by the same motion in every cycle. A drive is the spring of a joint or tendon
//! of a hand, with its force limit.

use super::tolerances::{SAME_CYCLE, SLIP_OF_JUMPS};
use nalgebra::{DVector, SVector};

use crate::grasp::{Engine, Site};
use crate::load_path::{CycleRecord, CycleState, Cycles};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Reals, chosen, lowest, picked};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Settings;

/// The units in which cycle states are compared.
#[derive(Debug, Clone, Copy)]
pub(super) struct CycleUnits {
    /// Unit of forces, N: the largest contact force of the cycle.
    pub(super) force: f64,
    /// Unit of gaps and slips, m: the stretch of the softest spring under `force`.
    pub(super) stretch: f64,
}

/// One cycle of loads, or several cycles joined to one, with the cycle states at its beginning and end.
#[derive(Debug, Clone)]
pub(super) struct Cycle {
    pub(super) from: CycleState,
    pub(super) to: CycleState,
    pub(super) record: CycleRecord,
    pub(super) scale: CycleUnits,
}

impl Cycle {
    /// Follows the load path through the next cycle; `None` if the path ends, for example with a loss of equilibrium, before the cycle is complete.
    pub(super) fn next(engine: &Engine, cycles: &mut Cycles<'_>) -> Option<Self> {
        let from = cycles.cycle_state()?;
        let record = cycles.follow_cycle()?;
        let to = cycles.cycle_state()?;
        Some(Self { scale: scale_of(engine, &record, &to), from, to, record })
    }

    /// The cycle that begins at the cycle state `there`, and the load path for the cycles after it. `None` if `there`, with its slips, is no
    /// equilibrium, or if the path ends within the cycle.
    pub(super) fn beginning_at<'g>(
        engine: &'g Engine,
        cycles: &Cycles<'g>,
        there: &CycleState,
        settings: &Settings,
    ) -> Option<(Self, Cycles<'g>)> {
        // `there` is an extrapolated cycle state. If no limit cycle is near it, directions of slip may turn ever faster along the path. Therefore the
        // number of steps is limited.
        let tried = settings.with_most_steps(settings.most_steps.min(1000));
        let mut others = cycles.beginning_at(there, &tried)?;
        let cycle = Self::next(engine, &mut others)?;
        others.allow_steps(settings.most_steps);
        Some((cycle, others))
    }

    /// Joins the next cycle to this one, so that both together are treated as one cycle.
    pub(super) fn append(&mut self, next: &Self) {
        self.record.append(&next.record);
        self.scale = CycleUnits {
            force: self.scale.force.max(next.scale.force),
            stretch: self.scale.stretch.max(next.scale.stretch),
        };
        self.to = next.to.clone();
    }

    /// The forces and gaps of a cycle state, divided by the units of [`CycleUnits`], and for each contact 1 if its friction is kinetic, else 0. Gaps
    /// of contacts that stay open during the whole cycle are replaced by zero: they may change although all forces repeat.
    pub(super) fn numbers(&self, place: &CycleState) -> DVector<f64> {
        place.numbers(&self.scale, &|i| self.record.open[i].is_some())
    }

    /// The numbers ([`Self::numbers`]: forces and gaps in their units) of the cycle state at the end of the cycle less those at its beginning.
    pub(super) fn difference(&self) -> DVector<f64> {
        self.numbers(&self.to) - self.numbers(&self.from)
    }

    /// The largest magnitude of an entry of [`Self::difference`].
    pub(super) fn change(&self) -> f64 {
        self.difference().amax()
    }

    /// The largest [`Self::change`] with which a cycle is taken to repeat itself. It is [`SAME_CYCLE`], 1e-11, which allows for rounding, or the
    /// estimated relative step error of the cycle's load path if that is larger.
    pub(super) fn same(&self) -> f64 {
        SAME_CYCLE.max(self.record.step_error)
    }

    /// The number of further cycles like this one before the first open gap closes. `None` if no gap shrinks, or for a billion cycles or more.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole, and from 0 to a billion"
    )]
    pub(super) fn cycles_until_closing(&self) -> Option<usize> {
        let still = NEGLIGIBLE * self.scale.stretch;
        let nearer = |i: usize| self.from.gaps[i] - self.to.gaps[i];
        let open = chosen(self.record.open.len(), &|i| nearer(*i) > still);
        let cycles = picked(&open, &|i| Some((self.record.open[*i]? / nearer(*i)).floor() - 1.0));
        // If the gap would close after a billion cycles or more, it is taken never to close.
        let first = lowest(&cycles, &|cycles| *cycles).filter(|cycles| **cycles < 1e9);
        first.map(|cycles| cycles.max(0.0) as usize)
    }

    /// Whether a contact or drive slides in the cycle. It does if its path of slip is longer than the sum of two errors: rounding, and the false slip
    /// from the numerical steps of jumps (motions under constant load).
    pub(super) fn slides(&self, site: usize) -> bool {
        self.record.slid[site] > NEGLIGIBLE * self.scale.stretch + SLIP_OF_JUMPS * self.record.jump_motion
    }

    /// Whether a contact is open at some time in the cycle, by a gap larger than rounding.
    pub(super) fn is_open(&self, site: usize) -> bool {
        self.record.largest_gap[site] > NEGLIGIBLE * self.scale.stretch
    }

    /// Whether a contact opens and closes again in the cycle.
    pub(super) fn opens(&self, site: usize) -> bool {
        self.record.open[site].is_none() && self.is_open(site)
    }

    /// Whether the object has moved, and the slip of some contact has changed, from the beginning to the end of the cycle, both by more than
    /// rounding. Slips shorter than the errors of jumps, which [`Self::slides`] ignores, count here, since slips of the same sense add up over the
    /// cycles.
    pub(super) fn walks(&self) -> bool {
        // If directions of slip turn along the load path, the error of the slips in a cycle may be a hundred times the estimated step errors.
        let still = NEGLIGIBLE.max(100.0 * self.record.step_error) * self.scale.stretch;
        let slips = self.to.slips.iter().zip(&self.from.slips);
        let slid = |i: usize| self.record.slid[i] > NEGLIGIBLE * self.scale.stretch;
        slips.enumerate().any(|(i, (to, from))| slid(i) && (to - from).norm() > still)
            && (&self.to.twist - &self.from.twist).amax() > still
    }
}

/// The [`CycleUnits`] of this cycle. The unit of force is 1 N if no contact force acted; the unit of gaps and slips is the size of the grasp if no
/// spring is stretched.
fn scale_of(engine: &Engine, record: &CycleRecord, at: &CycleState) -> CycleUnits {
    let softness = |(site, force): (&Site, &SVector<f64, 3>)| {
        let size = force.norm();
        if size > 0.0 { site.springs.deflection(force).norm() / size } else { 0.0 }
    };
    let softest = engine.sites().iter().zip(&at.forces).map(softness).most();
    let force = if record.largest > 0.0 { record.largest } else { 1.0 };
    CycleUnits { force, stretch: if softest > 0.0 { force * softest } else { engine.length() } }
}
