//! The ways in which a solve can end.

use super::residuals::Residuals;
use super::solution::{Solution, SolutionView};
use core::convert::Infallible;
use core::fmt;
use nalgebra::DVector;
use thiserror::Error;

/// The end of a solve, and the conclusion that it allows. S is the type of a solution: of an [`Lcp`](super::Lcp), of a problem with free variables
/// ([`MixedSolution`](super::MixedSolution)), or in the memory of a solver ([`OutcomeView`]).
///
/// The first four state a fact about the problem; the last three leave it open. Its `Display` is one line.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Outcome<S = Solution> {
    /// A solution was found and checked against the data given.
    Solved(S),
    /// No z ≥ 0 has M z + q ≥ 0, for the data given: the [`Certificate`] proves it without rounding.
    Infeasible(Certificate),
    /// Data that differ from those given by rounding are infeasible, as the [`Certificate`] shows.
    ///
    /// The data given may have a z ≥ 0 with M z + q ≥ 0, but none that is small:
    /// [`Lcp::least_feasible`](super::Lcp::least_feasible) bounds it from below. Computed data usually allow no stronger conclusion.
    NearlyInfeasible(Certificate),
    /// None of the 2ⁿ complementary bases has a solution, for the M and q given: each was excluded by a vector that
    /// was checked without rounding. No Farkas certificate was found, so z ≥ 0 with M z + q ≥ 0 should exist.
    NoBasis {
        /// Pivots made.
        pivots: usize,
    },
    /// The path ended in a secondary ray, along which z₀ never reaches zero. The ray proves nothing, and every further attempt
    /// that the [`Settings`](super::Settings) allow has failed.
    Ray(Ray),
    /// The pivot limit was reached first.
    PivotLimit {
        /// Pivots made.
        pivots: usize,
    },
    /// The computation could not be carried through in double precision.
    Breakdown {
        /// Pivots made until then.
        pivots: usize,
        /// The reason.
        cause: BreakdownCause,
    },
}

/// The answer of a [`Workspace`](super::Workspace) or a [`Series`](super::Series), whose solution lies in their memory.
pub type OutcomeView<'a> = Outcome<SolutionView<'a>>;

/// Any outcome but a solution.
pub(super) type Unsolved = Outcome<Infallible>;

impl<S> Outcome<S> {
    /// The solution, if there is one.
    #[must_use]
    pub fn solution(&self) -> Option<&S> {
        if let Self::Solved(solution) = self { Some(solution) } else { None }
    }

    /// Whether the constraints are shown to contradict each other, exactly or but for rounding.
    #[must_use]
    pub fn is_infeasible(&self) -> bool {
        matches!(self, Self::Infeasible(_) | Self::NearlyInfeasible(_))
    }

    /// Applies `next` to a solution and passes every other outcome on.
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

    /// This outcome with its number of pivots set to `made`; the pivots of a solution do not change.
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
    /// The same outcome, with any type of solution.
    pub(super) fn into<S>(self) -> Outcome<S> {
        self.and_then(|never| match never {})
    }
}

impl OutcomeView<'_> {
    /// A copy that outlives the workspace.
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

/// A vector y (n entries) that shows that no z ≥ 0 has M z + q ≥ 0, by Farkas' lemma: y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0.
///
/// But z ≥ 0 and M z + q ≥ 0 imply yᵀ(M z + q) ≥ 0. [`Lcp::proves_infeasible`](super::Lcp::proves_infeasible) checks y
/// without rounding.
///
/// For a [`MixedLcp`](super::MixedLcp) y has m + n entries, the first m of either sign, see
/// [`MixedLcp::proves_infeasible`](super::MixedLcp::proves_infeasible).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Certificate {
    /// The vector.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub y: DVector<f64>,
    /// Pivots made.
    pub pivots: usize,
}

impl Certificate {
    pub(crate) fn new(y: DVector<f64>, pivots: usize) -> Self {
        Self { y, pivots }
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = self.y.iter().filter(|y| **y != 0.0).count();
        write!(f, "a combination of {rows} of {} rows ({} pivots)", self.y.len(), self.pivots)
    }
}

/// The secondary ray on which the first path ended.
///
/// Let ẑ, ŵ be the direction and ẑ₀ the rate of the covering variable. Then ŵ = M ẑ + d ẑ₀ with
/// ẑ ≥ 0, ŵ ≥ 0, ẑ₀ ≥ 0 and ẑᵀŵ = 0. The augmented problem has solutions for arbitrarily large
/// steps along this direction, none of which solves the problem itself (Cottle, Pang & Stone,
/// section 4.4).
///
/// The covering vector d is that of the settings or, by default, that of the balanced problem.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Ray {
    /// ẑ (n entries, none negative, the largest 1), in the caller's units.
    #[cfg_attr(feature = "serde", serde(serialize_with = "super::written::list"))]
    pub direction: DVector<f64>,
    /// ẑ₀ ≥ 0, at the scale of the direction.
    pub covering_rate: f64,
    /// Pivots made.
    pub pivots: usize,
}

/// Why a solve broke down. The first three causes are settings that do not fit, the others lie in the arithmetic.
#[derive(Debug, Clone, PartialEq, Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum BreakdownCause {
    /// The covering vector of the settings has another length than the problem.
    #[error("the covering vector has {given} entries, but the problem has {needed} rows")]
    CoveringLength {
        /// Its length.
        given: usize,
        /// The length of the problem.
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
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number left the range of double precision.
    #[error("a number left the range of double precision")]
    Overflow,
    /// The principal block of the final basis is singular, or so nearly that q is lost in the terms
    /// of M z.
    #[error("the final basis is singular")]
    SingularBasis,
    /// Newton's method, which continues from the complementarity problem of a polygon, reached no smaller residual; see
    /// [`FrictionProblem`](crate::friction::FrictionProblem).
    #[error("Newton's method came no closer than {residual:.1e}, at contact {contact}")]
    NoConvergence {
        /// The least residual that was reached.
        residual: f64,
        /// The contact with this residual, counted from 0.
        contact: usize,
    },
    /// The caller's watch function stopped the solve at this residual; see
    /// [`FrictionProblem::solve_watched`](crate::friction::FrictionProblem::solve_watched).
    #[error("stopped on request at a residual of {residual:.1e}, at contact {contact}")]
    Stopped {
        /// The least residual that was reached.
        residual: f64,
        /// The contact with this residual, counted from 0.
        contact: usize,
    },
    /// The final basis was reached, but its point misses the tolerance for these residuals.
    #[error("the point of the final basis misses its tolerance, {0}")]
    Residual(Residuals),
}
