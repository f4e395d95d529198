//! At which load does the first contact leave rolling, for millions of grasps of two to five
//! contacts?
//!
//! This is the commonest question of a planner. Screening answers it without memory of its own and
//! without a branch: it stretches all springs as if every contact rolled, once at factor zero of
//! the load and once for its rate. A ratio test on the exact cone then says where the first contact
//! leaves.
//!
//! [`Grasp::onset`](crate::grasp::Grasp::onset) finds this factor, too, wherever every contact
//! rolls at factor zero and the numbers are not extreme. Elsewhere screening says why it has no
//! answer ([`Verdict`]) and leaves the question to `Grasp::onset`. Screening does not ask what
//! comes beyond the onset.
//!
//! ```text
//! F_i(τ) = F_i(W₀) + τ F_i',   W = W₀ + τ W',   onset: the least τ > 0 beyond which |F_t| > μ F_n (if μ is 0 or infinite: F_n < 0) at some contact
//! ```
//!
//! One scene at a time: [`Fingers`]. Many under common loads: [`Batch`], and
//! [`sweep::onsets_of_batch`](crate::sweep::onsets_of_batch) on all cores.

mod arccotangent;
mod balance;
mod batch;
mod block;
mod cone;
mod enough;
mod exit;
mod finger;
mod fingers;
mod first;
mod forces;
mod lanes;
mod load_cases;
mod pair;
mod pull;
mod question;
mod ready;
mod rolling;
mod screened;
mod screened_squeeze;
mod turning;
mod turning_pull;
mod verdict;

pub use batch::Batch;
pub(crate) use batch::Part;
pub use fingers::Fingers;
pub use first::Verdict;
pub use load_cases::LoadCases;
pub use pull::Pull;
pub(crate) use question::Question;
pub use screened::{Screened, ScreenedTurn};
pub use screened_squeeze::{ScreenedSqueeze, SqueezeVerdict};
pub use turning_pull::TurningPull;
