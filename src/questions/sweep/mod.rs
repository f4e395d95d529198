//! The same question for many loads or grasps at once, with answers in the order of the items and the same bits for any number of threads. Also
//! grasps with uncertain data: random samples of them, and the load up to which they stick with a reserve.
//!
//! Every item is computed independently by the same serial code. Threads (feature `parallel`, rayon's global pool) only share the items among them.
//! Outside this module only the sums over very many contacts of one scene use threads; they give the same bits, too.

mod batch;
mod caught;
mod courses;
mod datum;
mod failure;
mod in_order;
mod joint_effects;
mod margin;
mod off;
mod progress;
mod reserve;
mod second_order;
mod stuck_grasp;
mod tolerances;
mod uncertainty;
mod union;

pub use batch::{least_squeezes_of_batch, onset_gradients_of_batch, onsets_of_batch};
pub(crate) use caught::caught;
#[cfg(feature = "json")]
pub(crate) use caught::fault_in;
pub use in_order::map_in_order;
pub use progress::{Progress, map_watched};
pub use reserve::Reserve;
pub use uncertainty::Uncertainty;
