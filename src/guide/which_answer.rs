//! Which answer to trust, and when.
//!
//! # Three outcomes
//!
//! A question about equilibrium has one of three outcomes.
//!
//! | [`Outcome`](crate::equilibrium::Outcome) | what it says | what to do with it |
//! |---|---|---|
//! | `Equilibrium` | forces, motion and states that satisfy every condition, checked against the question | use it, after a look at the fields below |
//! | `NoEquilibrium` | a [proof](crate::equilibrium::Proof) that quasi-static equilibrium is impossible | the grasp gives way; the motion in the proof says how |
//! | `Undecided` | neither was found, and [why](crate::equilibrium::Doubt) | not "holds" and not "fails": raise [`most_states`](crate::Settings::most_states), or treat it as a failure |
//!
//! `Undecided` comes in three cases. Many contacts may stand on the verge of what friction can do. The load may lie, to the
//! last digit, on the boundary of what the grasp can hold. The numbers of a scene may lie so far apart that forces cannot
//! be written down.
//!
//! # What an equilibrium says of itself
//!
//! * [`residuals`](crate::equilibrium::Equilibrium::residuals): by how much the numbers violate equilibrium, springs, cones and gaps, recomputed
//!   from contacts, commands and load. Some 1e-16. This says that the answer solves the question, not that the question is known well.
//! * [`accuracy`](crate::ask::Grasp::accuracy): estimated distance to the exact solution for these states, N and m (measured against exact arithmetic it is at most ten times that),
//!   and the condition: how many times more the forces change than the data, both relative. Data from a sensor known to 1 % and a condition of 50 leave
//!   no digit of a force, however small the residual.
//! * [`distinct`](crate::ask::Grasp::distinct): whether a contact's state is told apart from its neighbour. At the very onset of
//!   sliding, sticking and sliding are the same forces; which word is used depends on rounding, and the flag says so.
//! * [`margin`](crate::equilibrium::ContactAnswer::margin): friction in reserve, N. Where friction is known to 10 %, a contact with a margin below
//!   10 % of `μ F_n` may slide; [`Grasp::onset_of_samples`](crate::ask::Grasp::onset_of_samples) answers for samples of friction, stiffness and squeeze.
//! * [`free_motions`](crate::equilibrium::Equilibrium::free_motions): motions that nothing resists. The forces are right, the twist is one of many.
//! * [`rule`](crate::equilibrium::Equilibrium::rule): how it was found. Anything but [`EverythingSticks`](crate::equilibrium::Rung::EverythingSticks)
//!   may be one of several: see [`several_equilibria`](super::several_equilibria).
//!
//! # Which question to ask
//!
//! | question | ask | why not another |
//! |---|---|---|
//! | Does it hold this load without sliding? | [`Grasp::onset`](crate::ask::Grasp::onset): a factor above 1 | `solve` also finds equilibria with sliding |
//! | Does it hold at all? | [`Grasp::solve`](crate::ask::Grasp::solve), or [`follow`](crate::ask::Grasp::follow) to the limit load | the onset is often not the limit: other contacts take over |
//! | Where does the object end up after loading and unloading? | [`Grasp::follow`](crate::ask::Grasp::follow) | `solve` knows no history: all slip starts from zero |
//! | Which of a million grasps? | [`screening`](crate::screening) | the same onset, angle of onset or least squeeze, without the answer around it |
//! | How does that change with every number of a million grasps? | [`onset_gradients_of_batch`](crate::sweep::onset_gradients_of_batch) | exact derivatives of the onset, and whether they are one-sided |
//! | In a control loop: what have the forces left that are felt just now? | [`Fingers::watch`](crate::screening::Fingers::watch) | margin, first slip and extra squeeze, without an allocation |
//! | Can the minimum of energy be used? | [`agreement_with_minimum_energy`](crate::ask::Energy::agreement) | beyond its factor the program returns numbers that balance nothing |
//!
//! ```
//! use grasp_lcp::load_path::{Leg, PathEnd};
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
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
//! let onset = grasp.onset_of_sliding(&weight, &pull)?.factor();
//! assert!(onset.is_some_and(|factor| (factor - 1.5).abs() < 1e-12));
//! // … but the others hold until friction is used up everywhere: 0.5 · 5 N.
//! let mut path = grasp.follow(&weight, &[Leg::load_by(Wrench::force([10.0, 0.0]))])?;
//! path.run();
//! let Some(PathEnd::Lost(loss)) = path.end() else { panic!("something gives way") };
//! assert!((10.0 * loss.fraction - 2.5).abs() < 1e-12);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
