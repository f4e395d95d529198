//! Progress reports during the solution of a large problem. The matrix W of a problem maps contact forces to contact velocities. An island is a set
//! of contacts that W couples, directly or through other contacts.

use nalgebra::DVector;

/// The progress of a solve, see [`FrictionProblem::solve_watched`](super::FrictionProblem::solve_watched).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SolveProgress<'a> {
    /// Indices, in the caller's problem, of the contacts that are being solved: an island, or all contacts.
    pub contacts: &'a [usize],
    /// The forces of `contacts` in the iterate with the smallest residual so far: for each contact the normal component, then the tangential ones.
    pub forces: &'a DVector<f64>,
    /// The largest of the [`Residuals`](super::Residuals) of Coulomb's law at `forces`, over these contacts.
    pub residual: f64,
    /// Index, in the caller's problem, of the contact with the largest residual.
    pub worst: usize,
    /// Number of Newton steps made for `contacts`. Steps of the method that starts from a solution with polygonal friction cones are not counted.
    pub steps: usize,
}
