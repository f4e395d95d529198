//! Contacts with static friction, and lower kinetic friction while they slide, along a load path. A leg is a section of the load program. A jump is a
//! motion of the object, at constant load, to another equilibrium. A contact's state (open, sticking or sliding) ends where its force reaches the
//! boundary or the apex (zero force) of its cone.

use super::event::{Change, Event, PathEnd};
use super::first_exits::ExitsReached;
use super::jump::Jump;
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, Mode};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, chosen, mapped, moved, picked};
use crate::prelude::*;

impl<'g> PiecewiseFollower<'g> {
    /// If some contact has kinetic friction below its static friction, stores the present friction cone of every contact from here on. Contacts that
    /// slide at the start get kinetic friction. This may cause a jump, which the path reports as its first event. Changes nothing if the cones are
    /// stored already. The error is the end of the path, if the jump leads to no equilibrium.
    pub(super) fn with_falling_friction(mut self, run: &ProgramRun<'g>) -> Result<Self, PathEnd<3>> {
        let grasp = run.grasp;
        if self.friction_falls() || grasp.weaker_once_they_slide().next().is_none() {
            return Ok(self);
        }
        self.segment.problem.cones = mapped(grasp.sites(), &|site| site.friction);
        let slides = |i| Some((i, Change::Slides { direction: self.node.directions[i]? }));
        let changes: Vec<_> = grasp.weaker_once_they_slide().filter_map(slides).list();
        let begin = self.begin_to_slide(&changes);
        let before = self.present_state(run);
        if let Some(jump) = self.jump(run, &begin)?
            && let Some(state) = before
        {
            let (changes, drives) = grasp.contacts_and_drives(changes);
            self.first = Some(Box::new(Event {
                leg: 0,
                fraction: 0.0,
                load: run.program.load_at(0.0),
                changes,
                drives,
                free_motions: Vec::new(),
                other_continuations: None,
                state,
                jump: Some(Box::new(jump)),
            }));
        }
        Ok(self)
    }

    /// Whether some contact has kinetic friction below its static friction, so that the present friction cones are stored.
    pub(super) fn friction_falls(&self) -> bool {
        !self.segment.problem.cones.is_empty()
    }

    /// Gives static friction again to contacts with kinetic friction that do not slide. Their forces are inside the static cone, which is wider. Thus
    /// their active sets (facets of the cone on which the force lies) become empty. A contact with zero force stays at the apex of its cone.
    pub(super) fn friction_of_rest(&mut self) {
        let problem = &mut self.segment.problem;
        for (i, cone) in problem.cones.iter_mut().enumerate() {
            let rest = problem.sites[i].friction;
            if *cone != rest && !self.node.states[i].slides() {
                *cone = rest;
                if !self.node.active_sets[i].apex {
                    self.node.active_sets[i] = ActiveSet::EMPTY;
                }
            }
        }
    }

    /// `reached` are the contacts whose present states end here. Returns whether one of them has kinetic friction and no contact force left, up to
    /// the fraction 1e-9 of the largest force on the path so far. As the force of such a contact decreases to zero, it alternately sticks and slips
    /// infinitely often, which steps cannot follow.
    pub(super) fn runs_out(&self, reached: &ExitsReached) -> bool {
        let largest = self.segment.largest;
        let is_weaker = |i: usize| self.segment.problem.sites[i].kinetic.is_some();
        // A force is taken as zero if it is at most the fraction `NEGLIGIBLE` of the largest force on the path so far.
        reached.iter().any(|(i, _)| is_weaker(*i) && self.node.at.forces[*i].norm() <= NEGLIGIBLE * largest)
    }

    /// `reached` are the contacts whose present states end here. Their forces are small if they are at most the fraction `NEGLIGIBLE` of the largest
    /// force on the path so far. Contacts with small forces are put at the apex of their cones, as if they had no force. Each neglected force,
    /// divided by the largest force, is added to the step error.
    pub(super) fn put_at_apex(&mut self, reached: &ExitsReached) {
        let largest = self.segment.largest;
        for (i, _) in reached {
            let force = self.node.at.forces[*i].norm();
            if force <= NEGLIGIBLE * largest {
                self.node.active_sets[*i].apex = true;
                self.step_error += force / largest;
            }
        }
        self.stalls = 0;
    }

    /// A leg along which neither load nor commands change stands for a pause, in which contacts that slide with kinetic friction come to rest: they
    /// stick, with static friction. Returns their changes to sticking; empty on every other leg.
    pub(super) fn pause(&mut self) -> Vec<(usize, Change<3>)> {
        let segment = &self.segment;
        let is_still = matches!(&segment.trajectory, Trajectory::Straight { rate, .. } if rate.norm() == 0.0)
            && segment.change.iter().all(|change| change.norm() == 0.0);
        let slides = |i: &usize| {
            self.node.states[*i].slides() && segment.problem.cone(*i) != segment.problem.sites[*i].friction
        };
        let rest: Vec<_> = if is_still { chosen(segment.problem.len(), &slides) } else { Vec::new() };
        for &i in &rest {
            (self.node.states[i], self.node.directions[i]) = (Mode::Sticking, None);
        }
        self.friction_of_rest();
        moved(rest, &|i| (i, Change::Sticks))
    }

    /// Sets the friction of contacts after the changes `changes` of contact states. If contacts begin to slide with kinetic friction, makes and
    /// returns the jump that follows, else `None`. The error is the end of the path, if the jump leads to no equilibrium.
    pub(super) fn friction_after(
        &mut self,
        run: &ProgramRun<'g>,
        changes: &[(usize, Change<3>)],
    ) -> Result<Option<Box<Jump<3>>>, PathEnd<3>> {
        self.friction_of_rest();
        let begin = self.begin_to_slide(changes);
        Ok(self.jump(run, &begin)?.map(Box::new))
    }

    /// Indices of those contacts among `changes` that begin to slide, and have kinetic friction but still the static friction cone.
    pub(super) fn begin_to_slide(&self, changes: &[(usize, Change<3>)]) -> Vec<usize> {
        let problem = &self.segment.problem;
        let falls = |(i, change): &(usize, Change<3>)| {
            let begins = matches!(change, Change::Slides { .. } | Change::ClosesSliding { .. });
            let site = &problem.sites[*i];
            (begins && site.kinetic.is_some() && problem.cone(*i) == site.friction).then_some(*i)
        };
        picked(changes, &falls)
    }
}
