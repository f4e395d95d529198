//! A load on the object in twice the working precision.

use crate::numerics::Vector;

use crate::error::Error;
use crate::grasp::{Engine, Wrench};

/// A load in the engine's coordinates (moments about the centroid of the contacts, with lever arms in the engine's unit of length). The rounding
/// error of this conversion is kept beside it.
#[derive(Debug, Clone)]
pub(crate) struct Load {
    pub(crate) wrench: Vector,
    pub(crate) rest: Vector,
}

impl Engine {
    /// The caller's load in the engine's coordinates. The pull of vacuums and the constant loads on bodies and joints are added to it.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50; `what` names it.
    pub(crate) fn load(&self, load: &Wrench<3>, what: &'static str) -> Result<Load, Error> {
        Ok(Load { wrench: self.load_alone(load, what)?, rest: self.inside_rest(load) })
    }

    /// The wrench of [`Self::load`] as working-precision numbers, without the remainder that holds its rounding error.
    pub(crate) fn load_alone(&self, load: &Wrench<3>, what: &'static str) -> Result<Vector, Error> {
        load.check_in(self.space(), what)?;
        Ok(self.load_unchecked(load))
    }

    /// [`Self::load_alone`] without the check that the components of the wrench are finite and moderate, which the caller has made.
    pub(crate) fn load_unchecked(&self, load: &Wrench<3>) -> Vector {
        let mut inside = self.inside_unchecked(load);
        if let Some(bodies) = self.bodies() {
            inside += self.combine_wrenches(bodies, &bodies.loads);
        }
        if let Some(vacuum) = self.vacuum() {
            inside += &vacuum.inside;
        }
        match self.linkage() {
            None => inside,
            Some(linkage) => inside + &linkage.held_forces + &linkage.external_torques,
        }
    }
}

impl From<&Vector> for Load {
    fn from(wrench: &Vector) -> Self {
        Self { wrench: wrench.clone(), rest: Vector::zeros() }
    }
}
