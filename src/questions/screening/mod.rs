//! Screening: the load factor of first slip, at which the first contact ceases to stick, for millions of grasps of two to five contacts.
//!
//! Planners ask for this load factor most often. Screening answers without allocating and almost without branches. It computes the contact forces as
//! if every contact stuck, at load factor zero and per unit of load factor. A ratio test on the exact friction cone then finds the least load factor
//! at which a contact ceases to stick. In the formulas W is the load, τ the load factor (multiple of the growing load), a the commands (displacements
//! that the fingers would make if there were no object), and s the factor on the given commands. F_i is the force of contact i. In the first formula
//! F_i⁰ is its value under the base load W₀ and F_i' its rate. In the second formula F_iᵃ is due to the commands alone, and F_iᵂ to the load and the
//! clearances (gaps between fingers and object before the commands) alone.
//!
//! | question | type | answer | method for unclear cases |
//! |---|---|---|---|
//! | At which factor of a growing load does the first contact cease to stick? | [`Pull`] | [`Screened`] | [`Grasp::onset`] |
//! | Which least squeeze makes all contacts stick under each load of a list? | [`LoadCases`] | [`ScreenedSqueeze`] | [`Grasp::least_squeeze`] |
//!
//! ```text
//! F_i(τ) = F_i⁰ + τ F_i'               W = W₀ + τ W'                      onset: the least τ > 0 beyond which a contact ceases to stick
//! F_i(s) = s F_iᵃ + F_iᵂ               a = s times the given commands     squeeze: the least s >= 0 with |F_t| <= μ F_n at every contact
//! ```
//!
//! [`ScreenedGradients`] are the derivatives of the load factor of first slip with respect to all data of a grasp. All derivatives together take as
//! long as a few load factors. One grasp: [`Fingers::onset_gradients`]. Many:
//! [`sweep::onset_gradients_of_batch`](crate::sweep::onset_gradients_of_batch).
//!
//! In a control loop [`Fingers::watch`] takes measured contact forces. It returns their margins, the load factor of first slip under a load to come,
//! and the relative increase of all commands that this load needs.
//!
//! [`Grasp::onset`] and [`Grasp::least_squeeze`] agree with screening if every contact sticks at load factor zero, and no numbers are so large or
//! small that their products over- or underflow. Otherwise the verdict of screening says why there is no number ([`ScreeningVerdict`],
//! [`SqueezeVerdict`]). Screening does not follow the grasp beyond first slip.
//!
//! One grasp at a time: [`Fingers`]. Many grasps under common loads: [`Batch`]; with soft fingertips or more than five contacts: [`PointBatch`]. On
//! all cores: [`sweep::onsets_of_batch`](crate::sweep::onsets_of_batch) and
//! [`sweep::least_squeezes_of_batch`](crate::sweep::least_squeezes_of_batch).
//!
//! A *lane* is the index of a grasp in a vector register, and a *block* as many grasps as there are lanes. A contact *leaves* (its friction cone)
//! when it ceases to stick.
//!
//! [`Grasp::onset`]: crate::ask::Grasp::onset
//! [`Grasp::least_squeeze`]: crate::ask::Grasp::least_squeeze

mod answer_slots;
mod balance;
mod batch;
mod batch_part;
mod block;
mod buckling;
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
mod question;
mod screened;
mod screened_gradient;
mod screened_squeeze;
mod slip_and_rotation;
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
pub use screened::Screened;
pub use screened_gradient::{ScreenedGradient, ScreenedGradients};
pub use screened_squeeze::{ScreenedSqueeze, SqueezeVerdict};
pub(crate) use slip_and_rotation::{SlipAndRotation, WhileSticking};
pub use watch::Watched;
