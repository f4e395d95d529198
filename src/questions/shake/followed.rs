//! Follows cycle after cycle of a repeated load until the cycles repeat themselves, or until extrapolation gives the limit of the cycles. A cycle
//! state consists of the contact forces and gaps between two cycles. At rest means before the first cycle, under the base load alone. Events are
//! changes of contact states at one point of a load path: contacts slip, stick, open or close. The object walks if it moves on by the same motion in
//! every cycle. A drive is the spring of a joint or tendon of a hand, with its force limit. Motions are small within the limits up to which the
//! linear theory is trusted.

use super::cycle::Cycle;
use super::period_search::PeriodSearch;
use super::recurrence::Recurrence;
use super::tolerances::{NEAR_THE_LIMIT, NEAR_THE_LIMIT_ON_ARCS};
use super::verdict::{Repeats, Shaken};
use crate::equilibrium::TooFar;
use crate::error::Error;
use crate::grasp::{BodyMotion, Engine, WholeContact, Wrench};
use crate::load_path::{CycleState, Cycles, DriveChange, Leg, PathEnd, Ramp};
use crate::numerics::{IntoList, Reals, any_index, mapped};
use crate::prelude::*;
use crate::search::Settings;

/// Number of cycle states kept for extrapolation, each at the end of a cycle. [`Recurrence`] uses at most the last ten of them.
const KEPT_STATES: usize = 12;

impl Engine {
    pub(crate) fn shake(
        &self,
        base: &Wrench<3>,
        legs: &[Leg<3>],
        settings: &Settings,
    ) -> Result<Shaken<3>, Error> {
        let cycles = Cycles::at_rest(self, (base, legs), settings)?;
        let Some(rest) = cycles.cycle_state() else {
            let repeats =
                Repeats::NoRest { rest: Box::new(self.hold(&Ramp::load(*base, Wrench::ZERO), settings)?) };
            return Ok(Shaken {
                base: *base,
                repeats,
                every: 1,
                cycles: 0,
                followed: 0,
                change: 0.0,
                ratio: 0.0,
                opens: Vec::new(),
                leaks: Vec::new(),
                jumps: false,
                yields: Vec::new(),
                moved: Vec::new(),
                too_far: None,
                left_out: None,
                state: None,
            });
        };
        let slid = vec![false; rest.forces.len()];
        let places = vec![rest.clone()];
        let shaking = FollowedCycles {
            engine: self,
            settings,
            base: *base,
            rest,
            cycles,
            places,
            opened: vec![false; slid.len()],
            slid,
            jumps: false,
            round: PeriodSearch::new(),
            every: 1,
            alike: 0,
            followed: 0,
            cycles_gone: 0,
            too_far: None,
        };
        Ok(shaking.until_it_repeats())
    }
}

/// A repeated load on a grasp, and the data of the cycles that were followed so far.
struct FollowedCycles<'g, 's> {
    engine: &'g Engine,
    settings: &'s Settings,
    base: Wrench<3>,
    rest: CycleState,
    cycles: Cycles<'g>,
    /// The latest cycle states, oldest first, at most [`KEPT_STATES`]. If a cycle has other events than the cycle before, all cycle states before the
    /// beginning of this cycle are dropped.
    places: Vec<CycleState>,
    /// For each contact or drive, whether it has slid in any cycle so far.
    slid: Vec<bool>,
    /// For each contact or drive, whether it was open in any cycle so far.
    opened: Vec<bool>,
    /// Whether the object has jumped in any cycle so far.
    jumps: bool,
    round: PeriodSearch,
    /// The period of the limit cycle, as a number of load cycles.
    every: usize,
    /// Number of successive cycles, up to the present one, that each had the same events (slipping, sticking, opening, closing) as the cycle before.
    alike: usize,
    /// Number of cycles whose load path was computed, including trials of extrapolated cycle states.
    followed: usize,
    /// Number of load cycles from rest to the present cycle state, including cycles that extrapolation skipped.
    cycles_gone: usize,
    /// The first reason why the cycles followed so far may be wrong: a motion that was not small, a suction cup that leaks, or buckling. `None` if
    /// there is no such reason.
    too_far: Option<TooFar>,
}

impl<'g> FollowedCycles<'g, '_> {
    fn until_it_repeats(mut self) -> Shaken<3> {
        let (mut last, mut change): (Option<Cycle>, _) = (None, 0.0);
        let (mut most_cycles, mut walked_out) = (self.settings.most_cycles, None);
        while self.followed < most_cycles {
            self.followed += 1;
            self.cycles_gone += 1;
            let next = Cycle::next(self.engine, &mut self.cycles);
            self.record_motion_ratio(self.cycles.too_far());
            let Some(cycle) = next else {
                let repeats = self.repeats_at_end(self.cycles_gone);
                return walked_out.unwrap_or_else(|| self.answer(repeats, (change, 0.0), None));
            };
            change = cycle.change();
            let mut round = core::mem::replace(&mut self.round, PeriodSearch::new());
            let alone = (change <= cycle.same()).then_some((&cycle, 1));
            if let Some((closed, many)) = alone.or_else(|| round.closed_by(&cycle)) {
                let Some(more) = closed.cycles_until_closing() else {
                    let (repeats, change) =
                        (self.repeats_from(closed, Some(self.cycles_gone)), closed.change());
                    self.every = many;
                    return self.answer(repeats, (change, 0.0), Some(closed));
                };
                // Forces repeat with a period of `many` cycles, but an open gap shrinks in every period. Until the gap closes, all periods have the
                // same events and forces. These `more` periods are skipped.
                let there = closed.to.after_repeats(&closed.from, more as f64);
                if more > 0
                    && let Some(further) = self.cycles.beginning_at(&there, self.settings)
                {
                    self.note(&cycle);
                    (self.cycles, last) = (further, None);
                    self.restart_from(there, many * more);
                    continue;
                }
            }
            self.round = round;
            self.note(&cycle);
            if walked_out.is_none() && self.has_walked_out(&cycle) {
                let repeats = self.repeats_from(&cycle, Some(self.cycles_gone));
                walked_out = Some(self.answer(repeats, (change, 0.0), Some(&cycle)));
                // The object has walked beyond the range of small motions while forces still change from cycle to cycle. The answer is then a walk
                // with changing forces, unless up to twice [`KEPT_STATES`] further cycles lead to a walk with constant forces.
                most_cycles = most_cycles.min(self.followed + 2 * KEPT_STATES);
            }
            let is_alike = last.as_ref().is_some_and(|last| last.record.is_like(&cycle.record));
            self.alike = if is_alike { self.alike + 1 } else { 0 };
            if !is_alike {
                self.places.drain(..self.places.len() - 1);
            }
            self.places.push(cycle.to.clone());
            self.places.drain(..self.places.len().saturating_sub(KEPT_STATES));
            // Extrapolation is tried once three successive cycles had the same events as the cycle before, and again after every three more such
            // cycles.
            if self.alike > 0 && self.alike.is_multiple_of(3) {
                match self.extrapolate(&cycle) {
                    Extrapolation::To { limit, ratio, error } => {
                        let repeats = self.repeats_from(&limit, None);
                        return self.answer(repeats, (error, ratio), Some(&limit));
                    }
                    Extrapolation::Further { cycle, cycles, passed } => {
                        self.cycles = *cycles;
                        self.restart_from(cycle.to.clone(), passed + 1);
                        last = Some(*cycle);
                        continue;
                    }
                    Extrapolation::NotKnown => {}
                }
            }
            last = Some(cycle);
        }
        walked_out.unwrap_or_else(|| self.answer(Repeats::Undecided { doubt: None }, (change, 0.0), None))
    }

    /// Continues with the cycles from `state`, which the grasp reaches `passed` cycles after the present cycle state.
    fn restart_from(&mut self, state: CycleState, passed: usize) {
        self.places = vec![state];
        self.round = PeriodSearch::new();
        self.alike = 0;
        self.cycles_gone += passed;
    }

    /// Extrapolates from cycles that all have the same events: to the limit of their cycle states, or else over many cycles at once.
    /// [`Extrapolation::NotKnown`] if all extrapolations fail.
    ///
    /// An extrapolation is confirmed by computing the cycle that begins at the extrapolated cycle state. The states at the beginning of cycles with
    /// the same events form a convex set. If the cycles from the last and from the extrapolated cycle state have the same events, so have all skipped
    /// cycles, whose states lie in between. Two events may swap their order: this does not change the map from one cycle state to the next.
    fn extrapolate(&mut self, last: &Cycle) -> Extrapolation<'g> {
        let places = self.places.clone();
        let numbers: Vec<_> = mapped(&places, &|place| last.numbers(place));
        let Some(recurrence) = Recurrence::of(&places, &numbers, last.same()) else {
            return Extrapolation::NotKnown;
        };
        let near = if last.record.step_error > 0.0 { NEAR_THE_LIMIT_ON_ARCS } else { NEAR_THE_LIMIT };
        // A cycle state is near the limit if forces and gaps change by at most the relative number `near` in the cycle that begins there. `near` is
        // at most a thousandth of the change in the present cycle, but not below rounding. Thus, if an extrapolation fails, the next one from a later
        // cycle leads closer to the limit.
        let near = near.min(1e-3 * last.change()).max(last.same());
        let farthest = recurrence.cycles_until(near);
        let mut passed = farthest;
        // An extrapolation skips at least this many cycles, unless the limit is nearer. Its confirmation takes the load path of one cycle. If it
        // skipped fewer cycles, it would hardly be faster than following them.
        let fewest = 4;
        loop {
            let (state, predicted) = recurrence.after(passed);
            self.followed += 1;
            let tried = Cycle::beginning_at(self.engine, &self.cycles, &state, self.settings);
            let is_so = |cycle: &Cycle| {
                let error = (last.numbers(&cycle.to) - last.numbers(&cycle.from) - &predicted).amax();
                error <= last.same()
                    || (cycle.record.is_like(&last.record) && error <= 1e-3 * predicted.amax())
            };
            match tried.filter(|(cycle, _)| is_so(cycle)) {
                Some((cycle, cycles)) if passed >= fewest || passed == farthest => {
                    if passed == farthest
                        && predicted.amax() <= 2.0 * near
                        && let Some(limit) = self.limit(&recurrence, last)
                    {
                        let (error, ratio) = (limit.change(), recurrence.ratio());
                        return Extrapolation::To { limit: Box::new(limit), ratio, error };
                    }
                    return Extrapolation::Further {
                        cycle: Box::new(cycle),
                        cycles: Box::new(cycles),
                        passed,
                    };
                }
                // After a failed extrapolation the next one skips a quarter as many cycles.
                _ if passed >= 4 * fewest => passed /= 4,
                _ => return Extrapolation::NotKnown,
            }
        }
    }

    /// The cycle that begins at the limit of the cycle states. `None` if they have no limit, or if this cycle does not repeat itself or one of its
    /// gaps shrinks.
    fn limit(&mut self, recurrence: &Recurrence<'_>, last: &Cycle) -> Option<Cycle> {
        self.followed += 1;
        let there = recurrence.fixed_point().filter(|_| recurrence.ratio() < 1.0)?;
        let (limit, cycles) = Cycle::beginning_at(self.engine, &self.cycles, &there, self.settings)?;
        self.record_motion_ratio(cycles.too_far());
        // If friction falls once contacts slide, events at the limit may differ from the events just before the limit. In that case the cycle at the
        // limit does not show the behaviour of the grasp.
        let happens_there = limit.from.has_kinetic_friction.is_empty() || limit.record.is_like(&last.record);
        let is_one = limit.change() <= last.same() && limit.cycles_until_closing().is_none();
        (happens_there && is_one).then_some(limit)
    }

    /// Whether the object, or a body, has walked from rest farther than its contact points extend (their root mean square distance from their
    /// centroid). Its motion is then no longer small.
    fn has_walked_out(&self, cycle: &Cycle) -> bool {
        let is_out = |moved: &BodyMotion<3>| moved.speed() > moved.reach && moved.reach > 0.0;
        cycle.walks() && self.moves(&self.rest, &cycle.to).iter().any(is_out)
    }

    fn record_motion_ratio(&mut self, too_far: Option<TooFar>) {
        self.too_far = self.too_far.take().or(too_far);
    }

    fn note(&mut self, cycle: &Cycle) {
        self.slid.iter_mut().enumerate().for_each(|(i, slid)| *slid |= cycle.slides(i));
        self.opened.iter_mut().enumerate().for_each(|(i, opened)| *opened |= cycle.is_open(i));
        self.jumps |= cycle.record.jumps > 0;
    }

    /// The behaviour if the load path ends within cycle number `cycle`, counted from 1 for the cycle that starts at rest: the object is lost, or the
    /// behaviour is undecided.
    fn repeats_at_end(&self, cycle: usize) -> Repeats<3> {
        match self.cycles.end() {
            Some(PathEnd::Lost(loss)) => {
                let (leg, fraction) = self.cycles.place();
                let lost = Box::new(self.engine.lost(fraction, loss, self.cycles.state()));
                Repeats::Lost { cycle, leg, load: loss.load, lost }
            }
            Some(PathEnd::Undecided { doubt, .. }) => Repeats::Undecided { doubt: Some(*doubt) },
            _ => Repeats::Undecided { doubt: None },
        }
    }

    fn parts(&self, is_meant: &dyn Fn(usize) -> bool) -> Vec<WholeContact> {
        self.engine.wholes().with(is_meant)
    }

    /// The behaviour that a repeating cycle shows: rest, slips to and fro, or a walk. `number` is the number of this cycle from rest, or `None` for a
    /// cycle at the extrapolated limit.
    fn repeats_from(&self, cycle: &Cycle, number: Option<usize>) -> Repeats<3> {
        let (slides, dissipated) = (self.parts(&|i| cycle.slides(i)), cycle.record.dissipated);
        let jumps = cycle.record.jumps;
        if jumps == 0 && !any_index(self.slid.len(), &|i| cycle.slides(i)) {
            let slid = self.parts(&|i| self.slid[i]);
            return match number {
                Some(number) => Repeats::Rests { after: number - 1, slid },
                None => Repeats::DiesOut { slid },
            };
        }
        if cycle.walks() {
            return Repeats::Walks { by: self.moves(&cycle.from, &cycle.to), slides, dissipated };
        }
        let way = cycle.record.slid.iter().take(self.engine.len()).copied().most();
        Repeats::Alternates { slides, way, dissipated, jumps }
    }

    fn moves(&self, from: &CycleState, to: &CycleState) -> Vec<BodyMotion<3>> {
        self.engine.each_moves(&(&to.twist - &from.twist))
    }

    /// The answer, with the motion of each body from rest to the end of the repeating cycle `last`; if `last` is `None`, to the end of the path.
    /// `change` is the relative change of forces and gaps within the last cycle. `ratio` is the factor by which differences of successive cycle
    /// states shrink per cycle, or 0 if the limit is not extrapolated.
    fn answer(&self, repeats: Repeats<3>, (change, ratio): (f64, f64), last: Option<&Cycle>) -> Shaken<3> {
        let here = self.cycles.cycle_state();
        let at = last.map(|cycle| &cycle.to).or(here.as_ref());
        let moved = at.map(|at| self.moves(&self.rest, at)).unwrap_or_default();
        let comes_to_rest = matches!(repeats, Repeats::Rests { .. } | Repeats::DiesOut { .. });
        let slides =
            |i: usize| if comes_to_rest { self.slid[i] } else { last.is_some_and(|last| last.slides(i)) };
        let opens = |i: usize| last.is_some_and(|last| last.opens(i));
        let is_open = |i: usize| self.opened[i] || last.is_some_and(|last| last.is_open(i));
        // A drive whose force has reached its limit gives way at this constant force, and its slip stays zero. In the model each of its two limits is
        // a frictionless contact, which opens as the limit is reached.
        let is_at_limit = |i: usize| {
            let what = self.engine.part_change(i, true).map(|change| change.what);
            what == Some(DriveChange::Yields)
                && if comes_to_rest { is_open(i) } else { last.is_some_and(|last| last.is_open(i)) }
        };
        let drives = (self.engine.len()..self.slid.len()).filter(|i| slides(*i) || is_at_limit(*i));
        let mut yields: Vec<_> = drives.filter_map(|i| self.engine.part(i)).list();
        yields.dedup();
        let state = self.cycles.end().is_none().then(|| self.cycles.state()).flatten().map(Box::new);
        Shaken {
            base: self.base,
            repeats,
            every: self.every,
            cycles: self.cycles_gone,
            followed: self.followed,
            change,
            ratio,
            leaks: self.parts(&|i| is_open(i) && self.engine.contacts()[i].suction > 0.0),
            opens: self.parts(&opens),
            jumps: self.jumps || last.is_some_and(|last| last.record.jumps > 0),
            yields,
            moved,
            left_out: self.cycles.left_out,
            too_far: self.too_far.clone(),
            state,
        }
    }
}

/// The result of an extrapolation over cycles with the same events.
enum Extrapolation<'g> {
    /// The cycle states converge, and a cycle from their limit repeats itself.
    To {
        /// The cycle that begins at the limit.
        limit: Box<Cycle>,
        /// The factor by which differences of successive cycle states shrink per cycle.
        ratio: f64,
        /// The largest change of forces and gaps within `limit`.
        error: f64,
    },
    /// The limit is not reached yet, but all cycles up to `cycle` have the same events.
    Further {
        /// The cycle after the skipped cycles, computed to confirm the extrapolation.
        cycle: Box<Cycle>,
        /// The load path as it stands at the end of `cycle`, from which further cycles can be followed.
        cycles: Box<Cycles<'g>>,
        /// Number of cycles between the present cycle state and the beginning of `cycle`. These cycles are skipped.
        passed: usize,
    },
    /// All extrapolations failed.
    NotKnown,
}
