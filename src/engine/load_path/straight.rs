//! Advance along a piece of the load path on which no contact slides on a round cone. Forces and motions are affine in the fraction of the leg that
//! is done. A ratio test gives the next event, where a force reaches the boundary of its cone, a gap closes, or a slip reverses. While the load
//! turns, forces and motions are harmonics of its angle, and the event is a root of a trigonometric polynomial ([`super::turning_load`]). A leg is a
//! section of the load program. The active set of a contact has the facets of its friction cone on which its force lies. An exit of a contact is a
//! point of the leg at which its present state ends.

use super::event::PathEnd;
use super::first_exits::ExitsReached;
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::segment::PathPoint;
use super::tolerances::LARGEST_CORRECTION;
use crate::contact::Exit;
use crate::object::ForcesAndTwist;
use crate::prelude::*;
use crate::search::Doubt;

impl<'g> PiecewiseFollower<'g> {
    /// Advances along the present piece to its end: the first exit, where the present state of a contact ends, or the end of the leg. Adds the piece
    /// to the list of finished pieces. Returns whether the leg is complete.
    pub(super) fn advance_straight(&mut self, run: &ProgramRun<'g>) -> Result<bool, PathEnd<3>> {
        let Some(point) = self.point.clone() else {
            return Err(run.undecided(self.factor, Doubt::OnTheBoundary));
        };
        let rest = 1.0 - self.factor;
        let exits = self.segment.first_exits(&self.node.states, &point, rest).reached;
        // If a contact reaches the boundary of its cone at the end of the leg, up to rounding, the step ends with the leg. The facet that the force
        // has reached then enters the active set of the contact when the next leg begins.
        let at_the_end = |reached: &ExitsReached| {
            reached.iter().any(|(_, exits)| exits.iter().any(|e| (e.step - rest).abs() <= e.uncertainty))
        };
        let (step, reached, leg_done) = match exits {
            Some((_, reached)) if at_the_end(&reached) => (rest, reached, true),
            // While the load turns, the step was computed as a root of a trigonometric polynomial and refined, so it needs no correction.
            Some((step, reached)) if point.turned.is_some() && self.factor + step < 1.0 => {
                (step, reached, false)
            }
            Some((step, reached)) if self.factor + step < 1.0 => {
                let step = self.corrected(&point, step, &reached);
                if self.factor + step < 1.0 { (step, reached, false) } else { (rest, reached, true) }
            }
            Some((step, reached)) if step <= rest => (rest, reached, true),
            _ => (rest, Vec::new(), true),
        };
        let to = if leg_done { 1.0 } else { self.factor + step };
        // A step that is no longer than its own rounding error may in truth have length zero. Rounding may choose between two continuations of the
        // path that lead back to each other. If it did, the path would make such steps for ever.
        let uncertain = reached.iter().any(|(_, exits)| exits.iter().any(|exit| step <= exit.uncertainty));
        self.stalls = if to > self.factor && (leg_done || !uncertain) { 0 } else { self.stalls + 1 };
        // Up to this many steps in a row, each no longer than its own rounding error, may be events at one load. More such steps mean that
        // rounding makes the path cycle.
        let piled_up = self.stalls > 64;
        if piled_up && !self.runs_out(&reached) {
            // Two continuations of the path alternate in steps of length zero, and only rounding decides between them.
            return Err(run.undecided(self.factor, Doubt::OnTheBoundary));
        }
        let end = self.state_after(&point, step);
        if let Some(energy) = self.energy.last_mut() {
            energy.add(&self.segment, &self.node.states, &point, self.factor, step);
        }
        self.behind.push(self.piece(run, point.clone(), to, end.clone()));
        self.node.move_to_end(&mut self.segment, &point, to, &end);
        self.node.add_exits(self.segment.problem.space().axes(), &reached);
        if piled_up {
            self.put_at_apex(&reached);
        }
        self.factor = to;
        self.record_motion_ratio(run);
        self.at_node = true;
        Ok(leg_done)
    }

    /// Forces and twist after the change `step` of the fraction of the leg along the present piece, which begins at `point`. They are solved for at
    /// the new fraction, or extrapolated if that fails.
    pub(super) fn state_after(&self, point: &PathPoint, step: f64) -> ForcesAndTwist {
        let near = point.after(step);
        self.segment.state(&point.linear_problem, self.factor + step, Some(&near.twist)).unwrap_or(near)
    }

    /// Corrects `step`, the change of the fraction of the leg up to the exits `reached`. The step was extrapolated from the present path point and
    /// has the rounding error of that point. The correction follows from forces and twist at the end of the step, which are solved for directly. A
    /// correction by more than 1e-6 (`LARGEST_CORRECTION`) of the fraction of the leg there is not applied.
    fn corrected(&self, point: &PathPoint, step: f64, reached: &ExitsReached) -> f64 {
        let mut clearest: Option<(usize, &Exit)> = None;
        for (i, exits) in reached {
            for exit in exits {
                if clearest.is_none_or(|(_, known)| exit.uncertainty.total_cmp(&known.uncertainty).is_lt()) {
                    clearest = Some((*i, exit));
                }
            }
        }
        let Some((i, exit)) = clearest else { return step };
        let end = self.state_after(point, step);
        let more = self.segment.step_to_exit(i, &self.node.states[i], exit, point, self.factor + step, &end);
        if more.abs() <= LARGEST_CORRECTION * (self.factor + step) { (step + more).max(0.0) } else { step }
    }
}
