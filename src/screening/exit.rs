//! Where forces that change in proportion to the load leave their friction cones.

use super::lanes::{Lanes, dot};
use super::screened::{GIVES_WAY, NOT_ROLLING, Screened, UNCLEAR};

/// A contact this close to the edge of its cone at factor zero, relative to the forces there, may
/// be on it. With a smaller part rounding would decide whether it rolls; with a larger one more
/// grasps would be unclear.
pub(super) const ON_THE_EDGE: f64 = 1e-12;
/// Contacts that leave at factors less than this part apart leave together, as those of symmetric
/// grasps do up to rounding.
const TOGETHER: f64 = 1e-12;
/// Forces that leave more than this part of the load unbalanced are not accurate enough: the factor
/// would have fewer than twelve digits.
const BALANCED: f64 = 1e-12;
/// A margin that closes at less than so many times the rounding of its rate closes at a factor of
/// fewer than six digits, which is no answer.
const SHARP: f64 = 1e6;
/// A force times a rate outside of these bounds, squared, loses its digits to underflow or
/// overflows.
const LEAST: f64 = 1e-140;
const MOST: f64 = 1e150;

/// The forces of all contacts, or their rates; arrays run over the contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces<const C: usize, const N: usize, const L: usize> {
    pub(super) normal: [Lanes<L>; N],
    /// In space a vector across the normal, axis by axis; in the plane the first entry is that
    /// along (n_y, -n_x).
    pub(super) tangential: [[Lanes<L>; N]; C],
    /// What of them may be rounding.
    pub(super) rounding: [Lanes<L>; N],
    /// What part of the load they leave unbalanced; not a number if there are no such forces.
    pub(super) unbalanced: Lanes<L>,
    /// Positive if the load works on a motion that no contact resists.
    pub(super) free: Lanes<L>,
}

impl<const C: usize, const N: usize, const L: usize> Forces<C, N, L> {
    /// No forces.
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = Lanes::ZERO;
        Self {
            normal: [zero; N],
            tangential: [[zero; N]; C],
            rounding: [zero; N],
            unbalanced: zero,
            free: zero,
        }
    }

    /// The tangential part at one contact.
    #[inline(always)]
    pub(super) fn friction(&self, contact: usize) -> [Lanes<L>; C] {
        let mut friction = [Lanes::ZERO; C];
        for axis in 0..C {
            friction[axis] = self.tangential[axis][contact];
        }
        friction
    }
}

/// What a contact must obey to roll, `α F_n >= β |F_t|`: α and β are the friction coefficient and
/// one, 1 and 0 if it can only open, both zero if it never leaves.
#[derive(Debug, Clone, Copy)]
struct Cone<const L: usize> {
    alpha: Lanes<L>,
    beta: Lanes<L>,
}

/// Instead of a friction coefficient: the contact leaves rolling only by opening, for it has no
/// friction, or infinite friction.
pub(super) const OPENS_ONLY: f64 = -1.0;
/// Instead of a friction coefficient: the contact never leaves, for it is bonded, or kept closed
/// without or with infinite friction.
pub(super) const STAYS: f64 = 0.0;

impl<const L: usize> Cone<L> {
    /// From a friction coefficient or one of the two codes.
    #[inline(always)]
    fn of(friction: Lanes<L>) -> Self {
        let (zero, one) = (Lanes::ZERO, Lanes::all(1.0));
        Self { alpha: friction.abs(), beta: friction.above(zero, one, zero) }
    }
}

/// The way of one contact out of its cone.
struct Exit<const L: usize> {
    /// Infinite if there is none, a code if it is not known.
    factor: Lanes<L>,
    /// The margin to the edge at factor zero, and the margin less its rounding.
    margin: Lanes<L>,
    sure: Lanes<L>,
}

/// Where `F + factor · F'` leaves the cone. The margin at factor zero must not be negative.
///
/// With n and t for `α F_n` and `β F_t` the margin `n - |t|` is concave along the line, and in the
/// long run it closes at the rate `|t'| - n'`: whether that is more than rounding decides whether
/// the line leaves at all. In the plane it is two straight lines. In space the first root of a
/// quadratic is wanted,
///
/// ```text
/// c + 2 b τ - a τ² = 0,   c = n² - |t|²,   b = n n' - t·t',   a = |t'|² - n'²,   Δ = b² + a c = |n t' - n' t|² - |t × t'|²
/// ```
///
/// and of `c / (√Δ - b)` and `(√Δ + b) / a` that one is taken in which nothing cancels. In its
/// second form Δ keeps its digits where the line passes close to the apex.
#[inline(always)]
fn exit<const C: usize, const N: usize, const L: usize>(
    cone: &Cone<L>,
    contact: usize,
    base: &Forces<C, N, L>,
    rates: &Forces<C, N, L>,
) -> Exit<L> {
    let zero = Lanes::ZERO;
    let weight = cone.alpha + cone.beta;
    let noise = weight * rates.rounding[contact];
    let (n, dn) = (cone.alpha * base.normal[contact], cone.alpha * rates.normal[contact]);
    let (factor, margin);
    // Minus infinity where nothing is sure.
    let mut lost = zero;
    if C == 2 {
        let [t, dt] = [cone.beta * base.tangential[0][contact], cone.beta * rates.tangential[0][contact]];
        let (one, two) = (n - t, n + t);
        let (closing_one, closing_two) = (dt - dn, -(dt + dn));
        margin = one.min(two);
        factor =
            known(one / closing_one, closing_one, noise).min(known(two / closing_two, closing_two, noise));
    } else {
        let (mut t, mut dt) = (base.friction(contact), rates.friction(contact));
        for axis in 0..C {
            t[axis] = cone.beta * t[axis];
            dt[axis] = cone.beta * dt[axis];
        }
        let (friction, friction_rate) = (dot(&t, &t).sqrt(), dot(&dt, &dt).sqrt());
        margin = n - friction;
        let closing = friction_rate - dn;
        let a = closing * (friction_rate + dn);
        let b = n * dn - dot(&t, &dt);
        let c = margin * (n + friction);
        let mut discriminant = zero;
        for axis in 0..C {
            let (next, last) = ((axis + 1) % C, (axis + 2) % C);
            let turn = n * dt[axis] - dn * t[axis];
            let twist = t[next] * dt[last] - t[last] * dt[next];
            discriminant += turn * turn - twist * twist;
        }
        let root = discriminant.max(zero).sqrt();
        let root = b.above(zero, root + b, c) / b.above(zero, a, root - b);
        factor = known(root, closing, noise);
        let product = (n.abs() + friction) * (dn.abs() + friction_rate);
        let all = Lanes::all(f64::NEG_INFINITY);
        let squared = product.above(Lanes::all(LEAST), product.above(Lanes::all(MOST), all, zero), all);
        lost = closing.above(noise, squared, zero);
    }
    Exit { factor, margin, sure: margin - weight * base.rounding[contact] + lost }
}

/// A factor as far as it is known from the rate at which the margin closes there: infinite if that
/// is rounding, a code if it is close to it.
#[inline(always)]
fn known<const L: usize>(factor: Lanes<L>, closing: Lanes<L>, noise: Lanes<L>) -> Lanes<L> {
    let factor = closing.above(Lanes::all(SHARP) * noise, factor, Lanes::all(UNCLEAR));
    closing.above(noise, factor, Lanes::all(f64::INFINITY))
}

/// The verdicts on the scenes of a block, from the forces at factor zero and their rates.
#[inline(always)]
pub(super) fn judge<const C: usize, const N: usize, const L: usize>(
    friction: &[Lanes<L>; N],
    base: &Forces<C, N, L>,
    rates: &Forces<C, N, L>,
) -> [Screened; L] {
    let zero = Lanes::ZERO;
    let infinite = Lanes::all(f64::INFINITY);
    let mut factors = [zero; N];
    let (mut first, mut margin, mut sure) = (infinite, infinite, infinite);
    for i in 0..N {
        let exit = exit(&Cone::of(friction[i]), i, base, rates);
        factors[i] = exit.factor;
        first = first.min(exit.factor);
        margin = margin.min(exit.margin);
        sure = sure.min(exit.sure);
    }
    let until = Lanes::all(1.0 + TOGETHER) * first;
    let mut leaving = zero;
    for i in 0..N {
        leaving += factors[i].above(until, zero, Lanes::all(f64::from(1 << i)));
    }
    // Where there are no forces this is not a number; what never leaves has a margin of zero, as
    // exactly as it should.
    let code = first + Lanes::ZERO * sure;
    let code = (-sure).above(zero, Lanes::all(UNCLEAR), code);
    let code = Lanes::all(BALANCED).above(base.unbalanced + rates.unbalanced, code, Lanes::all(UNCLEAR));
    let code = rates.free.above(zero, Lanes::all(GIVES_WAY), code);
    // What the smaller may be off is at most their difference.
    let code = (sure - margin).above(margin, Lanes::all(NOT_ROLLING), code);
    let code = base.free.above(zero, Lanes::all(GIVES_WAY), code);
    let mut screened = [Screened::UNKNOWN; L];
    for lane in 0..L {
        screened[lane] = Screened { code: code.0[lane], leaving: leaving.0[lane] };
    }
    screened
}
