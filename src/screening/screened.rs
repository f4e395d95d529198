//! What screening says of one grasp.

use std::fmt;

/// The onset of sliding of one grasp, or why screening does not know it.
#[derive(Clone, Copy, PartialEq)]
pub struct Screened {
    /// The factor, infinite if nothing leaves, or one of the codes below: a plain number, so that
    /// kernels choose it without a branch.
    pub(super) code: f64,
    /// Sum of 2^i over the contacts i that leave at the factor.
    pub(super) leaving: f64,
}

/// Not a factor: [`Verdict::NotRolling`].
pub(super) const NOT_ROLLING: f64 = -1.0;
/// Not a factor: [`Verdict::GivesWay`].
pub(super) const GIVES_WAY: f64 = -2.0;
/// Not a factor: [`Verdict::Unclear`], as what is not a number.
pub(super) const UNCLEAR: f64 = -3.0;

/// How the screening of one grasp ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Verdict {
    /// Contacts leave rolling at the [factor](Screened::factor): they slide or open.
    Leaves,
    /// However large the load grows, no contact leaves rolling.
    Never,
    /// Not every contact rolls at factor zero: one would slide or be open there, perhaps there is
    /// no equilibrium. [`Grasp::onset`](crate::grasp::Grasp::onset) says more.
    NotRolling,
    /// The load works on a motion that no contact resists, at factor zero or as it grows.
    GivesWay,
    /// Single passes of floating-point arithmetic do not tell; ask
    /// [`Grasp::onset`](crate::grasp::Grasp::onset).
    ///
    /// * A contact stands on the edge of its cone at factor zero.
    /// * A margin closes so slowly that rounding would show in the factor.
    /// * Two contacts in the plane do not hold the object because friction is missing.
    /// * Numbers are too extreme.
    Unclear,
}

impl Screened {
    /// Not asked yet.
    pub(super) const UNKNOWN: Self = Self { code: UNCLEAR, leaving: 0.0 };

    /// How it ended.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self.code {
            f64::INFINITY => Verdict::Never,
            NOT_ROLLING => Verdict::NotRolling,
            GIVES_WAY => Verdict::GivesWay,
            factor if factor > 0.0 => Verdict::Leaves,
            _ => Verdict::Unclear,
        }
    }

    /// The factor of the direction at which the first contact leaves rolling, positive; `None` for
    /// every verdict but [`Verdict::Leaves`], so also where none ever does.
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        (self.verdict() == Verdict::Leaves).then_some(self.code)
    }

    /// Whether the grasp is known to hold, every contact rolling, up to this factor and including
    /// it. For negative factors nothing is known.
    #[must_use]
    pub fn holds_up_to(&self, factor: f64) -> bool {
        // All codes are negative.
        factor >= 0.0 && factor <= self.code
    }

    /// The contacts that leave there, counted from 0, in rising order; several if their factors
    /// agree to twelve digits, none unless the verdict is [`Verdict::Leaves`].
    pub fn leaving(&self) -> impl Iterator<Item = usize> + use<> {
        let leaving = if self.verdict() == Verdict::Leaves { self.leaving } else { 0.0 };
        (0..5_u8).filter(move |&i| (leaving / f64::from(1 << i)).floor() % 2.0 == 1.0).map(usize::from)
    }
}

impl fmt::Debug for Screened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Screened");
        shown.field("verdict", &self.verdict());
        if let Some(factor) = self.factor() {
            shown.field("factor", &factor).field("leaving", &self.leaving().collect::<Vec<_>>());
        }
        shown.finish()
    }
}
