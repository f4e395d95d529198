//! Follows a load program piece by piece, from event to event, and finds the exact load of each event. With up to some hundreds of contacts this
//! takes acceptable time. A leg is a part of the program along which load and commands change linearly, or the load turns. A piece is a part of a leg
//! on which all contacts keep their states (open, sticking or sliding). A node is the point between two pieces: an event, at which contact states
//! change, or the start of a leg. A jump is a motion of the object, at constant load, to another equilibrium. A drive, the spring of a joint or
//! tendon of a hand with its force limit, is treated like a contact.
//!
//! While every contact keeps its state, forces and motions are affine in the fraction of the leg that is done. A ratio test gives the next event: the
//! first point at which a force leaves its friction cone, a gap closes, or a slip reverses ([`super::straight`]). Under a turning load forces and
//! motions are harmonics of the load's angle. The next event is then a root of a trigonometric polynomial ([`super::turning_load`]). If a contact
//! slides on a round cone, its direction of sliding turns along the piece, which is then called an arc ([`super::turning`]). At an event some contact
//! forces are on the boundary or at the apex of their friction cones, or gaps have just closed. The rates of forces and motion solve a
//! complementarity problem for these contacts. Its solution determines the next piece; without a solution the path ends.

use nalgebra::SVector;

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::{Event, PathEnd};
use super::flow::{FlowStep, Rule};
use super::follower::{Advance, Follower, StateAtEdge};
use super::following::Following;
use super::jump_leg::beyond_a_jump;
use super::leg::Leg;
use super::node::Node;
use super::pace::Pace;
use super::path::{LoadPath, Path};
use super::path_state::softest_spring_force;
use super::program_run::{ProgramRun, SearchAtRest};
use super::segment::{PathPoint, Segment};
use super::small_motions::EndOfSmallMotions;
use super::snapping_over::SnapCount;
use super::stored_piece::{ArcStep, StoredPiece};
use super::trajectory::Trajectory;
use crate::contact::{State, WEIGHTLESS};
use crate::equilibrium::{ACCURATE, Equilibrium};
use crate::error::Error;
use crate::grasp::{Engine, WholeContact, Wrench};
use crate::numerics::{Vector, chosen, largest, mapped};
use crate::object::{ForcesAndTwist, Problem};
use crate::prelude::*;
use crate::search::{Doubt, Settings};

/// The follower of a [`LoadPath`], which advances piece by piece. It stores the fraction of the present leg that is done (`factor`) and all pieces
/// that the path has passed.
#[derive(Debug)]
pub(crate) struct PiecewiseFollower<'g> {
    pub(super) factor: f64,
    pub(super) segment: Segment<'g>,
    pub(super) node: Node,
    /// Whether the path is at a node from which its continuation is still to be computed.
    pub(super) at_node: bool,
    pub(super) point: Option<PathPoint>,
    /// All pieces that the path has passed so far, the first one first, jumps included.
    pub(super) behind: Vec<StoredPiece<'g>>,
    pub(super) energy: Vec<LegEnergy>,
    /// Number of the latest pieces in a row that did not advance the path: each was no longer than the rounding error of its own length. After more
    /// than 64 such pieces, rounding is taken to make the path cycle between two continuations.
    pub(super) stalls: usize,
    pub(super) pace: Pace,
    /// The fraction of the leg at which events closer to each other than the error of a step were last treated as one event; NaN if there were none
    /// on this leg.
    pub(super) gathered: f64,
    /// The fraction of the leg at which slips last ended on an arc of this leg, and the contacts whose slips ended there. NaN if none has ended yet.
    pub(super) stopped: (f64, Vec<usize>),
    /// How often the object has snapped over on this leg, and the fraction of the leg at which it last came to rest after that. It snaps over if it
    /// moves to another equilibrium at the end of a path of equilibria.
    pub(super) snapped: SnapCount,
    /// Sum of the estimated relative errors of the path so far: errors of integration steps along arcs, on which directions of sliding turn, and
    /// errors made by treating close events as one event.
    pub(super) step_error: f64,
    /// An event to return before all others, if a contact slides at the start of the path. Its friction then falls from the static to the kinetic
    /// value.
    pub(super) first: Option<Box<Event<3>>>,
    /// The static problem at the load of a jump that led to no equilibrium. Slips and friction are those at the end of the jump. `None` if no jump
    /// has failed.
    pub(super) failed_jump: Option<Problem<'g>>,
    /// The point of the path at which a motion first exceeded its limit of small motions; `None` if no motion has exceeded its limit so far.
    pub(super) end_of_small_motions: Option<EndOfSmallMotions>,
    /// The largest ratio of a rotation, slip or opening to its limit of small motions, at the ends of all pieces so far.
    pub(super) farthest: f64,
}

impl Engine {
    pub(crate) fn follow(
        &self,
        start: &Wrench<3>,
        legs: &[Leg<3>],
        settings: &Settings,
    ) -> Result<LoadPath<'_, 3>, Error> {
        Ok(Path::new(Box::new(Following::start(self, (start, legs), settings, PiecewiseFollower::at_start)?)))
    }

    /// The load path from the load `start` along `legs`. `rest` is the result of the search for the first equilibrium, if the computation of an onset
    /// has made it already, under the same load and with the same settings.
    pub(crate) fn follow_from_rest(
        &self,
        (start, rest): (&Wrench<3>, Option<SearchAtRest>),
        legs: &[Leg<3>],
        settings: &Settings,
    ) -> Result<LoadPath<'_, 3>, Error> {
        let run = ProgramRun { rest, ..ProgramRun::new(self, start, settings)? };
        Ok(Path::new(Box::new(Following::of(run, legs, PiecewiseFollower::at_start)?)))
    }
}

impl<'g> Follower<'g> for PiecewiseFollower<'g> {
    type Report = Event<3>;

    fn start_leg(&mut self, run: &ProgramRun<'g>) -> Result<(), PathEnd<3>> {
        let cones = core::mem::take(&mut self.segment.problem.cones);
        self.segment = run.segment(core::mem::take(&mut self.segment.problem.slips));
        self.segment.problem.cones = cones;
        self.factor = 0.0;
        self.pace = Pace::new();
        self.gathered = f64::NAN;
        self.stopped.0 = f64::NAN;
        self.snapped = SnapCount::NEVER;
        self.energy.push(LegEnergy::default());
        self.at_node = true;
        Ok(())
    }

    fn advance(&mut self, run: &ProgramRun<'g>) -> Result<Advance<Event<3>>, PathEnd<3>> {
        match self.advance_unless_lost(run) {
            Err(PathEnd::Lost(loss)) => {
                let caught = self.closing_gap_event(run, &loss).or_else(|| self.snaps_over(run, &loss));
                caught.map(Advance::Reached).ok_or(PathEnd::Lost(loss))
            }
            other => other,
        }
    }

    fn fraction(&self) -> f64 {
        self.factor
    }

    fn state(&self, run: &ProgramRun<'g>) -> Option<Equilibrium<3>> {
        match self.behind.last() {
            Some(last) => self.state_on(last, last.to),
            None => self.present_state(run),
        }
    }

    fn forces(&self, _: &ProgramRun<'g>) -> Vec<SVector<f64, 3>> {
        self.node.at.forces.clone()
    }

    fn cups_open(&self, run: &ProgramRun<'g>) -> Vec<WholeContact> {
        run.grasp.cups_open(|i| self.node.states[i].is_open())
    }

    fn step_error(&self) -> f64 {
        self.step_error
    }

    fn energies(&self) -> &[LegEnergy] {
        &self.energy
    }

    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        self.end_of_small_motions.as_ref()
    }

    fn farthest(&self) -> f64 {
        self.farthest
    }

    fn all_slide_from(&self, until: (usize, f64)) -> Option<(usize, f64)> {
        self.pieces_all_slide_from(until)
    }

    fn sticks_until(&self) -> Vec<(usize, f64)> {
        let sticks = |piece: &StoredPiece<'_>| !piece.states.iter().any(State::slides);
        let ends_before_a_slip = |k: &usize| {
            let piece = &self.behind[*k];
            piece.to > piece.from && sticks(piece) && self.behind.get(k + 1).is_none_or(|next| !sticks(next))
        };
        let last = chosen(self.behind.len(), &ends_before_a_slip);
        mapped(&last, &|k| (self.behind[*k].leg, self.behind[*k].to))
    }

    fn state_behind(&self, leg: usize, fraction: f64) -> Option<Equilibrium<3>> {
        self.state_on(self.piece_behind(leg, fraction)?, fraction)
    }

    fn beyond_a_jump(&self, settings: &Settings) -> Option<Beyond<3>> {
        self.failed_jump.as_ref().map(|problem| beyond_a_jump(problem, settings))
    }

    fn edge(&self, _: &ProgramRun<'g>) -> StateAtEdge<'g> {
        let laws = self.segment.laws_of_rates(&self.node.active_sets, &self.node.states);
        let rates = self.segment.rates(self.node.ahead, laws);
        StateAtEdge { segment: self.segment.clone(), rates, forces: self.node.at.forces.clone() }
    }
}

impl<'g> PiecewiseFollower<'g> {
    /// The follower at the start of its path, at an equilibrium that solves `problem`. If no equilibrium is found, the error is the end of the
    /// path.
    pub(super) fn at_start(run: &ProgramRun<'g>, problem: &Problem<'g>) -> Result<Self, PathEnd<3>> {
        let found = run.start(problem)?;
        // The path has not begun, so load and commands have no rates yet.
        let change = run.grasp.offset_changes(None, None);
        let trajectory = Trajectory::Straight { from: problem.wrench.clone(), rate: Vector::zeros() };
        let (grasp, answer_for, problem) = (run.grasp, run.answer_for(), problem.clone());
        let mut segment = Segment { grasp, answer_for, problem, change, trajectory, largest: 0.0 };
        let node = Node::at_start(&mut segment, found);
        let mut path = Self::at_segment_start(segment, node).with_falling_friction(run)?;
        path.record_motion_ratio(run);
        Ok(path)
    }

    /// A follower at the beginning of a segment (a leg or a part of it), before any piece of the path.
    pub(super) fn at_segment_start(segment: Segment<'g>, node: Node) -> Self {
        Self {
            factor: 0.0,
            node,
            segment,
            at_node: false,
            point: None,
            behind: Vec::new(),
            energy: Vec::new(),
            stalls: 0,
            pace: Pace::new(),
            gathered: f64::NAN,
            stopped: (f64::NAN, Vec::new()),
            snapped: SnapCount::NEVER,
            step_error: 0.0,
            first: None,
            failed_jump: None,
            end_of_small_motions: None,
            farthest: 0.0,
        }
    }

    fn advance_unless_lost(&mut self, run: &ProgramRun<'g>) -> Result<Advance<Event<3>>, PathEnd<3>> {
        if core::mem::take(&mut self.at_node) {
            return Ok(self.decide(run)?.map_or(Advance::OnTheWay, Advance::Reached));
        }
        let leg_done =
            if self.node.turns() { self.advance_along_arc(run) } else { self.advance_straight(run) };
        Ok(if leg_done? { Advance::EndOfLeg } else { Advance::OnTheWay })
    }

    /// The first stored piece that contains the fraction `fraction` of the leg `leg`. `None` if the path has not passed this fraction. Also `None`
    /// between the fraction of the leg at which the object snaps over and the slightly larger one at which it rests again.
    pub(super) fn piece_behind(&self, leg: usize, fraction: f64) -> Option<&StoredPiece<'g>> {
        self.behind.iter().find(|s| s.leg == leg && fraction >= s.from && fraction <= s.to)
    }

    pub(super) fn state_on(&self, piece: &StoredPiece<'g>, fraction: f64) -> Option<Equilibrium<3>> {
        piece.state_at(self.segment.grasp, self.segment.answer_for, fraction)
    }

    /// The equilibrium at the present event with the contact states of the last piece, before the event. `None` at the start of the path, or if
    /// it cannot be computed.
    pub(super) fn state_before_event(&self) -> Option<Equilibrium<3>> {
        self.behind.last()?.state_before_event(self.segment.grasp, self.segment.answer_for)
    }

    /// Computes how the path continues from the present node. Returns an event if a contact or drive changes its state, or if nothing resists some
    /// motion any more. At the start of a leg, also returns an event if the path could continue in several ways.
    fn decide(&mut self, run: &ProgramRun<'g>) -> Result<Option<Event<3>>, PathEnd<3>> {
        if let Some(first) = self.first.take() {
            self.at_node = true;
            return Ok(Some(*first));
        }
        let before = self.state_before_event();
        let rested = if self.friction_falls() && self.factor == 0.0 { self.pause() } else { Vec::new() };
        let mut next = self.node.continue_path(&mut self.segment, run, self.factor)?;
        next.changes.splice(0..0, rested);
        let grasp = run.grasp;
        let free = self.point.as_ref().map_or(0, |point| point.free_motions.len());
        let set_free = next.point.free_motions.len() > free;
        let free_motions = mapped(&next.point.free_motions, &|v| grasp.motion_outside(v));
        self.point = Some(next.point);
        self.pace = self.pace.at_node();
        let jump = if self.friction_falls() { self.friction_after(run, &next.changes)? } else { None };
        let (changes, drives) = grasp.contacts_and_drives(next.changes);
        // At the start of a leg an event is returned if the path could continue in several ways. This holds even if no contact changes its state in
        // the way chosen.
        let branches = self.factor == 0.0 && next.other_continuations.is_some_and(|others| others > 0);
        if changes.is_empty() && drives.is_empty() && !(set_free && before.is_some()) && !branches {
            return Ok(None);
        }
        let Some(state) = before.or_else(|| self.present_state(run)) else { return Ok(None) };
        if !self.is_accurate(&state) {
            return Err(run.undecided(self.factor, Doubt::Inaccurate));
        }
        Ok(Some(Event {
            leg: run.program.leg,
            fraction: self.factor,
            load: run.program.load_at(self.factor),
            changes,
            drives,
            state,
            free_motions,
            other_continuations: next.other_continuations,
            jump,
        }))
    }

    /// Whether an equilibrium at the present point of the path is accurate: its residuals are small, or its imbalances are no larger than the
    /// rounding errors of spring forces. The second test is needed where all forces vanish together: the computed forces are then rounding errors,
    /// and residuals relative to them mean nothing.
    pub(super) fn is_accurate(&self, state: &Equilibrium<3>) -> bool {
        let worst = state.residuals.worst();
        let largest = largest(&state.contacts, &|contact| contact.force.norm());
        worst <= ACCURATE || largest * worst.min(1.0) <= self.rounding_of_forces()
    }

    /// The magnitude, N, up to which contact forces at the present point of the path count as rounding errors. It is 1e-12 ([`WEIGHTLESS`]) of the
    /// larger of two forces. These are the largest force on the path so far, and the least force that the displacements cause in a spring.
    fn rounding_of_forces(&self) -> f64 {
        let springs = softest_spring_force(&self.segment.problem_at(self.factor), &self.node.at.twist);
        WEIGHTLESS * self.segment.largest.max(springs)
    }

    /// If the contact forces and the load at the present point of the path are no larger than rounding errors, sets the contact forces to zero. If
    /// they were not set to zero, the signs of rounding errors would decide which contacts press.
    pub(super) fn let_go_of_rounding(&mut self) {
        let most =
            largest(&self.node.at.forces, &SVector::norm).max(self.segment.trajectory.at(self.factor).norm());
        if most <= self.rounding_of_forces() {
            self.node.at.forces.fill(SVector::zeros());
            for (active, state) in self.node.active_sets.iter_mut().zip(&self.node.states) {
                active.apex |= !state.is_open();
            }
        }
    }

    /// The equilibrium at the present point of the path with the present contact states; at an event these are the states after the event.
    /// `None` if the equilibrium cannot be computed because of rounding.
    pub(super) fn present_state(&self, run: &ProgramRun<'g>) -> Option<Equilibrium<3>> {
        self.state_on(&self.present_piece(run)?, self.factor)
    }

    /// The present point of the path as a piece of zero length; `None` if forces and motion there cannot be computed because of rounding.
    pub(super) fn present_piece(&self, run: &ProgramRun<'g>) -> Option<StoredPiece<'g>> {
        let point =
            match &self.point {
                Some(point) => point.clone(),
                // If the path does not continue along the leg, no rates of forces and motion exist there. The point is then computed with load and
                // commands held constant.
                None => self.node.point_at(&self.segment, self.factor, None).ok().or_else(|| {
                    self.node.point_at(&self.segment.at_rest(self.factor), self.factor, None).ok()
                })?,
            };
        let end = self.state_after(&point, 0.0);
        Some(self.piece(run, point, self.factor, end))
    }

    pub(super) fn piece(
        &self,
        run: &ProgramRun<'g>,
        point: PathPoint,
        to: f64,
        end: ForcesAndTwist,
    ) -> StoredPiece<'g> {
        StoredPiece {
            leg: run.program.leg,
            from: self.factor,
            to,
            problem: self.segment.problem.clone(),
            change: self.segment.change.clone(),
            trajectory: self.segment.trajectory.clone(),
            load: run.program.trajectory,
            bodies: run.program.bodies.clone(),
            torques: run.program.torques.clone(),
            states: self.node.states.clone(),
            here: point,
            there: end,
            arc_step: None,
            jump: None,
        }
    }

    /// Moves the path to the end `reached` of a step of the arclength `length` along an arc, and stores the step as a piece.
    pub(super) fn take_step(
        &mut self,
        run: &ProgramRun<'g>,
        point: &PathPoint,
        (length, rule): (f64, Rule),
        reached: &FlowStep,
    ) {
        let (at, to) = (reached.state(), reached.to);
        if let Some(energy) = self.energy.last_mut() {
            energy.add_part(&reached.energy);
        }
        self.step_error += reached.error;
        let arc_step = self.pace.unit.map(|unit| ArcStep { unit, length, rule });
        let piece = self.piece(run, point.clone(), to, at.clone());
        self.behind.push(StoredPiece { arc_step, ..piece });
        self.node.move_to_end(&mut self.segment, point, to, &at);
        self.factor = to;
        self.record_motion_ratio(run);
    }
}
