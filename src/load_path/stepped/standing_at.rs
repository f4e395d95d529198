//! The state on the way, as physics.

use nalgebra::SVector;

use super::one_step::Standing;
use super::stepped_path::SteppedPath;
use crate::contact::{Mode, Slide};
use crate::equilibrium::{Cone, Equilibrium};
use crate::search::{Effort, Found, Rung};

impl<const D: usize, const C: usize> SteppedPath<'_, D, C> {
    /// Where the path stands: the whole equilibrium there, with residuals recomputed from the grasp, the load and the slip so far; `None` if
    /// there was none to start from. One pass over all contacts.
    #[must_use]
    pub fn state(&self) -> Option<Equilibrium<D, C>> {
        let at = self.standing.as_ref()?;
        let mut problem = self.problem.clone();
        problem.wrench = self.course.at(at.fraction);
        problem.wrench_rest = SVector::zeros();
        problem.slips.clone_from(&at.slips);
        let [base, change] = &self.drives;
        let (mut largest, mut travel) = (at.largest_force(), 0.0_f64);
        largest = largest.max(problem.wrench.norm());
        for (i, site) in problem.sites.iter().enumerate() {
            problem.drives[i] = base[i] + change[i] * at.fraction - at.slips[i];
            travel = travel.max(site.span(&problem.drives[i], &at.twist));
        }
        // All slip so far is memory: what is left of a slide is its direction.
        let standing = |state: &Mode<Slide<C>>| match state {
            Mode::Round(slide) => Mode::Round(Slide { lambda: 0.0, ..*slide }),
            other => *other,
        };
        let states = at.states.iter().map(standing).collect();
        let sizes = [largest, travel];
        let found = Found { sizes, ..Found::new(states, at.forces.clone(), at.twist) };
        let (load, cone) = (self.program.load_at(at.fraction), Cone::of::<C>(&self.settings));
        Some(self.grasp.equilibrium(&problem, &load, &found, Rung::LoadPath, &Effort::default(), cone))
    }

    /// Forces on the object in the contact frames where the path stands, N: (`F_n`, `F_t`…), in the order of the grasp; empty if there was
    /// no equilibrium to start from.
    #[must_use]
    pub fn forces(&self) -> &[SVector<f64, C>] {
        self.standing.as_ref().map_or(&[], |at: &Standing<D, C>| &at.forces)
    }
}
