//! A robot from its description file, and the hand with which it holds an object (feature `urdf`).
//!
//! A [`Robot`] consists of the links and joints of a URDF, in a posture. [`Robot::hand`] makes a [`Hand`](crate::grasp::Hand) of contacts on its
//! links. A joint that mimics another has no coordinate of its own and follows the other exactly. Contacts are given, or are computed from the
//! collision shapes of a link that touch a part ([`Robot::surface`] makes meshes of these shapes).
//!
//! ```
//! use grasp_lcp::robot::Robot;
//! use grasp_lcp::spatial::{Contact, Wrench};
//!
//! // Two fingers of one joint each, 80 mm apart and 60 mm long; the second follows the first.
//! let urdf = r#"<robot name="tongs">
//!   <link name="palm"/><link name="left"/><link name="right"/>
//!   <joint name="close" type="revolute">
//!     <parent link="palm"/><child link="left"/><origin xyz="-0.04 0 0"/><axis xyz="0 1 0"/>
//!     <limit lower="0" upper="1" effort="3" velocity="1"/>
//!   </joint>
//!   <joint name="follow" type="revolute">
//!     <parent link="palm"/><child link="right"/><origin xyz="0.04 0 0"/><axis xyz="0 -1 0"/>
//!     <limit lower="0" upper="1" effort="3" velocity="1"/><mimic joint="close"/>
//!   </joint>
//! </robot>"#;
//! let robot = Robot::from_urdf(urdf)?.stiffness(5.0).limited_by_effort();
//! let tip = |inward: f64| {
//!     Contact::new([0.0, 0.0, 0.06], [inward, 0.0, 0.0]).series_stiffness(1e4, 1e4).friction(0.5).pressed_with(20.0)
//! };
//! let contacts = [robot.on_link("left", &tip(1.0))?, robot.on_link("right", &tip(-1.0))?];
//! let grasp = robot.hand(&contacts)?.grasp()?;
//! let onset = grasp.onset(Wrench::force_at([0.0, 1.0, 0.0], [0.0, 0.0, 0.06]))?;
//! assert!((onset.factor().expect("held") - 20.0).abs() < 1e-12);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```

mod described;
mod fingers;
mod posture;
mod shapes;
mod urdf;

pub use described::{Robot, RobotJoint};
#[cfg(feature = "serde")]
pub(crate) use fingers::Mover;
