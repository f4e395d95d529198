//! Grasps in the plane: 3 degrees of freedom, 2 axes a contact. Lengths in m, forces in N, moments from x to y in N m.
//!
//! The contact frame is (n, t) with n into the object and `t = (n_y, -n_x)`. Nothing is approximated: the planar
//! friction cone is a polygonal one.

pub use crate::grasp::Pressure;

crate::names::names!(2);
