//! Frictional contact problems (W, q, μ), as they arise in the dynamics of many rigid or flexible bodies.
//!
//! Given n contacts in the plane (C = 2) or in space (C = 3), find forces r and velocities u with
//!
//! ```text
//! u = W r + q,     and at each contact Coulomb's law between u_i and r_i:
//!
//!     open      r = 0,                                u_N ≥ 0
//!     sticking  u = 0,                                ‖r_T‖ ≤ μ r_N
//!     sliding   u_N = 0,   r_T = −μ r_N u_T / ‖u_T‖,  r_N ≥ 0
//! ```
//!
//! This module is independent of grasps. It solves problems in the form in which Siconos, FCLIB and Pinocchio pose them, so that this crate can
//! be checked against these programs.
//!
//! | symbol | meaning | dimension |
//! |---|---|---|
//! | W | Delassus matrix: change of the velocities per unit contact force; any real matrix | C n × C n |
//! | q | velocities without contact forces | C n |
//! | μ | friction of each contact, finite, not negative | n |
//! | r, u | forces and relative velocities: for each contact the normal component first, then the tangential components | C n |
//!
//! The normal points so that u_N > 0 separates and r_N > 0 presses. All consistent units are allowed, also displacements in place of velocities
//! or impulses in place of forces.
//!
//! All three cases are one condition. With û = u + μ ‖u_T‖ n it reads: r lies in the cone K = { ‖r_T‖ ≤ μ r_N }, û lies in its dual cone, and û ⟂ r
//! (G. de Saxcé and Z.-Q. Feng, *The bipotential method*, Math. Comput. Modelling 28, 1998). Simulators that omit the term μ ‖u_T‖ n solve a convex
//! problem in which sliding contacts lift off; this module includes the term.
//!
//! ```
//! use grasp_lcp::friction::{ContactMode, SpatialContacts};
//! use nalgebra::{DMatrix, DVector};
//!
//! // A block on the floor is pushed sideways, harder than friction holds: W is the identity over its mass.
//! let mass = 2.0;
//! let problem = SpatialContacts::new(
//!     DMatrix::identity(3, 3) / mass,
//!     DVector::from_vec(vec![-9.81, 3.0, 4.0]),
//!     vec![0.3],
//! )?;
//! let outcome = problem.solve();
//! let solution = outcome.solution().expect("the floor carries it");
//! assert_eq!(solution.states, [ContactMode::Sliding]);
//! let normal = 9.81 * mass;
//! assert!((solution.r[0] - normal).abs() < 1e-12);
//! assert!((solution.r[1] + 0.3 * normal * 0.6).abs() < 1e-12);
//! # Ok::<(), grasp_lcp::friction::Error>(())
//! ```
//!
//! # Method
//!
//! An island is a set of contacts that are coupled by W, directly or through others. Each island is solved as a separate problem.
//!
//! **A few contacts.** With a polygon of facets in place of each cone the problem is a linear complementarity problem, which Lemke's method solves
//! ([`FrictionProblem::facets`]; D. E. Stewart and J. C. Trinkle, Int. J. Numer. Methods Eng. 39, 1996). In the plane two facets are the cone itself,
//! so facets cause no error. In space Newton's method starts from the forces on the polygon and solves the round cone (P. Alart and A. Curnier,
//! Comput. Methods Appl. Mech. Eng. 92, 1991). If Newton's method does not converge, the facets are rotated towards the slip directions, and the
//! method starts again.
//!
//! **Many contacts, or a few for which facets fail.** Gauss–Seidel sweeps with the exact force of one contact at a time (M. Jean, Comput. Methods
//! Appl. Mech. Eng. 177, 1999) find the magnitude of the forces. From these forces the solver follows the central path û ∘ r = τ as τ decreases to
//! zero (∘ is the Jordan product of the cone). The path lies inside the cones. No contact has to be declared open, sticking or sliding before the end
//! of the path (M. Fukushima, Z.-Q. Luo and P. Tseng, SIAM J. Optim. 12, 2001). For a few contacts the solver also follows the path around the folds
//! that friction causes. Newton's method makes the last steps. Until its last few steps a proximal term holds the forces near given forces, the
//! anchor, because the forces of redundant contacts are not determined.
//!
//! W is stored in blocks, so zero blocks cost nothing. [`FrictionProblem::solve_watched`] reports progress and can be stopped.
//!
//! W may be singular, as with redundant contacts; the forces are then one of many solutions. W need not be symmetric.
//!
//! Every solution is checked on the given W, q and μ, each contact relative to its own force and the terms of its velocity, see [`Residuals`]. A
//! vector that [`FrictionProblem::proves_infeasible`] checks is a proof that no solution exists.

// Files. Input: `problem` validates it. Law: `law` computes residuals of Coulomb's law, `checked_solution` accepts forces as a solution. `solve`
// chooses the methods, `islands` splits the problem. A few contacts: `facets` poses the complementarity problem, `polygons` and `newton` continue on
// the round cone. Many contacts: `approach` combines `sweeps` over `one_contact`, the `central_path` (around its `folds`) and `alart_curnier`.
// `central_path` and `alart_curnier` have the form of `equations` in `blocks`, solved by `elimination`. `certificate` proves that no solution exists.
// `tolerances` holds the limits for rounding.

mod alart_curnier;
mod approach;
mod blocks;
mod central_path;
mod certificate;
mod checked_solution;
mod elimination;
mod equations;
mod error;
mod facets;
mod folds;
mod islands;
mod law;
mod newton;
mod one_contact;
mod polygons;
mod problem;
mod progress;
mod settings;
mod solution;
mod solve;
mod sweeps;
mod tolerances;

pub use error::Error;
pub use facets::FacetedProblem;
pub use law::{ContactMode, Residuals};
pub use problem::{FrictionProblem, PlanarContacts, SpatialContacts};
pub use progress::SolveProgress;
pub use settings::Settings;
pub use solution::Solution;
