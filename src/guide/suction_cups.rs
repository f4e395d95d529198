//! Suction cups: the loads that a vacuum holds, and when it lets go.
//!
//! The vacuum pulls object and cup together with the force `V = p A` for any load; p is the pressure difference and A the area inside the lip. The
//! lip touches the object: a ring of points of radius R that presses with V less the pull on the object. A [`SuctionCup`](crate::grasp::SuctionCup)
//! consists of this force and this ring. In scenes it is `"suction": {"radius": 0.015, "pressure": 60000}` on a contact, whose normal points into the
//! object.
//!
//! The vacuum is not a load of the question: the load in an answer is the weight and any other load that the question states. Unlike the force of a
//! finger, the vacuum needs no support on the other side of the object, because it pulls on cup and object alike.
//!
//! | load | load at which the first point of the lip slides or opens | what happens there |
//! |---|---|---|
//! | hang: a force away from the cup | V | all of the lip opens |
//! | shear: a force along the lip, in its plane | μ V | all of it slides |
//! | peel: a moment across the normal | V R / 2 | one point opens |
//! | spin: a moment about the normal | μ V R | all of it slides |
//!
//! A point of a real lip that opens lets air in: the cup leaks. [`Grasp::hold`](crate::ask::Grasp::hold) and all questions that build on it count a
//! load as held up to the opening of the first point. An equilibrium beyond this opening carries a caution: it assumes that the vacuum lasts, as may
//! be the case with a bellows that follows the object. When the lip is open all around, the cup lets go, and a load path ends. If an equilibrium is
//! computed under a larger load, its [`open_cups`](crate::equilibrium::Equilibrium::open_cups) list the cup: the vacuum is gone, and this equilibrium
//! does not hold. [`SuctionCup`](crate::grasp::SuctionCup) lists the behaviour in other questions. A load that combines hang, shear, peel or spin has
//! no such short formula; [`Grasp::onset`](crate::ask::Grasp::onset) answers for it. [`Grasp::need`](crate::ask::Grasp::need) for a squeeze returns
//! the required vacuum.
//!
//! ```
//! use grasp_lcp::need::Need;
//! use grasp_lcp::spatial::{Contact, Grasp, SuctionCup, Wrench};
//!
//! // A cup of 30 mm on top of a plate, 60 kPa: V = 60e3 · π · 0.015² = 42.4 N. Normals point down, into the plate.
//! let (radius, friction) = (0.015, 0.6);
//! let lip = Contact::new([0.0, 0.0, 0.0], [0.0, 0.0, -1.0]).name("cup").series_stiffness(8e3, 4e3).friction(friction);
//! let cup = SuctionCup::of_pressure(radius, 12, 60e3)?;
//! let plate = Grasp::new(cup.contacts(&lip)?)?;
//!
//! let limit = |load: Wrench| -> Result<f64, grasp_lcp::Error> { Ok(plate.onset(load)?.factor().unwrap()) };
//! let is = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
//! let vacuum = cup.force();
//! is(limit(Wrench::force([0.0, 0.0, -1.0]))?, vacuum);
//! is(limit(Wrench::force([1.0, 0.0, 0.0]))?, friction * vacuum);
//! is(limit(Wrench::new([0.0; 3], [0.0, 1.0, 0.0]))?, vacuum * radius / 2.0);
//! is(limit(Wrench::new([0.0; 3], [0.0, 0.0, 1.0]))?, friction * vacuum * radius);
//!
//! // The weight hangs 20 mm below the lip and the arm accelerates sideways: shear and peel at once.
//! let shaken = limit(Wrench::force_at([0.5, 0.0, -1.0], [0.0, 0.0, -0.02]))?;
//! assert!(shaken < vacuum * radius / 2.0 / 0.01);
//!
//! // What vacuum do 10 N in the plane of the lip take? 10 N / μ.
//! let needed = plate.need(&Need::squeeze(Wrench::force([10.0, 0.0, 0.0])).if_lower_by(0.0, 0.0))?;
//! assert!(needed.to_string().starts_with("NEEDS 23.5786 kPa (16.6667 N) at cup so that it holds and nothing slides\n  with less: SLIPS OUT"), "{needed}");
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
