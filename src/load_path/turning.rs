//! Along a sliding arc of the round cone, step by step, to the next event.
//!
//! Each step is extrapolated to the tolerance of the settings; what refuses is halved, or made by the other rule. An event is where
//! one of these reaches zero,
//!
//! ```text
//! rolling   μ F_n - |F_t|, or F_n where friction has no limit or is none
//! open      the gap
//! sliding   the rate at which it slips, and F_n
//! ```
//!
//! found by making the last step again, shorter or longer, until it ends there. No interpolation comes in.

use nalgebra::SVector;

use super::arc::{Arc, Rule};
use super::event::{Loss, PathEnd};
use super::extrapolation::{Reached, extrapolate};
use super::loss::end_of_arc;
use super::path::LoadPath;
use super::segment::{Here, Standing};
use super::watch::{Watch, watch};
use crate::contact::{Exit, Line, Mode, Stand, ZERO_SLACK, tangential};
use crate::object::PieceState;
use crate::search::Doubt;

/// The first step turns the fastest contact by this angle, as far as can be told from the rate there.
const FIRST_TURN: f64 = 0.3;
/// A step leaves this part of the way to where a sliding contact loses its normal force: its direction may turn ever faster.
const APPROACH: f64 = 0.5;
/// Steps shorter than this part of the way gone are none: the arc ends here.
const SHORTEST: f64 = 1e-13;
/// The energy of a step balances but for this many times its error; on another equilibrium it is off by far.
const UNBALANCED: f64 = 1e2;
/// A leg that takes more steps along arcs is given up.
const MOST_STEPS: usize = 20_000;
/// Evaluations on the way to an event: bisection alone would need 50.
const MOST_TRIALS: usize = 80;

/// Where a step ends.
struct End<const D: usize, const C: usize> {
    to: f64,
    rule: Rule,
    reached: Reached<D, C>,
    here: Here<D, C>,
    watches: Vec<Watch>,
    /// The condition that it was made to end at.
    located: Option<usize>,
}

impl<const D: usize, const C: usize> LoadPath<'_, D, C> {
    /// Makes one step along the arc, up to an event if one comes first.
    pub(super) fn advance_along_arc(&mut self) {
        let Some(here) = self.here.clone() else { return };
        let rest = 1.0 - self.factor;
        let length =
            self.pace.length.unwrap_or_else(|| self.first_length(&here)).min(self.way_to_apex(&here));
        let to = if length >= rest { 1.0 } else { self.factor + length };
        let too_short = to < 1.0 && length <= SHORTEST * self.factor.max(f64::EPSILON);
        let dies_out = too_short || to <= self.factor;
        if dies_out && self.node.let_go(&here) {
            self.at_node = true;
            return;
        }
        if dies_out && self.pace.loosen(rest) {
            return;
        }
        if dies_out || self.pace.steps > MOST_STEPS {
            self.end = Some(self.loss(&here));
            return;
        }
        let Some(end) =
            self.step(&here, to, self.pace.rule).or_else(|| self.step(&here, to, self.pace.rule.other()))
        else {
            self.pace.refuse(to - self.factor);
            return;
        };
        let start = watch(&self.segment, &self.node.states, &here);
        match Self::first_crossing(&start, &end) {
            None if end.reached.backwards => self.pace.refuse(to - self.factor),
            None => self.arrive_at(&here, end),
            Some(contact) => match self.locate(&here, &start, end, contact) {
                Some(end) => self.arrive_at(&here, end),
                None => self.pace.refuse(to - self.factor),
            },
        }
    }

    fn first_length(&self, here: &Here<D, C>) -> f64 {
        let mut length = 1.0 - self.factor;
        for (line, state) in here.lines.iter().zip(&self.node.states) {
            let (f, df) = (&line.force, &line.rate);
            // What has just closed has no direction yet.
            let touches = Stand::is_weightless(f, line.force_size);
            if C == 3 && state.slides() && !touches {
                let turn = (f[1] * df[C - 1] - f[C - 1] * df[1]).abs() / (f[1] * f[1] + f[C - 1] * f[C - 1]);
                if turn.is_finite() && turn * length > FIRST_TURN {
                    length = FIRST_TURN / turn;
                }
            }
        }
        length
    }

    fn way_to_apex(&self, here: &Here<D, C>) -> f64 {
        let mut way = f64::INFINITY;
        for (line, state) in here.lines.iter().zip(&self.node.states) {
            if state.slides()
                && line.rate[0] < -ZERO_SLACK * line.rate_size
                && !Stand::is_weightless(&line.force, line.force_size)
            {
                way = way.min((1.0 - APPROACH) * line.force[0] / -line.rate[0]);
            }
        }
        way
    }

    /// A step to a factor, with what comes next there.
    fn step(&self, here: &Here<D, C>, to: f64, rule: Rule) -> Option<End<D, C>> {
        let forces = here.lines.iter().map(|line| line.force).collect();
        let start = PieceState { forces, twist: here.twist };
        let arc = Arc::new(&self.segment, &self.node.states, self.factor, start, here.twist_rate);
        let tolerance = self.settings.step_error * self.pace.looser;
        let reached = extrapolate(&arc, rule, to, tolerance)?;
        // A step that jumped over to another equilibrium converges as well; its energy does not balance.
        if reached.energy.residual().abs() > UNBALANCED * tolerance.max(reached.error) {
            return None;
        }
        let here = self.node.tangent_at(&self.segment, to, &reached.there.at).ok()?;
        let watches = watch(&self.segment, &self.node.states, &here);
        Some(End { to, rule, reached, here, watches, located: None })
    }

    /// The contact whose condition is violated at the end of a step, the one that would be first on straight lines.
    fn first_crossing(start: &[Watch], end: &End<D, C>) -> Option<usize> {
        let part = |k: usize| {
            let (from, to) = (start[k].value.max(0.0), end.watches[k].value);
            from / (from - to)
        };
        let violated = (0..start.len()).filter(|&k| end.watches[k].is_violated());
        violated.min_by(|&i, &j| part(i).total_cmp(&part(j)))
    }

    /// The step that ends where a condition is just met, and no other is violated.
    fn locate(
        &self,
        here: &Here<D, C>,
        start: &[Watch],
        mut end: End<D, C>,
        mut k: usize,
    ) -> Option<End<D, C>> {
        let (mut low, mut high) = ((self.factor, start[k].value.max(0.0)), (end.to, end.watches[k].value));
        if start[k].is_met() {
            // It stands there already, and leaves at once.
            low.1 = 0.0;
        }
        for trial in 0..MOST_TRIALS {
            // The secant, and every third time the middle, so that the bracket shrinks for certain.
            let part = low.1 / (low.1 - high.1);
            let part = if trial % 3 == 2 { 0.5 } else { part.clamp(1e-3, 1.0 - 1e-3) };
            let newton = end.watches[k].way().map(|way| end.to + way).filter(|t| *t > low.0 && *t < high.0);
            let to = newton.unwrap_or(low.0 + (high.0 - low.0) * part);
            if to <= low.0 || to >= high.0 {
                // No number lies between.
                end.located = Some(k);
                return Some(end);
            }
            end = self.step(here, to, end.rule).or_else(|| self.step(here, to, end.rule.other()))?;
            if let Some(other) = Self::first_crossing(start, &end) {
                if other != k {
                    k = other;
                    low = (self.factor, start[k].value.max(0.0));
                }
                high = (end.to, end.watches[k].value);
            } else if end.watches[k].is_met() {
                end.located = Some(k);
                return Some(end);
            } else {
                low = (end.to, end.watches[k].value);
            }
        }
        None
    }

    /// Goes there, and stands on what is met there.
    fn arrive_at(&mut self, here: &Here<D, C>, end: End<D, C>) {
        let length = end.to - self.factor;
        self.pace.accept(length, end.reached.sweeps);
        self.pace.rule = end.rule;
        let mut standing: Standing<C> = Vec::new();
        let mut sticks = Vec::new();
        for (k, watch) in end.watches.iter().enumerate() {
            if end.located != Some(k) && !(watch.is_met() && watch.falls()) {
                continue;
            }
            let line = &end.here.lines[watch.contact];
            match self.node.states[watch.contact] {
                Mode::Open => standing.push((watch.contact, vec![apex()])),
                Mode::Rolling => {
                    let rubs = self.segment.problem.local(watch.contact).may_slide();
                    let facet = if rubs { tangential(&line.force).normalize() } else { SVector::zeros() };
                    standing.push((watch.contact, vec![Exit { facet, ..apex() }]));
                }
                // At the end of a leg its rates are no longer what counts.
                _ if end.to >= 1.0 => {}
                _ => sticks.push(watch.contact),
            }
        }
        let weightless = |i: usize| {
            let (size, force) = (end.here.lines[i].force_size, &end.here.lines[i].force);
            self.node.states[i].slides() && Stand::is_weightless(force, size)
        };
        let leg_done = end.to >= 1.0;
        let stops = !standing.is_empty() || !sticks.is_empty() || (0..self.node.states.len()).any(weightless);
        self.take(here, end.to, end.rule, end.reached);
        self.node.reach(&standing);
        for contact in sticks {
            self.node.stick(contact);
        }
        self.here = Some(end.here);
        if leg_done {
            self.at_node = true;
            self.program.leg += 1;
            self.begin_leg();
        } else {
            self.at_node = stops;
        }
    }

    /// Why the arc cannot be followed further: steps that get ever shorter close in on a load at which the object leaves. The motion
    /// is that of the rates there, which grow without bound.
    fn loss(&self, here: &Here<D, C>) -> PathEnd<D, C> {
        let (leg, fraction) = (self.program.leg, self.factor);
        let size = here.twist_rate.norm();
        if self.pace.steps > MOST_STEPS || !(size > 0.0 && size.is_finite()) {
            let doubt = if self.pace.steps > MOST_STEPS { Doubt::OutOfSteps } else { Doubt::Inaccurate };
            return PathEnd::Undecided { leg, fraction, doubt };
        }
        let motion = here.twist_rate / size;
        let on_an_edge = |i: &usize| self.node.states[*i].slides();
        let loss = Loss {
            leg,
            fraction,
            load: self.program.load_at(fraction),
            contacts: (0..self.node.states.len()).filter(on_an_edge).collect(),
            motion: Some(self.grasp.outside(&motion)),
        };
        // Without forces there is nothing that an arc could close in on: it only could not set out.
        let weightless = |line: &Line<C>| Stand::is_weightless(&line.force, line.force_size);
        let ends = !here.lines.iter().all(weightless);
        end_of_arc(&self.segment, ends, &motion, &self.node.at.forces, loss, &self.settings)
    }
}

/// Where a normal force or a gap vanishes.
fn apex<const C: usize>() -> Exit<C> {
    Exit { step: 0.0, uncertainty: 0.0, facet: SVector::zeros() }
}
