//! The questions that a grasp answers, as methods.
//!
//! Every question is a method of [`Grasp`], or of one of its three views for rare questions: [`Statics`], [`Sensitivity`], [`Energy`].

// Declared first, because rustdoc lists the methods of `Grasp` in the order of these modules.
mod grasp;

mod changed;
mod closer_look;
mod energy;
mod growing;
mod hold_batch;
mod many;
mod onsets;
mod paths;
mod rows;
mod sensitivity;
mod squeezes;
mod statics;
mod workspace;

pub use energy::Energy;
pub use grasp::Grasp;
#[cfg(feature = "serde")]
pub(crate) use growing::check_growing;
pub use rows::RowOf;
pub(crate) use rows::{answers_of_rows, while_sticking};
pub use sensitivity::Sensitivity;
pub use statics::Statics;
pub use workspace::OnsetWorkspace;
