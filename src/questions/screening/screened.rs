//! The answers of screening for one grasp under a load that grows or turns.

use core::fmt;

use super::first_slip::{ScreeningVerdict, SlipCode};

/// The load factor at first slip of one grasp under a growing load, or the reason why screening has none.
#[derive(Clone, Copy, PartialEq)]
pub struct Screened(pub(super) SlipCode);

/// The angle of the load at first slip of one grasp under a turning load, or the reason why screening has none. This type has no load factor.
#[derive(Clone, Copy, PartialEq)]
pub struct ScreenedTurn {
    pub(super) first: SlipCode,
    /// The angle up to which the load turns, rad; infinite for a full turn, beyond which the load repeats.
    pub(super) most: f64,
}

impl Screened {
    /// How the screening ended: with a first slip, without one, or without an answer.
    #[must_use]
    pub fn verdict(&self) -> ScreeningVerdict {
        self.0.verdict()
    }

    /// The positive load factor, the multiple of the load direction, at which the first contact stops sticking. `None` for every verdict but
    /// [`ScreeningVerdict::Leaves`], so also where no contact ever leaves.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        self.0.place()
    }

    /// Whether every contact is known to stick from load factor zero up to and including this one; `false` for negative load factors.
    #[must_use]
    pub fn holds_up_to(&self, factor: f64) -> bool {
        self.0.holds_up_to(factor)
    }

    /// The contacts that stop sticking at [`Self::factor`], counted from 0, in rising order. They are several if their load factors agree to twelve
    /// digits, and none unless the verdict is [`ScreeningVerdict::Leaves`].
    pub fn leaving(&self) -> impl Iterator<Item = usize> + use<> {
        self.0.leaving()
    }
}

impl ScreenedTurn {
    /// How the screening ended: with a first slip, without one, or without an answer.
    #[must_use]
    pub fn verdict(&self) -> ScreeningVerdict {
        self.first.verdict()
    }

    /// The angle at which the first contact stops sticking, rad, between 0 and 2π. `None` for every verdict but [`ScreeningVerdict::Leaves`], so also
    /// where no contact leaves as far as the load turns.
    #[must_use]
    pub fn angle(&self) -> Option<f64> {
        self.first.place()
    }

    /// Whether every contact is known to stick up to and including this angle, rad; `false` for negative angles. It is also `false` for angles beyond
    /// the turn, unless the turn is a full one.
    #[must_use]
    pub fn holds_up_to(&self, angle: f64) -> bool {
        angle <= self.most && self.first.holds_up_to(angle)
    }

    /// The contacts that stop sticking at [`Self::angle`], counted from 0, in rising order. They are several if their angles agree to twelve digits,
    /// and none unless the verdict is [`ScreeningVerdict::Leaves`].
    pub fn leaving(&self) -> impl Iterator<Item = usize> + use<> {
        self.first.leaving()
    }
}

impl fmt::Debug for Screened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.show(f, ["Screened", "factor"])
    }
}

impl fmt::Debug for ScreenedTurn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.first.show(f, ["ScreenedTurn", "angle"])
    }
}
