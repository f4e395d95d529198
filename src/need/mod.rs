//! How much does it need? The least squeeze or friction, the greatest load, arm or angle, such that nothing slides or such that it is not lost.
//!
//! A [`Need`] says which quantity is sought and for which loads; [`Grasp::need`](crate::ask::Grasp::need) answers in the unit that people set:
//! newtons at each jaw, a coefficient of friction, metres, degrees.
//!
//! | sought | what may be asked for | answer |
//! |---|---|---|
//! | [`Need::squeeze`] | least, as N at each contact at rest | all commands in proportion |
//! | [`Need::friction`] | least, of all contacts or of one | |
//! | [`Need::load`] | greatest, as so many times the loads | |
//! | [`Need::arm`] | greatest distance at which a force may act, m | |
//! | [`Need::angle`] | greatest angle of a load that turns, rad | |
//!
//! What is to be kept is a [`Demand`]: nothing slides, or the object is not lost; or, where the loads are put on again and again, it comes to rest, or does not walk.
//!
//! Every trial is a verdict of its own, from rest ([`Grasp::hold`](crate::ask::Grasp::hold)): one amount does, the other does not, and the answer
//! names both. Between them it is bisected to the last digits. No theorem says that more is better: a motor at its limit presses no harder while another
//! finger still pushes the object away. So the search goes both ways from what is given, and between amounts to where most of the load is carried. Then a
//! scan of amounts around the bound tells up to where they do ([`FarEnd`]), and which others do ([`AmountWindow`]).

mod answer;
mod around;
mod at_amount;
mod needed;
mod question;
mod repeated;
mod search;
mod trial;
mod words;

pub use answer::{Amount, AmountWindow, FarEnd, Needed, Press, Quantity};
pub use question::{Demand, Need};
