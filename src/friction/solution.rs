//! The solution of a frictional contact problem: n contacts with C components each (2 in the plane, 3 in space). An island is a set of contacts that
//! the matrix W couples, directly or through other contacts.

use super::law::{ContactMode, Residuals};
use crate::numerics::{Each, counted};
use crate::prelude::*;
use core::fmt;
use nalgebra::DVector;

/// Forces and velocities that satisfy Coulomb's law.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Solution {
    /// Forces r (C n entries): for each contact the normal component, then the tangential components.
    #[cfg_attr(feature = "serde", serde(serialize_with = "crate::lcp::list"))]
    pub r: DVector<f64>,
    /// Velocities u = W r + q (C n entries): the matrix W times the forces r, plus the velocities q without contact forces.
    #[cfg_attr(feature = "serde", serde(serialize_with = "crate::lcp::list"))]
    pub u: DVector<f64>,
    /// State of each contact (n entries). If a contact is on the border between two states, such as sliding with zero slip, rounding decides which of
    /// them is reported.
    pub states: Vec<ContactMode>,
    /// Residuals of Coulomb's law for these forces, recomputed from the given W, q and μ.
    pub residuals: Residuals,
    /// Number of pivots of Lemke's method, over all islands. Lemke's method solves the problem with a polygon in place of each friction cone.
    pub pivots: usize,
    /// Number of Newton steps of all methods, over all islands.
    pub steps: usize,
}

impl fmt::Display for Solution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |state| counted(&self.states, &|s| *s == state);
        let [open, sticking, sliding] =
            [ContactMode::Open, ContactMode::Sticking, ContactMode::Sliding].each(count);
        write!(
            f,
            "{open} open, {sticking} sticking, {sliding} sliding, residuals up to {:.1e}",
            self.residuals.max()
        )
    }
}
