//! A motion that proves that no contact forces balance a load, regardless of springs and commands.

use crate::contact::Polygon;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::Vector;
use crate::object::Load;
use crate::prelude::*;
use crate::proofs::separating_motion;
use crate::search::Settings;

impl Engine {
    /// A motion that proves that no contact forces inside their cones balance this load together with the permanent loads, i.e. weights of bodies,
    /// vacuums of suction cups and other loads that act in every question. No contact force inside its cone does negative work along the motion, and
    /// the loads do positive work along it. `None` if no such proof was found.
    pub(crate) fn unbalanced_along(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<Option<Vec<f64>>, Error> {
        let load = Load::from(&self.load_alone(load, "load")?);
        let polygon = Polygon::shared(self.space(), &settings.cone);
        let problem = self.problem(polygon, settings.is_round(self.space()), self.offsets(), &load);
        Ok(separating_motion(&problem).map(|v| v.as_slice().to_vec()))
    }

    /// The total work, J, of this load and of the permanent loads along `motion`, which [`Self::unbalanced_along`] found.
    pub(crate) fn work_along(&self, load: &Wrench<3>, motion: &[f64]) -> Result<f64, Error> {
        let load = self.load_alone(load, "load")?;
        Ok(load.dot(&Vector::from_fn(self.size(), |k| motion.get(k).copied().unwrap_or(0.0))))
    }
}
