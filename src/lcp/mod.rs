//! The linear complementarity problem: find z with
//!
//! ```text
//! 0 ≤ z  ⟂  w = M z + q ≥ 0,
//! ```
//!
//! that is, z ≥ 0, w ≥ 0 and z_i w_i = 0 for every i. This module is independent of contacts.
//!
//! | symbol | meaning | size |
//! |---|---|---|
//! | M | any real square matrix, dense | n × n |
//! | q | any real vector | n |
//! | z, w | unknowns and slacks, complementary in pairs | n |
//! | d, z₀ | covering vector and covering variable of the augmented problem w = q + M z + d z₀ | n, 1 |
//! | α | set of the i with z_i basic; M_αα is the principal block | |
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
//! | positive semidefinite, or copositive-plus | solvable if {z ≥ 0, Mz + q ≥ 0} is not empty (3.8.6) | one is found; a ray proves that none exists (4.4.12) |
//! | any other | perhaps no solution, perhaps many | a ray proves nothing |
//!
//! [`Outcome`] is "solved" only after the residuals have been recomputed from the given M and q. If a ray proves nothing, further attempts follow,
//! which [`Lcp::solve_with`] lists.
//!
//! Proofs that no solution exists are checked without rounding.
//!
//! # Units, ties, cost
//!
//! z_i and w_i have the units that follow from M and q. Rows and columns of M are balanced first, by powers of two, so that the path does not
//! depend on units (A. R. Curtis and J. K. Reid, *On the automatic scaling of matrices for Gaussian elimination*, 1972).
//!
//! If several variables reach zero together, the lexicographic rule (section 4.9) chooses the variable that leaves: the one that reaches zero first
//! if q is replaced by q + ε p, ε → 0+. The vector p is fixed and generic. With this rule no path returns to an earlier basis.
//!
//! A pivot costs O(n²) flops. The path needs scratch buffers of O(n²) numbers in addition to M. A [`Workspace`] or a [`Series`] keeps them from
//! problem to problem.

// The files of this module, lowest level first. `tolerances` holds every number with which a value is compared. `problem` is validated input,
// `scaling` balances its rows and columns, and a `dictionary` represents one of its bases. `path`, `lemke` and `refactor` move from dictionary to
// dictionary and recompute dictionaries. `point` and `conclusion` check the end of a path against the given M and q. `farkas` and `exclusion` prove
// without rounding that no solution exists. One `attempt` is one path with its end; the `ladder` defines the sequence of attempts. The entry points
// are `solve`, `enumerate`, `series` and `parametric`.

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
mod kernel;
mod ladder;
mod lemke;
mod linear_program;
mod logarithms;
mod memory;
mod outcome;
mod p_matrix;
mod parametric;
mod path;
mod pattern;
mod point;
mod principal;
mod problem;
mod quadratic_program;
mod ratio;
mod refactor;
mod residuals;
mod scaling;
mod series;
mod settings;
mod solution;
mod solve;
pub(crate) mod tolerances;
mod vertices;
mod workspace;
#[cfg(feature = "serde")]
mod written;

pub use basis::{Basis, Variable};
pub use enumerate::AllSolutions;
pub use error::LcpError;
pub use outcome::{BreakdownCause, Certificate, Outcome, OutcomeView, Ray};
pub use parametric::{Breakpoint, Parametric, PathEnd, Trend};
pub use problem::Lcp;
pub(crate) use quadratic_program::quadratic_program;
pub use residuals::Residuals;
pub use series::Series;
pub use settings::Settings;
pub use solution::{Solution, SolutionView};
pub use workspace::Workspace;
#[cfg(feature = "serde")]
pub(crate) use written::list;
