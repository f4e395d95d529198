//! Suction cups: a vacuum is a load, and the lip of the cup is a ring of contacts.
//!
//! The vacuum pulls object and cup together with the force `V = p A`, pressure difference times the area inside of the lip, whatever the load
//! does. So it belongs to the load: a force V on the object, at the middle of the lip, against the normal of the contact. The lip carries
//! what is left. It is a [`SoftFingertip::ring`](crate::grasp::SoftFingertip::ring) of radius R, and its springs are those of the lip.
//!
//! | load | the first point of the lip leaves at | how |
//! |---|---|---|
//! | hang: a force away from the cup | V | all of the lip opens |
//! | shear: a force along the lip, in its plane | μ V | all of it slides |
//! | peel: a moment across the normal | V R / 2 | one point opens |
//! | spin: a moment about the normal | μ V R | all of it slides |
//!
//! A point of a real lip that opens lets air in, so that the onset of peeling is the end. A load of several kinds at once has no such short formula,
//! and is what [`Grasp::onset`](crate::ask::Grasp::onset) answers.
//!
//! ```
//! use grasp_lcp::spatial::{Contact, Grasp, SoftFingertip, Wrench};
//!
//! // A cup of 30 mm on top of a plate, 60 kPa: V = 60e3 · π · 0.015² = 42.4 N. Normals point down, into the plate.
//! let (radius, friction) = (0.015, 0.6);
//! let vacuum = 60e3 * std::f64::consts::PI * radius * radius;
//! let lip = Contact::new([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]).series_stiffness(8e3, 4e3).friction(friction);
//! let plate = Grasp::new(SoftFingertip::ring(radius, 12)?.contacts(&lip)?)?;
//!
//! let pulled = Wrench::force([0.0, 0.0, vacuum]);
//! let limit = |load: Wrench| -> Result<f64, grasp_lcp::Error> { Ok(plate.onset_of_sliding(&pulled, &load)?.factor().unwrap()) };
//! let is = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
//! is(limit(Wrench::force([0.0, 0.0, -1.0]))?, vacuum);
//! is(limit(Wrench::force([1.0, 0.0, 0.0]))?, friction * vacuum);
//! is(limit(Wrench::new([0.0; 3], [0.0, 1.0, 0.0]))?, vacuum * radius / 2.0);
//! is(limit(Wrench::new([0.0; 3], [0.0, 0.0, 1.0]))?, friction * vacuum * radius);
//!
//! // The weight hangs 20 mm below the lip and the arm accelerates sideways: shear and peel at once.
//! let shaken = limit(Wrench::force_at([0.5, 0.0, -1.0], [0.0, 0.0, -0.02]))?;
//! assert!(shaken < vacuum * radius / 2.0 / 0.01);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
