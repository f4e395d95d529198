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
    /// The problem of n contacts with the Delassus matrix W (C n × C n). The vector q (C n entries) has the velocities without contact forces, μ (n
    /// entries) the friction coefficients; n may be 0.
    ///
    /// # Errors
    ///
    /// [`Error::Numbers`] if dimensions do not fit or an entry is not finite.
    /// [`Error::Friction`] for a negative or infinite μ.
    pub fn new(w: DMatrix<f64>, q: DVector<f64>, mu: Vec<f64>) -> Result<Self, Error> {
        LcpError::check_vector("q", &q, C * mu.len())?;
        LcpError::check_block("W", &w, (q.len(), q.len()))?;
        match mu.iter().position(|mu| !(mu.is_finite() && *mu >= 0.0)) {
            Some(contact) => Err(Error::Friction { contact, value: mu[contact] }),
            None => Ok(Self { w, q, mu }),
        }
    }

    /// The Delassus matrix W (C n × C n), from contact forces to velocities.
    #[must_use]
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.w
    }

    /// The velocities q without contact forces (C n entries).
    #[must_use]
    pub fn vector(&self) -> &DVector<f64> {
        &self.q
    }

    /// The friction coefficients μ of the contacts (n entries).
    #[must_use]
    pub fn friction(&self) -> &[f64] {
        &self.mu
    }

    /// The number n of contacts.
    #[must_use]
    pub fn len(&self) -> usize {
        self.mu.len()
    }

    /// Whether there are no contacts, n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.mu.is_empty()
    }

    /// The velocities u = W r + q (C n entries) for the contact forces r.
    pub(super) fn velocities(&self, r: &DVector<f64>) -> DVector<f64> {
        &self.w * r + &self.q
    }
}

/// The components of contact i in a vector with C components for each contact.
pub(super) fn part<const C: usize>(v: &DVector<f64>, i: usize) -> SVector<f64, C> {
    v.fixed_rows::<C>(C * i).into_owned()
}
