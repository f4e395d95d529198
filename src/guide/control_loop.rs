//! Monitoring of measured contact forces in a control loop, with an operating system and without one.
//!
//! [`Fingers::watch`](crate::screening::Fingers::watch) takes contact forces that were measured just now, and the load to come. It returns the least
//! margin of the contacts, i.e. the additional friction force, N, that a contact could take before it slides. It also returns the load at first slip,
//! and the extra clamping force that prevents it. It allocates nothing, and the number of its operations is bounded for a given number of contacts.
//!
//! # One tick
//!
//! ```
//! use grasp_lcp::Error;
//! use grasp_lcp::spatial::{Fingers, Wrench};
//!
//! /// Largest growth of the squeeze in one tick, as a fraction of the first squeeze.
//! const FASTEST: f64 = 0.01;
//!
//! /// `forces` are measured at the fingers, N, along the coordinate axes; `to_come` is the load that the next 30 ms add to the present one.
//! fn tick(fingers: &Fingers<3>, forces: &[[f64; 3]; 3], to_come: &Wrench, squeeze: &mut f64) -> Result<(), Error> {
//!     let seen = fingers.watch(forces, to_come)?;
//!     // Without a factor a contact slides already, or no squeeze holds: press as fast as the motors can.
//!     *squeeze += seen.extra_squeeze().factor().unwrap_or(FASTEST).min(FASTEST);
//!     Ok(())
//! }
//! ```
//!
//! `cargo run --release -p grasp-lcp --example raise_the_squeeze` closes the loop around a bottle that is swung.
//! `cargo run --release -p reports --bin watch_forces` prints the longest time of a tick.
//!
//! # In C
//!
//! `cargo build --release --package grasp-lcp-c` in the repository builds `libgrasp_lcp_c.a` and `.so` for `examples/in_c/grasp_lcp.h`, for fingers
//! in space:
//!
//! ```c
//! grasp_lcp_fingers_t *fingers;
//! char *wrong = grasp_lcp_fingers((slice_ref_grasp_lcp_finger_t){three, 3}, &fingers);
//! …
//! wrong = grasp_lcp_watch(fingers, (slice_ref_grasp_lcp_vector_t){forces, 3}, &to_come, &seen);
//! if (wrong == NULL) squeeze += fmin(seen.extra_squeeze, FASTEST);
//! ```
//!
//! Each function returns an error as a text, or NULL if there is none. An unknown squeeze is NAN, in which case `fmin` returns its other argument.
//! `examples/in_c/tests/watch.c` is a complete program.
//!
//! # On a controller without an operating system
//!
//! ```toml
//! grasp-lcp = { version = "0.1", default-features = false, features = ["libm"] }
//! ```
//!
//! The whole library is then `no_std`: equilibria, paths, verdicts and complementarity problems as well, on one core. All of these need an allocator;
//! `onset` and `watch` of `Fingers` allocate nothing. The [root](crate#without-the-standard-library) lists the parts that need std.
//!
//! A program that uses `Fingers` alone contains only the functions for screening, in the plane or in space. A program that uses a
//! [`Grasp`](crate::ask::Grasp) contains all questions.
//!
//! A Cortex-M4 has no hardware for double precision: software emulates it, and determines the time of a tick. A Cortex-M7 may have such hardware.
//! Times must be measured on the controller; this guide promises none.
//!
//! `tests/without_std` in the repository is such a program. It is compiled for `thumbv7em-none-eabihf`, and run on a desktop, where its answers agree
//! with those of std to ten digits.
