//! Frictional contact problems (W, q, μ), as they arise in the mechanics of many rigid or flexible bodies.
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
//! This module knows nothing of grasps. It solves problems of other programs, as Siconos, FCLIB and Pinocchio pose them, so that
//! this crate can be checked against theirs.
//!
//! | symbol | meaning | size |
//! |---|---|---|
//! | W | Delassus matrix: change of velocities by forces; any real matrix | C n × C n |
//! | q | velocities without contact forces | C n |
//! | μ | friction of each contact, finite, not negative | n |
//! | r, u | forces and relative velocities: of each contact the normal component first, then the tangential ones | C n |
//!
//! The normal points so that u_N > 0 separates and r_N > 0 presses. Any consistent units will do, also displacements in place of velocities or
//! impulses in place of forces.
//!
//! The three cases are one condition, with û = u + μ ‖u_T‖ n: the dual cone of K = { ‖r_T‖ ≤ μ r_N } contains û, K contains r, and û ⟂ r (G. de Saxcé
//! and Z.-Q. Feng, *The bipotential method*, Math. Comput. Modelling 28, 1998). Simulators that omit μ ‖u_T‖ n solve a convex problem in which
//! sliding contacts lift off; this module includes it.
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
//! An island is a set of contacts that move each other, directly or through others. Each island is solved as a problem by itself.
//!
//! **A few contacts.** With a polygon of facets in place of the cone the problem is a linear complementarity problem ([`FrictionProblem::facets`]; D.
//! E. Stewart and J. C. Trinkle, Int. J. Numer. Methods Eng. 39, 1996), which Lemke's method solves. In the plane two facets are the cone itself, and
//! the answer is exact. In space Newton's method continues from the polygon's forces on the round cone (P. Alart and A. Curnier, Comput. Methods
//! Appl. Mech. Eng. 92, 1991). Where it does not converge, the facets are turned towards the slips, and it starts again.
//!
//! **Many contacts, and few where facets fail.** Gauss–Seidel sweeps with the exact force of one contact at a time (M. Jean, Comput. Methods Appl.
//! Mech. Eng. 177, 1999) find the size of the forces. From there the solver follows the path û ∘ r = τ through the inside of the cones as τ goes to
//! zero. On this path no contact has to choose its state early (M. Fukushima, Z.-Q. Luo and P. Tseng, SIAM J. Optim. 12, 2001). For a few contacts it
//! also follows this path around the folds that friction makes in it. Newton's method makes the last steps. They are held near an anchor, because the
//! forces of redundant contacts are not determined.
//!
//! W is used in blocks, so blocks that vanish cost nothing. [`FrictionProblem::solve_watched`] reports its progress and can be stopped.
//!
//! W may be singular, as with redundant contacts: the forces are then one solution of many. W need not be symmetric.
//!
//! Every solution has been checked on the data given, each contact relative to its own force and terms, see [`Residuals`]. A vector that
//! [`FrictionProblem::proves_infeasible`] checks proves that there is no solution.

// `problem` is checked input; `law` measures how far forces miss Coulomb's law, `settled` makes a solution of forces. `solve`
// chooses the methods, `islands` splits the problem. A few contacts: `facets` poses the complementarity problem, `polygons` and `newton` continue on
// the round cone. Many: `approach` combines `sweeps` of `one_contact` after the other, the `central_path` (around its `folds`) and `alart_curnier`;
// both of the last are `equations` in `blocks`, solved by `elimination`. `certificate` proves that there is no solution. `tolerances` holds what
// counts as zero.

mod alart_curnier;
mod approach;
mod blocks;
mod central_path;
mod certificate;
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
mod settled;
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
