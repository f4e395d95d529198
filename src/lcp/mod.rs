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
//! [`Lcp::solve`] follows Lemke's path. In exact arithmetic the path ends after finitely many
//! pivots in a solution or in a secondary ray. Which of the two depends on M (Cottle, Pang & Stone,
//! *The Linear Complementarity Problem*, 1992, chapters 3 and 4):
//!
//! | M | means | then |
//! |---|---|---|
//! | positive definite, or a P-matrix (all principal minors positive) | one solution for every q (3.3.7) | it is found |
//! | strictly copositive (zᵀMz > 0 for 0 ≠ z ≥ 0) | a solution for every q (3.8.5) | one is found |
//! | positive semidefinite, or copositive-plus | solvable if {z ≥ 0, Mz + q ≥ 0} is not empty (3.8.6) | one is found, and a ray proves that there is none (4.4.12) |
//! | any other | perhaps no solution, perhaps many | a ray proves nothing |
//!
//! [`Outcome`] says which of these happened. It says "solved" only after the residuals have been
//! recomputed from the M and q given. A ray that proves nothing is not the end: [`Lcp::solve_with`]
//! lists the attempts that follow it.
//!
//! Proofs that there is no solution are checked without rounding. [`Lcp::verify`] proves on request, with bounds, that a basis has an exact solution.
//!
//! # Units, ties, cost
//!
//! z_i and w_i have the units that M and q give them. Rows and columns of M are balanced first, by
//! powers of two, so the path does not depend on units (A. R. Curtis and J. K. Reid, *On the
//! automatic scaling of matrices for Gaussian elimination*, 1972).
//!
//! Where several variables reach zero together, the lexicographic rule (section 4.9) decides which
//! of them leaves: the variable that would be first with q + ε p in place of q, ε → 0+. The
//! vector p is fixed and without structure. Under this rule no path comes back to an earlier basis.
//!
//! A pivot costs O(n²) flops. The path takes O(n²) memory besides M, which a [`Workspace`] or a
//! [`Series`] keeps.

// From the ground up: `tolerances` holds every number that a value is compared with.
// `problem` is checked input, `scaling` balances it, and a `dictionary` represents one basis of it.
// `path`, `lemke` and `refactor` walk through dictionaries and compute them afresh.
// `point` and `conclusion` check the end of a path against the data.
// `farkas` and `exclusion` prove without rounding that there is no solution, `verified` that there is one.
// One `attempt` is one path with its end; the `ladder` goes from one attempt to the next.
// The entry points come last: `solve`, `enumerate`, `series`, `parametric`, `mixed`.

mod attempt;
mod basis;
mod certificate;
mod conclusion;
mod dictionary;
mod enumerate;
mod error;
mod exclusion;
mod farkas;
mod few_rows;
mod given;
mod kernel;
mod ladder;
mod lemke;
mod linear_program;
mod logarithms;
mod matrix_class;
mod memory;
mod mixed;
mod outcome;
mod parametric;
mod path;
mod pattern;
mod point;
mod principal;
mod problem;
mod quadratic_program;
mod ratio;
mod reduction;
mod refactor;
mod residuals;
mod scaling;
mod series;
mod settings;
mod solution;
mod solve;
pub(crate) mod tolerances;
mod verified;
mod vertices;
mod workspace;
#[cfg(feature = "serde")]
mod written;

pub use basis::{Basis, Variable};
pub use enumerate::AllSolutions;
pub use error::LcpError;
pub use matrix_class::{Copositivity, Definiteness, Guarantee, MatrixClass};
pub use mixed::{MixedLcp, MixedSolution};
pub use outcome::{BreakdownCause, Certificate, Outcome, OutcomeView, Ray};
pub use parametric::{Breakpoint, Parametric, PathEnd, Trend};
pub use problem::Lcp;
pub(crate) use quadratic_program::quadratic_program;
pub use residuals::Residuals;
pub use series::Series;
pub use settings::Settings;
pub use solution::{Solution, SolutionView};
pub use verified::Verified;
pub use workspace::Workspace;
#[cfg(feature = "serde")]
pub(crate) use written::list;
