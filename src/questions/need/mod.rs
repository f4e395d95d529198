//! How much does it need? The least squeeze or friction, the greatest load, arm or angle, such that nothing slides or such that it is not lost.
//!
//! A [`Need`] names the sought quantity and the loads; [`Grasp::need`](crate::ask::Grasp::need) answers with a [`Needed`]. Its sentence has the units
//! of practice: newtons at each jaw, a coefficient of friction, metres, degrees.
//!
//! | sought | bound | unit of [`Amount`] |
//! |---|---|---|
//! | [`Need::squeeze`] | least, all commands in proportion | multiple of the squeeze given; the sentence has N at each contact, of suction cups kPa |
//! | [`Need::friction`] | least, of all contacts or of some | coefficient |
//! | [`Need::load`] | greatest | multiple of the loads given |
//! | [`Need::arm`] | greatest displacement of a force | m |
//! | [`Need::angle`] | greatest angle of a load that turns | rad; the sentence has degrees |
//! | [`Need::force`] | least load of a body, or command of a contact, cable or joint | multiple of the one given; in the sentence N or N m |
//! | [`Need::load_at_rest`] | least | multiple of the load at rest given |
//!
//! The [`Demand`] is one of four. The object is held, and the answer adds the amount with which nothing slides; or nothing slides at all. Where the
//! loads are put on again and again, the object comes to rest, or it does not walk.
//!
//! Every trial is a verdict from rest ([`Grasp::hold`](crate::ask::Grasp::hold)). The answer names two amounts that were tried: one suffices, the
//! other beside it does not. Between them, secants of the carried part of the load lead to the last digits; where that jumps, those of small motions
//! or of sticking at rest. These trials leave out the search of every case, which takes longest beside a bound; both amounts of the answer have it.
//!
//! Statics comes first: the amounts for which some forces inside all cones balance the loads form an interval, and a proof excludes all others. No
//! theorem says that more is better: a motor at its limit presses no harder while another finger still pushes the object away. So the search goes
//! both ways from the start, and between trials towards the largest carried part. Then a few amounts around the bound show up to where amounts
//! suffice ([`FarEnd`]), and which others do ([`AmountWindow`]). A narrow window between two of them stays unseen, so that the answer says how many
//! amounts were tried ([`TriedAmounts`]), unless a proof excludes all others. Where only loads and squeeze act, twice the squeeze carries twice the load, and this
//! scan is omitted unless a far squeeze moves the part too far.
//!
//! Where no command presses there is no squeeze. Then the force of the only loaded body is sought in its place, or the load at rest, and the answer
//! says so.

mod answer;
mod around;
mod at_amount;
mod batch;
mod between;
mod face;
mod loading;
mod needed;
mod posed;
mod press;
mod question;
mod range;
mod repeated;
mod search;
mod threshold;
mod tolerances;
mod trial;
mod tried;
mod words;

pub use answer::{Amount, AmountWindow, FarEnd, Needed, PressedBy, Quantity, TriedAmounts};
pub use batch::ShortAmount;
pub use press::Press;
pub use question::{Demand, Need};
