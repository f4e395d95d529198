//! The verdict of screening on a grasp: the load factor at which the first contact leaves its friction cone (ceases to stick), or a negative code if
//! there is no such factor. At load factor zero the margins of all contacts must be positive. The margin of a contact is `α F_n - β |F_t|` with the
//! normal force F_n and the friction force F_t. For a contact with friction α is its coefficient and β is 1;
//! [`StickingCone`](super::cone::StickingCone) has the values for other contacts. A block holds as many grasps as a SIMD vector has numbers (lanes).

use super::first_slip::{GIVES_WAY, NOT_STICKING, SlipCode, UNCLEAR};
use super::lanes::Packed;
use crate::numerics::tolerances::SOLVED_ROUNDING;

/// The least margin of sticking among the contacts at load factor zero, for several grasps, one in each lane of a vector.
pub(super) struct Start<X: Packed> {
    /// The least margin of all contacts, N. Contacts whose squared forces over- or underflow are left out.
    margin: X,
    /// The least value of a contact's margin less the bound of its rounding, N. Contacts whose squared forces over- or underflow are left out.
    sure: X,
    /// Minus infinity if squared forces of some contact over- or underflow, so that the verdict is unclear; else zero.
    lost: X,
    /// Positive if the load at load factor zero does positive work along a motion that no contact resists.
    pub(super) free: X,
}

impl<X: Packed> Start<X> {
    /// The values before any contact has been added: both margins are infinite. `free` is positive if the load at load factor zero does positive work
    /// along a motion that no contact resists.
    #[inline(always)]
    pub(super) fn new(free: X) -> Self {
        let infinite = X::all(f64::INFINITY);
        Self { margin: infinite, sure: infinite, lost: X::all(0.0), free }
    }

    /// Adds a contact with this margin and the bound of its rounding; `lost` is minus infinity if its squared forces over- or underflow, else
    /// zero.
    #[inline(always)]
    pub(super) fn add(&mut self, margin: X, rounding: X, lost: X) {
        self.margin = self.margin.min(margin - lost);
        self.sure = self.sure.min(margin - rounding - lost);
        self.lost = self.lost.min(lost);
    }

    /// The least value of a contact's margin less the bound of its rounding; minus infinity if squared forces of some contact over- or underflow.
    #[inline(always)]
    pub(super) fn sure(&self) -> X {
        self.sure + self.lost
    }
}

/// The answers for the grasps of a block; `answer` makes each of them from a [`SlipCode`]. `first` is the load factor at which the first contact
/// leaves its cone; it may be infinity, or a code such as [`UNCLEAR`]. It becomes the answer only if all contacts stick at load factor zero and the
/// contact forces balance the load. `leaving` encodes the contacts that leave their cones together. `freed` is positive if the growing load does
/// positive work along a motion that no contact resists: the answer is then [`GIVES_WAY`].
#[inline(always)]
pub(super) fn verdicts<A: Copy, X: Packed>(
    (first, leaving): (X, X),
    start: &Start<X>,
    unbalanced: X,
    freed: X,
    answer: impl Fn(SlipCode) -> A,
) -> X::Each<A> {
    let (zero, &Start { margin, sure, free, .. }) = (X::all(0.0), start);
    // If no forces were found, `sure` is NaN. Adding zero times `sure` then makes the code NaN, which also means unclear. An infinite `sure` would
    // have the same effect. It does not occur: a contact that never leaves its cone (α = β = 0) has the margin zero.
    let code = first + X::all(0.0) * sure;
    let code = (-start.sure()).above(zero, X::all(UNCLEAR), code);
    let code = balanced(unbalanced, code, X::all(UNCLEAR));
    let code = freed.above(zero, X::all(GIVES_WAY), code);
    // The bound of the rounding of the least margin is at most `margin - sure`. If the margin is negative by more than this difference, a contact
    // surely does not stick.
    let code = (sure - margin).above(margin, X::all(NOT_STICKING), code);
    let code = free.above(zero, X::all(GIVES_WAY), code);
    X::each(|lane| answer(SlipCode { code: code.lane(lane), leaving: leaving.lane(lane) }))
}

/// Returns `yes` if the contact forces balance the load up to rounding, else `no`; also `no` for NaN.
#[inline(always)]
pub(super) fn balanced<X: Packed>(unbalanced: X, yes: X, no: X) -> X {
    X::all(SOLVED_ROUNDING).above(unbalanced, yes, no)
}
