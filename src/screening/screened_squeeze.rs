//! What screening says of the squeeze that one grasp needs.

use core::fmt;

use super::least_factor::{GIVES_WAY, NO_FACTOR, UNCLEAR};

/// The least squeeze of one grasp under a list of loads, or why screening does not know it.
#[derive(Clone, Copy, PartialEq)]
pub struct ScreenedSqueeze {
    /// The factor, or one of the codes.
    pub(super) code: f64,
    /// The contact and the load that bind it, `8 load + contact`.
    pub(super) binding: f64,
}

/// How the screening of one grasp for its least squeeze ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SqueezeVerdict {
    /// With its commands times the [factor](ScreenedSqueeze::factor) everything touches and sticks
    /// under every load.
    Suffices,
    /// No factor suffices.
    NoFactor,
    /// A load works on a motion that no contact resists, however much the fingers press.
    GivesWay,
    /// Single passes of floating-point arithmetic do not tell; ask
    /// [`Grasp::least_squeeze`](crate::ask::Grasp::least_squeeze).
    ///
    /// * A factor would have fewer than six digits, because commands hardly change a margin or forces
    ///   only graze a cone.
    /// * What some contact needs at least is within rounding what another bears at most.
    /// * Two contacts in the plane do not hold the object because friction is missing.
    /// * Numbers are too extreme.
    Unclear,
}

impl ScreenedSqueeze {
    /// Not asked yet.
    pub(super) const UNKNOWN: Self = Self { code: UNCLEAR, binding: 0.0 };

    /// How it ended.
    #[must_use]
    pub fn verdict(&self) -> SqueezeVerdict {
        match self.code {
            NO_FACTOR => SqueezeVerdict::NoFactor,
            GIVES_WAY => SqueezeVerdict::GivesWay,
            factor if factor >= 0.0 => SqueezeVerdict::Suffices,
            _ => SqueezeVerdict::Unclear,
        }
    }

    /// The least factor of all commands that suffices, zero if no squeeze is needed; `None` for every
    /// verdict but [`SqueezeVerdict::Suffices`]. Larger factors need not suffice: clearances stay, and
    /// a contact that the others press apart may leave.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        (self.verdict() == SqueezeVerdict::Suffices).then_some(self.code)
    }

    /// The contact that stands on the edge of its cone with this factor, and the load in the list
    /// under which it does, both counted from 0; the first of several. `None` where the factor is zero,
    /// and without one.
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
