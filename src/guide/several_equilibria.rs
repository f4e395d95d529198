//! Several equilibria under one load, and which of them is real.
//!
//! Coulomb's law is not the condition for a minimum of an energy. If friction is large enough to hold a body against the springs that support it, the
//! same load may have an equilibrium with a sticking contact, one with a sliding contact and one with an open contact (A. Klarbring, "Examples of
//! non-uniqueness and non-existence of solutions to quasistatic contact problems with friction", *Ingenieur-Archiv* 60, 1990). In his example, here
//! with numbers, springs hold a body above a floor. Components are tangential to the floor (t), then normal to it (n). Pulled along the floor the
//! body is lifted by its springs, since their stiffness
//!
//! ```text
//! K = ⎡ 2 -1⎤      couples the two directions,      K⁻¹ = ⅓ ⎡2 1⎤      and  μ = 3 > K_tt / |K_tn| = 2.
//!     ⎣-1  2⎦                                               ⎣1 2⎦
//! ```
//!
//! Under the load W = (2.5, -1) the body may hang free, lifted by (K⁻¹W)_n = 1/6, or rest on the floor, whose friction keeps it from being lifted:
//!
//! ```
//! use grasp_lcp::equilibrium::{ContactState, FoundBy};
//! use grasp_lcp::load_path::Leg;
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! let spring = |x: f64| Contact::new([x, 0.0], [1.0, -1.0]).series_stiffness(1.5, 0.5).friction(1.0).bonded();
//! let floor = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(100.0, 100.0).friction(3.0);
//! let grasp = Grasp::new([spring(-1.0), spring(1.0), floor])?;
//! let load = Wrench::force([2.5, -1.0]);
//!
//! let all = grasp.equilibria(&load)?;
//! let has = |what: fn(&ContactState<2>) -> bool| all.iter().filter(|e| what(&e.contacts[2].state)).count();
//! assert_eq!(has(|s| matches!(s, ContactState::Sticking)), 1);
//! assert_eq!(has(|s| matches!(s, ContactState::Sliding { .. })), 1);
//! assert_eq!(has(|s| matches!(s, ContactState::Separated)), 1);
//! let hangs = all.iter().find(|e| e.contacts[2].state == ContactState::Separated).ok_or("one hangs free")?;
//! assert!((hangs.contacts[2].gap - 1.0 / 6.0).abs() < 1e-15);
//!
//! // The one in which everything sticks comes first.
//! let outcome = grasp.solve(&load)?;
//! assert_eq!(outcome.equilibrium().map(|e| e.rule), Some(FoundBy::EverythingSticks));
//!
//! // The history decides which one occurs: pressed down and then pulled, the body stays on the floor; pulled and then
//! // pressed down, it hangs free.
//! let (down, along) = (Wrench::force([0.0, -1.0]), Wrench::force([2.5, 0.0]));
//! for (first, state) in [(down, ContactState::Sticking), (along, ContactState::Separated)] {
//!     let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(first), Leg::load_to(load)])?;
//!     path.run();
//!     let end = path.state_at(1, 1.0).ok_or("the path is completed")?;
//!     assert_eq!(end.contacts[2].state, state);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which one is returned
//!
//! [`Grasp::solve`](crate::ask::Grasp::solve) returns the first equilibrium that the methods of [`FoundBy`](crate::equilibrium::FoundBy) find, in
//! this order:
//!
//! * everything sticks;
//! * everything that touches sticks;
//! * in space, with fewer than 32 contacts, the point to which viscous slip leads from the equilibrium in which everything sticks, if that point is
//!   an equilibrium;
//! * in space and from 32 contacts on, the point that Newton's method reaches from the solution in which everything sticks;
//! * the end of a path of Lemke's method;
//! * the first combination of contact states, in a fixed order, that has an equilibrium.
//!
//! [`Equilibrium::rule`](crate::equilibrium::Equilibrium::rule) names the method that found the equilibrium. The order is the same for every number
//! of threads, but it is a convention, not physics. Relaxation by viscous slip makes the returned equilibrium continuous. For nearly equal loads,
//! clamping forces or coefficients of friction it ends in nearly equal equilibria, as long as these are stable.
//!
//! # Which one is real
//!
//! * For few contacts [`Grasp::equilibria`](crate::ask::Grasp::equilibria) lists all equilibria. If there is only one, it is the real one. (On the
//!   round cone the list has those equilibria that are found from the states of a polygonal cone.)
//! * [`Grasp::follow`](crate::ask::Grasp::follow) computes the equilibrium that occurs: it starts where the history is known and follows the load.
//!   [`Event::other_continuations`](crate::load_path::Event::other_continuations) lists the other continuations at an event at which even the path
//!   leaves a choice.
//! * A grasp that must hold after any history must hold in each of these equilibria.
