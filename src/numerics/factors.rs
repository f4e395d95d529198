//! LU factors of a small square matrix: partial pivoting if it is far from singular, complete pivoting otherwise.

use crate::numerics::{Square, Vector};

use super::complete_pivoting::CompletePivoting;
use super::partial_pivoting::PartialPivoting;
use crate::prelude::*;

/// An equation is unsolvable if it is missed by more than this part of the sizes of its terms, times the growth of errors.
const OUT_OF_REACH: f64 = 1e-12;

/// Factors of a `D x D` matrix A.
#[derive(Debug, Clone)]
#[allow(clippy::large_enum_variant)] // boxing would allocate at every step of Newton's method
pub(crate) enum Factors {
    Regular(PartialPivoting),
    /// Singular or nearly so: complete pivoting distinguishes singular from soft.
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

    /// A solution of `A y = b`. A part of b that no y reaches is ignored.
    pub(crate) fn solve(&self, b: &Vector) -> Vector {
        match self {
            Self::Regular(regular) => regular.solve(b),
            Self::Singular(full) => full.solve(b).0,
        }
    }

    /// A solution of `A y = b`, if there is one; `size` is that of the terms whose sum is b.
    pub(crate) fn solve_exactly(&self, b: &Vector, size: f64) -> Option<Vector> {
        match self {
            Self::Regular(regular) => Some(regular.solve(b)),
            Self::Singular(full) => {
                let (y, unreached) = full.solve(b);
                (unreached <= OUT_OF_REACH * size * full.growth()).then_some(y)
            }
        }
    }

    /// A basis of {y : A y = 0}.
    pub(crate) fn kernel(&self) -> Vec<Vector> {
        match self {
            Self::Regular(_) => Vec::new(),
            Self::Singular(full) => full.kernel(),
        }
    }

    /// The growth of relative rounding errors in a solution, at least 1.
    pub(crate) fn growth(&self) -> f64 {
        match self {
            Self::Regular(regular) => {
                let size = regular.size();
                let solved = |k: usize| regular.solve(&Vector::unit(size, k));
                (0..size.count()).map(|k| solved(k).amax()).fold(1.0, f64::max)
            }
            Self::Singular(full) => full.growth(),
        }
    }
}
