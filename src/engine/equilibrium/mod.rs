//! Equilibrium under a load: the conditions, the order of the methods that solve them, and the answer in physical quantities.
//!
//! Sought are the twist q and the contact forces F that satisfy the law of the [crate page](crate#the-problem). With given states of all contacts,
//! and given directions of slides, the conditions are linear. Contacts are then coupled by the object alone, through d equations of equilibrium, one
//! for each coordinate of the twist. Here `a` is a finger's offset (commanded displacement minus clearance), `u_c` the displacement of the body at
//! the contact, and `g` the gap. A contact has the stiffnesses `k_n`, `k_t` along its normal n and tangent t, and the stiffness matrix K. G_i is its
//! grasp map, and μ its coefficient of friction:
//!
//! | state | force | must hold |
//! |---|---|---|
//! | separated | `F = 0` | `g = n·u_c - a_n >= 0` |
//! | sticking | `F = K (a - G_iᵀq)` | `F_n >= 0`, `\|F_t\| <= μ F_n` |
//! | sliding | `F_n = k_n (a_n - n·u_c)`, `\|F_t\| = μ F_n` | `F_n >= 0`, slip `s = a_t - t·u_c - F_t/k_t` along F_t |
//!
//! The contact states remain to be found. Several methods ([`FoundBy`]) propose them, in this order, the cheapest first:
//!
//! 1. Everything sticks.
//! 2. Everything that touches sticks.
//! 3. Newton's method, in space and with many contacts.
//! 4. Lemke's method on the complementarity problem for slips and gaps, then on the problem for forces ([`forms`](crate::forms)).
//! 5. Every combination of contact states, with few contacts.
//!
//! In space Newton's method solves for the round cone. It starts near the solution in which everything sticks, later from proposals of Lemke's method
//! on a polygonal cone. If both starts fail, branch and bound over contact states and directions of friction finds an equilibrium or a proof that
//! none exists. The linear problem of the proposed contact states is solved again, and every condition is checked. Residuals are recomputed from the
//! numbers given for grasp and load before the answer is called an [`Equilibrium`].
//!
//! If no equilibrium is found, the answer is a [`Proof`] that none exists, or [`Undecided`], with the reason. A proof is a motion that nothing
//! resists, or a motion that separates the load from all admissible contact forces. Other proofs tried all contact states, or contradicted all cases
//! of contact states ([`Refutation`]).

mod accuracy;
mod answer;
mod cone;
mod contact_answer;
mod decomposition;
mod display;
mod distinct;
#[cfg(test)]
mod exact_refutation;
mod face;
mod geometry;
mod hand_answer;
mod influence;
mod installed;
mod left_out;
mod no_equilibrium;
mod pad_answer;
mod parameter;
mod questions;
mod recomputed;
mod refutation;
mod residuals;
mod snap_through;
mod sticking_response;
mod tolerances;
mod too_far;
mod turning_parts;
mod turns_over;
mod write_out;

pub use crate::search::{Doubt, FoundBy, Settings, SmallMotions};
pub use accuracy::Accuracy;
pub use answer::{Equilibrium, Outcome, Undecided, WorkDone};
pub(crate) use cone::AnswerFor;
pub use cone::Cone;
pub use contact_answer::{ContactAnswer, ContactState};
pub use decomposition::Decomposition;
pub use hand_answer::{DriveState, JointAnswer, TendonAnswer};
pub(crate) use influence::{Influence, push};
pub use no_equilibrium::{NoEquilibrium, Proof};
pub use pad_answer::{PadAnswer, WholeAnswer};
pub use parameter::Parameter;
pub use refutation::Refutation;
pub use residuals::Residuals;
pub(crate) use sticking_response::{ContactForces, StickingResponse};
pub use too_far::TooFar;
pub(crate) use too_far::{AIR_FLOWS_IN, CountedMotion, MotionData, farthest};
pub(crate) use write_out::site_states;

pub(crate) use left_out::LEAST_FRACTION;
pub(crate) use tolerances::ACCURATE;
