//! One cycle: where it begins and ends, and what happens in it.

use nalgebra::{DVector, SVector};

use crate::grasp::{Engine, Site};
use crate::load_path::{CycleRecord, CycleState, Cycles};
use crate::numerics::Size;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Settings;

/// Forces and gaps that differ by less than this part of the largest at both ends of a cycle are the same: rounding.
const SAME: f64 = 1e-11;
/// Slips below this part of what springs are stretched by are none.
const NO_SLIP: f64 = 1e-9;
/// Along sliding arcs the error of a cycle may be so many times the estimated errors of its steps, in what they lead to.
const WAYS: f64 = 100.0;
/// Most steps along sliding arcs of a leg where a cycle is only tried: where nothing leads to directions may turn ever faster.
const MOST_TRIED: usize = 1000;
/// Nobody waits for so many cycles.
const FOR_EVER: f64 = 1e9;

/// What forces and gaps are measured by: the largest force (N), and what it stretches springs by (m).
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub(super) force: f64,
    pub(super) stretch: f64,
}

/// What is known after a cycle.
#[derive(Debug, Clone)]
pub(super) struct Cycle<D: Size, const C: usize> {
    pub(super) from: CycleState<D, C>,
    pub(super) to: CycleState<D, C>,
    pub(super) record: CycleRecord<C>,
    pub(super) scale: Scale,
}

impl<D: Size, const C: usize> Cycle<D, C> {
    /// The next cycle; `None` where it is not gone to its end.
    pub(super) fn next(engine: &Engine<D, C>, cycles: &mut Cycles<'_, D, C>) -> Option<Self> {
        let from = cycles.standing()?;
        let record = cycles.go()?;
        let to = cycles.standing()?;
        Some(Self { scale: scale_of(engine, &record, &to), from, to, record })
    }

    /// The one that begins somewhere else, with who goes it.
    pub(super) fn beginning_at<'g>(
        engine: &'g Engine<D, C>,
        cycles: &Cycles<'g, D, C>,
        there: &CycleState<D, C>,
        settings: &Settings,
    ) -> Option<(Self, Cycles<'g, D, C>)> {
        let tried = settings.with_most_steps(settings.most_steps.min(MOST_TRIED));
        let mut others = cycles.beginning_at(there, &tried)?;
        let cycle = Self::next(engine, &mut others)?;
        others.allow_steps(settings.most_steps);
        Some((cycle, others))
    }

    /// The two in a row as one.
    pub(super) fn append(&mut self, next: &Self) {
        self.record.append(&next.record);
        self.scale = Scale {
            force: self.scale.force.max(next.scale.force),
            stretch: self.scale.stretch.max(next.scale.stretch),
        };
        self.to = next.to.clone();
    }

    /// Forces and gaps somewhere, as numbers without unit; gaps left out of what was open all the way.
    pub(super) fn numbers(&self, place: &CycleState<D, C>) -> DVector<f64> {
        place.numbers(&self.scale, &|i| self.record.open[i].is_some())
    }

    /// By what they differ at its end.
    pub(super) fn difference(&self) -> DVector<f64> {
        self.numbers(&self.to) - self.numbers(&self.from)
    }

    /// By how much forces and gaps differ at both ends, over the largest.
    pub(super) fn change(&self) -> f64 {
        self.difference().amax()
    }

    /// What is no change.
    pub(super) fn same(&self) -> f64 {
        SAME.max(self.record.step_error)
    }

    /// How many more cycles like this one there can be: until what is open would close. `None` where nothing comes nearer.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole, and from 0 to a billion"
    )]
    pub(super) fn cycles_until_closing(&self) -> Option<usize> {
        let still = NO_SLIP * self.scale.stretch;
        let nearer = |i: usize| self.from.gaps[i] - self.to.gaps[i];
        let open = self.record.open.iter().enumerate().filter_map(|(i, gap)| gap.map(|gap| (i, gap)));
        let cycles = open.filter(|(i, _)| nearer(*i) > still).map(|(i, gap)| (gap / nearer(i)).floor() - 1.0);
        let first = cycles.min_by(f64::total_cmp).filter(|cycles| *cycles < FOR_EVER);
        first.map(|cycles| cycles.max(0.0) as usize)
    }

    /// Whether a site slides.
    pub(super) fn slides(&self, site: usize) -> bool {
        self.record.slid[site] > NO_SLIP * self.scale.stretch
    }

    /// Whether the object has moved on.
    pub(super) fn walks(&self) -> bool {
        let still = NO_SLIP.max(WAYS * self.record.step_error) * self.scale.stretch;
        let slips = self.to.slips.iter().zip(&self.from.slips);
        slips.enumerate().any(|(i, (to, from))| self.slides(i) && (to - from).norm() > still)
            && (&self.to.twist - &self.from.twist).amax() > still
    }
}

/// The largest force of a cycle, and what it stretches springs by.
fn scale_of<D: Size, const C: usize>(
    engine: &Engine<D, C>,
    record: &CycleRecord<C>,
    at: &CycleState<D, C>,
) -> Scale {
    let softness = |(site, force): (&Site<D, C>, &SVector<f64, C>)| {
        let size = force.norm();
        if size > 0.0 { site.springs.give(force).norm() / size } else { 0.0 }
    };
    let softest = engine.sites().iter().zip(&at.forces).map(softness).fold(0.0, f64::max);
    let force = if record.largest > 0.0 { record.largest } else { 1.0 };
    Scale { force, stretch: if softest > 0.0 { force * softest } else { engine.length() } }
}
