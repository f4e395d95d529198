//! Advance along a piece of the load path on which no contact slides on a round cone. Forces and motions are affine in the fraction of the leg. A
//! ratio test gives the next event, where a force reaches an edge of its cone, a gap closes, or a slip reverses. While the load turns, forces and
//! motions are harmonics of its angle, and the event is a root of a trigonometric polynomial ([`super::turning_load`]). A leg is a section of the
//! load program; the load factor is the fraction of it that is done. The active set of a contact has the edges of its cone on which its force lies.
//! An exit of a contact is a load factor at which its present state ends.

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
        // If a contact reaches an edge of its cone at the end of the leg, up to rounding, the step ends with the leg. The edge then enters the
        // active set of the contact when the next leg begins.
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
        // path that lead back to each other. The path would then make such steps for ever.
        let uncertain = reached.iter().any(|(_, exits)| exits.iter().any(|exit| step <= exit.uncertainty));
        self.stalls = if to > self.factor && (leg_done || !uncertain) { 0 } else { self.stalls + 1 };
        // Up to this many steps in a row, each no longer than its own rounding error, may be events at one load. More such steps mean that
        // rounding makes the path cycle.
        let piled_up = self.stalls > 64;
        if piled_up && !self.runs_out(&reached) {
            // Two continuations of the path alternate in steps of length zero, and only rounding would decide between them.
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

    /// Forces and twist after the change `step` of the load factor along the present piece, which begins at `point`. The state is solved for at the
    /// new load factor, or extrapolated if that fails.
    pub(super) fn state_after(&self, point: &PathPoint, step: f64) -> ForcesAndTwist {
        let near = point.after(step);
        self.segment.state(&point.linear_problem, self.factor + step, Some(&near.twist)).unwrap_or(near)
    }

    /// Corrects `step`, the change of the load factor up to the exits `reached`. The step was extrapolated from the present state and has the
    /// rounding error of this state. The correction follows from the state at the end of the step, which is solved for directly. A correction by more
    /// than 1e-6 of the load factor (`LARGEST_CORRECTION`) is not applied.
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
