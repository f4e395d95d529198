//! From what contacts do to the verdict on their grasp.

use super::first_slip::{GIVES_WAY, NOT_STICKING, SlipCode, UNCLEAR};
use super::lanes::Packed;

/// Contacts that leave at factors or angles less than this part apart leave together, as those of
/// symmetric grasps do up to rounding.
pub(super) const TOGETHER: f64 = 1e-12;
/// Forces that leave more than this part of the load unbalanced are not accurate enough: the factor
/// would have fewer than twelve digits.
const BALANCED: f64 = 1e-12;

/// How scenes begin.
pub(super) struct Start<X: Packed> {
    /// The least margin of a contact to the edge of its cone, and the least one less its rounding.
    pub(super) margin: X,
    pub(super) sure: X,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: X,
}

/// The verdicts: the factor or angle at which contacts leave first, infinite or a code, holds if all
/// of them stick at the beginning and forces balance.
#[inline(always)]
pub(super) fn verdicts<A: Copy, X: Packed>(
    (first, leaving): (X, X),
    &Start { margin, sure, free }: &Start<X>,
    unbalanced: X,
    freed: X,
    answer: impl Fn(SlipCode) -> A,
) -> X::Each<A> {
    let zero = X::all(0.0);
    // Where there are no forces this is not a number; what never leaves has a margin of zero, as
    // exactly as it should.
    let code = first + X::all(0.0) * sure;
    let code = (-sure).above(zero, X::all(UNCLEAR), code);
    let code = balanced(unbalanced, code, X::all(UNCLEAR));
    let code = freed.above(zero, X::all(GIVES_WAY), code);
    // What the smaller may be off is at most their difference.
    let code = (sure - margin).above(margin, X::all(NOT_STICKING), code);
    let code = free.above(zero, X::all(GIVES_WAY), code);
    X::each(|lane| answer(SlipCode { code: code.lane(lane), leaving: leaving.lane(lane) }))
}

/// A choice by whether forces balance the load.
#[inline(always)]
pub(super) fn balanced<X: Packed>(unbalanced: X, yes: X, no: X) -> X {
    X::all(BALANCED).above(unbalanced, yes, no)
}
