//! LU factors of a small square matrix: with partial pivoting if the matrix is far from singular, otherwise with complete pivoting.

use crate::numerics::{Square, Vector};

use super::complete_pivoting::CompletePivoting;
use super::partial_pivoting::PartialPivoting;

/// LU factors of a square matrix A, by one of two kinds of pivoting.
#[derive(Debug, Clone)]
pub(crate) enum Factors {
    Regular(PartialPivoting),
    /// The matrix is singular or nearly so. Complete pivoting tells exact null vectors from directions in which the matrix is merely small. In a
    /// stiffness matrix, null vectors are motions that stretch no spring; the other directions are motions that stretch only soft springs.
    Singular(CompletePivoting),
}

impl Factors {
    pub(crate) fn new(matrix: &Square) -> Self {
        if let Some(regular) = PartialPivoting::new(matrix) {
            return Self::Regular(regular);
        }
        let d = matrix.size().count();
        Self::Singular(CompletePivoting::new(matrix.clone(), d, d))
    }

    /// A solution of `A y = b`. A component of b outside the range of A is ignored.
    pub(crate) fn solve(&self, b: &Vector) -> Vector {
        match self {
            Self::Regular(regular) => regular.solve(b),
            Self::Singular(full) => full.solve(b).0,
        }
    }
}
