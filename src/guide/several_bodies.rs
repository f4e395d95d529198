//! Several bodies: wedges, vices, tongs, parts side by side, stacks on a tray, arches.
//!
//! A scene has a list of `bodies`. Each contact names the body that its normal points into, `on`, and the body on the other side, `against`; without
//! `against` it is the ground or a finger. Everything else is as with one object: the law of a contact, commands, hands, and all questions. A load of
//! a question acts on the first body, or on the body marked as `loaded`. With `shared_by_mass` it acts on all bodies, at their common centre of mass
//! unless `at` is given. A permanent load, such as a weight, is the `load` of a body. A list of `links` joins bodies: a hinge, a slide (linear
//! guide), a rigid joint, a spring, or a cable that only pulls. A link is `between` two bodies, or `on` one body and attached to the ground. The
//! scenes are in `examples/scenes/bodies`, and the commands are run there.
//!
//! # What does it take to drive a wedge under a machine?
//!
//! ```text
//! $ grasp-lcp hold wedge.json
//! SLIPS OUT at 1902.12 N of 2000 N: machine moves along +y and wedge moves along −x; floor, incline and wall slide (gross slip)
//! ```
//!
//! The limit is `W tan(α + 2φ)` with W = 1800 N, α = 8° and tan φ = 0.35. At the limit friction alone determines the forces, for any stiffness.
//!
//! # How hard may I pull at a part in a vice?
//!
//! ```text
//! $ grasp-lcp hold vice.json
//! HOLDS, everything sticks: 283.494 N (1.13397 times this load) until the first slip (fixed jaw), 300 N (1.2 times) until it is lost
//! ```
//!
//! The part slips out at 300 N, twice 0.3 · 500 N. The moving jaw is a body of its own. The screw pushes it along its guide, and it turns a little
//! under the pull. The jaws therefore share the pull unequally, and the fixed jaw slips first. The table below the answer has the force and moment of
//! the guide, a link: 119 N and 2.1 N m.
//!
//! # What do tongs carry?
//!
//! ```text
//! $ grasp-lcp hold tongs.json
//! SLIPS OUT at 47.8723 N of 60 N: bar moves along −y; left jaw and right jaw slide
//! ```
//!
//! Hands press the handles apart with P = 50 N each, at the distance a = 0.3 m above the pin. The jaws hold the bar at the distance b = 0.2 m below
//! the pin and c = 0.04 m to either side. The limit is `2 μ P a / (b - μ c)`: the bar hangs on the jaws and presses them together. The pin is a hinge
//! between the levers, and a stand holds one of them at the pin.
//!
//! # How rough must the jaws of lifting tongs be?
//!
//! ```text
//! $ grasp-lcp need scissor.json
//! NEEDS a coefficient of friction of 0.6 so that it holds and nothing slides
//!   if friction is 10 % less: 0.666667
//!   with less: SLIPS OUT at once, under any part of 200 N: block moves along −y
//! ```
//!
//! Ropes at 45° pull each lever upwards with W/2, and inwards with the same force. About the pin, the rope's force has the arms 0.2 m (of its upward
//! part) and 0.15 m (of its inward part). The forces of a jaw have the arms 0.15 m (friction) and 0.3 m (normal force). Each jaw then presses with
//! 0.25/0.3 W and has to carry W/2, for any W: `μ = 0.6`. Ropes are links that go slack where they would have to push.
//!
//! # Do three parts side by side stay in one gripper?
//!
//! ```text
//! $ grasp-lcp hold row.json
//! HOLDS, everything sticks: 27.7894 N (4.72128 times this load) until the first slip (joint a–b and joint b–c), 40 N (6.79578 times) until it is lost
//! ```
//!
//! The joints a–b and b–c are the faces at which the parts touch. Only the part in the middle hangs on them: their friction, 2 · 0.2 · 40 N, is 8.2
//! times its weight. The parts turn before this friction is used up, which lowers the limit to 6.8 times.
//!
//! # How far may a tray be tilted with a stack on it?
//!
//! ```text
//! $ grasp-lcp need tray.json
//! TAKES 21.8014° anticlockwise and holds, 17.5854° and nothing slides
//!   if friction is 10 % less: 19.7989°
//!   with more: SLIPS OUT at 21.8014°: lower and upper move along −x; tray slides
//! ```
//!
//! All weights turn together. The stack slides on the tray at tan θ = 0.4, before its upper box slides or tips.
//!
//! # Does the arch stand, and with a load on one side?
//!
//! ```text
//! $ grasp-lcp hold arch.json
//! HOLDS, everything sticks: 3912.46 N (1.95623 times this load) until the first slip (right foot), 23931.4 N (11.9657 times) until it is lost
//! ```
//!
//! A joint of masonry has two points, which open where the thrust leaves the middle third; a joint with one open point is a hinge.
//!
//! # In Rust
//!
//! [`Link`](crate::planar::Link) has an example of a lever on a hinge.
//!
//! ```
//! use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};
//!
//! // Two boxes on each other, 20 N and 10 N; the lower one is pulled until it slides under both.
//! let face = |y: f64, mu: f64| [-0.1, 0.1].map(|x| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu));
//! let grasp = Bodies::new([
//!     Body::new("lower").load(Wrench::force_at([0.0, -20.0], [0.0, 0.1])),
//!     Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
//! ])
//! .contacts(face(0.0, 0.5).map(|contact| contact.on("lower")))
//! .contacts(face(0.2, 0.3).map(|contact| contact.on("upper").against("lower")))
//! .grasp()?;
//! let verdict = grasp.hold(Wrench::force([20.0, 0.0]))?;
//! assert!(verdict.to_string().starts_with("SLIPS OUT at 15 N of 20 N: lower and upper move along +x"));
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # Could contact forces hold all bodies?
//!
//! [`Statics::force_closure`](crate::ask::Statics::force_closure) says whether contact forces could balance any loads on all bodies at once, if every
//! contact pressed as needed. If not, it returns a motion of the bodies that nothing opposes: a body on a table may go up. Springs and weights do not
//! matter for this question.
//!
//! # Loads on several bodies
//!
//! A question loads one body, or all of them in proportion to their mass. With `together_with`, in `hold`, `need`, `solve` and `onset`, loads on
//! further bodies grow in the same proportion. On the command line:
//!
//! ```text
//! $ grasp-lcp hold wedge.json --force -2000,0 --at 0.5,0.05 --together-with machine=0,-500@0.12,0.3
//! HOLDS, but wall slides from the start; lost at 2585.05 N (1.29252 times this load)
//! ```
//!
//! While the wedge is driven in, 500 N more are put on the machine: `2000 λ = (1800 + 500 λ) tan(α + 2φ)`.
//!
//! Along a program the load of each body may follow its own path, with `body_loads_by` and `body_loads_to` of a leg. These loads begin at zero and
//! act on top of the `load` and the weight that the body has in the scene:
//!
//! ```
//! use grasp_lcp::planar::{Bodies, Body, Contact, Leg, Wrench};
//!
//! // A wedge of 8° under a block beside a frictionless wall. The block is put on, the wedge is pressed in and released: it stays.
//! let face = |a: [f64; 2], b: [f64; 2], mu: f64| {
//!     let along = [b[0] - a[0], b[1] - a[1]];
//!     [0.1, 0.9].map(|s| {
//!         Contact::new([a[0] + s * along[0], a[1] + s * along[1]], [-along[1], along[0]]).series_stiffness(3e6, 2e6).friction(mu)
//!     })
//! };
//! let grasp = Bodies::new([Body::new("wedge"), Body::new("block")])
//!     .contacts(face([0.0, 0.0], [2.0, 0.0], 0.35).map(|floor| floor.on("wedge")))
//!     .contacts(face([0.0, 0.1], [1.0, 0.1 + 8f64.to_radians().tan()], 0.35).map(|slope| slope.on("block").against("wedge")))
//!     .contacts(face([0.0, 2.0], [0.0, 0.5], 0.0).map(|wall| wall.on("block")))
//!     .grasp()?;
//! let press = |newtons: f64| Wrench::force_at([-newtons, 0.0], [2.0, 0.15]);
//! let legs = [
//!     Leg::body_load_to("block", Wrench::force_at([0.0, -400.0], [0.45, 1.0])),
//!     Leg::load_to(press(200.0)),
//!     Leg::load_to(press(0.0)),
//! ];
//! let mut path = grasp.follow(Wrench::ZERO, &legs)?;
//! path.run();
//! let left = path.state().expect("it stays");
//! assert_eq!(left.body_loads[0].load, Wrench::force_at([0.0, -400.0], [0.45, 1.0]));
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # Limits
//!
//! The measure of Ferrari and Canny, limit analysis, the least squeeze over loads and screening accept a single object only. Links are exact to first
//! order, like all displacements: the tension of a cable keeps its direction as its line turns. The equations of many bodies are ordered by body, and
//! bodies that touch are close to each other in this order. A wall of 1 000 bricks settles in about a second, and `hold` follows a push until it is
//! lost in some seconds: the programs `several_bodies` and `scaling` in `examples/reports` print the times. These times are for the plane. In space
//! each half of a brick rests on four points; a wall of 36 bricks takes a tenth of a second, one of 100 bricks some seconds. For a structure that
//! cannot stand, the proof takes no longer.
