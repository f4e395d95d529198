//! Choosing between round cone and polygon, and the number of facets.
//!
//! In the plane two rays bound a friction cone, which needs no approximation: this page is for space.
//!
//! # Usually none
//!
//! Equilibria, onsets (load factors at first slip) and load paths in space use the **round** cone. Newton's method finds them from the elastic trial,
//! in which everything sticks. If it does not converge, Lemke's method proposes contact states on a polygon of 8 facets. At each contact the polygon
//! is turned so that a corner lies along the friction force of the elastic trial. Newton's method continues from this proposal to the round cone. The
//! answer names the cone ([`Cone::Round`](crate::equilibrium::Cone::Round)) and the change of contact forces from the polygon to the round cone
//! ([`change_from_polygon`](crate::equilibrium::Equilibrium::change_from_polygon)). More facets make the proposal more expensive, and the answer no
//! better. The load at first slip needs no facets at all: it follows from one quadratic equation per contact.
//!
//! # Where facets are used
//!
//! Polygons are used by [`Settings::on_the_polygon`](crate::Settings::on_the_polygon), for comparison with codes that have nothing else, and by the
//! quadratic programs of [`energy`](crate::energy).
//!
//! A regular polygon of m facets inside a circle of radius `μ F_n` has its facets at the distance `μ F_n cos(π/m)` from the centre. A polygon around
//! the circle has its corners at the distance `μ F_n / cos(π/m)`:
//!
//! | m | largest loss of friction | error of an onset | error of an equilibrium with sliding |
//! |---|---|---|---|
//! | 4 | 29 % | | |
//! | 8 | 7.6 % | falls like 1/m² | falls like 1/m: the direction of slip jumps from facet to facet |
//! | 16 | 1.9 % | | |
//! | 64 | 0.12 % | | |
//!
//! An inscribed polygon is safe for the load at first slip: a contact force inside this polygon lies inside the round cone, too. A circumscribed
//! polygon is safe for a proof that no equilibrium exists. Once a contact slides, neither polygon gives a bound.
//!
//! ```
//! use grasp_lcp::load_path::Ramp;
//! use grasp_lcp::spatial::{Contact, Grasp, Wrench};
//! use grasp_lcp::{PolygonFit, PolygonCone, Settings};
//! use std::f64::consts::PI;
//!
//! // Three fingers under a plate of 12 N: 3 · 0.5 · 4 N hold in every direction, on the round cone.
//! let finger = |x: f64, y: f64| {
//!     Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(100.0, 100.0).friction(0.5).command([0.04, 0.0, 0.0])
//! };
//! let grasp = Grasp::new([finger(-1.0, -1.0), finger(1.0, -1.0), finger(0.0, 2.0)])?;
//! let base = Wrench::force([0.0, 0.0, -12.0]);
//! let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
//! for k in 0..16 {
//!     let angle = PI * f64::from(k) / 8.0;
//!     let ramp = Ramp::load(base, Wrench::force([angle.cos(), angle.sin(), 0.0]));
//!     let round = grasp.onset(&ramp)?.factor().ok_or("it slides")?;
//!     assert!((round - 3.0 * 0.5 * 4.0).abs() < 1e-12);
//!     let eight = Settings::default().with_cone(PolygonCone::new(8, PolygonFit::Inscribed)?);
//!     let polygon = grasp.with(&eight.on_the_polygon()).onset(&ramp)?.factor().ok_or("it slides")?;
//!     (least, most) = (least.min(polygon / round), most.max(polygon / round));
//! }
//! // Exact along a corner, off by 1 - cos(π/8) along a facet's middle.
//! assert!((least - (PI / 8.0).cos()).abs() < 1e-12 && (most - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Time and error of facets on real scenes: `cargo run --release -p reports --bin cone_error`.
