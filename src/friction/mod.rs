//! Frictional contact problems (W, q, μ), as they come from mechanics of many rigid or flexible bodies.
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
//! This room knows nothing of grasps. It takes the problems of others, as Siconos, FCLIB and Pinocchio pose them, and lets them
//! check this crate.
//!
//! | symbol | meaning | size |
//! |---|---|---|
//! | W | Delassus matrix: how forces change velocities; any real matrix | C n × C n |
//! | q | velocities without contact forces | C n |
//! | μ | friction of each contact, finite, not negative | n |
//! | r, u | forces and relative velocities: of each contact the normal component first, then the tangential ones | C n |
//!
//! The normal points so that u_N > 0 separates and r_N > 0 presses. Any units do that fit: displacements in place of velocities, impulses
//! in place of forces.
//!
//! The three cases are one condition, with û = u + μ ‖u_T‖ n: the dual cone of K = { ‖r_T‖ ≤ μ r_N } contains û, K contains r, and û ⟂ r
//! (G. de Saxcé and Z.-Q. Feng, *The bipotential method*, Math. Comput. Modelling 28, 1998). Simulators that leave out μ ‖u_T‖ n solve a convex problem in which
//! sliding contacts lift off; it is in here.
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
//! # How it is solved
//!
//! Contacts that move each other, directly or through others, are an island; each island is a problem by itself.
//!
//! A few contacts: with a polygon of facets in place of the cone it is a linear complementarity problem ([`FrictionProblem::facets`]; D. E. Stewart and
//! J. C. Trinkle, Int. J. Numer. Methods Eng. 39, 1996), which Lemke's method solves. In the plane two facets are the cone itself, and the answer
//! is exact. In space Newton's method goes on from there on the round cone (P. Alart and A. Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991). Where it does
//! not arrive, the facets are turned to where the contacts slide, and it starts once more.
//!
//! Many contacts, and few where that leads nowhere: sweeps of Gauss–Seidel with exact answers of each contact (M. Jean, Comput. Methods Appl. Mech. Eng. 177,
//! 1999) find how large the forces are. From there it follows the path û ∘ r = τ through the inside of the cones as τ goes to zero, where no contact
//! has to decide early what it does (M. Fukushima, Z.-Q. Luo and P. Tseng, SIAM J. Optim. 12, 2001), of a few contacts around the folds that friction makes in
//! it. Newton's method makes the last steps, held near where it stands because redundant contacts leave forces open. W is taken by blocks: what vanishes in it
//! costs nothing. [`FrictionProblem::solve_watched`] tells how far it has come, and may be stopped.
//!
//! W may be singular, as where contacts are redundant: forces are then one solution of many. W need not be symmetric.
//!
//! Whatever is called solved has been checked on the data given, each contact beside its own sums, see [`Residuals`]. That there is no solution is
//! proved by a vector which [`FrictionProblem::proves_infeasible`] checks.
//!
//! [`ReadProblem`] takes the files of Siconos; `python/examples/fclib_to_text.py` makes such files of FCLIB's HDF5.

// `problem` is checked input, `siconos` reads it; `law` says how well forces obey it, `settled` what is called a solution.
// `solve` says which way a problem goes, `islands` takes it apart.
// A few contacts: `facets` poses the complementarity problem, `polygons` and `newton` go on to the round cone.
// Many: `approach` goes by `sweeps` of `one_contact` after the other, the `central_path` (around its `folds`) and `alart_curnier`; both are
// `equations` by `blocks`, solved by `elimination`.
// `certificate` proves that there is no solution.

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
mod siconos;
mod siconos_matrix;
mod solution;
mod solve;
mod sweeps;

pub use error::Error;
pub use facets::FacetedProblem;
pub use law::{ContactMode, Residuals};
pub use problem::{FrictionProblem, PlanarContacts, SpatialContacts};
pub use progress::SolveProgress;
pub use settings::Settings;
pub use siconos::ReadProblem;
pub use solution::Solution;
