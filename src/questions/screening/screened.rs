//! The answer of screening for one grasp under a load that grows.

use core::fmt;

use super::first_slip::{ScreeningVerdict, SlipCode};

/// The onset of sliding of one grasp as a load grows, or the reason why screening does not know it.
#[derive(Clone, Copy, PartialEq)]
pub struct Screened(pub(super) SlipCode);

impl Screened {
    /// How the screening ended.
    #[must_use]
    pub fn verdict(&self) -> ScreeningVerdict {
        self.0.verdict()
    }

    /// The positive factor of the direction at which the first contact stops sticking. `None` for every verdict but [`ScreeningVerdict::Leaves`], so
    /// also where no contact ever leaves.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        self.0.factor()
    }

    /// Whether every contact is known to stick up to and including this load factor. For negative load factors nothing is known.
    #[must_use]
    pub fn holds_up_to(&self, factor: f64) -> bool {
        self.0.holds_up_to(factor)
    }

    /// The contacts that leave at the load factor, counted from 0, in rising order. They are several if their load factors agree to twelve digits,
    /// and none unless the verdict is [`ScreeningVerdict::Leaves`].
    pub fn leaving(&self) -> impl Iterator<Item = usize> + use<> {
        self.0.leaving()
    }
}

impl fmt::Debug for Screened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.show(f)
    }
}
