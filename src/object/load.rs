//! A load on the object to twice the working precision.

use nalgebra::SVector;

use crate::error::Error;
use crate::grasp::{Engine, Wrench};

/// A load in inside coordinates, and what rounding took from it when it was moved to the centroid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load<const D: usize> {
    pub(crate) wrench: SVector<f64, D>,
    pub(crate) rest: SVector<f64, D>,
}

impl<const D: usize, const C: usize> Engine<D, C> {
    /// A load of the caller's with what acts on joints whatever they do, in inside coordinates.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50; `what` names it.
    pub(crate) fn load(&self, load: &Wrench<C>, what: &'static str) -> Result<Load<D>, Error> {
        Ok(Load { wrench: self.load_alone(load, what)?, rest: self.inside_rest(load) })
    }

    /// [`Self::load`] without what rounding takes from it.
    pub(crate) fn load_alone(&self, load: &Wrench<C>, what: &'static str) -> Result<SVector<f64, D>, Error> {
        load.check(what)?;
        Ok(self.load_unchecked(load))
    }

    /// [`Self::load_alone`] of a wrench that was checked before.
    pub(crate) fn load_unchecked(&self, load: &Wrench<C>) -> SVector<f64, D> {
        let inside = self.inside_unchecked(load);
        self.linkage().map_or(inside, |linkage| inside + linkage.held + linkage.pulled)
    }
}

impl<const D: usize> From<&SVector<f64, D>> for Load<D> {
    fn from(wrench: &SVector<f64, D>) -> Self {
        Self { wrench: *wrench, rest: SVector::zeros() }
    }
}
