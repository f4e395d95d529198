//! The answer of screening for the least factor on the commands with which all contacts of one grasp stick. A command is the displacement that a
//! finger would make if there were no object. A clearance is the gap between finger and object before the command; it is negative if they overlap.

use core::fmt;

use super::first_slip::{GIVES_WAY, UNCLEAR};
use super::least_factor::NO_FACTOR;

/// The least factor on the commands with which all contacts of one grasp stick under each load of a list, or the reason why screening has no factor.
#[derive(Clone, Copy, PartialEq)]
pub struct ScreenedSqueeze {
    /// The least factor on the commands if the verdict is [`SqueezeVerdict::Suffices`]. Each other verdict has a code instead: one of the constants
    /// `NO_FACTOR`, `GIVES_WAY` and `UNCLEAR`.
    pub(super) code: f64,
    /// The contact and the load that determine the factor, encoded as `8 · load + contact`.
    pub(super) binding: f64,
}

/// How the screening of one grasp for its least factor on the commands ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SqueezeVerdict {
    /// With the commands times [`ScreenedSqueeze::factor`] every contact touches and sticks under every load of the list.
    Suffices,
    /// No factor on the commands makes all contacts stick under all loads of the list.
    NoFactor,
    /// A load does positive work along a motion that no contact resists, however much the fingers press.
    GivesWay,
    /// Screening has no answer, because of rounding or missing friction. [`Grasp::least_squeeze`](crate::ask::Grasp::least_squeeze) may have an
    /// answer. The reasons are:
    ///
    /// * Fewer than six digits of a factor are right. Either commands hardly change the friction margin `μ F_n - |F_t|` of a contact. Or the force of
    ///   a contact, as a function of the factor, only grazes its friction cone.
    /// * The least factor with which one contact sticks and the largest factor with which another contact sticks differ by no more than rounding.
    /// * Two contacts in the plane do not hold the object because friction is missing.
    /// * Forces or stiffnesses are so large or small that squares overflow or lose digits.
    Unclear,
}

impl ScreenedSqueeze {
    /// The value that fills the storage of answers before they are computed: the code for [`SqueezeVerdict::Unclear`].
    pub(super) const UNKNOWN: Self = Self { code: UNCLEAR, binding: 0.0 };

    /// How the screening ended: with a factor on the commands, with the result that no factor makes all contacts stick, or without an answer.
    #[must_use]
    pub fn verdict(&self) -> SqueezeVerdict {
        match self.code {
            NO_FACTOR => SqueezeVerdict::NoFactor,
            GIVES_WAY => SqueezeVerdict::GivesWay,
            factor if factor >= 0.0 => SqueezeVerdict::Suffices,
            _ => SqueezeVerdict::Unclear,
        }
    }

    /// The least common factor on all commands with which every contact sticks under every load; zero if all contacts stick without commands. `None`
    /// for every verdict but [`SqueezeVerdict::Suffices`]. With larger factors a contact may slide or open: clearances are not scaled, and a contact
    /// may be pushed open by other contacts.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        (self.verdict() == SqueezeVerdict::Suffices).then_some(self.code)
    }

    /// The contact whose force reaches the boundary of its friction cone at [`Self::factor`], and the load under which it does, as indices from 0. If
    /// several contacts reach this boundary, the first of them is returned. `None` if the factor is zero, or if there is no factor.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a small whole number
    pub fn binding(&self) -> Option<(usize, usize)> {
        let binding = self.binding as usize;
        (self.code > 0.0).then_some((binding % 8, binding / 8))
    }
}

impl fmt::Debug for ScreenedSqueeze {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("ScreenedSqueeze");
        shown.field("verdict", &self.verdict());
        if let Some(factor) = self.factor() {
            shown.field("factor", &factor).field("binding", &self.binding());
        }
        shown.finish()
    }
}
