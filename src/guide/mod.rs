//! Guides: the meaning of answers, and the right questions to ask.
//!
//! | question | page |
//! |---|---|
//! | What does the crate contain, from the program to the solvers? | [`tour`] |
//! | Which commands answer twelve everyday questions? | [`everyday`] |
//! | Which numbers may be trusted, and when? | [`which_answer`] |
//! | Why are there several equilibria, and which one is real? | [`several_equilibria`] |
//! | What does it mean that Lemke's method ended on a ray? | [`reading_a_ray`] |
//! | Round cone or polygon, and how many facets? | [`choosing_facets`] |
//! | Where should fingers be, and how hard should they press? | [`choosing_fingers`] |
//! | How is a grasp watched a thousand times a second, on a controller without an operating system? | [`control_loop`] |
//! | Is the object caught again after the first slip, or does it fall? | [`kinetic_friction`] |
//! | How are wedges, vices, stacks and arches described, with several bodies? | [`several_bodies`] |
//! | Does the grasp survive shaking, or does the object creep out of it? | [`loads_that_repeat`] |
//! | Which friction, loads of supports and squeeze follow from observed slips? | [`slips_that_were_seen`] |
//! | How is a suction cup described, and when does it let go? | [`suction_cups`] |
//! | Which stiffness is entered, and which answers depend on it? What do a pad's strips cost, and where do its sides lie? | [`pads_and_stiffness`] |
//! | How are joints, tendons, stalled motors and constant finger forces described, and what do they change? | [`hands`] |
//!
//! The pages have no items of their own; their examples are compiled and run as tests.

pub mod choosing_facets;
pub mod choosing_fingers;
pub mod control_loop;
pub mod everyday;
pub mod hands;
pub mod kinetic_friction;
pub mod loads_that_repeat;
pub mod pads_and_stiffness;
pub mod reading_a_ray;
pub mod several_bodies;
pub mod several_equilibria;
pub mod slips_that_were_seen;
pub mod suction_cups;
pub mod tour;
pub mod which_answer;
