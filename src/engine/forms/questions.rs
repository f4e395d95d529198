//! The two linear complementarity problems of a grasp under a load, for callers with a solver of their own. The unknowns of the kinematic form are
//! gaps and slips, those of the force form contact forces.

use super::force_form::force_form;
use super::kinematic::kinematic_form;
use super::rows::Form;
use crate::contact::PolygonCone;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};

impl Engine {
    pub(crate) fn kinematic_form(&self, load: &Wrench<3>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        let problem = self.on_polygons(load, cone)?;
        let trial = problem.trial();
        let Ok(state) = trial.solve(problem.sites, &problem.offsets, problem.load()) else { return Ok(None) };
        Ok(kinematic_form(&problem, &trial, &state))
    }

    pub(crate) fn force_form(&self, load: &Wrench<3>, cone: &PolygonCone) -> Result<Option<Form>, Error> {
        Ok(force_form(&self.on_polygons(load, cone)?))
    }
}
