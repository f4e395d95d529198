//! Screening: the load at which the first contact stops sticking, for millions of grasps of two to five contacts.
//!
//! This is the commonest question of a planner. Screening answers it without allocating and without a branch. It stretches all springs as if every
//! contact stuck, once at factor zero of the load and once for its rate. A ratio test on the exact cone then finds where the first contact leaves.
//!
//! | question | type | answer | method for unclear cases |
//! |---|---|---|---|
//! | At which factor of a growing load does the first contact leave? | [`Pull`] | [`Screened`] | [`Grasp::onset`] |
//! | Which least squeeze holds each load of a list? | [`LoadCases`] | [`ScreenedSqueeze`] | [`Grasp::least_squeeze`] |
//!
//! ```text
//! F_i(τ) = F_i(W₀) + τ F_i'            W = W₀ + τ W'                      onset: the least τ > 0 beyond which
//! F_i(s) = s F_iᵃ + F_i(W)             a = s times the commands           squeeze: the least s >= 0 with |F_t| <= μ F_n at every contact
//! ```
//!
//! Derivatives of the factor of a load by all data of a grasp are [`ScreenedGradients`]; all of them together take as long as a few values. One grasp:
//! [`Fingers::onset_gradients`]. Many: [`sweep::onset_gradients_of_batch`](crate::sweep::onset_gradients_of_batch).
//!
//! In a control loop [`Fingers::watch`] evaluates measured forces: their margins, the first slip under a load to come, and the extra squeeze that
//! this load needs.
//!
//! [`Grasp::onset`] and its siblings agree with screening wherever every contact sticks at the start and the numbers are not extreme. Elsewhere the
//! verdict of screening says why it has no answer ([`ScreeningVerdict`], [`SqueezeVerdict`]). Screening does not follow the grasp beyond the onset.
//!
//! One grasp at a time: [`Fingers`]. Many under common loads: [`Batch`], with pads or more contacts [`PointBatch`], and on all cores
//! [`sweep::onsets_of_batch`](crate::sweep::onsets_of_batch) and [`sweep::least_squeezes_of_batch`](crate::sweep::least_squeezes_of_batch).
//!
//! In the code a *scene* is one grasp, a *lane* its place in a vector register, and a *block* as many scenes as there are lanes.
//!
//! [`Grasp::onset`]: crate::ask::Grasp::onset
//! [`Grasp::least_squeeze`]: crate::ask::Grasp::least_squeeze

mod answer_slots;
mod balance;
mod batch;
mod batch_part;
mod block;
mod by_motion;
mod cone;
mod edge;
mod factors;
mod finger;
mod fingers;
mod first_exit;
mod first_slip;
mod forces;
mod gradient;
mod gradient_row;
mod kernels;
mod lanes;
mod least_factor;
mod load_cases;
mod method;
mod moved;
mod one_grasp;
mod pair;
mod pinch;
mod point_batch;
mod pull;
mod put_on;
mod question;
mod screened;
mod screened_gradient;
mod screened_squeeze;
mod springs;
mod tolerances;
mod triangle;
mod verdict;
mod watch;

pub use batch::Batch;
pub use fingers::Fingers;
pub use first_slip::ScreeningVerdict;
pub use load_cases::LoadCases;
pub use point_batch::PointBatch;
pub use pull::Pull;
pub(crate) use put_on::{PutOn, WhileSticking};
pub use screened::Screened;
pub use screened_gradient::{ScreenedGradient, ScreenedGradients};
pub use screened_squeeze::{ScreenedSqueeze, SqueezeVerdict};
pub use watch::Watched;
