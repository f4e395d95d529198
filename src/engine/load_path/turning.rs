//! Advances step by step to the next event (change of contact states) along an arc, a piece of the load path. On an arc directions of sliding turn on
//! the round cone. A leg is a section of the load program; λ is the fraction of the leg that is done. A margin is the distance of a contact force
//! from the boundary of its friction cone.
//!
//! Steps are in arclength, measured along the curve of the twist, divided by a unit of displacement, and of λ ([`super::flow`]). They are as long as
//! the allowed error of the settings permits. An event is the point where one of these values vanishes. The first three lines are for a contact in
//! the given state, the last line is for the path as a whole:
//!
//! ```text
//! sticking  μ F_n - |F_t|, or F_n where friction is infinite or zero
//! open      the gap
//! sliding   the slip rate along the friction force, and F_n
//! path      the rate of λ, and the rest of the leg
//! ```
//!
//! The event is found by repeating the last step with other lengths until the step ends at the event ([`super::crossing`]).

use crate::numerics::IntoList;
use nalgebra::SVector;

use super::crossing::StepEnd;
use super::event::{LossKind, PathEnd};
use super::first_exits::ExitsReached;
use super::flow::{Flow, Rule};
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::segment::PathPoint;
use super::tolerances::STANDS_STILL;
use super::trajectory::Trajectory;
use super::watched_condition::{ConditionValue, WatchedCondition, watch};
use super::within_a_step::first_dip;
use crate::contact::{ActiveSet, Exit, Line, Mode, State, ZERO_SLACK, tangential};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::prelude::*;
use crate::search::Doubt;

impl<'g> PiecewiseFollower<'g> {
    /// Tries one step along the arc. The step ends early if an event comes first. If the integration error of the step is too large, the step is
    /// refused: the path does not advance, and the next step is shorter. Returns whether the leg is complete; an `Err` is the end of the path.
    pub(super) fn advance_along_arc(&mut self, run: &ProgramRun<'g>) -> Result<bool, PathEnd<3>> {
        // An object that snaps over to another equilibrium may come to rest under the load at the end of the leg. The leg is then complete.
        if self.factor >= 1.0 {
            return Ok(true);
        }
        let Some(point) = self.point.take() else {
            return Err(run.undecided(self.factor, Doubt::OnTheBoundary));
        };
        // After an event the unit of displacement is chosen so that the object's motion and λ have equal weight in the arclength.
        let point = if self.pace.unit.is_some() {
            point
        } else {
            let unit = self.displacement_rate(&point);
            self.pace.unit = Some(unit);
            point.slowed(1.0 / (&point.twist_rate / unit).norm().hypot(1.0))
        };
        self.point = Some(point.clone());
        if self.slides_away(&point) {
            return Err(self.loss_at_end(run, LossKind::Asymptote, &point));
        }
        if self.pace.steps >= run.settings.most_steps {
            return Err(run.undecided(self.factor, Doubt::OutOfSteps));
        }
        if let Some(length) = self.straight_length(&point)
            && let Some(end) = self.step(&point, (length, 0), Rule::Straight)
            && let Some(end) = self.up_to_a_break(&point, end)
        {
            self.node.starts_at_apex = false;
            return self.finish_step(run, &point, &end);
        }
        let length = self.pace.length.unwrap_or_else(|| self.first_length(&point));
        let length = length.min(self.way_to_apex(&point)).min(self.part_of_a_turn(&point));
        let tolerance = run.settings.step_error * self.pace.error_factor;
        let (length, rule) = self.stable(&point, length, tolerance);
        // If the arclength of a step is at most this fraction of λ, the step changes λ by rounding only. The arc then cannot be followed further with
        // the present contact states.
        if length <= 1e-13 * self.factor.max(f64::EPSILON) {
            if self.node.release_vanishing(&point) {
                self.at_node = true;
            } else if self.stops_for_good(tolerance) {
                return Err(self.loss_at_end(run, LossKind::Corner, &point));
            } else if !self.pace.allow_larger_error(1.0 - self.factor) {
                let gathered = if self.may_gather() { self.node.gather(&self.segment, &point) } else { None };
                let Some(apart) = gathered else {
                    return Err(run.undecided(self.factor, Doubt::Inaccurate));
                };
                self.step_error += apart;
                (self.at_node, self.gathered) = (true, self.factor);
            }
            return Ok(false);
        }
        let end = self.step(&point, (length, 0), rule);
        let missed = end.as_ref().map_or(f64::INFINITY, |end| end.reached.error / tolerance);
        let Some(end) = end.filter(|_| missed <= 1.0) else {
            self.pace.refuse(length, missed);
            return Ok(false);
        };
        let end = self.up_to_a_crossing(&point, end, tolerance);
        let Some(end) = end.filter(|end| end.located.is_some() || !end.reached.backwards) else {
            self.pace.refuse(length, f64::INFINITY);
            return Ok(false);
        };
        self.finish_step(run, &point, &end)
    }

    /// The step `end` from `point`, shortened so that it ends where the value of a condition (one of the values that the head of this file lists)
    /// first becomes zero. A condition that is violated only within the step, and holds again at its end, is found, too. `None` if the end of the
    /// shortened step is not found.
    fn up_to_a_crossing(&self, point: &PathPoint, mut end: StepEnd, tolerance: f64) -> Option<StepEnd> {
        let start = watch(&self.segment, &self.node.states, (self.factor, point));
        let mut looks = 0;
        loop {
            if let Some(condition) = Self::first_crossing(&start, &end) {
                end = self.locate(point, &start, end, condition)?;
            }
            let ends = [point, &end.reached.point];
            // The bounds on margins within a step are used on a straight leg only. If they were used while the load turns, they would shorten steps
            // needlessly.
            let is_straight = matches!(self.segment.trajectory, Trajectory::Straight { .. });
            let dip = is_straight
                .then(|| first_dip(&self.segment, &self.node.states, ends, (end.length, tolerance)))
                .flatten();
            // A step within which a condition for a contact state may be violated is shortened. After twenty shortenings the step is made as it is.
            let Some(part) = dip.filter(|_| looks < 20) else { return Some(end) };
            looks += 1;
            end = self.step(point, (part * end.length, 0), end.rule)?;
        }
    }

    /// Whether some contact whose slip has ended at the present point of the path can neither stick nor slide on.
    fn stops_for_good(&self, tolerance: f64) -> bool {
        let (at, contacts) = &self.stopped;
        // Fractions of the leg that differ by less than this are taken as the same point of the path.
        let is_here = (self.factor - at).abs() <= NEGLIGIBLE;
        is_here && contacts.iter().any(|contact| self.neither_sticks_nor_slides(*contact, tolerance))
    }

    /// Whether forces nearly on the boundary of their cones may now be treated as on it, and nearly closed gaps as closed. Events that are close
    /// together then happen at one point of the path. This is done at most once at the same fraction of the leg.
    fn may_gather(&self) -> bool {
        self.gathered.is_nan() || (self.factor - self.gathered).abs() > NEGLIGIBLE
    }

    /// The arclength along which the load turns by a quarter of a radian; infinite for a load that changes linearly. Along a longer step a contact
    /// may violate the condition of its state, and yet satisfy it again at the end.
    fn part_of_a_turn(&self, point: &PathPoint) -> f64 {
        match self.segment.trajectory {
            // In one integration step the load turns by at most this angle, rad.
            Trajectory::Turn { angle, .. } => 0.25 / (angle * point.factor_rate.abs()),
            Trajectory::Straight { .. } => f64::INFINITY,
        }
    }

    /// Arclength, at most `length`, and integration rule of a step in which the integration is stable. Stability depends on how fast friction
    /// forces relax, i.e. turn towards the directions of slip.
    fn stable(&mut self, point: &PathPoint, length: f64, tolerance: f64) -> (f64, Rule) {
        let unit = self.pace.unit.unwrap_or(1.0);
        let flow = Flow::new(&self.segment, &self.node.states, self.factor, point, unit);
        // The longest explicit step is four times the length over which the fastest direction of friction relaxes towards the slip. Steps longer than
        // about six such lengths are unstable.
        let stable = 4.0 / flow.fastest_relaxation();
        let rest = (1.0 - self.factor) / point.factor_rate;
        self.pace.implicit |= self.pace.needs_implicit_steps(stable, rest);
        if self.pace.implicit && length > stable {
            (length, Rule::Implicit { tolerance })
        } else {
            (length.min(stable), Rule::Explicit)
        }
    }

    /// Whether the rates of λ and of all contact forces are zero within rounding, although the object moves. λ then tends to a limit that it never
    /// reaches (an asymptote). The tolerance for a sliding contact's force is proportional to the rate at which its friction turns towards its slip,
    /// as rounding is. Contacts that do not slide take up the rounding of all others, so their tolerance is the largest.
    fn slides_away(&self, point: &PathPoint) -> bool {
        if point.factor_rate.abs() > STANDS_STILL {
            return false;
        }
        let unit = self.pace.unit.unwrap_or(1.0);
        let flow = Flow::new(&self.segment, &self.node.states, self.factor, point, unit);
        let mut still = vec![flow.fastest_relaxation(); point.lines.len()];
        flow.relaxations().for_each(|(contact, rate)| still[contact] = rate);
        let still = still.into_iter().map(|rate| STANDS_STILL * point.sizes[0] * rate.max(1.0));
        point.lines.iter().zip(still).all(|(line, still)| line.rate.norm() <= still)
    }

    /// Arclength of a step straight along the tangent of the path; `None` if the next step need not be straight. A straight step is made in two
    /// cases. It leads away from the apex of a cone, where a friction force has no direction yet. Or it leads to the point at which a normal force
    /// that is almost zero vanishes.
    fn straight_length(&self, point: &PathPoint) -> Option<f64> {
        let rest = (1.0 - self.factor) / point.factor_rate;
        let last = point.lines.iter().zip(&self.node.states).filter_map(way_to_nothing);
        // If a normal force that is almost zero vanishes within the leg, the straight step ends where it vanishes. If it vanishes beyond the end of
        // the leg, by less than the rest of the leg, one straight step leads to this end. If instead a step of the integration stopped short of this
        // end, the normal force would count as zero at the beginning of the next step.
        if let Some(way) = last.reduce(f64::min).filter(|way| *way < 2.0 * rest) {
            return Some(way.min(rest));
        }
        let force_way = point.sizes[0] / point.rate_sizes[0];
        // `force_way` is the arclength along which forces change by their own magnitude. If it is at most 1e-12 (`SOLVED_ROUNDING`) of the rest of
        // the leg, all forces are rounding errors. The rest of the leg is then used in its place.
        let way = if force_way > SOLVED_ROUNDING * rest { rest.min(force_way) } else { rest };
        // The first step from the apex of a cone is 1e-6 of the length along which forces change by their own magnitude. The direction of friction is
        // taken as constant in this step, with an error of about the square of 1e-6.
        self.node.starts_at_apex.then_some(1e-6 * way)
    }

    fn first_length(&self, point: &PathPoint) -> f64 {
        let mut length = (1.0 - self.factor) / point.factor_rate;
        for (line, state) in point.lines.iter().zip(&self.node.states) {
            let (f, df) = (&line.force, &line.rate);
            // A contact that has just closed has no friction force yet, and so no direction of friction.
            let touches = ActiveSet::is_weightless(f, line.force_size);
            if state.slides() && !touches {
                let turn = (f[1] * df[2] - f[2] * df[1]).abs() / (f[1] * f[1] + f[2] * f[2]);
                // Along the first step no direction of friction turns by more than this angle (rad), at its initial rate. Longer first steps have, as
                // a rule, too large an error and are refused; shorter ones cost additional steps.
                let first_turn = 0.3;
                if turn.is_finite() && turn * length > first_turn {
                    length = first_turn / turn;
                }
            }
        }
        length
    }

    fn way_to_apex(&self, point: &PathPoint) -> f64 {
        let mut way = f64::INFINITY;
        for (line, state) in point.lines.iter().zip(&self.node.states) {
            if state.slides()
                && line.rate[0] < -ZERO_SLACK * line.rate_size
                && !ActiveSet::is_weightless(&line.force, line.force_size)
            {
                // A step covers at most half of the arclength after which a sliding contact loses its normal force. Near that point directions of
                // friction may turn ever faster.
                way = way.min(0.5 * line.force[0] / -line.rate[0]);
            }
        }
        way
    }

    /// Moves the path to the end `end` of an accepted step from `point`. A contact force may reach the boundary or the apex of its cone at this end.
    /// Then the facet (on the round cone, the tangent plane) or the apex is added to the active set of its contact. Returns whether the leg is
    /// complete; an `Err` is a loss of equilibrium at a maximum of the load.
    fn finish_step(
        &mut self,
        run: &ProgramRun<'g>,
        point: &PathPoint,
        end: &StepEnd,
    ) -> Result<bool, PathEnd<3>> {
        let tolerance = run.settings.step_error * self.pace.error_factor;
        self.pace.accept(end.length, end.reached.error / tolerance, end.located.is_some());
        let to = end.reached.to;
        let leg_done = to >= 1.0;
        // Whether the load has a maximum at the end of the step: its rate is zero there.
        let grows = |watch: &ConditionValue| watch.what == WatchedCondition::Growth && watch.is_met();
        let tops = end.located.is_some() && end.watches.iter().any(grows);
        let next = end.reached.point.clone();
        let mut at_edge: ExitsReached = Vec::new();
        let (mut sticks, mut stops) = (Vec::new(), false);
        for (k, watch) in end.watches.iter().enumerate() {
            if end.located != Some(k) && !(watch.is_met() && watch.falls()) {
                continue;
            }
            let WatchedCondition::Contact(contact) = watch.what else { continue };
            let line = &next.lines[contact];
            match self.node.states[contact] {
                Mode::Open => at_edge.push((contact, vec![apex()])),
                Mode::Sticking => {
                    let rubs = self.segment.problem.local(contact).may_slide();
                    let facet = if rubs { tangential(&line.force).normalize() } else { SVector::zeros() };
                    at_edge.push((contact, vec![Exit { facet, ..apex() }]));
                }
                // At the end of a leg, a slip rate of zero does not matter, since the next leg has other rates.
                _ if leg_done => {}
                // If the load turns back at this point of the path, all slips stop. The rates of the load just after this point then determine
                // which contacts slide on.
                _ if self.segment.load_turns_back(to) => stops = true,
                _ => sticks.push(contact),
            }
        }
        for (i, state) in self.node.states.iter().enumerate() {
            let (size, force) = (next.lines[i].force_size, &next.lines[i].force);
            // A straight step up to the point at which a normal force vanishes may leave a small remainder of this force. The remainder is too small
            // to determine the direction of friction, so the contact is taken as without force.
            let is_gone = end.rule == Rule::Straight
                && way_to_nothing((&point.lines[i], state)).is_some_and(|way| way <= end.length);
            if state.slides() && (is_gone || ActiveSet::is_weightless(force, size)) {
                at_edge.push((i, vec![apex()]));
            }
        }
        stops |= !at_edge.is_empty() || !sticks.is_empty();
        let idle = self.stands_still(point, &sticks);
        if !sticks.is_empty() {
            self.stopped = (to, sticks.clone());
        }
        self.take_step(run, point, (end.length, end.rule), &end.reached);
        self.node.add_exits(self.segment.problem.space().axes(), &at_edge);
        // If no other event happens at this point, all contacts in `sticks`, whose slip has ended, stick from now on. If there is another event, this
        // holds only for contacts that slipped in the step; the solution for the rates at the other event determines the states of the others.
        for contact in sticks.iter().filter(|contact| at_edge.is_empty() || !idle.contains(contact)) {
            self.node.stick(*contact);
        }
        self.at_node = leg_done || stops;
        // A maximum at the end of a leg does not end the path: the next leg may change the load in another direction.
        let lost = (tops && !leg_done).then(|| self.loss_at_end(run, LossKind::Fold, &next));
        self.point = Some(next);
        lost.map_or(Ok(leg_done), Err)
    }

    /// Selects, from the contacts `contacts`, those that do not slip at all in a step. At the end of the step all of `contacts` have a slip rate of
    /// zero. The selected ones have a slip rate of zero already at `point`, the beginning of the step.
    fn stands_still(&self, point: &PathPoint, contacts: &[usize]) -> Vec<usize> {
        if contacts.is_empty() {
            return Vec::new();
        }
        let start = watch(&self.segment, &self.node.states, (self.factor, point));
        let met = |contact: &usize| {
            start.iter().any(|watch| watch.what == WatchedCondition::Contact(*contact) && watch.is_met())
        };
        contacts.iter().copied().filter(met).list()
    }

    /// The loss of equilibrium of the kind `kind` at the present point of the path, the end of an arc. The object leaves with the twist rate of
    /// `point`.
    fn loss_at_end(&self, run: &ProgramRun<'g>, kind: LossKind, point: &PathPoint) -> PathEnd<3> {
        let slides = (0..self.node.states.len()).filter(|i| self.node.states[*i].slides());
        let motion = point.twist_rate.normalize();
        PathEnd::Lost(Box::new(run.loss(self.factor, kind, slides.list(), Some(&motion))))
    }
}

/// For a sliding contact whose normal force is almost zero and decreases, the arclength along the tangent up to the point where this force
/// vanishes. `None` for any other contact.
fn way_to_nothing((line, state): (&Line, &State)) -> Option<f64> {
    let falls = state.slides() && line.rate[0] < -ZERO_SLACK * line.rate_size;
    // A decreasing normal force below this fraction of the terms whose sum it is no longer determines the direction of friction, which further
    // integration needs. Such a force is followed to zero along the tangent of the path.
    let little = falls && line.force[0] > 0.0 && line.force[0] <= 1e-10 * line.force_size;
    little.then(|| line.force[0] / -line.rate[0])
}

/// The exit (where a contact leaves its state) of a contact whose normal force or gap vanishes at the present point of the path.
fn apex() -> Exit {
    Exit { step: 0.0, uncertainty: 0.0, facet: SVector::zeros() }
}
