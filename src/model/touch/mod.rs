//! Contacts from surfaces: pads that close on a part (feature `mesh`).
//!
//! A [`Part`] is a triangle mesh, from STL, OBJ or arrays, in m. A [`Touch`] is a [`Pad`] with a position and a closing direction. [`Touch::on`]
//! computes where this pad touches a part, as the points of one contact, each with its own normal, springs and clearance.
//!
//! # The model
//!
//! A pad is an elastic foundation: a layer of modulus E (Pa) and thickness t (m) has the stiffness `K = E/t` per unit area, N/m³. Every point of the
//! pad travels along the closing direction c until it meets the part, at the depth d_i. The point with the least depth d_min touches first, and the
//! pad then advances further by s. Let θ_i be the angle between c and the inward normal of the part at point i, and A_i the pad's area at this point.
//! Its clearance, its normal stiffness k_i and its normal force F_i are
//!
//! ```text
//! clearance_i = (d_i - d_min) cos θ_i        k_i = K A_i        F_i = k_i (s - d_i + d_min) cos θ_i >= 0
//! ```
//!
//! Tangential springs of `E/3t` per unit area, as of rubber, start at the position where the point first touches. With
//! [`Contact::pressed_with`](crate::grasp::Contact::pressed_with) the advance s is chosen so that the forces along c sum to the given force, if the
//! part does not move.
//!
//! A rubber layer between plates much wider than its thickness is stiffer than E/t, since it cannot bulge. In this case give the stiffness of
//! the whole pad, [`Contact::series_stiffness`](crate::grasp::Contact::series_stiffness), which is divided among the points by area.
//!
//! # How many points
//!
//! On a flat face the stiffnesses that are sums over the points equal those of the uniform pad in [`SoftFingertip`](crate::grasp::SoftFingertip),
//! even for one strip. A flat pad of length L on a cylinder of radius R, pressed in by δ, touches over the half width `√(2Rδ)` with the force
//! `4/3 K L δ √(2Rδ)`. With six points across the whole contact width the force is accurate to 2 %, with 26 to 0.1 %; the program `from_mesh` in
//! `examples/reports` prints these errors. A mesh of n sides deviates from its cylinder by `R (1 - cos(π/n))`, which should be small compared with δ.
//!
//! ```
//! use grasp_lcp::spatial::{Contact, Grasp, Wrench};
//! use grasp_lcp::touch::{Pad, Part, Touch};
//!
//! // A box of 60 x 40 x 30 mm in steel, held by two jaws of 20 x 30 mm that press with 40 N.
//! let corner = |i: usize| [0.06 * (i & 1) as f64, 0.04 * (i >> 1 & 1) as f64, 0.03 * (i >> 2) as f64];
//! let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
//! let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
//! let faces: Vec<[usize; 3]> = sides.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
//! let part = Part::new(&corners, &faces)?.of_density(7850.0)?;
//!
//! let jaw = |x: f64, closing: f64, name| {
//!     let contact = Contact::new([x, 0.02, 0.015], [closing, 0.0, 0.0]).tangent([0.0, 1.0, 0.0]).name(name);
//!     Touch::new(Pad::rectangle([0.02, 0.03], [1, 1])?.of_layer(2e6, 0.003), contact.friction(0.5).pressed_with(40.0)).on(&part)
//! };
//! let (left, right) = (jaw(-0.01, 1.0, "left")?, jaw(0.07, -1.0, "right")?);
//! assert_eq!((left.missing(), right.missing()), (0.0, 0.0));
//! let grasp = Grasp::new([left.contacts(), right.contacts()].concat())?;
//! let weight = 9.81 * part.mass().expect("of steel");
//! let pull = Wrench::force_at([0.0, 0.0, -weight], part.centre_of_mass().expect("closed"));
//! assert_eq!(grasp.hold(pull)?.holds(), Some(true));
//! # Ok::<(), grasp_lcp::Error>(())
//! ```

mod closing;
mod edges;
mod mesh_file;
mod pad;
mod part;
mod rays;
mod touched;

pub use crate::words::Unit;
pub use closing::Touch;
pub use pad::Pad;
pub use part::Part;
pub use touched::Touched;
