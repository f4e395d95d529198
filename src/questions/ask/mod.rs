//! Questions to a grasp.
//!
//! [`Grasp`] is the one type to ask. Its engine has as many coordinates as the grasp needs; callers need not know their number. Rare questions have
//! views of their own: [`Statics`], [`Sensitivity`], [`Energy`].

// First, because the documentation of `Grasp` begins with the methods of the first file.
mod grasp;
mod installed;

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
