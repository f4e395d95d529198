//! Does the grasp hold?
//!
//! A multifingered hand holds an object. Each contact is a point with Coulomb friction. Finger and object give way like springs. The fingers are
//! commanded to move a little, and a load pulls on the object. This crate computes the motion of the object, the contact forces, **the load at which
//! a contact starts to slide**, and whether an equilibrium exists beyond it.
//!
//! ```
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! // The two-finger grasp of the paper: springs of 10 N/m, μ = 1/4, fingers pressed 0.1 m along their normals.
//! let finger = |side: f64| {
//!     Contact::new([4.0 * side, 1.8], [-8.0 * side, -1.0])
//!         .body_stiffness(10.0, 10.0)
//!         .finger_stiffness(10.0, 10.0)
//!         .friction(0.25)
//!         .command([0.1, 0.0125 * side])
//! };
//! let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
//!
//! let onset = grasp.onset_of_sliding(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
//! let exact = 65f64.sqrt() / 66.0;
//! assert!((onset.factor().unwrap() - exact).abs() < 1e-15);
//!
//! let holds = grasp.solve(&Wrench::force([0.0, -0.1]))?;
//! assert!(holds.equilibrium().is_some());
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # The problem
//!
//! Contact i has a frame: the unit normal n into the object and one tangent t (two in space). To first order the body's
//! displacement at the contact is `u_c = G_iᵀq` along the axes of that frame. With the series stiffness `1/k = 1/k_body + 1/k_finger` of each axis
//!
//! ```text
//! F_n = k_n (a_n - n·u_c + g)        0 <= g  ⟂  F_n >= 0
//! F_t = k_t (a_t - t·u_c - s)        |F_t| <= μ F_n,  slip s along F_t on the cone's edge, zero inside
//! Σ G_i F_i + W = 0
//! ```
//!
//! | symbol | meaning | unit | size |
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
//! F_t and the slip s point the same way. The law is the unified one of the paper, its sections 3.A and 3.B, with contacts that may also open; the
//! sign of its equation 3.B.5 is a misprint. Units are SI in the docs. Any consistent units work.
//!
//! # The map
//!
//! | module | contents |
//! |---|---|
//! | [`planar`], [`spatial`] | the names to start from |
//! | [`guide`] | which answer to trust, several equilibria, rays, facets, hands |
//! | [`ask`] | a grasp and its questions, for any number of coordinates |
//! | [`grasp`] | the parts of a question: contacts, soft fingertips, stiffness, friction, hands, bodies, wrench and twist; vectors of other libraries |
//! | [`forms`] | kinematic and force form, and the meaning of their rows |
//! | [`lcp`] | `0 <= z ⟂ M z + q >= 0` by Lemke's method; knows nothing of contacts |
//! | [`friction`] | frictional contact problems (W, q, μ) as simulators pose them, on the round cone |
//! | [`hold`] | does it hold: the verdict on a load that is applied from rest, in a sentence |
//! | [`shake`] | loads that repeat: rest, slip to and fro, walking or loss |
//! | [`identify`] | friction, loads of supports, squeeze and stiffness from observed slips, with their errors |
//! | [`need`] | how much squeeze, friction, load, arm or angle a grasp needs or allows |
//! | [`improve`] | places of fingers on given surfaces, and squeezes, for a late first slip |
//! | [`equilibrium`] | trial state → kinematic form → force form → proofs; the answer as physics |
//! | [`statics`] | force closure and form closure: which loads contact forces could balance |
//! | [`squeeze`] | the least squeeze for a set of loads, the weakest direction, and the least onset within bounds of commands and loads |
//! | [`load_path`] | onset of sliding and the behaviour just beyond it; load programs followed with slip memory, for a few contacts ([`load_path::LoadPath`]) or thousands ([`load_path::SteppedPath`]); sensitivities |
//! | [`screening`] | the onset of sliding as a load grows or turns, with its gradient, and the least squeeze, for millions of grasps of two to five contacts; a watch over measured forces |
//! | [`energy`] | the paper's quadratic program, its comparison with complementarity, stability |
//! | [`sweep`] | many questions at once, in parallel (feature `parallel`, on by default); grasps with uncertain data |
//! | [`words`] | numbers with their units, motions and names, in words |
//! | `picture` | grasps, load curves and maps over all directions as SVG, spatial grasps also as HTML pages (feature `plot`) |
//! | `scene` | scenes and answers in any self-describing format of serde (feature `serde`), JSON with messages that name the field (feature `json`) |
//! | `stream` | scenes in JSON, one a line, answered in order on all cores (feature `json`) |
//! | `schema` | the JSON Schemas of scenes and answers (feature `schema`) |
//!
//! # Answers
//!
//! "No equilibrium exists" is an answer ([`equilibrium::Outcome::NoEquilibrium`]) with its proof, never an error and never numbers. Malformed input
//! is an [`Error`] with the contact, the field, its value and the allowed values. Every equilibrium carries [residuals](equilibrium::Residuals)
//! recomputed from the question. With friction several equilibria are common: [`equilibrium::FoundBy`] is the rule by which the returned one was found.
//! [`ask::Grasp::equilibria`] lists all of them (on the round cone those that a polygon leads to).
//!
//! A point contact carries no moment: a two-finger pinch in space turns freely about its line, which is one of the answer's
//! [`free_motions`](equilibrium::Equilibrium::free_motions). [`grasp::SoftFingertip`] spreads a contact over a patch that resists.
//!
//! The model is that of "Position Control for Multifingered Robot Hand". The paper solves the sticking case as a quadratic program; [`energy`] has
//! it, and shows where its minimum stops being an equilibrium. `paper-notes.md` in the repository lists what this crate takes from the paper, its
//! misprints, and the extensions.
//!
//! # Without the standard library
//!
//! `default-features = false, features = ["libm"]` makes the crate `no_std`, with every question above, and the same answers to rounding. It needs an
//! allocator and atomic pointers (`thumbv7em`, `riscv32imac`; not `thumbv6m`), and double precision, which small processors compute in software.
//!
//! | needs std | feature |
//! |---|---|
//! | several cores; without them sweeps and long sums run one after the other | `parallel` |
//! | vector instructions, chosen by the processor at run time | `simd` |
//! | pictures and pages | `plot` |
//! | scenes, files, streams, schemas | `serde`, `json`, `schema` |
//! | the program | `cli`, `cli-full` |
//!
//! In a control loop [`screening::Fingers`] needs nothing else: [`onset`](screening::Fingers::onset) and [`watch`](screening::Fingers::watch)
//! allocate nothing and take the same steps for all numbers. Floating-point functions come from `libm`, whose last digits differ from std's: if a
//! load has several equilibria, the answer may be another one.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]
#![warn(missing_docs)]
#![cfg_attr(test, allow(unexpected_cfgs, reason = "`tests/inside` has no such features"))]

#[cfg_attr(not(feature = "std"), macro_use)]
extern crate alloc;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("grasp-lcp needs the feature `std`, or `libm` where there is no standard library");

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
pub(crate) use engine::{object, proofs, search, structured};
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
pub use questions::{ask, energy, hold, identify, improve, need, screening, shake, squeeze, statics, sweep};

pub use contact::{Fit, PolygonCone};
pub use equilibrium::{Settings, SmallMotions};
pub use error::{ContactLabel, Error, Field};
pub use grasp::Limit;
/// The library of vectors and matrices in questions and answers, in the matching version.
pub use nalgebra;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use search::record;

/// The programs in the README are doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
