//! The ways in which the solution of a linear complementarity problem 0 ≤ z ⟂ w = M z + q ≥ 0 can end. A path is one run of Lemke's method. It
//! follows solutions of the augmented problem w = q + M z + d z₀, with the covering vector d, until the covering variable z₀ is zero.

use super::residuals::Residuals;
use super::solution::{Solution, SolutionView};
use crate::numerics::counted;
use core::convert::Infallible;
use core::fmt;
use nalgebra::DVector;
use thiserror::Error;

/// The way a solve ended, and what this says about the problem. S is the type of a solution, for example a [`Solution`] of an [`Lcp`](super::Lcp), or
/// a view that borrows the vectors of a solver ([`OutcomeView`]).
///
/// The first four variants state a fact about the problem; the last three leave it undecided. `Display` writes one line.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Outcome<S = Solution> {
    /// A solution was found and checked against the given M and q.
    Solved(S),
    /// No z ≥ 0 satisfies M z + q ≥ 0 for the given data: the [`Certificate`] proves it without rounding.
    Infeasible(Certificate),
    /// Data that differ from the given data by rounding are infeasible, as the [`Certificate`] shows.
    ///
    /// The given data may have a z ≥ 0 with M z + q ≥ 0, but only a large z: [`Lcp::least_feasible`](super::Lcp::least_feasible) gives a lower bound
    /// on Σ z_j. For computed data, stronger conclusions are rarely possible.
    NearlyInfeasible(Certificate),
    /// The problem has no solution. For the given M and q no solution belongs to any of the 2ⁿ complementary bases: each basis is excluded by a
    /// vector that was checked without rounding. No Farkas certificate was found, so some z ≥ 0 with M z + q ≥ 0 probably exists.
    NoBasis {
        /// Number of pivots on all paths.
        pivots: usize,
    },
    /// The path ended in a secondary ray, along which z₀ never reaches zero. The ray proves nothing, and all further attempts that the
    /// [`Settings`](super::Settings) allow have failed.
    Ray(Ray),
    /// The pivot limit of the settings was reached before the solve ended.
    PivotLimit {
        /// Number of pivots on all paths.
        pivots: usize,
    },
    /// The settings are invalid, or the computation failed in double precision; `cause` has the reason.
    Breakdown {
        /// Number of pivots before the breakdown.
        pivots: usize,
        /// The reason: invalid settings, or a failure in double precision.
        cause: BreakdownCause,
    },
}

/// The answer of a [`Workspace`](super::Workspace) or a [`Series`](super::Series); the solution borrows their vectors.
pub type OutcomeView<'a> = Outcome<SolutionView<'a>>;

/// Any outcome except a solution.
pub(super) type Unsolved = Outcome<Infallible>;

impl<S> Outcome<S> {
    /// The solution; `None` for every other outcome.
    #[must_use]
    pub fn solution(&self) -> Option<&S> {
        if let Self::Solved(solution) = self { Some(solution) } else { None }
    }

    /// Whether a certificate proves that M z + q ≥ 0 and z ≥ 0 contradict each other, exactly or up to rounding. The result is false for
    /// [`Self::NoBasis`].
    #[must_use]
    pub fn is_infeasible(&self) -> bool {
        matches!(self, Self::Infeasible(_) | Self::NearlyInfeasible(_))
    }

    /// Applies `next` to a solution; every other outcome is returned unchanged.
    #[must_use]
    pub fn and_then<T>(self, next: impl FnOnce(S) -> Outcome<T>) -> Outcome<T> {
        match self {
            Self::Solved(solution) => next(solution),
            Self::Infeasible(certificate) => Outcome::Infeasible(certificate),
            Self::NearlyInfeasible(certificate) => Outcome::NearlyInfeasible(certificate),
            Self::NoBasis { pivots } => Outcome::NoBasis { pivots },
            Self::Ray(ray) => Outcome::Ray(ray),
            Self::PivotLimit { pivots } => Outcome::PivotLimit { pivots },
            Self::Breakdown { pivots, cause } => Outcome::Breakdown { pivots, cause },
        }
    }

    /// This outcome with the number of pivots replaced by `made`, the number of pivots on all paths. A solution is returned unchanged.
    pub(super) fn after(mut self, made: usize) -> Self {
        match &mut self {
            Self::Solved(_) => {}
            Self::Infeasible(Certificate { pivots, .. })
            | Self::NearlyInfeasible(Certificate { pivots, .. })
            | Self::NoBasis { pivots }
            | Self::Ray(Ray { pivots, .. })
            | Self::PivotLimit { pivots }
            | Self::Breakdown { pivots, .. } => *pivots = made,
        }
        self
    }
}

impl Unsolved {
    /// This outcome with another type S of solutions; this outcome holds no solution.
    pub(super) fn into<S>(self) -> Outcome<S> {
        self.and_then(|never| match never {})
    }
}

impl OutcomeView<'_> {
    /// This outcome with a copy of the solution, which borrows nothing from the workspace or series.
    #[must_use]
    pub fn into_outcome(self) -> Outcome {
        self.and_then(|view| Outcome::Solved(view.to_solution()))
    }
}

impl<S: fmt::Display> fmt::Display for Outcome<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solved(solution) => write!(f, "solved: {solution}"),
            Self::Infeasible(certificate) => {
                write!(f, "infeasible, proved without rounding by {certificate}")
            }
            Self::NearlyInfeasible(certificate) => {
                write!(f, "infeasible but for rounding, by {certificate}")
            }
            Self::NoBasis { pivots } => {
                write!(f, "no solution: every complementary basis is excluded ({pivots} pivots)")
            }
            Self::Ray(Ray { pivots, .. }) => {
                write!(f, "nothing known: a ray that proves nothing, after {pivots} pivots")
            }
            Self::PivotLimit { pivots } => write!(f, "nothing known: stopped after {pivots} pivots"),
            Self::Breakdown { pivots, cause } => {
                write!(f, "nothing known: {cause} (after {pivots} pivots)")
            }
        }
    }
}

/// A vector y (n entries) that proves by Farkas' lemma that no z ≥ 0 satisfies M z + q ≥ 0: y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0.
///
/// For such a z both yᵀ(M z + q) ≥ 0 and yᵀ(M z + q) = (Mᵀy)ᵀz + qᵀy < 0, a contradiction. [`Lcp::proves_infeasible`](super::Lcp::proves_infeasible)
/// checks y without rounding.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Certificate {
    /// The Farkas vector.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub y: DVector<f64>,
    /// Number of pivots on all paths.
    pub pivots: usize,
}

impl Certificate {
    pub(crate) fn new(y: DVector<f64>, pivots: usize) -> Self {
        Self { y, pivots }
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = counted(self.y.as_slice(), &|y| *y != 0.0);
        write!(f, "a combination of {rows} of {} rows ({} pivots)", self.y.len(), self.pivots)
    }
}

/// The secondary ray on which the first path ended.
///
/// Let ẑ, ŵ be the direction and ẑ₀ the rate of the covering variable. Then ŵ = M ẑ + d ẑ₀ with ẑ ≥ 0, ŵ ≥ 0, ẑ₀ ≥ 0 and ẑᵀŵ = 0. The augmented
/// problem has solutions for arbitrarily large steps along this direction, none of which solves the original problem (Cottle, Pang & Stone,
/// section 4.4).
///
/// The covering vector d is given by the settings. By default it is the vector of ones after rows and columns of M have been scaled such that its
/// nonzero entries lie near 1.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Ray {
    /// Direction ẑ (n entries, none negative, the largest 1), in the caller's units.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub direction: DVector<f64>,
    /// Rate ẑ₀ ≥ 0 of the covering variable, that belongs to `direction`, whose largest entry is 1.
    pub covering_rate: f64,
    /// Number of pivots on all paths.
    pub pivots: usize,
}

/// The reason why a solve broke down. The first three are invalid settings; the others arise during the solve.
#[derive(Debug, Clone, PartialEq, Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum BreakdownCause {
    /// The length of the covering vector of the settings differs from the number of rows of the problem.
    #[error("the covering vector has {given} entries, but the problem has {needed} rows")]
    CoveringLength {
        /// Length of the covering vector.
        given: usize,
        /// Number of rows of the problem.
        needed: usize,
    },
    /// An entry of the covering vector is negative or not finite, or is zero in a row with q_i < 0.
    #[error(
        "entry {row} of the covering vector is {value}, but must be finite, not negative, and positive where q is negative"
    )]
    CoveringEntry {
        /// Row of the entry.
        row: usize,
        /// The entry.
        value: f64,
    },
    /// A tolerance of the settings is negative, infinite or not a number.
    #[error("{name} is {value}, but must be finite and not negative")]
    Tolerance {
        /// Name of the tolerance.
        name: &'static str,
        /// The value of this tolerance.
        value: f64,
    },
    /// A number left the range of double precision.
    #[error("a number left the range of double precision")]
    Overflow,
    /// The principal block of the final basis is singular, or so close to singular that q is smaller than the rounding error of M z.
    #[error("the final basis is singular")]
    SingularBasis,
    /// The methods for a [`FrictionProblem`](crate::friction::FrictionProblem) ended without a solution.
    #[error("Newton's method came no closer than {residual:.1e}, at contact {contact}")]
    NoConvergence {
        /// The largest residual over all contacts, at the best forces found, i.e. the forces for which this residual is smallest.
        residual: f64,
        /// The contact with this residual at the best forces, counted from 0.
        contact: usize,
    },
    /// The caller's watch function stopped the solve ([`FrictionProblem::solve_watched`](crate::friction::FrictionProblem::solve_watched)).
    #[error("stopped on request at a residual of {residual:.1e}, at contact {contact}")]
    Stopped {
        /// The largest residual over all contacts, at the best forces found until then, i.e. the forces for which this residual is smallest.
        residual: f64,
        /// The contact with this residual at these forces, counted from 0.
        contact: usize,
    },
    /// The final basis was reached, but the residuals of its point, given here, exceed the tolerance.
    #[error("the point of the final basis misses its tolerance, {0}")]
    Residual(Residuals),
}
