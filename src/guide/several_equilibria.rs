//! Several equilibria under one load, and which of them is real.
//!
//! Coulomb's law is not the condition of a minimum. Where friction is large enough to hold a body against its springs, the same load may be held by
//! a contact that sticks, by one that slides and by none at all (A. Klarbring, "Examples of non-uniqueness and non-existence of solutions to
//! quasistatic contact problems with friction", *Ingenieur-Archiv* 60, 1990). His example, with numbers: springs hold a body
//! above a floor; pulled along the floor they lift it, since their stiffness
//!
//! ```text
//! K = ⎡ 2 -1⎤      couples the two directions,      K⁻¹ = ⅓ ⎡2 1⎤      and  μ = 3 > K_tt / |K_tn| = 2.
//!     ⎣-1  2⎦                                               ⎣1 2⎦
//! ```
//!
//! Under the load (2.5, -1) the body may hang free, lifted by (K⁻¹W)_n = 1/6, or rest on the floor, whose friction keeps it from being lifted:
//!
//! ```
//! use grasp_lcp::equilibrium::{ContactState, Rung};
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
//! assert_eq!(outcome.equilibrium().map(|e| e.rule), Some(Rung::EverythingSticks));
//!
//! // Which one comes about depends on what was before: first pressed down and then pulled, the body stays on the floor;
//! // first pulled and then pressed down, it hangs free.
//! let (down, along) = (Wrench::force([0.0, -1.0]), Wrench::force([2.5, 0.0]));
//! for (first, state) in [(down, ContactState::Sticking), (along, ContactState::Separated)] {
//!     let mut path = grasp.follow(&Wrench::ZERO, &[Leg::load_to(first), Leg::load_to(load)])?;
//!     path.run();
//!     let end = path.state_at(1, 1.0).ok_or("the path is completed")?;
//!     assert_eq!(end.contacts[2].state, state);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which one is returned
//!
//! [`Grasp::solve`](crate::ask::Grasp::solve) takes the first that the ladder of [`Rung`](crate::equilibrium::Rung) finds, in this order:
//!
//! * everything sticks;
//! * everything that touches sticks;
//! * in space and from 32 contacts on, where Newton's method arrives from the elastic trial state;
//! * the end of a path of Lemke's method;
//! * the first of all combinations.
//!
//! [`Equilibrium::rule`](crate::equilibrium::Equilibrium::rule) says which. The order is the same for every number of
//! threads, but it is a rule, not physics.
//!
//! # Which one is real
//!
//! * Among few contacts [`Grasp::equilibria`](crate::ask::Grasp::equilibria) lists all of them. If there is only one, that is
//!   it. (On the round cone the list has those that a polygon leads to.)
//! * [`Grasp::follow`](crate::ask::Grasp::follow) has the physics: it starts where the history is known and goes on without jumps;
//!   [`Event::other_continuations`](crate::load_path::Event::other_continuations) says where even that leaves a choice.
//! * [`Energy::stability`](crate::ask::Energy::stability) tells of one in which nothing slides whether a small push leaves it alone.
//! * A grasp that is to hold whatever happened before must hold in each of them.
