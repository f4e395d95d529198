//! A solution, owned or in the memory of a solver.

use super::basis::Basis;
use super::residuals::Residuals;
use core::fmt;
use nalgebra::DVector;

/// A solution 0 ≤ z ⟂ w = M z + q ≥ 0.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Solution {
    /// z (n entries, none negative).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub z: DVector<f64>,
    /// w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub w: DVector<f64>,
    /// Which z_i are basic.
    pub basis: Basis,
    /// The violations at z, recomputed from the M and q given, before zeros are set in w = M z + q.
    pub residuals: Residuals,
    /// Pivots made, on all paths.
    pub pivots: usize,
    /// Whether a basic variable is zero: other bases then have this point as well, and the
    /// solution may be one of several.
    pub degenerate: bool,
}

/// A [`Solution`] in the memory of its [`Workspace`](super::Workspace) or
/// [`Series`](super::Series); each field is that of the same name there.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SolutionView<'a> {
    /// z (n entries, none negative).
    pub z: &'a [f64],
    /// w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: &'a [f64],
    /// Which z_i are basic.
    pub basis: &'a Basis,
    /// The violations at z, recomputed from the M and q given; see [`Residuals`].
    pub residuals: Residuals,
    /// Pivots made, on all paths.
    pub pivots: usize,
    /// Whether a basic variable is zero: other bases then have this point as well.
    pub degenerate: bool,
}

impl SolutionView<'_> {
    /// A copy that outlives the workspace.
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

/// One line about a solution: the number of basic z, the largest residual and the number of pivots.
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
