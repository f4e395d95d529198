//! Does the grasp hold?
//!
//! A multifingered hand holds an object. Each contact is a point with Coulomb friction. Finger and object are elastic at each contact, like springs
//! in series. Small displacements of the fingers are commanded, and a load (force and moment) acts on the object. This crate computes the motion of
//! the object, the contact forces, and **the load at which a contact starts to slide**. It also decides whether an equilibrium exists beyond that
//! load.
//!
//! ```
//! use grasp_lcp::need::Need;
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! // Two jaws of a gripper, 60 mm apart: series springs of 1000 and 800 N/m, friction 0.5, pressed with 10 N each.
//! let jaw = |x: f64, name| {
//!     Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0)
//! };
//! let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
//!
//! // Does it hold 4 N?
//! let weight = Wrench::force([0.0, -4.0]);
//! println!("{}", gripper.hold(weight)?); // HOLDS, everything sticks: 10 N (2.5 times this load) until it is lost, as left and right slide
//!
//! // How hard must it press?
//! println!("{}", gripper.need(&Need::squeeze(weight))?); // NEEDS 4 N at left and right, at most 23.9999 N, so that it holds …
//!
//! // Where does the object go, and with which forces?
//! let outcome = gripper.solve(weight)?;
//! let state = outcome.equilibrium().expect("it holds");
//! assert!((state.twist.translation()[1] + 4.0 / 1600.0).abs() < 1e-15);
//! # assert!(gripper.hold(weight)?.to_string().starts_with("HOLDS, everything sticks: 10 N (2.5 times this load)"));
//! # assert!(gripper.need(&Need::squeeze(weight))?.to_string().starts_with("NEEDS 4 N at left and right, at most 23.9999 N, so that it holds and nothing slides"));
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # Start here
//!
//! | module | contents |
//! |---|---|
//! | [`planar`], [`spatial`] | the types of a grasp in the plane and in space, under short names |
//! | [`guide`] | which answer to trust, several equilibria, rays, facets, hands |
//! | [`ask`] | a [`Grasp`](ask::Grasp), and a table of the questions that it answers |
//! | [`grasp`] | the parts of a question: contacts, soft fingertips, stiffness, friction, hands, bodies, wrench and twist; vectors of other libraries |
//! | [`hold`] | does it hold: the verdict on a load that grows from zero, as one sentence |
//! | [`need`] | how much squeeze, friction, load, arm or angle a grasp needs or allows |
//! | [`equilibrium`] | motion and contact forces under a load, or the proof that no equilibrium exists |
//!
//! # More questions
//!
//! | module | contents |
//! |---|---|
//! | [`load_path`] | first slip and the behaviour just beyond it; load programs followed with the accumulated slips of all contacts, for a few contacts ([`load_path::LoadPath`]) or thousands ([`load_path::SteppedPath`]); sensitivities |
//! | [`shake`] | loads that repeat: rest, alternating slip, slip that accumulates (walking), or loss |
//! | [`identify`] | friction, loads of supports, squeeze and stiffness from observed slips, with their standard errors |
//! | [`improve`] | finger places on given surfaces, and clamping forces, with the latest first slip |
//! | [`squeeze`] | the least squeeze for a set of loads, and the weakest direction |
//! | [`statics`] | force closure and form closure: which loads contact forces could balance |
//! | [`energy`] | the quadratic program (minimum energy) of "Position Control for Multifingered Robot Hand", and its comparison with the complementarity problem |
//! | [`sweep`] | the same question for many grasps or loads, in parallel (feature `parallel`, on by default); grasps with uncertain data |
//! | [`screening`] | first slip as a load grows or turns, with its gradient, and the least squeeze, for millions of grasps of two to five contacts; monitoring of measured forces |
//!
//! # Solvers
//!
//! | module | contents |
//! |---|---|
//! | [`lcp`] | `0 <= z ⟂ M z + q >= 0` by Lemke's method; independent of contacts |
//! | [`friction`] | frictional contact problems given by a matrix W, a vector q and coefficients μ, as simulators pose them, on the round cone |
//! | [`forms`] | kinematic and force form of a grasp as linear complementarity problems, and the meaning of their rows |
//!
//! # Files and pictures
//!
//! | module | contents |
//! |---|---|
//! | `scene` | scenes and answers in any self-describing format of serde (feature `serde`), JSON with messages that name the field (feature `json`) |
//! | `stream` | scenes in JSON, one a line, answered in order on all cores (feature `json`) |
//! | `schema` | the JSON Schemas of scenes and answers (feature `schema`) |
//! | `touch` | contacts from surfaces: pads that close on a part from STL or OBJ (feature `mesh`) |
//! | `picture` | grasps, load curves and maps over all directions as SVG, spatial grasps also as HTML pages (feature `plot`) |
//! | [`words`] | numbers with their units, motions and names, in words |
//!
//! # The problem
//!
//! Contact i has a frame: the unit normal n into the object and one tangent t (two in space). To first order the body's
//! displacement at the contact is `u_c = G_iᵀq` along the axes of that frame. With the series stiffness `1/k = 1/k_body + 1/k_finger` of each axis
//!
//! ```text
//! F_n = k_n (a_n - n·u_c + g)        0 <= g  ⟂  F_n >= 0
//! F_t = k_t (a_t - t·u_c - s)        |F_t| <= μ F_n,  slip s along F_t on the cone's boundary, zero inside
//! Σ G_i F_i + W = 0
//! ```
//!
//! | symbol | meaning | unit | dimension |
//! |---|---|---|---|
//! | q | twist of the object: translation of the origin, rotation ([`grasp::Twist`]) | m, rad | d = 3 in the plane, 6 in space |
//! | W | load on the object: force, moment about the origin ([`grasp::Wrench`]) | N, N m | d |
//! | G_i | grasp map: contact force in its frame → wrench | 1, m | d × c |
//! | k | series stiffness, axis by axis | N/m | c = 2 in the plane, 3 in space |
//! | a_i | commanded finger displacement in the contact frame, the normal part less the clearance | m | c |
//! | F_i | force on the object in the contact frame; F_n > 0 pushes | N | c |
//! | g, s | gap between the surfaces; slip of the finger over the body | m | 1, c - 1 |
//! | μ | coefficient of friction, each contact its own | | 1 |
//!
//! Signs: normals point into the object, the way the finger pushes; in the plane `t = (n_y, -n_x)`. Friction drags the body along with the finger, so
//! F_t and the slip s have the same direction. The contact law is the unified law of "Position Control for Multifingered Robot Hand" (sections 3.A
//! and 3.B), for contacts that may also open; the sign in equation 3.B.5 of that paper is a misprint. Units are SI in the docs. Any consistent units
//! work.
//!
//! # Answers
//!
//! "No equilibrium exists" is an answer ([`equilibrium::Outcome::NoEquilibrium`]) with its proof; it is not an error, and no numbers are returned.
//! Malformed input is an [`Error`] with the contact, the field, its value and the allowed values. Every equilibrium carries
//! [residuals](equilibrium::Residuals) recomputed from the question. With friction several equilibria are common: [`equilibrium::FoundBy`] is the
//! rule by which the returned equilibrium was found. [`ask::Grasp::equilibria`] lists all equilibria; on the round cone it lists the equilibria found
//! from contact states on a polygonal cone.
//!
//! A point contact carries no moment. A two-finger pinch in space therefore turns freely about the line between the contacts. The answer contains
//! this motion in [`free_motions`](equilibrium::Equilibrium::free_motions). [`grasp::SoftFingertip`] spreads a contact over a patch that resists
//! moments.
//!
//! The model is taken from the paper "Position Control for Multifingered Robot Hand". The paper solves the sticking case as a quadratic program.
//! [`energy`] implements this program, and shows where its minimum stops being an equilibrium. `paper-notes.md` in the repository lists what this
//! crate takes from the paper, its misprints, and the extensions.
//!
//! # Without the standard library
//!
//! `default-features = false, features = ["libm"]` makes the crate `no_std`, with every question above, and the same answers up to rounding. It needs
//! an allocator and atomic pointers (`thumbv7em`, `riscv32imac`; not `thumbv6m`), and double precision, which small processors compute in software.
//!
//! | needs std | feature |
//! |---|---|
//! | several cores; without them sweeps and long sums run one after the other | `parallel` |
//! | vector instructions of the processor (SIMD), detected at run time | `simd` |
//! | pictures and pages | `plot` |
//! | scenes, files, streams, schemas | `serde`, `json`, `schema` |
//! | the program | `cli`, `cli-full` |
//!
//! In a control loop [`screening::Fingers`] suffices: [`onset`](screening::Fingers::onset) and [`watch`](screening::Fingers::watch) allocate nothing,
//! and the number of their operations is bounded for a given number of contacts. Floating-point functions come from `libm`, whose last digits differ
//! from std's. If a load has several equilibria, another equilibrium may therefore be returned.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]
#![warn(missing_docs)]
#![cfg_attr(test, allow(unexpected_cfgs, reason = "`tests/inside` has no such features"))]

#[cfg_attr(not(feature = "std"), macro_use)]
extern crate alloc;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("grasp-lcp needs the feature `std`, or `libm` where there is no standard library");

#[macro_use]
mod setters;

mod engine;
mod error;
pub mod friction;
pub mod guide;
mod io;
pub mod lcp;
mod model;
mod numerics;
pub mod planar;
mod prelude;
mod questions;
#[cfg(feature = "serde")]
mod serial;
pub mod spatial;
pub mod words;

pub use engine::{equilibrium, forms, load_path};
pub(crate) use engine::{object, proofs, search};
#[cfg(feature = "plot")]
pub use io::picture;
#[cfg(feature = "serde")]
pub use io::scene;
#[cfg(feature = "schema")]
pub use io::schema;
#[cfg(feature = "json")]
pub use io::stream;
pub(crate) use model::contact;
pub use model::grasp;
#[cfg(feature = "urdf")]
pub use model::robot;
#[cfg(feature = "mesh")]
pub use model::touch;
pub use questions::{ask, energy, hold, identify, improve, need, screening, shake, squeeze, statics, sweep};

pub use contact::{PolygonCone, PolygonFit};
pub use equilibrium::{Settings, SmallMotions};
pub use error::{ContactLabel, Error, Field};
pub use grasp::Limit;
/// The version of nalgebra that this crate uses, for the vectors and matrices in questions and answers.
pub use nalgebra;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use search::record;

/// The programs in the README are tested as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
