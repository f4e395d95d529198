//! Reading a ray: the meaning of a path of Lemke's method that does not end in a solution.
//!
//! A linear complementarity problem asks for z >= 0 and w = q + M z >= 0 with w·z = 0. Lemke's method follows a path of almost complementary
//! solutions of `w = q + M z + d z₀` with a positive vector d, while the covering variable z₀ shrinks. The path ends where z₀ = 0, at a solution, or
//! goes to infinity on a *secondary ray*. For matrices of contact problems without friction (positive semidefinite) a ray proves that there is no
//! solution. With friction M is not even symmetric, and **a ray alone proves nothing**: a solution may lie on another path. The ray is therefore only
//! a reason to search for a proof.
//!
//! # On a linear complementarity problem
//!
//! [`lcp::Outcome`](crate::lcp::Outcome) is a solution, a proof that none exists, or neither. [`Infeasible`](crate::lcp::Outcome::Infeasible) has a
//! vector y with `y ≥ 0`, `Mᵀy ≤ 0`, `qᵀy < 0`, which anyone can check:
//!
//! ```
//! use grasp_lcp::lcp::{Lcp, Outcome};
//! use nalgebra::{DMatrix, DVector};
//!
//! // w₁ = z₁ - z₂ - 1 and w₂ = z₂ - z₁ add up to -1: they cannot both be >= 0.
//! let m = DMatrix::from_row_slice(2, 2, &[1.0, -1.0, -1.0, 1.0]);
//! let q = DVector::from_vec(vec![-1.0, 0.0]);
//! let problem = Lcp::new(m.clone(), q.clone())?;
//! let Outcome::Infeasible(certificate) = problem.solve() else { panic!("no solution exists") };
//! let y = certificate.y;
//! assert!(y.iter().all(|y| *y >= 0.0) && m.tr_mul(&y).amax() < 1e-15 && q.dot(&y) < 0.0);
//! assert!(problem.proves_infeasible(&y));
//! # Ok::<(), grasp_lcp::lcp::LcpError>(())
//! ```
//!
//! The check computes all sums without rounding. A matrix M and a vector q that were computed with rounding usually are infeasible only up to
//! rounding. [`NearlyInfeasible`](crate::lcp::Outcome::NearlyInfeasible) has a y for an M and q that differ from the given ones by rounding, and
//! [`Lcp::least_feasible`](crate::lcp::Lcp::least_feasible) gives a lower bound on Σ z_j for every z ≥ 0 with M z + q ≥ 0.
//!
//! [`NoBasis`](crate::lcp::Outcome::NoBasis): it is proved for each of the 2ⁿ complementary bases that no solution belongs to it, thus no solution
//! exists.
//!
//! [`Ray`](crate::lcp::Outcome::Ray): nothing is known. Raise [`enumerate_up_to`](crate::lcp::Settings::enumerate_up_to), to 20 at most, or formulate
//! the problem differently.
//!
//! # On a grasp
//!
//! A free motion is detected before any path is followed. After a ray [`Grasp::solve`](crate::ask::Grasp::solve) tries another
//! [formulation](crate::forms) of the problem. It then searches for a proof on the grasp itself, in this order:
//!
//! | [`Proof`](crate::equilibrium::Proof) | motion in the proof | meaning | remedy |
//! |---|---|---|---|
//! | `FreeMotion` | nothing resists it in any state | a degree of freedom without springs | another contact, [`SoftFingertip`](crate::grasp::SoftFingertip)s |
//! | `SeparatingMotion` | the load drives it, no admissible force works against it | the load is too large for the friction cones, or has the wrong direction, for any stiffness and squeeze | more friction, other contact points |
//! | `EveryStateTried` | – | forces in the cones could balance the load, but springs and commands do not produce them | more squeeze |
//! | `EveryCaseContradicted` | – | as `EveryStateTried`, on the round cone: directions of friction are divided into cases, and each case is contradicted | more squeeze |
//! | `Undecided`: `RayWithoutProof` | – | no proof was found, and there are too many contacts to try all states | raise [`most_states`](crate::Settings::most_states), or let the load grow from zero with [`follow`](crate::ask::Grasp::follow), which does not depend on the ray |
//!
//! ```
//! use grasp_lcp::equilibrium::{Outcome, Proof};
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! let finger = |side: f64| {
//!     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
//! };
//! let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
//!
//! // 10 N of squeeze hold 10 N; more squeeze would hold more, so no motion separates this load from the cones.
//! let Outcome::NoEquilibrium(slips) = grasp.solve(Wrench::force([0.0, -11.0]))? else { panic!("too much") };
//! assert!(matches!(slips.proof, Proof::EveryStateTried { .. }));
//!
//! // One finger alone cannot be pulled at: whatever its friction and its squeeze.
//! let one = Grasp::new([finger(-1.0)])?;
//! let load = Wrench::force([1.0, 0.0]);
//! let Outcome::NoEquilibrium(parts) = one.solve(&load)? else { panic!("nothing pulls back") };
//! let Proof::SeparatingMotion { motion, work } = parts.proof else { panic!("{:?}", parts.proof) };
//! assert!(motion.object.translation()[0] > 0.0 && work > 0.0);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
