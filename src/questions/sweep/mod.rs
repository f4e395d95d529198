//! Asks the same question for many loads or grasps at once. Answers come in the order of the items and have the same bits for any number of threads.
//! Grasps with uncertain data are treated, too: random samples of them, and the load up to which all contacts stick with a number of standard
//! deviations in reserve.
//!
//! Every item is computed independently by the same serial code. With the feature `parallel`, threads of rayon's global pool compute different items
//! at the same time; no item is divided among threads. Outside this module only the sums over very many contacts of one scene use threads; they give
//! the same bits for any number of threads, too.

mod batch;
mod contact_errors;
mod datum;
mod failure;
mod in_order;
mod interaction;
mod margin;
mod panic_as_error;
mod progress;
mod reserve;
mod second_order;
mod source_forces;
mod stuck_grasp;
mod tolerances;
mod uncertainty;
mod union;

pub use batch::{least_squeezes_of_batch, onset_gradients_of_batch, onsets_of_batch};
pub use in_order::map_in_order;
pub(crate) use panic_as_error::caught;
#[cfg(feature = "json")]
pub(crate) use panic_as_error::fault_in;
pub use progress::{Progress, map_watched};
pub use reserve::Reserve;
pub use uncertainty::Uncertainty;
