//! Does it hold? The load is put on from rest, and what becomes of it is told in one sentence.
//!
//! Three questions hide behind that word, and each has its own answer here:
//!
//! | question | who answers |
//! |---|---|
//! | What happens as the load is put on, from rest? | [`Grasp::hold`](crate::ask::Grasp::hold) |
//! | Is there an equilibrium under the load, however it is reached? | [`Grasp::solve`](crate::ask::Grasp::solve) |
//! | Could any contact forces carry the load? | [`Grasp::statics`](crate::ask::Grasp::statics) |
//!
//! The first is what people mean. It follows one path ([`Grasp::follow`](crate::ask::Grasp::follow)) and searches for nothing, so that it decides
//! wherever the path does. Where the load is lost before it is all on, a [`Verdict`] says how the object leaves ([`WayOut`]), and how far around there
//! nothing holds the load ([`NothingNear`]): a proof, whatever contacts have slipped before.
//!
//! For any virtual motion v with `u_i = G_iᵀv` balance gives `W·v = -Σ F_i·u_i`. A contact does no more against v than its friction under
//! its normal force, and that is known at every q, so that an equilibrium needs
//!
//! ```text
//! h(q) = Σ (μ |u_t,i| - u_n,i)₊ k_n,i (a_n,i - n·G_iᵀq)₊  >=  W·v
//! ```
//!
//! With the v of the loss and from the q where it was lost, h grows no faster than contacts open: the radius is where it could reach `W·v`.

mod caught;
mod left_out;
mod put_on;
mod verdict;
mod way_out;
mod words;

pub use caught::{Caught, MovesTo, SlippedBy};
pub use verdict::{FirstSlip, Holding, Lost, NothingNear, Verdict};
pub use way_out::WayOut;
pub(crate) use words::does;
