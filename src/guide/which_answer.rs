//! How far answers can be trusted: which numbers of an answer to use, and when.
//!
//! # Three outcomes
//!
//! A question about equilibrium has one of three outcomes.
//!
//! | [`Outcome`](crate::equilibrium::Outcome) | meaning | use |
//! |---|---|---|
//! | `Equilibrium` | forces, motion and states that satisfy every condition, checked against the question | use it, after checking the fields below |
//! | `NoEquilibrium` | a [proof](crate::equilibrium::Proof) that quasi-static equilibrium is impossible | the grasp gives way; the motion in the proof shows how |
//! | `Undecided` | neither an equilibrium nor a proof was found, for the [reason](crate::equilibrium::Doubt) in the answer | neither "holds" nor "fails": raise [`most_states`](crate::Settings::most_states), or treat it as a failure |
//!
//! `Undecided` has three causes. Many contacts are at the limit of friction. The load lies, up to rounding, on the boundary of the loads that the
//! grasp can hold. The numbers of a scene differ so much in magnitude that forces cannot be represented.
//!
//! # The quality of an equilibrium
//!
//! * [`residuals`](crate::equilibrium::Equilibrium::residuals): how far the answer violates force balance and the laws of springs, friction cones and
//!   gaps, recomputed from contacts, commands and load; about 1e-16. They show that the answer solves the question, not that the numbers of the
//!   question are accurate.
//! * [`accuracy`](crate::ask::Grasp::accuracy): the estimated distance of forces (N) and displacements (m) to the exact solution for the contact
//!   states of the answer. In comparisons with exact arithmetic the true distance is at most ten times the estimate. Its field `condition` is the
//!   condition number: the relative error of the forces divided by the relative error of the numbers of the question. If a measured number is known
//!   to 1 % and the condition number is 50, no digit of a force is reliable, however small the residual.
//! * [`distinct`](crate::ask::Grasp::distinct): whether rounding errors are too small to change the state of a contact. Exactly at first slip, a
//!   sticking and a sliding contact have the same forces. The state then depends on rounding, and `distinct` says so.
//! * [`margin`](crate::equilibrium::ContactAnswer::margin): the additional friction force that a contact could take before it slides,
//!   `μ F_n - |F_t|`, N. If friction is known to 10 %, a contact with a margin below 10 % of `μ F_n` may slide.
//!   [`Grasp::onset_of_samples`](crate::ask::Grasp::onset_of_samples) computes the load at first slip for samples of friction, stiffness and clamping
//!   force.
//! * [`free_motions`](crate::equilibrium::Equilibrium::free_motions): motions of the object that nothing resists. The forces are determined; the
//!   twist is one of many possible twists.
//! * [`rule`](crate::equilibrium::Equilibrium::rule): the rule by which the equilibrium was found. With any other rule than
//!   [`EverythingSticks`](crate::equilibrium::FoundBy::EverythingSticks) the equilibrium may be one of several: see
//!   [`several_equilibria`](super::several_equilibria).
//!
//! # Questions and methods
//!
//! | question | method | why no other method |
//! |---|---|---|
//! | Does it hold this load without sliding? | [`Grasp::onset`](crate::ask::Grasp::onset): the load factor at first slip is above 1 | `solve` also finds equilibria with sliding |
//! | Does it hold at all? | [`Grasp::solve`](crate::ask::Grasp::solve), or [`follow`](crate::ask::Grasp::follow) to the limit load | after first slip other contacts often take over the load, and the grasp still holds |
//! | Where does the object come to rest after loading and unloading? | [`Grasp::follow`](crate::ask::Grasp::follow) | `solve` knows no history: all slip starts from zero |
//! | Which of a million grasps? | [`screening`](crate::screening) | the same load or angle at first slip, or the same least squeeze, without the rest of the answer |
//! | How do the onsets of a million grasps change with all their data? | [`onset_gradients_of_batch`](crate::sweep::onset_gradients_of_batch) | exact derivatives of the onset, and whether they hold on one side only |
//! | Which margin do the measured forces have, in a control loop? | [`Fingers::watch`](crate::screening::Fingers::watch) | distance to the friction limit (N), load at first slip and the additional clamping force that is needed, without allocation |
//! | Can the quadratic program of minimum energy be used? | [`Energy::agreement`](crate::ask::Energy::agreement) | beyond the load factor of this answer, the quadratic program returns forces that do not balance the load |
//!
//! ```
//! use grasp_lcp::load_path::{Leg, PathEnd};
//! use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
//!
//! // Three fingers under a body of 5 N, which is pulled sideways. The middle one carries least.
//! let finger = |x: f64, press: f64| {
//!     Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).friction(0.5).command([press, 0.0])
//! };
//! let grasp = Grasp::new([finger(-1.0, 0.02), finger(0.0, 0.01), finger(1.0, 0.02)])?;
//! let weight = Wrench::force([0.0, -5.0]);
//! let pull = Wrench::force([1.0, 0.0]);
//!
//! // The load is shared evenly, so that the middle finger slides at 3 · 0.5 · 1 N …
//! let onset = grasp.onset(Ramp::load(weight, pull))?.factor();
//! assert!(onset.is_some_and(|factor| (factor - 1.5).abs() < 1e-12));
//! // … but the others hold until friction is used up everywhere: 0.5 · 5 N.
//! let mut path = grasp.follow(weight, &[Leg::load_by(Wrench::force([10.0, 0.0]))])?;
//! path.run();
//! let Some(PathEnd::Lost(loss)) = path.end() else { panic!("something gives way") };
//! assert!((10.0 * loss.fraction - 2.5).abs() < 1e-12);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
