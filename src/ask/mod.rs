//! Questions put to a grasp.
//!
//! [`Grasp`] is the one type to ask. Behind it stands an engine for as many coordinates as the grasp has; who asks need not know.
//! What is rarely asked has a view of its own: [`Statics`], [`Sensitivity`], [`Energy`].

// First, for the page of its documentation begins with what stands here.
mod grasp;
mod installed;

mod changed;
mod closer_look;
mod energy;
mod engines;
mod many;
mod onsets;
mod paths;
mod questions;
mod sensitivity;
mod squeezes;
mod statics;
mod workspace;

pub use crate::structured::{EquilibriumView, Search};
pub use energy::Energy;
pub use grasp::Grasp;
pub use many::onset_of_each;
pub use sensitivity::Sensitivity;
pub use statics::Statics;
pub use workspace::{OnsetWorkspace, Workspace};
