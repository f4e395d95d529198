//! All equilibria under a load, their accuracy, the linear complementarity problems of which they are solutions, and proofs that no equilibrium
//! exists.

use super::grasp::Grasp;
use crate::contact::PolygonCone;
use crate::equilibrium::{Accuracy, Equilibrium, Refutation};
use crate::error::Error;
use crate::forms::Form;
use crate::grasp::{Wrench, inside, outside};
use crate::prelude::*;

impl<const C: usize> Grasp<C> {
    /// All equilibria under a load, for few contacts, by trying every combination of contact states. The equilibrium that [`Self::solve`] returns is
    /// among them.
    ///
    /// On the round cone the list may be incomplete. It has the equilibrium of [`Self::solve`], and those that Newton's method reaches from the
    /// equilibria on the polygonal cone. An empty list does not prove that no equilibrium exists: [`Self::solve`] returns a proof if it finds one. An
    /// equilibrium that satisfies several combinations of contact states, as with a contact force exactly on the boundary of its friction cone, is
    /// listed once. If equilibria form a line, one of its points is listed, with the directions of the line in
    /// [`neutral_motions`](Equilibrium::neutral_motions).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let all = grasp.equilibria(Wrench::force([0.0, -4.0]))?;
    /// assert_eq!(all.len(), 1); // a pinch with horizontal normals has no other
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::TooManyStates`] beyond [`Settings::most_states`](crate::Settings::most_states) combinations, [`Error::Wrench`] if the load is not
    /// finite, or beyond 1e50; [`Error::KineticFriction`] if a contact slides whose [kinetic friction](crate::grasp::Contact::kinetic) is lower.
    pub fn equilibria(&self, load: impl Into<Wrench<C>>) -> Result<Vec<Equilibrium<C>>, Error> {
        self.engine.equilibria(&inside(&load.into()), &self.settings).map(outside)
    }

    /// The estimated error of an equilibrium of this grasp, and how strongly the equilibrium depends on the last digits of the data. The estimate
    /// takes two more passes over the contacts in twice the working precision. `None` for an equilibrium with another number of contacts. Also `None`
    /// for an equilibrium of a load path with sliding on the round cone. The error of such a path is
    /// [`LoadPath::step_error`](crate::load_path::LoadPath::step_error).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let outcome = grasp.solve(Wrench::force([0.0, -4.0]))?;
    ///
    /// let accuracy = grasp.accuracy(outcome.equilibrium().expect("holds")).expect("its own answer");
    /// assert!(accuracy.force < 1e-14 && accuracy.condition < 10.0);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn accuracy(&self, equilibrium: &Equilibrium<C>) -> Option<Accuracy> {
        self.of_equilibrium(equilibrium).engine.accuracy(&inside(equilibrium))
    }

    /// For each contact, whether its state (open, sticking, sliding) can be distinguished from neighbouring states in working precision.
    ///
    /// A state has conditions on gap, normal force, friction margin (`μ F_n - |F_t|`) and slip. Each condition is a difference of two terms. The
    /// state is distinct if each difference exceeds 1e-12 of its terms, and ten times the estimated error from [`Self::accuracy`]. If the answer is
    /// `false`, the last digits of the data determine, say, whether the contact sticks or just slides. Forces and displacements hardly depend on
    /// this. `None` for an equilibrium with another number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5: they hold 10 N.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    /// let distinct = |load: f64| -> Result<Option<Vec<bool>>, grasp_lcp::Error> {
    ///     Ok(grasp.solve(Wrench::force([0.0, -load]))?.equilibrium().and_then(|held| grasp.distinct(held)))
    /// };
    /// assert_eq!(distinct(9.0)?, Some(vec![true, true]));
    /// assert_eq!(distinct(10.0)?, Some(vec![false, false]));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn distinct(&self, equilibrium: &Equilibrium<C>) -> Option<Vec<bool>> {
        self.of_equilibrium(equilibrium).engine.distinct(&inside(equilibrium))
    }

    /// The proof that no equilibrium exists under a load on round friction cones. It splits the possible states of the contacts (open, sticking,
    /// sliding) into cases and derives a contradiction from each case. [`Refutation::check`] verifies the proof and returns its safety factor against
    /// rounding (`escape` in the example), at least 1e4. `None` if an equilibrium exists, if more cases are needed than
    /// [`Settings::most_states`](crate::Settings::most_states) allows, or if no cone is round, as in the plane.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    ///
    /// // Three fingers around a jar press with 10 N each, μ = 0.5: they hold 15 N, and more if they squeezed more.
    /// let finger = |angle: f64| {
    ///     let (s, c) = angle.sin_cos();
    ///     Contact::new([c, s, 0.0], [-c, -s, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let jar = Grasp::new([0.0, 2.0, 4.0].map(finger))?;
    /// let load = Wrench::force([0.0, 0.0, -16.0]);
    ///
    /// let proof = jar.refutation(&load)?.expect("too heavy");
    /// assert!(proof.check(&jar, &load)?.is_some_and(|escape| escape > 1e4));
    /// // It says nothing about a load that is held.
    /// assert!(proof.check(&jar, &Wrench::force([0.0, 0.0, -1.0]))?.is_none());
    /// assert!(jar.refutation(Wrench::force([0.0, 0.0, -1.0]))?.is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn refutation(&self, load: impl Into<Wrench<C>>) -> Result<Option<Refutation<C>>, Error> {
        self.engine.refutation(&inside(&load.into()), &self.settings).map(outside)
    }

    /// The [kinematic form](crate::forms) of the linear complementarity problem under a load. Its unknowns are gaps and slips, added to the elastic
    /// trial solution, in which everything sticks. `None` if no contact can open or slide, if the load does work along a motion that no contact
    /// resists, or if a number overflows. If `lcp.vector() >= 0`, everything sticks, and the unknowns z = 0 (no gaps and slips) solve the problem. In
    /// the plane `cone` is ignored.
    ///
    /// ```
    /// use grasp_lcp::forms::Row;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{PolygonCone, lcp::Outcome};
    ///
    /// // A body on a spring of 100 N/m that rests on a floor just so, and is pulled up by 1 N: it lifts off by 10 mm.
    /// let spring = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).bonded();
    /// let floor = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0);
    /// let grasp = Grasp::new([spring, floor])?;
    ///
    /// let form = grasp.kinematic_form(Wrench::force([0.0, 1.0]), &PolygonCone::default())?.expect("the floor has a row");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it lifts off") };
    /// let row = form.position(Row::Gap { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.01).abs() < 1e-17);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn kinematic_form(
        &self,
        load: impl Into<Wrench<C>>,
        cone: &PolygonCone,
    ) -> Result<Option<Form>, Error> {
        self.engine.kinematic_form(&inside(&load.into()), cone)
    }

    /// The [force form](crate::forms) of the linear complementarity problem under a load. Its unknowns are the contact forces, and the twist as a
    /// difference of two non-negative parts ([`Row::Balance`](crate::forms::Row::Balance)). Force components that may have either sign have no rows
    /// of their own; they enter the balance rows as stiffness. Such force components are: all components of bonded contacts (which neither open nor
    /// slip), the normal force of contacts that are kept closed, and the tangential force of contacts with infinite friction. `None` if a number
    /// overflows. In the plane `cone` is ignored.
    ///
    /// ```
    /// use grasp_lcp::forms::Row;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::{PolygonCone, lcp::Outcome};
    ///
    /// // A body of 1 N on a spring and a floor of 100 N/m each: the floor carries half.
    /// let spring = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).bonded();
    /// let floor = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0);
    /// let grasp = Grasp::new([spring, floor])?;
    ///
    /// let form = grasp.force_form(Wrench::force([0.0, -1.0]), &PolygonCone::default())?.expect("moderate numbers");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it rests") };
    /// let row = form.position(Row::NormalForce { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn force_form(&self, load: impl Into<Wrench<C>>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        self.engine.force_form(&inside(&load.into()), cone)
    }
}

impl<const C: usize> Refutation<C> {
    /// Verifies this proof for a grasp and a load, and returns its safety factor against rounding. Let the elastic trial solution be that in which
    /// every contact sticks. Because of rounding, the proof can miss only an equilibrium in which springs are stretched far more than in the trial
    /// solution. The factor is a lower bound on the norm of stretches and forces over all contacts (in √J), relative to their norm in the trial
    /// solution. `None` if the proof does not hold for this grasp and this load, or if the factor is below 1e4.
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn check(&self, grasp: &Grasp<C>, load: impl Into<Wrench<C>>) -> Result<Option<f64>, Error> {
        grasp.engine.check_refutation(&inside(self), &inside(&load.into()))
    }
}
