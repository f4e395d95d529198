//! A solution, owned or borrowed from a solver.

use super::basis::Basis;
use super::residuals::Residuals;
use core::fmt;
use nalgebra::DVector;

/// A solution 0 ≤ z ⟂ w = M z + q ≥ 0.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Solution {
    /// Unknowns z (n entries, none negative).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub z: DVector<f64>,
    /// Slacks w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub w: DVector<f64>,
    /// The complementary basis to which the solution belongs: the set of the basic z_i.
    pub basis: Basis,
    /// Residuals at z, recomputed from the given M and q before entries of w are set to zero.
    pub residuals: Residuals,
    /// Number of pivots, on all of Lemke's paths that the solver followed.
    pub pivots: usize,
    /// Whether a basic variable is zero. Other bases then have the same point, and the solution may be one of several.
    pub degenerate: bool,
}

/// A [`Solution`] that borrows the vectors of its [`Workspace`](super::Workspace) or [`Series`](super::Series). It has the same fields as a
/// [`Solution`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SolutionView<'a> {
    /// Unknowns z (n entries, none negative).
    pub z: &'a [f64],
    /// Slacks w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: &'a [f64],
    /// The complementary basis to which the solution belongs: the set of the basic z_i.
    pub basis: &'a Basis,
    /// Residuals at z, recomputed from the given M and q before entries of w are set to zero.
    pub residuals: Residuals,
    /// Number of pivots, on all of Lemke's paths that the solver followed.
    pub pivots: usize,
    /// Whether a basic variable is zero. Other bases then have the same point, and the solution may be one of several.
    pub degenerate: bool,
}

impl SolutionView<'_> {
    /// A copy of the solution, which borrows nothing from the workspace or series.
    #[must_use]
    pub fn to_solution(&self) -> Solution {
        Solution {
            z: DVector::from_column_slice(self.z),
            w: DVector::from_column_slice(self.w),
            basis: self.basis.clone(),
            residuals: self.residuals,
            pivots: self.pivots,
            degenerate: self.degenerate,
        }
    }
}

/// Writes one line about a solution: the number of basic z, the largest residual and the number of pivots.
pub(super) fn line(
    f: &mut fmt::Formatter<'_>,
    basis: &Basis,
    residuals: &Residuals,
    pivots: usize,
) -> fmt::Result {
    write!(f, "{} of {} z basic, {residuals}, {pivots} pivots", basis.count(), basis.len())
}

impl fmt::Display for Solution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        line(f, &self.basis, &self.residuals, self.pivots)
    }
}

impl fmt::Display for SolutionView<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        line(f, self.basis, &self.residuals, self.pivots)
    }
}
