//! Which contact states working precision tells apart from their neighbours.
//!
//! Open and touching, rolling and sliding, sliding this way and that meet where a gap, a force, the friction in reserve or a slip
//! vanishes. Next to such an edge the last digits of the question decide.

use super::answer::Equilibrium;
use crate::contact::{Mode, State};
use crate::grasp::Grasp;
use crate::object::largest_force;

/// A condition met by less than this part of the size of its terms may be rounding of the data. Normals, arms and products of
/// them carry a few units of 1e-16, which well-posed grasps magnify a hundred times and more.
const ROUNDING_OF_DATA: f64 = 1e-12;
/// A condition met by less than so many times the estimated error may be that error.
const ERRORS: f64 = 10.0;

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Contact by contact, whether working precision tells the state of an equilibrium from its neighbours.
    ///
    /// A state has conditions on gap, normal force, friction in reserve and slip. Each of them must be larger than 1e-12 of the terms it is
    /// a difference of, and than ten times the estimated error ([`Self::accuracy`], which this asks for). Where the answer is
    /// `false` the last digits of the question decide between, say, rolling and just sliding. Forces and displacements hardly
    /// depend on that. `None` for an equilibrium with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5: they hold 10 N.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let distinct = |load: f64| -> Result<Option<Vec<bool>>, grasp_lcp::Error> {
    ///     Ok(grasp.solve(&Wrench::force([0.0, -load]))?.equilibrium().and_then(|held| grasp.distinct(held)))
    /// };
    /// assert_eq!(distinct(9.0)?, Some(vec![true, true]));
    /// assert_eq!(distinct(10.0)?, Some(vec![false, false]));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn distinct(&self, equilibrium: &Equilibrium<D, C>) -> Option<Vec<bool>> {
        let problem = self.problem_of(equilibrium)?;
        let [force_error, displacement_error] =
            self.accuracy(equilibrium).map_or([0.0; 2], |accuracy| [accuracy.force, accuracy.displacement]);
        let twist = &equilibrium.local.twist;
        let forces = equilibrium.site_forces();
        let sizes = forces.iter().map(nalgebra::Matrix::norm);
        let largest = largest_force(self.sites(), &problem.drives, twist, problem.wrench.norm(), sizes);
        let part = |error: f64, size: f64| if size > 0.0 { ERRORS * error / size } else { 0.0 };
        let distinct = |(i, state): (usize, &State<C>)| {
            let at = problem.at(i, &forces[i], twist, largest);
            let of_forces = part(force_error, largest);
            let of_displacements = part(displacement_error, at.span);
            let least = ROUNDING_OF_DATA.max(match state {
                Mode::Open => of_displacements,
                Mode::Rolling => of_forces,
                _ => of_forces.max(of_displacements),
            });
            let mut distinct = true;
            problem.local(i).for_each_condition(state, &at, |value, size| distinct &= value > least * size);
            distinct
        };
        Some(equilibrium.local.states.iter().enumerate().take(self.len()).map(distinct).collect())
    }
}
