//! Which friction a contact has: that of rest, or as long as it slides a lower one.

use super::event::{Change, Event, PathEnd};
use super::journey::Journey;
use super::jump::Jump;
use super::pieces::Pieces;
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, Mode};
use crate::numerics::Size;

impl<'g, D: Size, const C: usize> Pieces<'g, D, C> {
    /// From rest on every contact has a cone of its own, if some are weaker once they slide. Those that slide already do with less. Cones that are given
    /// are those of contacts that were on their way.
    pub(super) fn with_falling_friction(mut self, journey: &Journey<'g, D, C>) -> Result<Self, PathEnd<C>> {
        let grasp = journey.grasp;
        if self.friction_falls() || grasp.weaker_once_they_slide().next().is_none() {
            return Ok(self);
        }
        self.segment.problem.cones = grasp.sites().iter().map(|site| site.friction).collect();
        let slides = |i| Some((i, Change::Slides { direction: self.node.directions[i]? }));
        let changes: Vec<_> = grasp.weaker_once_they_slide().filter_map(slides).collect();
        let begin = self.begin_to_slide(&changes);
        let before = self.present_state(journey);
        if let Some(jump) = self.jump(journey, &begin)?
            && let Some(state) = before
        {
            let (changes, drives) = grasp.contacts_and_drives(changes);
            self.first = Some(Box::new(Event {
                leg: 0,
                fraction: 0.0,
                load: journey.program.load_at(0.0),
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

    /// Whether the friction of some contacts falls as they begin to slide.
    pub(super) fn friction_falls(&self) -> bool {
        !self.segment.problem.cones.is_empty()
    }

    /// What does not slide has its friction of rest, and is inside that cone.
    pub(super) fn friction_of_rest(&mut self) {
        let problem = &mut self.segment.problem;
        for (i, cone) in problem.cones.iter_mut().enumerate() {
            let rest = problem.sites[i].friction;
            if *cone != rest && !self.node.states[i].slides() {
                *cone = rest;
                if !self.node.stands[i].apex {
                    self.node.stands[i] = ActiveSet::NOWHERE;
                }
            }
        }
    }

    /// On a leg along which nothing changes, time passes: what slid comes to rest.
    pub(super) fn pause(&mut self) -> Vec<(usize, Change<C>)> {
        let segment = &self.segment;
        let is_still = matches!(&segment.course, Trajectory::Straight { rate, .. } if rate.norm() == 0.0)
            && segment.change.iter().all(|change| change.norm() == 0.0);
        let slides = |i: &usize| {
            self.node.states[*i].slides() && segment.problem.cone(*i) != segment.problem.sites[*i].friction
        };
        let rest: Vec<_> =
            if is_still { (0..segment.problem.len()).filter(slides).collect() } else { Vec::new() };
        for &i in &rest {
            (self.node.states[i], self.node.directions[i]) = (Mode::Sticking, None);
        }
        self.friction_of_rest();
        rest.into_iter().map(|i| (i, Change::Sticks)).collect()
    }

    /// The friction that contacts have after these changes, and the jump that comes of it if some begin to slide.
    pub(super) fn friction_after(
        &mut self,
        journey: &Journey<'g, D, C>,
        changes: &[(usize, Change<C>)],
    ) -> Result<Option<Box<Jump<C>>>, PathEnd<C>> {
        self.friction_of_rest();
        let begin = self.begin_to_slide(changes);
        Ok(self.jump(journey, &begin)?.map(Box::new))
    }

    /// Those that begin to slide with less friction than at rest.
    pub(super) fn begin_to_slide(&self, changes: &[(usize, Change<C>)]) -> Vec<usize> {
        let problem = &self.segment.problem;
        let falls = |(i, change): &(usize, Change<C>)| {
            let begins = matches!(change, Change::Slides { .. } | Change::ClosesSliding { .. });
            let site = &problem.sites[*i];
            (begins && site.kinetic.is_some() && problem.cone(*i) == site.friction).then_some(*i)
        };
        changes.iter().filter_map(falls).collect()
    }
}
