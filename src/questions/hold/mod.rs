//! Does the grasp hold? The load grows along one path from zero, in addition to the base load, which acts already at load factor 0.
//!
//! The word "hold" may mean three questions, each with its own method:
//!
//! | question | method |
//! |---|---|
//! | What happens as the load is put on, from rest? | [`Grasp::hold`](crate::ask::Grasp::hold) |
//! | Is there an equilibrium under the load, however it is reached? | [`Grasp::solve`](crate::ask::Grasp::solve) |
//! | Could any contact forces carry the load? | [`Grasp::statics`](crate::ask::Grasp::statics) |
//!
//! The first question is the usual one. [`Grasp::hold`](crate::ask::Grasp::hold) follows one load path ([`Grasp::follow`](crate::ask::Grasp::follow))
//! without a search for other equilibria. Its verdict is undecided only if this path cannot be continued, because of rounding or a limit on computing
//! effort. If equilibrium is lost before the whole load is applied, the [`Verdict`] names the motion of the object ([`WayOut`]). It also gives a
//! neighbourhood of the loss without any equilibrium ([`NoEquilibriumNear`]): a proof that holds whatever contacts have slipped before.
//!
//! The proof takes any virtual motion v with contact displacements `u_i = G_iᵀv`, where G_i is the grasp map of contact i. Let u_n,i be the normal
//! component of u_i (along the normal n into the object), and u_t,i its tangential part. The balance of the load W and the contact forces F_i gives
//! `W·v = -Σ F_i·u_i`. The negative work of a contact along v is at most that of its normal force and of the friction that this normal force allows.
//! The normal force is known at every motion q of the object, so that an equilibrium at the motion q needs
//!
//! ```text
//! h(q) = Σ (μ |u_t,i| - u_n,i)₊ k_n,i (a_n,i - n·G_iᵀq)₊  >=  W·v
//! ```
//!
//! Here μ is the coefficient of friction, a_n the normal command (displacement that the finger would make if there were no object, m), k_n the normal
//! stiffness (N/m) and `( )₊` the positive part. Thus `h` is an upper bound of the negative work of all contacts. Let v be the motion with which the
//! object leaves at the loss. As q moves away from its value at the loss, the terms of opposed contacts in h change in opposite senses. So h changes
//! little until one contact opens. The radius of the neighbourhood is the least change of q with which h could reach `W·v`.

mod applied_load;
mod caught_jump;
mod face;
mod first_slip;
mod in_slips;
mod loss;
mod short_verdict;
mod swing;
mod verdict;
mod way_out;
mod way_out_words;
mod words;

pub(crate) use applied_load::{AtRest, PathFacts, VerdictScope};
pub(crate) use caught_jump::NO_MOMENTUM;
pub use caught_jump::{CaughtJump, CaughtMotion, CaughtSlip};
pub use short_verdict::{LossVerb, ShortVerdict, VerdictKind};
pub use verdict::{FirstSlip, Holding, Lost, NoEquilibriumNear, Verdict};
pub use way_out::WayOut;
pub(crate) use words::{left_out_caution, subject_and_verb, taken_by_forces, they_open};
