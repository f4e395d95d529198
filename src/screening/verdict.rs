//! From what contacts do to the verdict on their grasp.

use super::first_slip::{GIVES_WAY, NOT_STICKING, SlipCode, UNCLEAR};
use super::lanes::Lanes;

/// Contacts that leave at factors or angles less than this part apart leave together, as those of
/// symmetric grasps do up to rounding.
pub(super) const TOGETHER: f64 = 1e-12;
/// Forces that leave more than this part of the load unbalanced are not accurate enough: the factor
/// would have fewer than twelve digits.
const BALANCED: f64 = 1e-12;

/// How scenes begin.
pub(super) struct Start<const L: usize> {
    /// The least margin of a contact to the edge of its cone, and the least one less its rounding.
    pub(super) margin: Lanes<L>,
    pub(super) sure: Lanes<L>,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: Lanes<L>,
}

/// The verdicts: the factor or angle at which contacts leave first, infinite or a code, holds if all
/// of them stick at the beginning and forces balance.
#[inline(always)]
pub(super) fn verdicts<A: Copy, const L: usize>(
    (first, leaving): (Lanes<L>, Lanes<L>),
    &Start { margin, sure, free }: &Start<L>,
    unbalanced: Lanes<L>,
    freed: Lanes<L>,
    answer: impl Fn(SlipCode) -> A,
) -> [A; L] {
    let zero = Lanes::ZERO;
    // Where there are no forces this is not a number; what never leaves has a margin of zero, as
    // exactly as it should.
    let code = first + Lanes::ZERO * sure;
    let code = (-sure).above(zero, Lanes::all(UNCLEAR), code);
    let code = balanced(unbalanced, code, Lanes::all(UNCLEAR));
    let code = freed.above(zero, Lanes::all(GIVES_WAY), code);
    // What the smaller may be off is at most their difference.
    let code = (sure - margin).above(margin, Lanes::all(NOT_STICKING), code);
    let code = free.above(zero, Lanes::all(GIVES_WAY), code);
    let mut verdicts = [answer(SlipCode::UNKNOWN); L];
    for lane in 0..L {
        verdicts[lane] = answer(SlipCode { code: code.0[lane], leaving: leaving.0[lane] });
    }
    verdicts
}

/// A choice by whether forces balance the load.
#[inline(always)]
pub(super) fn balanced<const L: usize>(unbalanced: Lanes<L>, yes: Lanes<L>, no: Lanes<L>) -> Lanes<L> {
    Lanes::all(BALANCED).above(unbalanced, yes, no)
}
