//! The linear complementarity problem: find z with
//!
//! ```text
//! 0 ≤ z  ⟂  w = M z + q ≥ 0,
//! ```
//!
//! that is z ≥ 0, w ≥ 0 and z_i w_i = 0 for every i. This module knows nothing of contacts.
//!
//! | symbol | meaning | size |
//! |---|---|---|
//! | M | any real square matrix, dense | n × n |
//! | q | any real vector | n |
//! | z, w | unknowns and slacks, complementary in pairs | n |
//! | d, z₀ | covering vector and covering variable of the augmented problem w = q + M z + d z₀ | n, 1 |
//! | α | the i with z_i basic; M_αα is the principal block | |
//!
//! ```
//! use grasp_lcp::lcp::{Lcp, Outcome};
//! use nalgebra::{DMatrix, DVector};
//!
//! let problem = Lcp::new(
//!     DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]),
//!     DVector::from_vec(vec![-5.0, -6.0]),
//! )?;
//! let Outcome::Solved(solution) = problem.solve() else { panic!("M is positive definite") };
//! assert!((solution.z - DVector::from_vec(vec![4.0 / 3.0, 7.0 / 3.0])).amax() < 1e-15);
//! # Ok::<(), grasp_lcp::lcp::LcpError>(())
//! ```
//!
//! # What Lemke's method guarantees
//!
//! [`Lcp::solve`] follows Lemke's path. In exact arithmetic it ends after finitely many pivots in a solution or in
//! a secondary ray, and (Cottle, Pang & Stone, *The Linear Complementarity Problem*, 1992, chapters 3 and 4):
//!
//! | M | means | then |
//! |---|---|---|
//! | positive definite, or a P-matrix (all principal minors positive) | one solution for every q (3.3.7) | it is found |
//! | strictly copositive (zᵀMz > 0 for 0 ≠ z ≥ 0) | a solution for every q (3.8.5) | one is found |
//! | positive semidefinite, or copositive-plus | solvable if {z ≥ 0, Mz + q ≥ 0} is not empty (3.8.6) | one is found, and a ray proves that there is none (4.4.12) |
//! | any other | perhaps no solution, perhaps many | a ray proves nothing |
//!
//! [`Outcome`] says which of these happened; "solved" is only said after the residuals have been recomputed
//! from the M and q given. A ray that proves nothing is not the end: [`Lcp::solve_with`] tells what is tried next.
//!
//! # Units, ties, cost
//!
//! z_i and w_i have the units that M and q give them. Rows and columns of M are balanced first, by powers of two (A. R. Curtis and J. K. Reid, *On the automatic
//! scaling of matrices for Gaussian elimination*, 1972), so that the path does not depend on units. Where several variables reach zero together,
//! the one leaves that would be first with q + ε p in place of q, ε → 0+ and p fixed and without structure: the lexicographic rule (section 4.9),
//! under which no path comes back to where it was. A pivot costs O(n²) flops and the path O(n²) memory besides M, which a [`Workspace`] or a
//! [`Series`] keeps.

// Formulas stand in the prose in plain Unicode, one-letter symbols with their indices included.
#![allow(clippy::doc_markdown)]

mod basis;
mod certificate;
mod conclusion;
mod dictionary;
mod enumerate;
mod error;
mod kernel;
mod ladder;
mod lemke;
mod logarithms;
mod matrix_class;
mod mixed;
mod outcome;
mod parametric;
mod pattern;
mod principal;
mod ratio;
mod reduction;
mod refactor;
mod residuals;
mod scaling;
mod series;
mod settings;
mod workspace;

pub use basis::{Basis, Variable};
pub use enumerate::AllSolutions;
pub use error::LcpError;
pub use matrix_class::{Copositivity, Definiteness, Guarantee, MatrixClass};
pub use mixed::{MixedLcp, MixedOutcome, MixedResiduals, MixedSolution};
pub use outcome::{BreakdownCause, Outcome, Proof, Ray, Solution};
pub use parametric::{Breakpoint, Parametric, PathEnd, Trend};
pub use residuals::Residuals;
pub use series::Series;
pub use settings::Settings;
pub use workspace::{Answer, SolutionView, Workspace};

use nalgebra::{DMatrix, DVector};

/// A linear complementarity problem (M, q) with finite entries.
#[derive(Debug, Clone, PartialEq)]
pub struct Lcp {
    m: DMatrix<f64>,
    q: DVector<f64>,
}

impl Lcp {
    /// The problem with the n × n matrix M and the vector q of n entries; n may be 0.
    ///
    /// # Errors
    ///
    /// [`LcpError::NotSquare`] for M, [`LcpError::Length`] if q has another length than M has rows, [`LcpError::MatrixEntry`] and
    /// [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn new(m: DMatrix<f64>, q: DVector<f64>) -> Result<Self, LcpError> {
        let n = m.nrows();
        if m.ncols() != n {
            return Err(LcpError::NotSquare { rows: n, columns: m.ncols() });
        }
        if q.len() != n {
            return Err(LcpError::Length { what: "q", given: q.len(), needed: n });
        }
        for column in 0..n {
            for row in 0..n {
                let value = m[(row, column)];
                if !value.is_finite() {
                    return Err(LcpError::MatrixEntry { what: "M", row, column, value });
                }
            }
        }
        if let Some(row) = q.iter().position(|q| !q.is_finite()) {
            return Err(LcpError::VectorEntry { what: "q", row, value: q[row] });
        }
        Ok(Self { m, q })
    }

    /// M.
    #[must_use]
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.m
    }

    /// q.
    #[must_use]
    pub fn vector(&self) -> &DVector<f64> {
        &self.q
    }

    /// The number n of pairs (w_i, z_i).
    #[must_use]
    pub fn len(&self) -> usize {
        self.q.len()
    }

    /// Whether n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.q.is_empty()
    }

    /// Solves the problem by Lemke's method with the default [`Settings`].
    #[must_use]
    pub fn solve(&self) -> Outcome {
        self.solve_with(&Settings::default())
    }

    /// Solves the problem by Lemke's method; an ordinary path has one to three times n pivots.
    ///
    /// Where the first path ends without a solution, but not at a limit on pivots or a wrong covering vector that the caller has set, these
    /// follow, each only if those before have settled nothing:
    ///
    /// 1. the ray itself as a Farkas vector;
    /// 2. a Farkas vector from the linear program min { t : M z + q + t 1 ≥ 0, z, t ≥ 0 };
    /// 3. paths with other covering vectors and from other bases ([`Settings::retries`]);
    /// 4. all 2ⁿ complementary bases of a small problem ([`Settings::enumerate_up_to`]).
    ///
    /// ```
    /// use grasp_lcp::lcp::{Lcp, Outcome, Proof, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = −z − 1 is negative for every z ≥ 0: y = 1 has Mᵀy = −1 ≤ 0 and qᵀy = −1 < 0.
    /// let problem = Lcp::new(DMatrix::from_element(1, 1, -1.0), DVector::from_element(1, -1.0))?;
    /// let Outcome::Ray(ray) = problem.solve_with(&Settings::default().with_retries(0)) else { panic!("w < 0") };
    /// let Proof::Infeasible(y) = ray.proof else { panic!("no z ≥ 0 has w ≥ 0") };
    /// assert!(problem.proves_infeasible(&y));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn solve_with(&self, settings: &Settings) -> Outcome {
        Workspace::new().solve(self, settings).into_outcome()
    }

    /// Solves the problem by Lemke's method from a complementary basis instead of the slacks, such as that of a
    /// neighbouring problem: only what is infeasible there is covered by z₀, so the path is as short as the bases are close.
    ///
    /// A singular basis, a basis of another length, or a path that does not end in a solution lead back to
    /// [`Lcp::solve_with`]. For many q with the same M use a [`Series`].
    ///
    /// ```
    /// use grasp_lcp::lcp::{Basis, Lcp, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = z - 1 is solved where z is basic: started there, no pivot is left to be made.
    /// let problem = Lcp::new(DMatrix::from_element(1, 1, 1.0), DVector::from_element(1, -1.0))?;
    /// let outcome = problem.solve_from(&Basis::from_indices(1, [0]), &Settings::default());
    /// let solution = outcome.solution().expect("M > 0");
    /// assert_eq!((solution.z[0], solution.w[0], solution.pivots), (1.0, 0.0, 0));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn solve_from(&self, basis: &Basis, settings: &Settings) -> Outcome {
        Workspace::new().solve_from(self, basis, settings).into_outcome()
    }

    /// All solutions of a small problem, by trying all 2ⁿ complementary bases: one factorisation of at most n rows each, and a linear
    /// program for each singular one. `None` if n > 20. Of the settings only the tolerances count.
    ///
    /// ```
    /// use grasp_lcp::lcp::{Lcp, Settings};
    /// use nalgebra::{DMatrix, DVector};
    ///
    /// // w = 1 − z in both rows: z_i = 0 or z_i = 1, each by itself.
    /// let problem = Lcp::new(-DMatrix::identity(2, 2), DVector::from_element(2, 1.0))?;
    /// let all = problem.all_solutions(&Settings::default()).expect("n <= 20");
    /// let z: Vec<[f64; 2]> = all.solutions.iter().map(|solution| [solution.z[0], solution.z[1]]).collect();
    /// assert_eq!(z, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    /// assert!(all.singular.is_empty());
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn all_solutions(&self, settings: &Settings) -> Option<AllSolutions> {
        (self.len() <= enumerate::LARGEST).then(|| enumerate::all_solutions(self, settings))
    }

    /// Whether y proves that no z ≥ 0 has M z + q ≥ 0: y ≥ 0, Mᵀy ≤ 0 and qᵀy < 0 (Farkas' lemma).
    ///
    /// Each sum is compared with 8 (n + 2) ε Σ|terms|, ε = 2⁻⁵², the rounding error it may carry: (Mᵀy)_j must not exceed
    /// that, qᵀy must be below minus that. Where the products and sums are exact, so is the proof. A y of another length, or
    /// with a negative entry or one that is not finite, proves nothing.
    #[must_use]
    pub fn proves_infeasible(&self, y: &DVector<f64>) -> bool {
        certificate::check(self, y)
    }

    /// How well z solves the problem. A z of another length, or with entries that are not finite, solves nothing: its
    /// residuals are infinite.
    #[must_use]
    pub fn residuals(&self, z: &DVector<f64>) -> Residuals {
        if z.len() == self.len() {
            residuals::residuals(&self.m, &self.q, z.as_slice())
        } else {
            Residuals::UNUSABLE
        }
    }
}
