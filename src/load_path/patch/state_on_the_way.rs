//! The state on the way, as physics.

use nalgebra::SVector;

use super::moving_contact::MovingContact;
use super::patch_path::PatchPath;
use crate::contact::State;
use crate::equilibrium::{Cone, Equilibrium};
use crate::grasp::Site;
use crate::load_path::segment::Segment;
use crate::object::Load;
use crate::search::{Effort, Found, Rung};

impl<'g, const D: usize, const C: usize> PatchPath<'g, D, C> {
    /// Where the path stands: the whole equilibrium there, with residuals recomputed from the
    /// grasp, the load and the slip so far; `None` if there was none to start from. It is not
    /// checked against them: look at the residuals. Just after an event the states are those with
    /// which the path goes on. One pass over all contacts.
    #[must_use]
    pub fn state(&self) -> Option<Equilibrium<D, C>> {
        let Self { balance, trial, .. } = self;
        if balance.contacts.is_empty() {
            return None;
        }
        let (y, tau) = (balance.balanced(), balance.tau);
        let segment = self.segment();
        let problem = segment.problem_at(tau);
        let twist = balance.twist(trial, &y);
        // What vanishes here is known up to the rounding of what it was at the beginning of the
        // leg.
        let mut largest = problem.wrench.norm() + segment.course.rate_at(tau).norm() * tau;
        let mut travel = 0.0_f64;
        let forces = self.forces_at(&y);
        for (i, (contact, site)) in balance.contacts.iter().zip(self.grasp.sites()).enumerate() {
            let rate = balance.force_rate(contact).component_mul(&site.springs.root());
            largest = largest.max(forces[i].norm() + rate.norm() * tau);
            travel = travel.max(site.span(&problem.drives[i], &twist));
        }
        let states = balance.contacts.iter().map(|contact| State::from(contact.state)).collect();
        let found = Found {
            free_motions: balance.free_motions(trial),
            sizes: [largest, travel],
            ..Found::new(states, forces, twist)
        };
        let (load, cone) = (self.program.load_at(tau), self.cone_answered());
        Some(self.grasp.equilibrium(&problem, &load, &found, Rung::LoadPath, &Effort::default(), cone))
    }

    /// Forces on the object in the contact frames where the path stands, N: (`F_n`, `F_t`…), in the
    /// order of the grasp; empty if there was no equilibrium to start from. Cheaper than
    /// [`Self::state`].
    #[must_use]
    pub fn forces(&self) -> Vec<SVector<f64, C>> {
        self.forces_at(&self.balance.balanced())
    }

    fn forces_at(&self, y: &SVector<f64, D>) -> Vec<SVector<f64, C>> {
        let force = |(contact, site): (&MovingContact<D, C>, &Site<D, C>)| {
            let x = contact.force(&contact.stretch(y, self.balance.tau), self.balance.facets(contact));
            x.component_mul(&site.springs.root())
        };
        self.balance.contacts.iter().zip(self.grasp.sites()).map(force).collect()
    }

    pub(super) fn cone_answered(&self) -> Cone {
        Cone::of::<C>(&self.settings)
    }

    /// The present leg, as the path of few contacts has it, with the slip up to where each contact
    /// has come into its state.
    pub(super) fn segment(&self) -> Segment<'g, D, C> {
        let [base, change] = self.program.drives(self.grasp);
        let course = self.program.inside_course(self.grasp);
        let mut problem = self.grasp.problem(self.polygon.clone(), false, base, &Load::from(&course.at(0.0)));
        for (i, (contact, site)) in self.balance.contacts.iter().zip(self.grasp.sites()).enumerate() {
            for axis in 1..site.springs.axes() {
                let slip = contact.memory[axis] / site.springs.root_along(axis);
                problem.slips[i][axis] = slip;
                problem.drives[i][axis] -= slip;
            }
        }
        Segment { grasp: self.grasp, cone: self.cone_answered(), problem, change, course, largest: 0.0 }
    }
}
