//! Progress reports of a large problem.

use nalgebra::DVector;

/// The progress of a solve, see [`FrictionProblem::solve_watched`](super::FrictionProblem::solve_watched).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SolveProgress<'a> {
    /// The contacts that are being solved, by index: an island, or all of them.
    pub contacts: &'a [usize],
    /// The best forces of these contacts so far: of each the normal component, then the tangential ones.
    pub forces: &'a DVector<f64>,
    /// The largest of their [`Residuals`](super::Residuals).
    pub residual: f64,
    /// The contact with this residual, by index.
    pub worst: usize,
    /// The number of Newton's steps made for these contacts.
    pub steps: usize,
}
