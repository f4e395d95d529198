//! The answer to a [`Need`](super::Need): the least or greatest amount of a quantity that meets a demand.
//!
//! An amount (of squeeze, friction, load, arm, angle or force) is sufficient if the grasp meets the demand with it. A safe amount is sufficient also
//! with less friction and squeeze (the field `lower`), or with larger loads (the field `safety`). The squeeze is everything by which contacts press
//! at rest without a load, such as commands (displacements that fingers would make without an object) and constant forces. The verdict on an amount
//! says whether the grasp meets the demand with it, or is undecided. At rest means before the loads of the question act. A drive is the spring of a
//! joint or tendon of a hand, with its force limit. A jump is a sudden motion of the object under constant load: it slips until a contact catches it,
//! or snaps over, i.e. loses its equilibrium and moves to another one.

use core::fmt;

use super::press::ContactPress;
use super::question::Demand;
use crate::error::Error;
use crate::grasp::WholeContact;
use crate::prelude::*;

/// The answer to "how much squeeze, friction, load, … does the grasp need?"; its [`Display`](std::fmt::Display) is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[expect(clippy::struct_excessive_bools, reason = "each says another fact of the question")]
#[non_exhaustive]
pub struct Needed {
    /// The sought quantity.
    pub quantity: Quantity,
    /// The condition that the grasp has to meet with the amount, such as that the object is held.
    pub demand: Demand,
    /// The least or greatest amount that meets the demand, with friction, squeeze and loads as given; in the unit of `quantity`.
    pub amount: Amount,
    /// The amount with which nothing slides; `None` unless the demand is that the object is held.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub sticks: Option<Amount>,
    /// The amount that meets the demand if friction and squeeze are reduced by `lower` and loads are multiplied by `safety`; `None` if nothing is
    /// reduced or multiplied. Every amount between it and its far end meets the demand both with these deviations and without them.
    pub safe: Option<Amount>,
    /// Relative reductions of friction and of the squeeze that `safe` allows for, each from 0 to less than 1. If no command presses, the reduction of
    /// the squeeze is 0.
    pub lower: [f64; 2],
    /// Factor on the loads that `safe` allows for; 1 without a factor of safety.
    #[cfg_attr(feature = "serde", serde(default = "once", skip_serializing_if = "is_once"))]
    pub safety: f64,
    /// Whether a load acts at rest, before the loads of the question; `safety` does not multiply it. Such loads are weights and loads of bodies, and
    /// the load at rest of the question.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub is_loaded_at_rest: bool,
    /// Magnitude of the force whose multiple is sought, N: an amount x means x times this force. `None` for other quantities, and unless the loads
    /// are one single force.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub force: Option<f64>,
    /// What exerts the sought force: a body, contact, link or joint, or the load at rest. `None` if another quantity is sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub of: Option<PressedBy>,
    /// True if a squeeze was asked for, but no command presses, so that there is no squeeze to multiply. The answer is then about the load on the
    /// only loaded body, or about the load at rest if no body is loaded.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub in_place_of_squeeze: bool,
    /// For an angle in the plane: whether the grasp is tilted anticlockwise, from x to y. `None` for other quantities, and unless the load turns.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub anticlockwise: Option<bool>,
    /// Whether the sought squeeze consists of overlaps (clearances below zero), because no command presses. Amounts are then multiples of the
    /// overlaps.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub by_overlaps: bool,
    /// Whether a contact has a coefficient of kinetic friction of its own, which changes in proportion to the friction sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub scales_kinetic: bool,
    /// Whether the force in any direction changes in proportion to the load sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub scales_any_force: bool,
    /// Whether, with the amount at the bound, the object jumps while the load is put on: it slips under constant load until a contact catches it, or
    /// snaps over. Its momentum is not counted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub jumps: bool,
    /// Minus the fraction of the springs' resistance that forces take away as they turn with the parts they act on, with the amount at the bound. The
    /// theory of small motions neglects this effect; see [`Verdict::left_out`](crate::hold::Verdict::left_out). `None` if the fraction is small.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub left_out: Option<f64>,
    /// The contacts whose coefficient of friction is sought; empty if one coefficient for all contacts is sought, and for other quantities.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub contacts: Vec<WholeContact>,
    /// Contacts without friction, which stay frictionless if one coefficient for all other contacts is sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub without_friction: Vec<WholeContact>,
}

#[cfg(feature = "serde")]
const fn once() -> f64 {
    1.0
}

#[cfg(feature = "serde")]
#[allow(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes references; where pointers have 32 bits the lint is silent"
)]
fn is_once(times: &f64) -> bool {
    *times == 1.0
}

/// What exerts the sought force (a body, contact, link or joint, or the load at rest), and the given magnitude of that force.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PressedBy {
    /// Name of the body, contact, link or joint; `None` for the load at rest.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub part: Option<String>,
    /// Whether the part is a body. The sought force is then the load on this body.
    pub is_body: bool,
    /// Whether the sought force is the commanded normal force of a contact, `pressed_with`. The normal force itself differs from it if the commands
    /// of other contacts press this contact, too.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub is_command: bool,
    /// Magnitude of the given force or moment, in `unit`: amounts are multiples of it. `None` if the load is neither one force nor one moment.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub size: Option<f64>,
    /// Unit of `size`, N or N m; `None` if `size` is `None`.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub unit: Option<String>,
}

/// A quantity whose least or greatest sufficient value is sought. The unit given is that of its values, the amounts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Quantity {
    /// The squeeze, as a multiple of the given squeeze.
    Squeeze,
    /// A coefficient of friction, of all contacts or of some.
    Friction,
    /// The loads, as a multiple of the given loads.
    Load,
    /// The arm of a force: the displacement, m, of the point at which it acts.
    Arm,
    /// The angle of a load that turns, rad.
    Angle,
    /// The force of one body, contact, link or joint, or the load at rest, as a multiple of the given force or load.
    Force,
}

impl Quantity {
    /// Whether the least amount is sought: of a squeeze, friction or a force. For all other quantities the greatest amount is sought.
    #[must_use]
    pub fn is_least(self) -> bool {
        matches!(self, Self::Squeeze | Self::Friction | Self::Force)
    }
}

/// The least or greatest sufficient amount (the bound), in the unit of its [`Quantity`]. An amount is sufficient if the grasp meets the demand with
/// this amount.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Amount {
    /// The least or greatest sufficient amount is known, with the insufficient amount next to it.
    #[non_exhaustive]
    Bound {
        /// The sufficient amount at the bound, for which a verdict was computed.
        sufficient: f64,
        /// The insufficient amount next to `sufficient`. Either the grasp was computed with it, or a proof excludes it. As a rule the two amounts
        /// differ by a fraction of at most 1e-12; in [`Needed::sticks`] and [`Needed::safe`] of at most 1e-8. In space, and for a force of any
        /// direction, the fraction is up to 1e-6 if the multiple of the load that is carried jumps at the bound. It is 1e-5 or more if only an
        /// enumeration of contact states shows that an amount is insufficient.
        insufficient: f64,
        /// The verdict on the grasp with `insufficient`, in a sentence.
        otherwise: String,
        /// True if the object is held with `insufficient`, too, but some motion exceeds its limit of small motions. The bound is then only the limit
        /// of the theory of small motions.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
        is_too_far: bool,
        /// An amount between `sufficient` and `insufficient` for which the verdict is undecided; `None` if all verdicts were decided.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        unknown: Option<f64>,
        /// Number of changes between sufficient and insufficient among the amounts tried around the bound, including the change at the bound. As a
        /// rule the number is 1.
        changes: usize,
        /// The other end of the interval of sufficient amounts that begins at `sufficient`. For example, a squeeze beyond this end pushes the object
        /// out. `None` if all amounts tried on that side are sufficient.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        until: Option<FarEnd>,
        /// Further intervals of sufficient amounts, beside the interval that begins at `sufficient`, in ascending order.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
        elsewhere: Vec<AmountWindow>,
        /// Normal force of each contact at rest (before the loads act) with the squeeze `sufficient`, N; empty for other quantities.
        presses: Vec<ContactPress>,
        /// Joints and tendons whose drives are at their limit at rest with the squeeze `sufficient`, so that they press no harder; empty for other
        /// quantities.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
        at_their_limit: Vec<String>,
        /// The amounts that were tried. `None` if no other amount can meet the demand, because a proof excludes all others, or because a larger load
        /// is never easier to carry.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        tried: Option<TriedAmounts>,
    },
    /// All amounts that were tried suffice: down to `to` if the least amount is sought, up to `to` if the greatest is sought.
    #[non_exhaustive]
    Any {
        /// The last sufficient amount that was tried.
        to: f64,
        /// Far end of the interval of sufficient amounts, on the side away from `to`. For example, a force jams the object with a long arm, but no
        /// longer with a very short one. `None` if all amounts tried on that side are sufficient.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        until: Option<FarEnd>,
        /// The amounts that were tried. `None` if no other amount can meet the demand, because a proof excludes all others, or because a larger load
        /// is never easier to carry.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        tried: Option<TriedAmounts>,
    },
    /// No amount is sufficient: a proof excludes all amounts between `from` and `to`, or all amounts that were tried are insufficient.
    #[non_exhaustive]
    None {
        /// The least amount that was tried, or that the proof covers.
        from: f64,
        /// The greatest amount that was tried, or that the proof covers.
        to: f64,
        /// Number of amounts that were tried.
        #[cfg_attr(feature = "serde", serde(default))]
        tried: usize,
        /// Whether a proof excludes all amounts from `from` to `to`. The proof shows that contact forces cannot balance the loads with any of these
        /// amounts.
        #[cfg_attr(feature = "serde", serde(default))]
        is_proved: bool,
        /// Whether this proof is about the load at rest alone, which acts before any of the other loads.
        #[cfg_attr(feature = "serde", serde(default))]
        at_rest: bool,
        /// The tried amount with which the grasp carries the largest part of the load.
        best: f64,
        /// The verdict on the grasp with `best`, in a sentence.
        otherwise: String,
    },
    /// The verdict for an amount is undecided, so that the least or greatest sufficient amount is not known.
    #[non_exhaustive]
    Undecided {
        /// The amount for which the verdict is undecided.
        at: f64,
        /// The reason why the verdict is undecided, in a sentence.
        doubt: String,
    },
}

impl Amount {
    /// The least or greatest sufficient amount; `None` if it is not known, or if there is no sufficient amount.
    #[must_use]
    pub fn bound(&self) -> Option<f64> {
        if let Self::Bound { sufficient, .. } = self { Some(*sufficient) } else { None }
    }
}

impl Amount {
    /// Moves the far end of these safe amounts, so that every amount before it suffices with and without the deviations. Deviations are lower
    /// friction and squeeze, or larger loads. `given` is the answer without deviations; its far end replaces a farther one.
    ///
    /// The deviations may include that the sought quantity itself is lower by the fraction `reduction`: with 5 % less squeeze than set, larger set
    /// squeezes suffice. The far end of a least amount is therefore first multiplied by 1 - `reduction`.
    pub(super) fn end_before(&mut self, given: &Self, is_least: bool, reduction: f64) {
        let (Self::Bound { until: given, .. } | Self::Any { until: given, .. }) = given else { return };
        let (safe, until) = match self {
            Self::Bound { sufficient, until, .. } => (*sufficient, until),
            Self::Any { to, until, .. } => (*to, until),
            _ => return,
        };
        if let Some(end) = until.as_mut().filter(|_| is_least) {
            end.scale(1.0 - reduction);
        }
        let is_before = |one: f64, other: f64| if is_least { one < other } else { one > other };
        if let Some(given) = given
            && until.as_ref().is_none_or(|end| is_before(given.sufficient, end.sufficient))
        {
            *until = Some(given.clone());
        }
        // If no amount suffices both with and without the deviations, the far end is left out. The text about the safe amount then says that this
        // amount does not suffice with friction, squeeze and loads as given.
        if until.as_ref().is_some_and(|end| is_before(end.sufficient, safe)) {
            *until = None;
        }
    }
}

/// The amounts for which a verdict was computed. An interval of other verdicts may lie unnoticed between two of them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TriedAmounts {
    /// Number of amounts tried.
    pub count: usize,
    /// The least amount tried.
    pub from: f64,
    /// The greatest amount tried.
    pub to: f64,
}

/// The far end of an interval of sufficient amounts. Amounts beyond it are insufficient again: too large if the least amount is sought, too small if
/// the greatest is sought.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FarEnd {
    /// The sufficient amount at this end of the interval; a verdict was computed for it.
    pub sufficient: f64,
    /// The insufficient amount next to `sufficient`, outside the interval; a verdict was computed for it.
    pub insufficient: f64,
    /// The verdict on the grasp with `insufficient` in a sentence, or the reason why the verdict is undecided.
    pub otherwise: String,
    /// Normal force of each contact at rest (before the loads act) with the squeeze `sufficient`, N; empty for other quantities.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub presses: Vec<ContactPress>,
    /// Joints and tendons whose drives are at their limit at rest with the squeeze `sufficient`; empty for other quantities.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub at_their_limit: Vec<String>,
}

impl FarEnd {
    /// Multiplies the amounts at this end, and all numbers that are proportional to a squeeze: normal forces, pressures, commanded forces and
    /// overlaps.
    fn scale(&mut self, factor: f64) {
        self.sufficient *= factor;
        self.insufficient *= factor;
        for press in &mut self.presses {
            press.force *= factor;
            press.pressure = press.pressure.map(|pressure| pressure * factor);
            press.pressed_with = press.pressed_with.map(|force| force * factor);
            press.overlap = press.overlap.map(|overlap| overlap * factor);
        }
    }
}

/// An interval of sufficient amounts, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct AmountWindow {
    /// Lower end: the least sufficient amount of the interval. `None` if the interval extends below the amounts that were tried.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub from: Option<f64>,
    /// Upper end: the greatest sufficient amount of the interval. `None` if the interval extends above the amounts that were tried.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub to: Option<f64>,
}

/// Refuses a relative reduction of friction or squeeze outside `0 <= value < 1`.
pub(super) fn check_part(what: &'static str, value: f64) -> Result<(), Error> {
    if (0.0..1.0).contains(&value) {
        Ok(())
    } else {
        Err(Error::Argument { what, value, allowed: "from 0 to less than 1: 0.1 is ten percent" })
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Squeeze => "squeeze",
            Self::Friction => "coefficient of friction",
            Self::Load => "multiple of the load",
            Self::Arm => "arm",
            Self::Angle => "angle",
            Self::Force => "force",
        })
    }
}
