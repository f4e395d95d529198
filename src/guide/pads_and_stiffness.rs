//! Pads and stiffness: which stiffness to enter, which answers depend on stiffness, what a pad's strips cost, and where its sides lie.
//!
//! # Which answers depend on stiffness
//!
//! If fingers press with given forces (`pressed_with`, `force`, suction), only **ratios** of stiffnesses decide how contacts share a load. If all
//! springs become ten times as stiff, contact forces and the loads at first slip and at loss of equilibrium stay the same. Displacements become a
//! tenth.
//!
//! | answer | depends on |
//! |---|---|
//! | load at which the grasp is lost, if pressing forces stay constant | friction and forces; on ratios of stiffness only if the load changes normal forces |
//! | first slip | ratios between contacts, and of tangential to normal stiffness |
//! | motions, and so whether a load moves the object too far | absolute stiffness |
//! | squeeze by `command`, a displacement | absolute stiffness: force = stiffness × displacement |
//!
//! ```
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! // Two jaws and a load off their middle; then all springs are ten times as stiff, and then only those of the left jaw.
//! let grasp = |left: f64, right: f64| {
//!     let jaw = |x: f64, k: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(2e5 * k, 7e4 * k).friction(0.5).pressed_with(20.0);
//!     Grasp::new([jaw(-0.04, left), jaw(0.04, right)])
//! };
//! let (soft, stiff, uneven) = (grasp(1.0, 1.0)?, grasp(10.0, 10.0)?, grasp(10.0, 1.0)?);
//! let load = Wrench::force_at([0.0, -5.0], [0.01, 0.0]);
//! let onset = |grasp: &Grasp| Ok::<_, grasp_lcp::Error>(grasp.onset(load)?.factor().expect("it slides"));
//! assert!((onset(&soft)? / onset(&stiff)? - 1.0).abs() < 1e-12);
//! let sinks = |grasp: &Grasp| Ok::<_, grasp_lcp::Error>(grasp.solve(load)?.equilibrium().expect("it holds").twist.translation()[1]);
//! assert!((sinks(&soft)? / sinks(&stiff)? - 10.0).abs() < 1e-9);
//! // The forces of two points follow from statics, for any springs; with a third jaw they depend on ratios of stiffness.
//! assert!((onset(&uneven)? / onset(&soft)? - 1.0).abs() < 1e-12);
//! let three = |k: f64| {
//!     let below = Contact::new([0.0, -0.03], [0.0, 1.0]).series_stiffness(2e5 * k, 7e4 * k).friction(0.5);
//!     Grasp::new(grasp(1.0, 1.0)?.contacts().iter().cloned().chain([below]))
//! };
//! assert!((onset(&three(10.0)?)? / onset(&three(1.0)?)? - 1.0).abs() > 0.5);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! A contact without a stiffness has 1e4 N/m in all directions. A warning names each question whose answer depends on this default.
//!
//! # Which stiffness to enter
//!
//! `stiffness` (or `series_stiffness`) is `[normal, tangential]` of all elastic parts between the object and its fixture, in series: the softest part dominates.
//! `grasp-lcp values` prints ordinary values with their sources.
//!
//! | what holds | enter | how it presses |
//! |---|---|---|
//! | rubber pad, area A, thickness t | normal E A/t, tangential a third; 400 mm² of 5 mm: 1.4e5 to 7.5e5 N/m. Of a mesh: `layer` with modulus and thickness | `pressed_with` |
//! | steel jaw, locator, vice | 1e7 to 1e8 N/m, tangential 0.7 to 0.9 of it | a screw that is tightened once: `pressed_with`; a clamp that follows the part: `force` |
//! | gripper with a servo that holds its position | finger (3 E I/L³) and pad in series, with the drive's stiffness if it is known | `pressed_with` |
//! | gripper with an air cylinder or a motor that stalls | pad and finger | `force`, or a joint with a `limit` |
//! | bolt or tie rod, section A, length L | a `spring` or `cable` link with E A/L; M10 of 50 mm: 2.4e8 N/m | `tension`, the tension after installation |
//! | strap, rope | a `cable` link; force over elongation of its data sheet, times its length | `tension` |
//! | suction cup | force over stroke of the bellows; some 8e3 N/m, tangential half | `suction` |
//! | contact of a simulator | its pads, as above, and the simulator's normal forces | `pressed_with` |
//!
//! MuJoCo's `solref` is not a stiffness in N/m: its time constant and damping ratio prescribe accelerations. The force for a given penetration is therefore proportional to
//! the mass behind the contact (MuJoCo's documentation, chapter Computation). Drake's hydroelastic modulus is a pressure, Pa: multiplied by the area and divided by the
//! thickness of the layer it is a stiffness. `python/examples` has both simulators.
//!
//! # Where a pad's sides lie
//!
//! `"rectangle": {"sides": [a, b]}` has a along the first tangent t₁ and b along t₂ = n × t₁. Without `tangent`, t₁ is the coordinate axis farthest
//! from the normal, and the first such axis if there are several:
//!
//! | normal along | a along | b along |
//! |---|---|---|
//! | x | y | z |
//! | y | x | z |
//! | z | x | y |
//!
//! ```
//! use grasp_lcp::spatial::{Contact, Grasp};
//!
//! for (normal, first, second) in [(0, 1, 2), (1, 0, 2), (2, 0, 1)] {
//!     for sign in [-1.0, 1.0] {
//!         let mut inward = [0.0; 3];
//!         inward[normal] = sign;
//!         let grasp = Grasp::new([Contact::new([0.0; 3], inward).series_stiffness(1.0, 1.0)])?;
//!         let frame = *grasp.frames().next().expect("one contact");
//!         assert!(frame[(first, 1)].abs() == 1.0 && frame[(second, 2)].abs() == 1.0);
//!     }
//! }
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # What strips cost
//!
//! Each half of a side is divided into `strips` of two points each: the default `[1, 1]` gives 16 points, `[2, 2]` gives 64. For any number of
//! strips, tilting and twisting stiffness, first opening and first sliding are those of the uniform pad. Only the transition from first to gross
//! sliding is coarser. Computing time grows faster than the number of points. The program `pad_strips` in `examples/reports` prints error and time
//! for a gripper whose pads are twisted and pulled at once.
//!
//! # Joints, meshes, simulators
//!
//! * Joints, motors and tendons: [`hands`](super::hands), the scene `three_joint_pinch.json`, `grasp-lcp new hand`; in Python `help(Grasp.from_dict)`.
//! * A mesh: `grasp-lcp new grip part.stl --jaws 20x30mm --force 40` writes a scene; `parts/bracket.json` is one; the program `from_mesh` in
//!   `examples/reports`, and the module `touch` in Rust.
//! * MuJoCo: `python/examples/mujoco_creep.py` takes the contacts of a grasp from it, `mujoco_watch.py` its forces a thousand times a second.
