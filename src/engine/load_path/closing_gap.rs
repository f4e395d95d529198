//! Free motion of the object after a loss of equilibrium: a motion that nothing resists, until the gap of an open contact closes. The apex of a
//! friction cone is zero force. A jump is a motion of the object, at constant load, to another equilibrium. The drives of a hand (the springs of its
//! joints and tendons, with their force limits) are treated like contacts.
//!
//! If nothing resists the motion v with which the object leaves, forces stay constant along v: no spring is stretched further, and friction is
//! exhausted already. Thus the object is in balance everywhere along the motion, under the load at which equilibrium was lost. The motion ends after
//! the displacement δ v, at which the first gap closes. Contact i has the normal n_i into the object, the grasp map G_i and the gap gap_i. The
//! minimum runs over all open contacts whose gap decreases along v:
//!
//! ```text
//! δ = min gap_i / (-n_i·G_iᵀv)
//! ```
//!
//! At the closed gap the path continues at the same load, with the slips that the motion has caused. If kinetic friction is lower, contacts that
//! begin to slide lose some of their friction force. This lost force is removed first, along a separate leg ([`super::jump_leg`]), i.e. a section of
//! the path; the gap may close on this leg already. If the motion is too large for linear kinematics, it is not made, and the path ends with the
//! loss.

use super::event::{Change, Event, Loss, LossKind, PathEnd};
use super::follower::Follower;
use super::jump_leg::JumpInProgress;
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use crate::contact::{Law, LocalLaw, Mode, Resistance, ZERO_SLACK, tangential};
use crate::equilibrium::Equilibrium;
use crate::grasp::Coordinates;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, Vector, every_index, mapped};
use crate::object::ForcesAndTwist;
use crate::prelude::*;
use crate::search::SearchSolution;

use nalgebra::SVector;

/// The distance that the object moves along a motion that nothing resists, up to the gap that closes first.
struct FreeTravel {
    /// Length of the motion, as a multiple of the motion vector.
    length: f64,
    /// Indices of the contacts and drives whose gaps close at the end of the motion.
    closing: Vec<usize>,
    /// For each contact or drive: true if the motion gives it no velocity. Such a contact sticks even if its force is on the boundary of its friction
    /// cone.
    still: Vec<bool>,
}

/// Whether the object can move past this contact at `velocity` (in the contact frame) without a change of the contact force. This requires that
/// the motion stretches no spring, and that friction is at its limit against the slip. Velocities up to `none` are treated as zero.
fn lets_pass(local: &LocalLaw<'_>, force: &SVector<f64, 3>, velocity: &SVector<f64, 3>, none: f64) -> bool {
    match local.resistance(velocity) {
        Resistance::Unlimited => false,
        Resistance::BySprings(row) => every_index(local.springs.axes(), &|axis| {
            row[axis].abs() <= local.springs.force_along(axis, none)
        }),
        Resistance::ByFriction(_) if velocity[0].abs() > none => false,
        Resistance::ByFriction(_) if !local.may_slide() || tangential(velocity).norm() <= none => true,
        Resistance::ByFriction(most) => {
            // `most` is the greatest power with which friction can oppose this velocity under the present normal force; [`Resistance::ByFriction`]
            // holds this power per unit of normal stretch, so it is multiplied by the normal stretch. The tolerance 1e-10 accepts a friction force
            // whose direction is within √(2·1e-10) rad of the direction against the slip. The term `force[0] * none` allows for a normal velocity
            // that is only rounding.
            let most = most * force[0] / local.springs.force_along(0, 1.0);
            -force.dot(velocity) >= most - 1e-10 * most.abs() - force[0] * none
        }
    }
}

impl<'g> PiecewiseFollower<'g> {
    /// The free motion of the object from the present point of the path along `motion`, up to the gap that closes first. `None` if a contact resists
    /// or blocks the motion, if no gap closes, or if rotations or slips exceed the limits of small motions.
    fn free_travel(&self, motion: &Vector) -> Option<FreeTravel> {
        let grasp = self.segment.grasp;
        let offsets = self.segment.offsets(self.factor);
        let (mut still, mut gaps, mut fastest) = (Vec::new(), Vec::new(), 0.0);
        for (i, site) in grasp.sites().iter().enumerate() {
            let velocity = site.map.tr_mul(motion);
            // A contact velocity up to `none` is rounding: it is a tiny fraction of the largest velocity that any motion of the same norm could give
            // this contact.
            let none = NEGLIGIBLE * site.span_moved(&SVector::zeros(), motion.norm());
            let (local, force) = (self.segment.problem.local(i), &self.node.at.forces[i]);
            still.push(velocity.norm() <= none);
            if self.node.states[i].is_open() || self.node.active_sets[i].apex && local.may_open() {
                let gap = -site.stretch(&offsets[i], &self.node.at.twist)[0];
                let shut = ZERO_SLACK * site.span(&offsets[i], &self.node.at.twist);
                if velocity[0] < -none {
                    // The gap of this contact is closed already, so that the contact blocks the motion.
                    if gap <= shut {
                        return None;
                    }
                    gaps.push((i, gap / -velocity[0], shut / -velocity[0]));
                }
            } else if !lets_pass(&local, force, &velocity, none) {
                return None;
            } else if i < grasp.len() {
                fastest = velocity.norm().max(fastest);
            }
        }
        let length = gaps.iter().map(|(_, travel, _)| *travel).reduce(f64::min)?;
        let together = gaps.iter().filter(|(_, travel, unknown)| travel - length <= *unknown);
        let closing: Vec<usize> = together.map(|(i, ..)| *i).list();
        for &i in closing.iter().filter(|i| **i < grasp.len()) {
            fastest = grasp.sites()[i].map.tr_mul(motion).norm().max(fastest);
        }
        let small = &self.segment.answer_for.small;
        let moves = grasp.each_moves(&(motion * length));
        let turns_little = moves.iter().all(|body| body.twist.parts().1.size() <= small.rotation);
        let is_small = turns_little && fastest * length <= small.slip * grasp.size_of_grasp();
        is_small.then_some(FreeTravel { length, closing, still })
    }

    /// Lets contacts slide whose forces are on the boundary of their friction cones, and opens contacts at the apex, as the object moves along
    /// `motion`. A contact with its force on the boundary sticks if this motion gives it no velocity. Returns the changes of contact states.
    fn yield_along(
        &mut self,
        motion: &Vector,
        travel: &FreeTravel,
        run: &ProgramRun<'g>,
    ) -> Vec<(usize, Change<3>)> {
        let rates = self.edge(run).rates;
        let mut states = rates.yielding();
        for (i, state) in states.iter_mut().enumerate() {
            if travel.still[i] && matches!(rates.laws[i], Law::Edge(_)) {
                *state = Mode::Sticking;
            }
        }
        let forces = vec![SVector::zeros(); states.len()];
        let found = SearchSolution::new(states, forces, motion.clone());
        self.node.apply_rates(&mut self.segment, self.factor, &rates, &found)
    }

    /// Moves the object by `motion` times `travel.length`, until the first gap closes, at the same load. `None` if the linear system for the
    /// forces in the new contact states has no solution.
    fn move_to_gap(&mut self, motion: &Vector, travel: &FreeTravel) -> Option<()> {
        let point = self.node.point_at(&self.segment.at_rest(self.factor), self.factor, None).ok()?;
        // Forces are solved for anew in the new contact states, so that the force of a contact that has opened is exactly zero.
        let forces = mapped(&point.lines, &|line| line.force);
        let twist = &self.node.at.twist + motion * travel.length;
        self.node.move_to_end(&mut self.segment, &point, self.factor, &ForcesAndTwist { forces, twist });
        let offsets = self.segment.offsets(self.factor);
        for (i, site) in self.segment.grasp.sites().iter().enumerate() {
            if self.node.states[i].is_open() {
                let gap = -site.stretch(&offsets[i], &self.node.at.twist)[0];
                let shut = ZERO_SLACK * site.span(&offsets[i], &self.node.at.twist);
                self.node.active_sets[i].clear();
                self.node.active_sets[i].apex = gap <= shut || travel.closing.contains(&i);
            }
        }
        (self.point, self.at_node) = (None, true);
        Some(())
    }

    /// The event that replaces the loss `loss`: the object, which nothing resists, moves until a gap closes, and the path continues with this gap
    /// closed. `None` if no gap closes, if a jump from this point of the path has failed, or if no integration steps are left.
    pub(super) fn closing_gap_event(&mut self, run: &ProgramRun<'g>, loss: &Loss<3>) -> Option<Event<3>> {
        if self.failed_jump.is_some() || self.pace.steps >= run.settings.most_steps {
            return None;
        }
        let before = self.state_before_event();
        let state = before.or_else(|| self.present_state(run))?;
        let goal = self.segment.trajectory.at(self.factor);
        let leg = Self::at_segment_start(self.segment.at_rest(self.factor), self.node.clone());
        let slips = leg.segment.problem.slips.clone();
        let mut jump = JumpInProgress::after(leg, &slips);
        jump.leg.pace.steps = self.pace.steps + 1;
        let went = jump.follow_free_motion(loss, &goal, run).and_then(|lets_go| {
            let first = core::mem::take(&mut jump.changes);
            if lets_go { jump.run(&goal, run).map(|()| first) } else { Ok(first) }
        });
        let changes = went.ok()?;
        // If the equilibrium at the closed gap cannot be computed because of rounding, the path ends with the loss.
        let jump = self.end_jump(run, &goal, jump).ok()?;
        self.at_node = true;
        Some(Event { jump: Some(Box::new(jump)), ..self.caught(run, changes, state) })
    }

    /// The event that replaces a loss from which the path continues. It has the changes of contact states `changes` at the loss, and the equilibrium
    /// `state` before these changes. The caller adds the jump.
    pub(super) fn caught(
        &self,
        run: &ProgramRun<'g>,
        changes: Vec<(usize, Change<3>)>,
        state: Equilibrium<3>,
    ) -> Event<3> {
        let (changes, drives) = run.grasp.contacts_and_drives(changes);
        Event {
            leg: run.program.leg,
            fraction: self.factor,
            load: run.program.load_at(self.factor),
            changes,
            drives,
            free_motions: Vec::new(),
            other_continuations: None,
            state,
            jump: None,
        }
    }
}

impl<'g> JumpInProgress<'g> {
    /// Continues the jump after `loss`, a loss of equilibrium on the jump's present leg. If contacts begin to slide with lower kinetic friction,
    /// starts a new leg, along which the friction force that they lose is removed, and returns true. Otherwise moves the object until a gap closes,
    /// and returns false.
    ///
    /// # Errors
    /// The loss `loss`, if no gap closes.
    pub(super) fn follow_free_motion(
        &mut self,
        loss: &Loss<3>,
        goal: &Vector,
        run: &ProgramRun<'g>,
    ) -> Result<bool, PathEnd<3>> {
        let lost = || PathEnd::Lost(Box::new(loss.clone()));
        let motion: Option<Vector> = loss.leaves.as_ref().map(Coordinates::to);
        let motion = motion.filter(|_| loss.kind != LossKind::LetsGo).ok_or_else(lost)?;
        let travel = self.leg.free_travel(&motion).ok_or_else(lost)?;
        let changes = self.leg.yield_along(&motion, &travel, run);
        let begin = self.leg.begin_to_slide(&changes);
        if !begin.is_empty()
            && let Some(leg) = self.leg.leg_of_release(goal, &begin, run)?
        {
            self.leg = leg;
            self.note(&changes);
            return Ok(true);
        }
        self.note(&changes);
        self.leg.move_to_gap(&motion, &travel).ok_or_else(lost)?;
        self.reaches.extend(travel.closing);
        Ok(false)
    }
}
