//! The two forms of a grasp under a load, for those who solve them elsewhere.

use super::force_form::force_form;
use super::kinematic::kinematic_form;
use super::rows::Form;
use crate::contact::PolygonCone;
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The [kinematic form](crate::forms) under a load: jumps (gaps and slips) on top of the elastic trial state in which everything
    /// sticks. `None` if no contact needs a row, if the load works on a motion that no contact resists, or if a number overflows. When
    /// `lcp.vector() >= 0` everything rolls and z = 0 is the answer. In the plane `cone` is not looked at.
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
    /// let form = grasp.kinematic_form(&Wrench::force([0.0, 1.0]), &PolygonCone::default())?.expect("the floor has a row");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it lifts off") };
    /// let row = form.position(Row::Gap { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.01).abs() < 1e-17);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn kinematic_form(&self, load: &Wrench<D, C>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let problem = self.on_polygons(load, cone)?;
        let trial = problem.trial();
        let Ok(state) = trial.solve(problem.sites, &problem.drives, problem.load()) else { return Ok(None) };
        Ok(kinematic_form(&problem, &trial, &state))
    }

    /// The [force form](crate::forms) under a load: forces as unknowns, the twist free and split in two halves ([`Row::Balance`](crate::forms::Row::Balance)). Contacts that act
    /// both ways (bonded, kept closed, infinite friction) have springs in the rows of the balance and no rows of their own. `None` if a
    /// number overflows. In the plane `cone` is not looked at.
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
    /// let form = grasp.force_form(&Wrench::force([0.0, -1.0]), &PolygonCone::default())?.expect("moderate numbers");
    /// let Outcome::Solved(solution) = form.lcp.solve() else { panic!("it rests") };
    /// let row = form.position(Row::NormalForce { contact: 1 }).expect("may open");
    /// assert!((form.z_unit[row] * solution.z[row] - 0.5).abs() < 1e-15);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn force_form(&self, load: &Wrench<D, C>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        Ok(force_form(&self.on_polygons(load, cone)?))
    }
}
