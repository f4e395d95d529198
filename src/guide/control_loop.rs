//! A watch in a control loop, with an operating system and without one.
//!
//! [`Fingers::watch`](crate::screening::Fingers::watch) takes contact forces that were measured just now and the load that is to come. It says what the forces
//! have left, when the first contact slides, and how much more squeeze holds. It allocates nothing and takes the same steps whatever the numbers.
//!
//! # One tick
//!
//! ```
//! use grasp_lcp::Error;
//! use grasp_lcp::spatial::{Fingers, Wrench};
//!
//! /// So much the squeeze may grow in a tick, in parts of the first one.
//! const FASTEST: f64 = 0.01;
//!
//! /// Forces in N along the coordinate axes, as sensors of the fingers feel them; the load that the next 30 ms bring on top of the present one.
//! fn tick(fingers: &Fingers<3>, forces: &[[f64; 3]; 3], to_come: &Wrench, squeeze: &mut f64) -> Result<(), Error> {
//!     let seen = fingers.watch(forces, to_come)?;
//!     // No factor: already one slides, or no squeeze holds. Then press as fast as the motors can.
//!     *squeeze += seen.extra_squeeze().factor().unwrap_or(FASTEST).min(FASTEST);
//!     Ok(())
//! }
//! ```
//!
//! `cargo run --release -p grasp-lcp --example raise_the_squeeze` closes the loop about a bottle that is swung. `cargo run --release -p reports --bin watch_forces`
//! prints the longest time that a tick has taken.
//!
//! # In C
//!
//! `cargo build --release --package grasp-lcp-c` in the repository makes `libgrasp_lcp_c.a` and `.so` for `examples/in_c/grasp_lcp.h`, with fingers in space:
//!
//! ```c
//! grasp_lcp_fingers_t *fingers;
//! char *wrong = grasp_lcp_fingers((slice_ref_grasp_lcp_finger_t){three, 3}, &fingers);
//! …
//! wrong = grasp_lcp_watch(fingers, (slice_ref_grasp_lcp_vector_t){forces, 3}, &to_come, &seen);
//! if (wrong == NULL) squeeze += fmin(seen.extra_squeeze, FASTEST);
//! ```
//!
//! What is wrong comes as a text, NULL if nothing is. A squeeze that is not known is NAN, of which `fmin` makes the other number. `examples/in_c/tests/watch.c` is a whole program.
//!
//! # On a controller without an operating system
//!
//! ```toml
//! grasp-lcp = { version = "0.1", default-features = false, features = ["libm"] }
//! ```
//!
//! The whole library is then `no_std`: equilibria, paths, verdicts and complementarity problems as well, on one core. These need an allocator; `onset` and `watch` of
//! `Fingers` ask it for nothing. What is missing without std stands in the [root](crate#without-the-standard-library).
//!
//! A program that asks `Fingers` alone links their kernels alone, for as many fingers as it has. A [`Grasp`](crate::ask::Grasp) brings all of its questions.
//!
//! Double precision is not in the hardware of a Cortex-M4: a tick there takes as long as software needs for it. A Cortex-M7 may have it. Times have to be
//! measured on the controller; none are promised here.
//!
//! `tests/without_std` in the repository is a program of that kind. It is compiled for `thumbv7em-none-eabihf`, and run on a desktop, where its answers are those
//! with std to ten digits.
