//! Lemke's method on lists of contact states, for one contact or a hundred thousand.
//!
//! All that couples the contacts is the motion of the object. With every contact in a known state its law is linear, so a
//! complementary basis is a list of contact states and a pivot solves one system with d + 1 rows; the matrix of the complementarity problem is never
//! formed. The pivots are those of the dense solver on [`Form`](crate::forms::Form).

mod basis;
mod contact_form;
mod newton;
mod path;
mod proposal;
mod solution;
mod variables;
mod workspace;

pub(crate) use proposal::{propose, propose_by_newton};
pub use workspace::{Search, View, Workspace};
