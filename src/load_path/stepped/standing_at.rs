//! Where a path stands, as physics, and what stands on an edge there.

use nalgebra::SVector;

use super::one_step::SteppedState;
use crate::contact::{Line, Mode, Slide, ZERO_SLACK};
use crate::equilibrium::Equilibrium;
use crate::load_path::follower::StandAtEdge;
use crate::load_path::journey::Journey;
use crate::numerics::Size;
use crate::search::Found;

/// Friction in reserve, and forces that a gap would take to close, below this part of the largest force are none: the last steps are parts of
/// 1e-12 of a leg. With less a contact that such a step would bring to its edge still holds, and the limit is not seen.
const AT_AN_EDGE: f64 = 1e-9;

impl<D: Size, const C: usize> SteppedState<D, C> {
    /// The whole equilibrium. One pass over all contacts.
    pub(super) fn equilibrium(&self, journey: &Journey<'_, D, C>) -> Equilibrium<C> {
        let problem = journey.segment(self.slips.clone()).problem_at(self.fraction);
        let spans =
            problem.sites.iter().zip(&problem.drives).map(|(site, drive)| site.span(drive, &self.twist));
        let sizes = [self.largest_force().max(problem.wrench.norm()), spans.fold(0.0, f64::max)];
        // All slip so far is memory: what is left of a slide is its direction.
        let standing = |state: &Mode<Slide<C>>| match state {
            Mode::Round(slide) => Mode::Round(Slide { lambda: 0.0, ..*slide }),
            other => *other,
        };
        let states = self.states.iter().map(standing).collect();
        let found = Found { sizes, ..Found::new(states, self.forces.clone(), self.twist.clone()) };
        journey.equilibrium(&problem, self.fraction, found)
    }

    /// The rates, with edges as near as the last steps can tell.
    pub(super) fn edge<'g>(&self, journey: &Journey<'g, D, C>) -> StandAtEdge<'g, D, C> {
        let segment = journey.segment(self.slips.clone());
        let (drives, largest) = (segment.drives(self.fraction), self.largest_force());
        let near = largest * (AT_AN_EDGE / ZERO_SLACK);
        let law = |i: usize| {
            let (local, state) = (segment.problem.local(i), &self.states[i]);
            let line =
                Line { force: self.forces[i], rate: SVector::zeros(), force_size: near, rate_size: 0.0 };
            let mut stand = local.stand(&line);
            if state.is_open() {
                let gap = -segment.problem.sites[i].stretch(&drives[i], &self.twist)[0];
                stand.apex = local.springs.force_along(0, gap) <= AT_AN_EDGE * largest;
            }
            local.law_of_rates(&stand, state)
        };
        let laws = (0..segment.problem.len()).map(law).collect();
        StandAtEdge { rates: segment.rates(self.fraction, laws), segment, forces: self.forces.clone() }
    }
}
