//! The equilibrium at a point of a path followed in steps, and the contacts that are then on the boundary of their cones (`edge` in names). A path
//! point is what is stored of the grasp at a point of the path: forces, twist, slips and contact states. A leg is a section of the load program.

use nalgebra::SVector;

use super::one_step::SteppedState;
use crate::contact::{Line, Mode, Slide, ZERO_SLACK};
use crate::equilibrium::Equilibrium;
use crate::load_path::follower::StateAtEdge;
use crate::load_path::program_run::ProgramRun;
use crate::numerics::{Reals, mapped, numbered};
use crate::search::SearchSolution;

impl SteppedState {
    /// This path point as a complete equilibrium for the caller, with residuals, computed in one pass over all contacts.
    pub(super) fn equilibrium(&self, run: &ProgramRun<'_>) -> Equilibrium<3> {
        let problem = run.segment(self.slips.clone()).problem_at(self.fraction);
        let spans =
            problem.sites.iter().zip(&problem.offsets).map(|(site, offset)| site.span(offset, &self.twist));
        let sizes = [self.largest_force().max(problem.wrench.norm()), spans.most()];
        // The slip so far is already subtracted from the offsets (command minus clearance) of the contact springs. A sliding contact therefore keeps
        // its direction of sliding, but its further slip is zero. So `lambda`, the ratio of this slip to the friction force, is set to zero.
        let standing = |state: &Mode<Slide>| match state {
            Mode::Round(slide) => Mode::Round(Slide { lambda: 0.0, ..*slide }),
            other => *other,
        };
        let states = mapped(&self.states, &standing);
        let found =
            SearchSolution { sizes, ..SearchSolution::new(states, self.forces.clone(), self.twist.clone()) };
        run.equilibrium(&problem, self.fraction, found)
    }

    /// The contact forces of this path point, and the problem for the rates of forces and motion there. A contact counts as on the boundary of its
    /// cone if the distance of its force from the boundary is at most 1e-9 of the largest force. The last steps of a path cannot resolve smaller
    /// distances.
    pub(super) fn edge<'g>(&self, run: &ProgramRun<'g>) -> StateAtEdge<'g> {
        let segment = run.segment(self.slips.clone());
        let (offsets, largest) = (segment.offsets(self.fraction), self.largest_force());
        // Two forces of a contact are taken as zero below this fraction of the largest force: the distance of its force from the boundary of its
        // cone, and the spring force that would close its gap. The last steps of a path, 1e-12 of a leg, bring a force to the boundary only within
        // this tolerance. If the fraction were smaller, the force would still count as inside its cone, and the limit load would not be recognised.
        let at_an_edge = 1e-9;
        let near = largest * (at_an_edge / ZERO_SLACK);
        let law = |i: usize| {
            let (local, state) = (segment.problem.local(i), &self.states[i]);
            let line =
                Line { force: self.forces[i], rate: SVector::zeros(), force_size: near, rate_size: 0.0 };
            let mut active = local.active_set(&line);
            if state.is_open() {
                let gap = -segment.problem.sites[i].stretch(&offsets[i], &self.twist)[0];
                active.apex = local.springs.force_along(0, gap) <= at_an_edge * largest;
            }
            local.law_of_rates(&active, state)
        };
        let laws = numbered(segment.problem.len(), &law);
        StateAtEdge { rates: segment.rates(self.fraction, laws), segment, forces: self.forces.clone() }
    }
}
