//! Jumps: motions of the object, at constant load, to another equilibrium. A jump begins if friction falls as a contact begins to slide, if nothing
//! resists the object any more, or if the object snaps over. A path ends at a fold (a maximum of the load), a corner (no contact states continue it)
//! or an asymptote (a load that it approaches but never reaches).

use core::fmt;

use nalgebra::SVector;

use super::event::ContactChange;
use crate::equilibrium::Equilibrium;
use crate::error::ContactLabel;
use crate::grasp::{BodyMotion, all_inside};
use crate::numerics::{IntoList, largest, mapped, picked};
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::{Words, listed};

/// A jump from one equilibrium to another under one load. There are three kinds. In the first kind, a fall of friction, contacts begin to slide, and
/// with [kinetic friction](crate::grasp::Contact::kinetic) they carry less tangential force.
///
/// The tangential force that they lose is removed so slowly that other contacts can take it over. Contacts that reach their static friction limit
/// meanwhile begin to slide, too, and lose force as well. The object comes to rest where forces balance again. It does not overshoot, as if its
/// motion were overdamped.
///
/// In the second kind, a free motion, nothing resists the object any more, and it moves until the gap of an open contact closes ([`Self::reaches`]).
/// At every point of this motion forces balance under the same load. The speed at which the gap closes plays no part.
///
/// In the third kind, a snap, no equilibrium is left near the end of a path, and the object [snaps over](Self::snaps) to another equilibrium. Its
/// motion is computed as if every spring had a damper in proportion to its stiffness, and does not overshoot either.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Jump<const C: usize> {
    /// Changes of contact states in the jump, in addition to the changes listed by the event, in the order in which they occur. Contacts begin to
    /// slide, stick again, open or close.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub changes: Vec<ContactChange<C>>,
    /// The contacts that slip in the jump, each with its slip.
    pub slips: Vec<JumpSlip<C>>,
    /// The contacts that stop a free motion of the object, because their gaps close. If the jump has several free motions, the contacts are listed in
    /// the order of these motions. Empty if the object does not move freely in the jump.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub reaches: Vec<ContactLabel>,
    /// True if the object snaps over to another equilibrium, from a fold, a corner or an asymptote of its path ([`LossKind`](super::LossKind)). False
    /// if friction falls, or if nothing resists the object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub snaps: bool,
    /// The motion of the object, or of each of several bodies, in the jump.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub moved: Vec<BodyMotion<C>>,
    /// Energy lost in the jump, J: the work of the load minus the energy that springs take up. Most of this energy becomes heat by friction; the rest
    /// is lost in the damping of the object's motion.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub energy_lost: f64,
    /// The equilibrium after the jump.
    pub state: Equilibrium<C>,
}

/// How far a contact slips in a jump.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct JumpSlip<const C: usize> {
    /// The contact that slips.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// Slip of the contact during the jump, in the contact frame, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub slip: SVector<f64, C>,
}

/// The jump in words, for example "caught after left slips 0.4 mm" or "the object moves 0.4 mm along +x to stop". For a soft fingertip the largest
/// slip of its points is named.
impl<const C: usize> fmt::Display for Jump<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        if !self.reaches.is_empty() {
            let mut reached: Vec<_> = mapped(&self.reaches, &|contact| contact.whole().text());
            reached.dedup();
            let (moved, words) = (all_inside(&self.moved), words.in_space(words.space::<C>()));
            let farthest = largest(&moved, &BodyMotion::speed);
            // A body is not named in the sentence if it moves by less than this fraction of the largest motion. Such a motion is only a rounding
            // error, or too small to matter.
            let moved =
                picked(&moved, &|body| (body.speed() > 1e-6 * farthest).then(|| words.body_motion(body)));
            return write!(f, "{} to {}", listed(&moved), listed(&reached));
        }
        let mut slips: Vec<(ContactLabel, f64)> = Vec::new();
        for slip in &self.slips {
            let (whole, far) = (slip.contact.whole(), slip.slip.norm());
            match slips.iter_mut().find(|(known, _)| *known == whole) {
                Some((_, farthest)) => *farthest = farthest.max(far),
                None => slips.push((whole, far)),
            }
        }
        let slips =
            slips.iter().map(|(contact, far)| format!("{} slips {}", contact.text(), words.length(*far)));
        let slips = listed(&slips.list());
        match (self.snaps, self.slips.is_empty()) {
            (true, _) => write!(f, "snaps over, and {slips}"),
            (false, true) => f.write_str("caught after moving"),
            (false, false) => write!(f, "caught after {slips}"),
        }
    }
}
