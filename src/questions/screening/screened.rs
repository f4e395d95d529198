//! The answer of screening for one grasp under a load that grows. Screening computes, for many grasps, the load factor of first slip, at which the
//! first contact ceases to stick.

use core::fmt;

use super::first_slip::{ScreeningVerdict, SlipCode};

/// The load factor of first slip of one grasp under a growing load, or the reason why screening has no load factor.
#[derive(Clone, Copy, PartialEq)]
pub struct Screened(pub(super) SlipCode);

impl Screened {
    /// How the screening ended: with a load factor of first slip, with the result that no contact ever slips, or without an answer.
    #[must_use]
    pub fn verdict(&self) -> ScreeningVerdict {
        self.0.verdict()
    }

    /// The load factor at which the first contact ceases to stick: a positive multiple of the load direction. `None` for every verdict but
    /// [`ScreeningVerdict::Leaves`]. For [`ScreeningVerdict::Never`], for example, every contact sticks at every factor.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        self.0.factor()
    }

    /// Whether every contact is known to stick from load factor zero up to and including `factor`; `false` for negative load factors.
    #[must_use]
    pub fn holds_up_to(&self, factor: f64) -> bool {
        self.0.holds_up_to(factor)
    }

    /// The contacts that cease to stick at [`Self::factor`], counted from 0, in rising order. There are several if their load factors agree to twelve
    /// digits. There are none unless the verdict is [`ScreeningVerdict::Leaves`].
    pub fn leaving(&self) -> impl Iterator<Item = usize> + use<> {
        self.0.leaving()
    }
}

impl fmt::Debug for Screened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.show(f)
    }
}
