//! How much is needed.

use crate::error::Error;
use crate::grasp::WholeContact;

use super::question::Demand;
use crate::prelude::*;

/// The answer to "how much does it need?"; its [`Display`](std::fmt::Display) says it in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Needed {
    /// What was sought.
    pub quantity: Quantity,
    /// What was to be kept.
    pub demand: Demand,
    /// How much of it that takes, or allows, on the numbers given.
    pub amount: Amount,
    /// Where it is to be held: how much of it takes, or allows, that nothing slides.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub sticks: Option<Amount>,
    /// The same as `amount` where friction and squeeze are less than said, and loads larger; `None` if that was not asked, or does not count here.
    pub safe: Option<Amount>,
    /// What friction and squeeze were taken to be less by then.
    pub lower: [f64; 2],
    /// How many times as large the loads were taken to be then.
    #[cfg_attr(feature = "serde", serde(default = "once", skip_serializing_if = "is_once"))]
    pub safety: f64,
    /// Where so many times a load is sought that is one force: its size, N.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub force: Option<f64>,
    /// Of a force the part that presses with it.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub of: Option<PressedBy>,
    /// Whether a squeeze was asked for where no command presses. Then the force is sought of what presses in its place, if there is one such part.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub in_place_of_squeeze: bool,
}

#[cfg(feature = "serde")]
const fn once() -> f64 {
    1.0
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
fn is_once(times: &f64) -> bool {
    *times == 1.0
}

/// What presses with a force that is sought.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PressedBy {
    /// A body, a contact, a link or a joint by its name; `None` for the load at rest.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub part: Option<String>,
    /// Whether it is a body, which presses by its load.
    pub is_body: bool,
    /// The size that amounts are multiples of; `None` where it is neither one force nor one moment.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub size: Option<f64>,
    /// The unit of that.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub unit: Option<String>,
}

/// A quantity that people set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Quantity {
    /// The squeeze, as a multiple of the one given.
    Squeeze,
    /// A coefficient of friction.
    Friction,
    /// The loads, as a multiple of those given.
    Load,
    /// The arm of a force, m.
    Arm,
    /// An angle, rad.
    Angle,
    /// The force of one part that presses, as a multiple of the one given.
    Force,
}

impl Quantity {
    /// Whether the least of it is sought, or else the greatest.
    #[must_use]
    pub fn is_least(self) -> bool {
        matches!(self, Self::Squeeze | Self::Friction | Self::Force)
    }
}

/// How much of a quantity.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Amount {
    /// This much, and no better.
    #[non_exhaustive]
    Bound {
        /// An amount that was tried and does.
        does: f64,
        /// One beside it that was tried and does not.
        does_not: f64,
        /// What happens with that: a sentence.
        otherwise: String,
        /// An amount between both of which it is not known.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        unknown: Option<f64>,
        /// How often the verdict changed among the amounts that were looked at; once as a rule.
        changes: usize,
        /// Where that amount goes on to do no longer, as with a squeeze under which something else is pressed away; `None` if it does as far as was looked.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        until: Option<FarEnd>,
        /// Amounts apart from these that do, in order.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
        elsewhere: Vec<AmountWindow>,
        /// Of a squeeze: what each contact presses with at rest, N.
        presses: Vec<Press>,
        /// Of a squeeze: joints and tendons whose drives are at their limit at rest, so that they press no harder.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
        at_their_limit: Vec<String>,
    },
    /// Any amount does, down or up to this one, which was tried.
    #[non_exhaustive]
    Any {
        /// The last amount.
        to: f64,
        /// Where the others end to do, as an arm which jams from some length on; `None` if they do as far as was looked.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        until: Option<FarEnd>,
    },
    /// No amount does: by a proof, or as far as was tried.
    #[non_exhaustive]
    None {
        /// The least amount that was tried, or that the proof is for.
        from: f64,
        /// The greatest.
        to: f64,
        /// How many were tried.
        #[cfg_attr(feature = "serde", serde(default))]
        tried: usize,
        /// Whether no amount between these can do: no forces of the contacts balance the loads with any of them.
        #[cfg_attr(feature = "serde", serde(default))]
        is_proved: bool,
        /// The one among them that carries most.
        best: f64,
        /// What happens with that: a sentence.
        otherwise: String,
    },
    /// With this amount it is not known.
    #[non_exhaustive]
    Undecided {
        /// The amount.
        at: f64,
        /// Why.
        doubt: String,
    },
}

impl Amount {
    /// The amount that does, if there is a bound.
    #[must_use]
    pub fn bound(&self) -> Option<f64> {
        if let Self::Bound { does, .. } = self { Some(*does) } else { None }
    }
}

/// The far end of the amounts that do.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FarEnd {
    /// The last amount that was tried and does.
    pub does: f64,
    /// One beside it that was tried and does not.
    pub does_not: f64,
    /// What happens with that: a sentence.
    pub otherwise: String,
    /// Of a squeeze: what each contact presses with at rest there, N.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub presses: Vec<Press>,
    /// Of a squeeze: joints and tendons whose drives are at their limit at rest there.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub at_their_limit: Vec<String>,
}

/// Amounts that do, from one to another; an end that was not found lies beyond the amounts that were looked at.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct AmountWindow {
    /// The least of them.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub from: Option<f64>,
    /// The greatest of them.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub to: Option<f64>,
}

impl AmountWindow {
    pub(super) fn contains(&self, amount: f64) -> bool {
        self.from.is_none_or(|from| from <= amount) && self.to.is_none_or(|to| amount <= to)
    }
}

/// What a contact presses with.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Press {
    /// The contact, or the soft fingertip.
    pub part: WholeContact,
    /// Its normal force, N.
    pub force: f64,
}

/// A part by which friction or squeeze may be less: from 0 to less than 1.
pub(super) fn check_part(what: &'static str, value: f64) -> Result<(), Error> {
    if (0.0..1.0).contains(&value) {
        Ok(())
    } else {
        Err(Error::Argument { what, value, allowed: "from 0 to less than 1: 0.1 is ten percent" })
    }
}
