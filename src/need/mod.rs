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
//! | [`Need::force`] | least, as a multiple of the load of a body, or of the command of one contact, cable or joint | N |
//! | [`Need::load_at_rest`] | least, as a multiple of the load at rest | |
//!
//! What is to be kept is a [`Demand`]: the object is held, with the amount beside it with which nothing slides; or nothing slides at all; or, where the loads are put on again and again, it comes to rest, or does not walk.
//!
//! Every trial is a verdict of its own, from rest ([`Grasp::hold`](crate::ask::Grasp::hold)): one amount does, the other does not, and the answer
//! names both. Between them secants of how much of the load is carried lead to the last digits. Statics comes first: the amounts for which any forces inside
//! all cones balance the loads are an interval, outside which a proof says that no amount does. No theorem says that more is better: a motor at its limit
//! presses no harder while another finger still pushes the object away. So the search goes both ways from what is given, and between amounts to where most
//! of the load is carried. Then a few amounts around the bound tell up to where they do ([`FarEnd`]), and which others do ([`AmountWindow`]). Where
//! loads and squeeze are all there is, twice the squeeze takes twice the load, and nothing has to be looked at.
//!
//! Where no command presses there is no squeeze: then the load is sought that presses in its place, of a body or at rest, and the answer says so.

mod answer;
mod around;
mod at_amount;
mod needed;
mod question;
mod range;
mod repeated;
mod search;
mod trial;
mod words;

pub use answer::{Amount, AmountWindow, FarEnd, Needed, Press, PressedBy, Quantity};
pub use question::{Demand, Need};
