//! The load on the object in twice the working precision: a wrench and its rounding error. The engine's unit of length for lever arms is the root
//! mean square distance of the contacts from their centroid.

use crate::numerics::Vector;

use crate::error::Error;
use crate::grasp::{Engine, Wrench};

/// A load in the engine's coordinates: moments about the centroid of the contacts, with lever arms in the engine's unit of length. It includes the
/// loads on joints and further bodies.
#[derive(Debug, Clone)]
pub(crate) struct Load {
    /// The load, rounded to working precision.
    pub(crate) wrench: Vector,
    /// The rounding error of the caller's moments in `wrench`: exact minus rounded.
    pub(crate) rounding_error: Vector,
}

impl Engine {
    /// The caller's load, with moments about the centroid of the contacts and lever arms in the engine's unit of length. The pull of vacuums and the
    /// constant loads on bodies and joints are added to it.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50; `what` is the name of the load in this error.
    pub(crate) fn load(&self, load: &Wrench<3>, what: &'static str) -> Result<Load, Error> {
        Ok(Load { wrench: self.load_alone(load, what)?, rounding_error: self.inside_rounding_error(load) })
    }

    /// The sum of all loads (the caller's load, the pull of vacuums, and the constant loads on bodies and joints) in working precision, without its
    /// rounding error.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50; `what` is the name of the load in this error.
    pub(crate) fn load_alone(&self, load: &Wrench<3>, what: &'static str) -> Result<Vector, Error> {
        load.check_in(self.space(), what)?;
        Ok(self.load_unchecked(load))
    }

    /// The sum of all loads (the caller's load, the pull of vacuums, and the constant loads on bodies and joints) in working precision. The caller
    /// has checked that the components of `load` are finite and at most 1e50.
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
        Self { wrench: wrench.clone(), rounding_error: Vector::zeros() }
    }
}
