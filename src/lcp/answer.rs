//! Answers that lie in the memory of a solver.

use super::basis::Basis;
use super::outcome::{Outcome, Solution};
use super::residuals::Residuals;
use nalgebra::DVector;

/// The answer of a [`Workspace`](super::Workspace) or a [`Series`](super::Series): a view of the
/// solution it holds, or the [`Outcome`] that is none.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer<'a> {
    /// The problem is solved.
    Solved(SolutionView<'a>),
    /// The problem is not solved; this outcome is never [`Outcome::Solved`].
    Unsolved(Box<Outcome>),
}

/// A [`Solution`] that still lies in the memory of its [`Workspace`](super::Workspace) or
/// [`Series`](super::Series); each field means what its namesake there means.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Whether a basic variable is zero: other bases then stand for this point as well.
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

impl Answer<'_> {
    /// A copy that outlives the workspace.
    #[must_use]
    pub fn into_outcome(self) -> Outcome {
        match self {
            Self::Solved(view) => Outcome::Solved(view.to_solution()),
            Self::Unsolved(outcome) => *outcome,
        }
    }
}
