//! A jump at constant load, i.e. a motion of the object to another equilibrium: other contacts take over the force that contacts lose when their
//! friction falls from the static to the kinetic value. The drives of a hand (the springs of its joints and tendons, with their force limits) are
//! treated like contacts. A free motion is a motion that nothing resists.
//!
//! Let a contact j leave its static cone with the force F_j. At the same stretch of its springs, its force on the kinetic cone is F_j'. The
//! difference F_j - F_j' is first applied as an external force. This force is then removed along a separate leg (part of a path) at the same load W
//! and commands. The fraction τ of this leg grows from 0 to 1. G_i and G_j are the grasp maps:
//!
//! ```text
//! Σ G_i F_i + W + (1 - τ) Σ G_j (F_j - F_j') = 0,      τ from 0 to 1
//! ```
//!
//! The leg of a jump is followed like any other leg. If another contact leaves its static cone on the leg, the force that it loses is added to what
//! remains of the external force. A new leg then removes the sum. If the leg reaches its end, the jump has led to an equilibrium without an external
//! force. Otherwise equilibrium is lost on the leg. If nothing resists the object then, it moves freely until a gap closes, and the jump continues.
//! If not, the path ends with this [`Loss`]. The external force stands for the damping forces of an overdamped motion, in which the object does not
//! overshoot the new equilibrium.

use nalgebra::{Matrix, SVector};

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::{Change, ContactChange, Loss, PathEnd};
use super::flow::Rule;
use super::jump::{Jump, JumpSlip};
use super::node::Node;
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::stored_piece::{ArcStep, JumpRecord};
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, tangential_norm};
use crate::numerics::{Vector, any_index, chosen, largest, mapped};
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{Doubt, SearchOutcome, SearchSolution, Settings, settle};

pub(super) struct JumpInProgress<'g> {
    /// The leg of the jump, along which the external force in place of the lost friction is removed.
    pub(super) leg: PiecewiseFollower<'g>,
    /// The history of the jump. For each contact and drive it has the slip before the jump, and a flag that is true if it has slid in the jump so
    /// far. It also has the states of all contacts and drives after each change.
    record: JumpRecord,
    pub(super) changes: Vec<(usize, Change<3>)>,
    /// Indices of contacts and drives whose gaps have closed at the end of a free motion in the jump.
    pub(super) reaches: Vec<usize>,
}

impl<'g> JumpInProgress<'g> {
    /// A jump at the beginning of its leg `leg`. `slips` are the accumulated slips before the jump. Contacts whose slips at the beginning of the leg
    /// differ from these have slid in the jump already.
    pub(super) fn after(leg: PiecewiseFollower<'g>, slips: &[SVector<f64, 3>]) -> Self {
        let mut slid = vec![false; slips.len()];
        for (i, slip) in slips.iter().enumerate() {
            slid[i] = leg.segment.problem.slips[i] != *slip;
        }
        let record = JumpRecord { slid, slips: slips.to_vec(), states: Vec::new() };
        Self { leg, record, changes: Vec::new(), reaches: Vec::new() }
    }

    /// Follows the leg of the jump to its end, where the load is `goal`. Friction forces that further contacts lose on the leg are removed as well.
    /// If the equilibrium is lost, the object moves until a gap closes. Returns the end of the path as an error if no gap closes, or if the number of
    /// removals and free motions exceeds its limit.
    pub(super) fn run(&mut self, goal: &Vector, run: &ProgramRun<'g>) -> Result<(), PathEnd<3>> {
        // Upper limit of the number of removals of lost friction force and free motions in a jump: sixteen for each contact and drive. Each removal
        // or free motion loses energy, so that their number is finite. A number above the limit is taken as a consequence of rounding errors.
        let mut left = 16 * self.record.slid.len();
        loop {
            let begin = match self.advance_to_node(run) {
                Ok(None) => return Ok(()),
                Ok(Some(begin)) if begin.is_empty() => continue,
                Ok(Some(begin)) => begin,
                Err(PathEnd::Lost(loss)) => {
                    self.follow_free_motion(&loss, goal, run)?;
                    Vec::new()
                }
                Err(end) => return Err(end),
            };
            left = left.checked_sub(1).ok_or_else(|| run.undecided(0.0, Doubt::OnTheBoundary))?;
            if !begin.is_empty()
                && let Some(leg) = self.leg.leg_of_release(goal, &begin, run)?
            {
                self.leg = leg;
            }
        }
    }

    /// Advances along the leg of the jump towards its next event and returns an empty list; `None` at the end of the leg. At an event it
    /// computes instead how the leg continues, and returns the contacts that begin to slide with lower kinetic friction.
    fn advance_to_node(&mut self, run: &ProgramRun<'g>) -> Result<Option<Vec<usize>>, PathEnd<3>> {
        let leg = &mut self.leg;
        if !core::mem::take(&mut leg.at_node) {
            let done = if leg.node.turns() { leg.advance_along_arc(run) } else { leg.advance_straight(run) };
            return Ok(if done? { None } else { Some(Vec::new()) });
        }
        let next = leg.node.continue_path(&mut leg.segment, run, leg.factor)?;
        leg.point = Some(next.point);
        leg.pace = leg.pace.at_node();
        leg.friction_of_rest();
        let begin = leg.begin_to_slide(&next.changes);
        self.note(&next.changes);
        Ok(Some(begin))
    }

    pub(super) fn note(&mut self, changes: &[(usize, Change<3>)]) {
        self.changes.extend(changes);
        let states = &self.leg.node.states;
        self.record.slid.iter_mut().zip(states).for_each(|(slid, state)| *slid |= state.slides());
        self.record.states.push(states.clone());
    }

    /// For each contact that has slid in the jump so far, its slip since the beginning of the jump.
    fn slips(&self, run: &ProgramRun<'g>) -> Vec<JumpSlip<3>> {
        let contacts = chosen(run.grasp.len(), &|i| self.record.slid[*i]);
        let slip = |i: usize| self.leg.segment.problem.slips[i] - self.record.slips[i];
        mapped(&contacts, &|i| JumpSlip { contact: run.grasp.contacts()[*i].label(*i), slip: slip(*i) })
    }
}

impl<'g> PiecewiseFollower<'g> {
    /// The leg of the jump that begins when the contacts `begin` start to slide with kinetic friction. The friction forces that they lose are first
    /// applied to the object as an external force, which the leg removes; at its end the load is `goal`. `None` if these contacts have no force to
    /// lose, because their forces are zero. The caller then computes again how the path continues, now with kinetic friction.
    pub(super) fn leg_of_release(
        &mut self,
        goal: &Vector,
        begin: &[usize],
        run: &ProgramRun<'g>,
    ) -> Result<Option<Self>, PathEnd<3>> {
        self.at_node = true;
        let mut any = false;
        let mut segment = self.segment.at_rest(self.factor);
        let (mut states, mut forces) = (self.node.states.clone(), self.node.at.forces.clone());
        let mut from = segment.trajectory.at(0.0);
        let largest = largest(&forces, &Matrix::norm);
        let problem = &mut segment.problem;
        for &i in begin {
            problem.cones[i] = problem.sites[i].kinetic.unwrap_or(problem.cones[i]);
            let stretch = problem.stretch(i, &self.node.at.twist);
            let answer = problem.local(i).relaxed(&stretch);
            if let Some(answer) = answer.filter(|_| !ActiveSet::is_weightless(&forces[i], largest)) {
                from += &problem.sites[i].map * (forces[i] - answer.force);
                (states[i], forces[i]) = (answer.state, answer.force);
                any = true;
            } else {
                self.node.active_sets[i].apex = true;
            }
        }
        if !any {
            self.segment.problem.cones.clone_from(&problem.cones);
            return Ok(None);
        }
        // A contact that has no friction force at this point, and starts to slide on a round cone, has no direction of slip. The path is then
        // undecided.
        let has_none = |i: usize| states[i].slide().is_some() && tangential_norm(&forces[i]) == 0.0;
        if any_index(states.len(), &has_none) {
            return Err(run.undecided(0.0, Doubt::OnTheBoundary));
        }
        problem.wrench.clone_from(&from);
        let rate = goal - &from;
        segment.trajectory = Trajectory::Straight { from, rate };
        let slide_on: Vec<_> = chosen(states.len(), &|i| states[*i].slides() && !begin.contains(i));
        let mut node =
            Node::at_start(&mut segment, SearchSolution::new(states, forces, self.node.at.twist.clone()));
        node.holds.clone_from(&self.node.holds);
        for i in slide_on {
            if node.active_sets[i].is_empty() {
                node.active_sets[i] = self.node.active_sets[i].clone();
            }
        }
        segment.largest = self.segment.largest;
        let mut leg = Self { at_node: true, ..Self::at_segment_start(segment, node) };
        leg.pace.steps = self.pace.steps + 1;
        Ok(Some(leg))
    }

    /// Makes the jump that follows when the contacts `begin` start to slide with kinetic friction. `None` if the list is empty, or if these contacts
    /// have no force to lose. Returns the end of the path as an error if no equilibrium is reached.
    pub(super) fn jump(
        &mut self,
        run: &ProgramRun<'g>,
        begin: &[usize],
    ) -> Result<Option<Jump<3>>, PathEnd<3>> {
        if begin.is_empty() {
            return Ok(None);
        }
        // Contacts may alternate between sticking and sliding, with a jump each time: the smaller the fall of friction, the more jumps. Therefore
        // each jump counts as one of the steps, whose number the settings limit.
        if self.pace.steps >= run.settings.most_steps {
            return Err(run.undecided(self.factor, Doubt::OutOfSteps));
        }
        let goal = self.segment.trajectory.at(self.factor);
        let factor = self.factor;
        let end_here = |end| match end {
            PathEnd::Undecided { doubt, .. } => run.undecided(factor, doubt),
            end => end,
        };
        let Some(leg) = self.leg_of_release(&goal, begin, run).map_err(end_here)? else {
            return Ok(None);
        };
        let mut jump = JumpInProgress::after(leg, &self.segment.problem.slips);
        jump.note(&[]);
        if let Err(end) = jump.run(&goal, run) {
            let PathEnd::Lost(loss) = end else { return Err(end_here(end)) };
            let (fraction, load) = (self.factor, run.program.load_at(self.factor));
            let loss = Loss { fraction, load, jumped: jump.slips(run), ..*loss };
            self.failed_jump = Some(jump.leg.segment.problem_at(1.0));
            return Err(PathEnd::Lost(Box::new(loss)));
        }
        self.end_jump(run, &goal, jump).map(Some)
    }

    /// Moves this path to the end of the jump `jump`, under the load `goal`, and returns the jump in the form reported to users. Returns an error if
    /// the equilibrium there is not accurate enough.
    pub(super) fn end_jump(
        &mut self,
        run: &ProgramRun<'g>,
        goal: &Vector,
        jump: JumpInProgress<'g>,
    ) -> Result<Jump<3>, PathEnd<3>> {
        let slips = jump.slips(run);
        let mut segment = self.segment.clone();
        let (problem, leg) = (&mut segment.problem, jump.leg);
        let relaxed = leg.segment.problem;
        for (i, slip) in relaxed.slips.iter().enumerate() {
            problem.offsets[i] -= slip - problem.slips[i];
        }
        (problem.slips, problem.cones) = (relaxed.slips, relaxed.cones);
        segment.largest = segment.largest.max(leg.segment.largest);
        let mut after_jump = Self { factor: self.factor, ..Self::at_segment_start(segment, leg.node) };
        after_jump.let_go_of_rounding();
        let inaccurate = || run.undecided(self.factor, Doubt::Inaccurate);
        let mut place = after_jump.present_piece(run).ok_or_else(inaccurate)?;
        if after_jump.node.turns() {
            // If springs resist a motion only weakly, a solution from the contact states alone does not give the twist accurately. Therefore the
            // twist at the end of the jump's leg is stored with this point of the path, in the form of an integration step of length zero.
            place.there = after_jump.node.at.clone();
            place.arc_step = Some(ArcStep { unit: 1.0, length: 0.0, rule: Rule::Explicit });
        }
        let state = after_jump.state_on(&place, self.factor);
        let state = state.filter(|state| after_jump.is_accurate(state)).ok_or_else(inaccurate)?;
        place.jump = Some(Box::new(jump.record));
        self.segment = after_jump.segment;
        let before = core::mem::replace(&mut self.node, after_jump.node).at;
        self.step_error += leg.step_error;
        self.pace.steps = leg.pace.steps;
        let energy = self.energy_of(goal, &before.forces, &before.twist);
        if let Some(leg) = self.energy.last_mut() {
            leg.add_part(&energy);
        }
        self.point = Some(place.here.clone());
        self.behind.push(place);
        self.record_motion_ratio(run);
        let (changes, _): (Vec<ContactChange<3>>, _) = run.grasp.contacts_and_drives(jump.changes);
        let moved = run.grasp.each_moves(&(&self.node.at.twist - &before.twist));
        let (reaches, _) = run.grasp.sites_apart(jump.reaches);
        Ok(Jump { changes, slips, reaches, snaps: false, moved, energy_lost: energy.dissipated, state })
    }

    /// Energies of a jump under the constant load `load`. The jump began with the contact forces `forces` and the twist `twist`, and ended with the
    /// present ones. All work of the load that springs do not take up is dissipated.
    fn energy_of(&self, load: &Vector, forces: &[SVector<f64, 3>], twist: &Vector) -> LegEnergy {
        let works = load.component_mul(&(&self.node.at.twist - twist));
        let mut energy =
            LegEnergy { load_work: works.sum(), turnover: works.map(f64::abs).sum(), ..LegEnergy::default() };
        energy.store(self.segment.grasp.sites(), forces, &self.node.at.forces);
        energy.dissipated = energy.load_work - energy.stored;
        energy
    }
}

/// Whether any equilibrium exists at the load of a jump that did not reach an equilibrium. `problem` is the equilibrium problem at this load, in
/// which contacts that slide have kinetic friction. Returns [`Beyond::Snap`] if an equilibrium is found, [`Beyond::LimitLoad`] if no equilibrium
/// exists.
pub(super) fn beyond_a_jump(problem: &Problem<'_>, settings: &Settings) -> Beyond<3> {
    match settle(problem, settings).0 {
        SearchOutcome::Found(..) => Beyond::Snap,
        SearchOutcome::Undecided(doubt) => Beyond::Undecided { doubt },
        _ => Beyond::LimitLoad,
    }
}
