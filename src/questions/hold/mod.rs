//! Does it hold? The load grows from rest along one path, and the verdict is one sentence.
//!
//! The word "hold" stands for three questions, each with its own method:
//!
//! | question | method |
//! |---|---|
//! | What happens as the load is put on, from rest? | [`Grasp::hold`](crate::ask::Grasp::hold) |
//! | Is there an equilibrium under the load, however it is reached? | [`Grasp::solve`](crate::ask::Grasp::solve) |
//! | Could any contact forces carry the load? | [`Grasp::statics`](crate::ask::Grasp::statics) |
//!
//! The first is the usual one. It follows one load path ([`Grasp::follow`](crate::ask::Grasp::follow)) without a search for other equilibria, and is
//! undecided only where the path is. If equilibrium is lost before the whole load is applied, the [`Verdict`] names the motion of the object
//! ([`WayOut`]). It also gives a neighbourhood of the loss without any equilibrium ([`NothingNear`]): a proof that holds whatever contacts have slipped
//! before.
//!
//! The proof takes any virtual motion v with contact displacements `u_i = G_iᵀv`; balance gives `W·v = -Σ F_i·u_i`. The work of a contact against v
//! is at most that of its normal force and the friction it allows. The normal force is known at every motion q of the object, so that an equilibrium
//! needs
//!
//! ```text
//! h(q) = Σ (μ |u_t,i| - u_n,i)₊ k_n,i (a_n,i - n·G_iᵀq)₊  >=  W·v
//! ```
//!
//! Here a_n is the normal command (m), k_n the normal stiffness (N/m) and `( )₊` the positive part. With the v and q of the loss, the terms of opposed
//! contacts balance as h grows with q, until one contact opens. The radius is the distance from q at which h could reach `W·v`.

mod applied_load;
mod caught;
mod face;
mod in_slips;
mod left_out;
mod loss;
mod short;
mod verdict;
mod way_out;
mod way_out_words;
mod words;

pub(crate) use applied_load::{AtRest, Extent, OfThePath};
pub use caught::{Caught, MovesTo, SlippedBy};
pub use short::{How, LossVerb, ShortVerdict};
pub use verdict::{FirstSlip, Holding, Lost, NothingNear, Verdict};
pub use way_out::WayOut;
pub(crate) use words::does;
