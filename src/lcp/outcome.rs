//! How a solve can end.

use super::basis::Basis;
use super::residuals::Residuals;
use nalgebra::DVector;

/// What is known when Lemke's method ends.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Outcome {
    /// A solution was found and checked against the M and q given.
    Solved(Solution),
    /// The path ended in a secondary ray: along it z₀ never reaches zero.
    ///
    /// [`Ray::proof`] says whether this proves that there is no solution. If it proves nothing,
    /// nothing is known: every way of going on that the [`Settings`](super::Settings) allow has
    /// been tried.
    Ray(Ray),
    /// The pivot limit was reached first; nothing is known about the problem.
    PivotLimit {
        /// Pivots made.
        pivots: usize,
    },
    /// The computation could not be carried through in double precision. Nothing is known about the
    /// problem.
    Breakdown {
        /// Pivots made until then.
        pivots: usize,
        /// What went wrong.
        cause: BreakdownCause,
    },
}

impl Outcome {
    /// The solution, if there is one.
    #[must_use]
    pub fn solution(&self) -> Option<&Solution> {
        if let Self::Solved(solution) = self { Some(solution) } else { None }
    }
}

/// A solution 0 ≤ z ⟂ w = M z + q ≥ 0.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// z (n entries, none negative).
    pub z: DVector<f64>,
    /// w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: DVector<f64>,
    /// Which z_i are basic.
    pub basis: Basis,
    /// The violations at z, recomputed from the M and q given, before zeros are set in w = M z + q.
    pub residuals: Residuals,
    /// Pivots made, on all paths.
    pub pivots: usize,
    /// Whether a basic variable is zero: other bases then stand for this point as well, and the
    /// solution may be one of several.
    pub degenerate: bool,
}

/// The secondary ray on which the path ended.
///
/// Let ẑ, ŵ be the direction and ẑ₀ the rate of the covering variable. Then ŵ = M ẑ + d ẑ₀ with
/// ẑ ≥ 0, ŵ ≥ 0, ẑ₀ ≥ 0 and ẑᵀŵ = 0. The augmented problem has solutions for arbitrarily large
/// steps along this direction, none of which solves the problem itself (Cottle, Pang & Stone,
/// section 4.4).
///
/// The ray is that of the first path. Its covering vector d is that of the settings or, by default,
/// that of the balanced problem. The direction is zero if that path ended otherwise and the proof
/// was found afterwards.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Ray {
    /// ẑ (n entries, none negative, the largest 1), in the caller's units.
    pub direction: DVector<f64>,
    /// ẑ₀ ≥ 0, at the scale of the direction.
    pub covering_rate: f64,
    /// The proof that the ray contains, or that was found after it.
    pub proof: Proof,
    /// Pivots made.
    pub pivots: usize,
}

/// Whether a problem on which Lemke's method met a ray is known to have no solution.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Proof {
    /// No z ≥ 0 has M z + q ≥ 0, by Farkas' lemma, for the M and q given.
    ///
    /// The vector y (n entries) has y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0. But z ≥ 0 and M z + q ≥ 0 imply
    /// yᵀ(M z + q) ≥ 0. [`Lcp::proves_infeasible`](super::Lcp::proves_infeasible) checks y without rounding.
    Infeasible(DVector<f64>),
    /// Some M and q that differ from those given by rounding are infeasible, by the Farkas vector y (n entries).
    ///
    /// Those given may have a z ≥ 0 with M z + q ≥ 0, but none that is small:
    /// [`Lcp::least_feasible`](super::Lcp::least_feasible) bounds it from below. Data that were computed say no more as a rule.
    NearlyInfeasible(DVector<f64>),
    /// None of the 2ⁿ complementary bases stands for a solution, for the M and q given: each was excluded by a vector that was
    /// checked without rounding. No Farkas vector of the whole was found, so z ≥ 0 with M z + q ≥ 0 should exist.
    NoComplementaryBasis,
    /// Nothing is proved.
    None,
}

/// Why a solve broke down. The first three causes are settings that do not fit, the others lie in the arithmetic.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum BreakdownCause {
    /// The covering vector of the settings has another length than the problem.
    CoveringLength {
        /// Its length.
        given: usize,
        /// The length of the problem.
        needed: usize,
    },
    /// An entry of the covering vector is negative or not finite, or is zero in a row with q_i < 0.
    CoveringEntry {
        /// Row of the entry.
        row: usize,
        /// The entry.
        value: f64,
    },
    /// A tolerance of the settings is negative, infinite or not a number.
    Tolerance {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number left the range of double precision.
    Overflow,
    /// The principal block of the final basis is singular, or so nearly that q is lost in the terms
    /// of M z.
    SingularBasis,
    /// The final basis was reached, but its point misses the tolerance for these residuals.
    Residual(Residuals),
}
