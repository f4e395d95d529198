//! The frictional contact problem.

use super::error::Error;
use crate::lcp::LcpError;
use crate::prelude::*;
use nalgebra::{DMatrix, DVector, SVector};

/// A frictional contact problem whose contacts have C components, 2 in the plane, 3 in space; see the [module](super).
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionProblem<const C: usize> {
    pub(super) w: DMatrix<f64>,
    pub(super) q: DVector<f64>,
    pub(super) mu: Vec<f64>,
}

/// A problem in the plane: one normal and one tangential component per contact.
pub type PlanarContacts = FrictionProblem<2>;
/// A problem in space: one normal and two tangential components per contact.
pub type SpatialContacts = FrictionProblem<3>;

impl<const C: usize> FrictionProblem<C> {
    /// The problem with W (C n × C n), q (C n entries) and μ (n entries); n may be 0.
    ///
    /// # Errors
    ///
    /// [`Error::Numbers`] if sizes do not fit or an entry is not finite.
    /// [`Error::Friction`] for a negative or infinite μ.
    pub fn new(w: DMatrix<f64>, q: DVector<f64>, mu: Vec<f64>) -> Result<Self, Error> {
        LcpError::check_vector("q", &q, C * mu.len())?;
        LcpError::check_block("W", &w, (q.len(), q.len()))?;
        match mu.iter().position(|mu| !(mu.is_finite() && *mu >= 0.0)) {
            Some(contact) => Err(Error::Friction { contact, value: mu[contact] }),
            None => Ok(Self { w, q, mu }),
        }
    }

    /// W (C n × C n).
    #[must_use]
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.w
    }

    /// q (C n entries).
    #[must_use]
    pub fn vector(&self) -> &DVector<f64> {
        &self.q
    }

    /// μ (n entries).
    #[must_use]
    pub fn friction(&self) -> &[f64] {
        &self.mu
    }

    /// The number n of contacts.
    #[must_use]
    pub fn len(&self) -> usize {
        self.mu.len()
    }

    /// Whether n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mu.is_empty()
    }

    /// Velocities u = W r + q (C n entries).
    pub(super) fn velocities(&self, r: &DVector<f64>) -> DVector<f64> {
        &self.w * r + &self.q
    }
}

/// The components of contact i, from a vector of all contacts.
pub(super) fn part<const C: usize>(v: &DVector<f64>, i: usize) -> SVector<f64, C> {
    v.fixed_rows::<C>(C * i).into_owned()
}
