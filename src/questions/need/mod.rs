//! The amount of a quantity that a grasp needs: the least squeeze or friction, or the greatest load, arm or angle, with which nothing slides, or with
//! which the object is held.
//!
//! A [`Need`] names the sought quantity and the loads; [`Grasp::need`](crate::ask::Grasp::need) answers with a [`Needed`]. The sentence of this
//! answer has the units of practice: newtons at each jaw, a coefficient of friction, metres, degrees.
//!
//! | sought | bound | unit of [`Amount`] |
//! |---|---|---|
//! | [`Need::squeeze`] | least, all commands in proportion | multiple of the given squeeze; the sentence has N at each contact, of suction cups kPa |
//! | [`Need::friction`] | least, of all contacts or of some | coefficient |
//! | [`Need::load`] | greatest | multiple of the given loads |
//! | [`Need::arm`] | greatest displacement of a force | m |
//! | [`Need::angle`] | greatest angle of a load that turns | rad; the sentence has degrees |
//! | [`Need::force`] | least load of a body, or command of a contact, cable or joint | multiple of the given one; in the sentence N or N m |
//! | [`Need::load_at_rest`] | least | multiple of the given load at rest |
//!
//! There are four [`Demand`]s. [`Held`](Demand::Held): the object is held; the answer then adds the amount with which nothing slides.
//! [`Sticks`](Demand::Sticks): nothing slides at all. [`Rests`](Demand::Rests): under loads that repeat, the object comes to rest.
//! [`Stays`](Demand::Stays): under loads that repeat, it does not walk.
//!
//! For every amount that is tried, [`Grasp::hold`](crate::ask::Grasp::hold) gives the verdict. An amount is sufficient if the grasp meets the demand
//! with it. The answer names two neighbouring amounts at the bound (the least or greatest sufficient amount): one is sufficient, the other is
//! insufficient. This bracket is narrowed with secants of the carried fraction of the load (the load factor up to which the demand is met), in the
//! plane to the last digits. If that fraction jumps at the bound, secants of another measure are used: the distance to the limit of small motions (up
//! to which the linear theory is trusted), or the least margin by which a contact sticks at rest. At rest means under the load that acts before the
//! others. If no equilibrium at rest exists beyond the bound, the distances of contacts from the ends of their states (open, sticking, sliding) are
//! used. While the bracket is narrowed, two parts of a verdict are omitted: the enumeration of many contact states, which is slowest near a bound,
//! and the reason why no equilibrium exists. The verdicts for the two amounts of the answer include both. If only the enumeration finds equilibria at
//! rest beyond the bound, a few amounts are tried there. If some are sufficient beyond insufficient ones, the bound lies before all of them.
//!
//! Statics comes first: the amounts for which some forces inside all cones balance the loads form an interval, and a proof excludes all others. A
//! larger squeeze is not always better: a motor at its limit presses no harder while another finger still pushes the object away. Therefore the
//! search goes both ways from the first amount, and then between the amounts tried, towards the largest carried fraction. A scan of a few amounts
//! around the bound finds how far the sufficient amounts extend ([`FarEnd`]), and further intervals of sufficient amounts ([`AmountWindow`]). If
//! contact states at rest differ between neighbouring amounts, or a margin is predicted to be zero between them, amounts between them are tried, too.
//! The scan can still miss a narrow interval between two amounts. The answer therefore says how many amounts were tried ([`TriedAmounts`]), unless a
//! proof excludes all others. If only loads and squeeze act, twice the squeeze carries twice the load. The scan is then omitted, unless a much larger
//! squeeze moves the object too far.
//!
//! If no command presses, there is no squeeze to scale. In that case the force of the only loaded body is sought, or the load at rest, and the answer
//! says so.

mod alternating;
mod amount_words;
mod answer;
mod any_direction;
mod at_amount;
mod batch;
mod between;
mod bound_scan;
mod checked_need;
mod face;
mod found_amounts;
mod loading;
mod needed;
mod press;
mod pressed_at_rest;
mod proved;
mod question;
mod range;
mod repeated;
mod search;
mod spread_directions;
mod threshold;
mod tolerances;
mod trial;
mod trial_record;
mod words;

pub use answer::{Amount, AmountWindow, FarEnd, Needed, PressedBy, Quantity, TriedAmounts};
pub use batch::ShortAmount;
pub use press::ContactPress;
#[cfg(feature = "serde")]
pub(crate) use press::pressure_of_cup;
pub use question::{Demand, Need};
