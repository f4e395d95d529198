//! The verdict on a grasp from the margins of its contacts.

use super::first_slip::{GIVES_WAY, NOT_STICKING, SlipCode, UNCLEAR};
use super::lanes::Packed;
use crate::numerics::tolerances::SOLVED_ROUNDING;

/// The state of the grasp in each lane at load factor zero.
pub(super) struct Start<X: Packed> {
    /// The least margin of all contacts but those whose squared forces over- or underflow.
    margin: X,
    /// The least margin, each less the bound of its rounding.
    sure: X,
    /// Minus infinity where squared forces of some contact over- or underflow, so that the verdict is unclear; else zero.
    lost: X,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: X,
}

impl<X: Packed> Start<X> {
    /// The state before any contact has been added.
    #[inline(always)]
    pub(super) fn new(free: X) -> Self {
        let infinite = X::all(f64::INFINITY);
        Self { margin: infinite, sure: infinite, lost: X::all(0.0), free }
    }

    /// Adds a contact with this margin and the bound of its rounding.
    #[inline(always)]
    pub(super) fn add(&mut self, margin: X, rounding: X, lost: X) {
        self.margin = self.margin.min(margin - lost);
        self.sure = self.sure.min(margin - rounding - lost);
        self.lost = self.lost.min(lost);
    }

    /// The least margin less its rounding; minus infinity where nothing is known of some contact.
    #[inline(always)]
    pub(super) fn sure(&self) -> X {
        self.sure + self.lost
    }
}

/// The verdicts. `first` is the load factor at which contacts leave first, infinite, or a code. It counts only if all contacts stick at the
/// start and the forces balance the load.
#[inline(always)]
pub(super) fn verdicts<A: Copy, X: Packed>(
    (first, leaving): (X, X),
    start: &Start<X>,
    unbalanced: X,
    freed: X,
    answer: impl Fn(SlipCode) -> A,
) -> X::Each<A> {
    let (zero, &Start { margin, sure, free, .. }) = (X::all(0.0), start);
    // Without valid forces `sure` is NaN, and so becomes the code. A contact that never leaves has a margin of exactly zero.
    let code = first + X::all(0.0) * sure;
    let code = (-start.sure()).above(zero, X::all(UNCLEAR), code);
    let code = balanced(unbalanced, code, X::all(UNCLEAR));
    let code = freed.above(zero, X::all(GIVES_WAY), code);
    // The bound of the rounding of the least margin is at most `margin - sure`. A margin that is negative beyond it means that a contact does not
    // stick.
    let code = (sure - margin).above(margin, X::all(NOT_STICKING), code);
    let code = free.above(zero, X::all(GIVES_WAY), code);
    X::each(|lane| answer(SlipCode { code: code.lane(lane), leaving: leaving.lane(lane) }))
}

/// `yes` if the forces balance the load, else `no`.
#[inline(always)]
pub(super) fn balanced<X: Packed>(unbalanced: X, yes: X, no: X) -> X {
    X::all(SOLVED_ROUNDING).above(unbalanced, yes, no)
}
