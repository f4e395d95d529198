//! The load factor of first slip of one grasp, at which the first contact ceases to stick. If screening has no such load factor, a negative code
//! replaces it; each code belongs to a verdict. Screening computes such load factors for many grasps. The base load acts at load factor 0.

use core::fmt;

use super::block::MOST_POINTS;
use crate::prelude::*;

/// The load factor of first slip of one grasp, or a code if there is none. It is stored as two numbers, so that screening can select among answers
/// without a branch.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct SlipCode {
    /// The load factor of first slip, infinite if no contact ever ceases to stick, or one of the negative codes of this file, such as
    /// [`NOT_STICKING`].
    pub(super) code: f64,
    /// Sum of 2^i over the contacts i that cease to stick at the load factor of first slip. A soft fingertip is one contact.
    pub(super) leaving: f64,
}

/// The value of [`SlipCode::code`] for [`ScreeningVerdict::NotSticking`].
pub(super) const NOT_STICKING: f64 = -1.0;
/// The value of [`SlipCode::code`] for [`ScreeningVerdict::GivesWay`].
pub(super) const GIVES_WAY: f64 = -2.0;
/// The value of [`SlipCode::code`] for [`ScreeningVerdict::Unclear`]; NaN has the same meaning.
pub(super) const UNCLEAR: f64 = -3.0;

/// How the screening of one grasp under one growing load ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ScreeningVerdict {
    /// Contacts cease to stick, at the [factor](crate::screening::Screened::factor): they slide or open.
    Leaves,
    /// However large the load grows, no contact ceases to stick.
    Never,
    /// Not every contact sticks at load factor zero: a contact slides or is open, or there is no equilibrium.
    /// [`Grasp::onset`](crate::ask::Grasp::onset) finds out which of these is true.
    NotSticking,
    /// The base load or the growing load does positive work along a motion that no contact resists.
    GivesWay,
    /// Screening has no answer, because of rounding or missing friction. [`Grasp::onset`](crate::ask::Grasp::onset) may have an answer. The reasons
    /// are:
    ///
    /// * A contact force is within rounding of the boundary of its friction cone at load factor zero.
    /// * A margin decreases so slowly that rounding would show in the load factor.
    /// * Two contacts in the plane do not hold the object because friction is missing.
    /// * Forces or stiffnesses are so large or small that squares overflow or lose digits.
    Unclear,
}

impl SlipCode {
    /// The value that fills the storage of answers before they are computed: the code [`UNCLEAR`] and no contact.
    pub(super) const UNKNOWN: Self = Self { code: UNCLEAR, leaving: 0.0 };

    pub(super) fn verdict(self) -> ScreeningVerdict {
        match self.code {
            f64::INFINITY => ScreeningVerdict::Never,
            NOT_STICKING => ScreeningVerdict::NotSticking,
            GIVES_WAY => ScreeningVerdict::GivesWay,
            factor if factor > 0.0 => ScreeningVerdict::Leaves,
            _ => ScreeningVerdict::Unclear,
        }
    }

    pub(super) fn factor(self) -> Option<f64> {
        (self.verdict() == ScreeningVerdict::Leaves).then_some(self.code)
    }

    pub(super) fn holds_up_to(self, factor: f64) -> bool {
        // Codes of verdicts without a load factor are negative, thus smaller than any allowed `factor`. The code of `Never` is infinite.
        factor >= 0.0 && factor <= self.code
    }

    pub(super) fn leaving(self) -> impl Iterator<Item = usize> + use<> {
        let leaving = if self.verdict() == ScreeningVerdict::Leaves { self.leaving } else { 0.0 };
        let mut left = leaving;
        (0..MOST_POINTS).filter(move |_| {
            let is_one = left % 2.0 == 1.0;
            left = (left / 2.0).floor();
            is_one
        })
    }

    pub(super) fn show(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Screened");
        shown.field("verdict", &self.verdict());
        if let Some(factor) = self.factor() {
            shown.field("factor", &factor).field("leaving", &self.leaving().collect::<Vec<_>>());
        }
        shown.finish()
    }
}
