//! The load factor at which the first contact force leaves its friction cone, if all contact forces are linear in the load factor. The margin of a
//! contact is `α F_n - β |F_t|` with the normal force F_n and the friction force F_t. For a contact with friction α is the coefficient of friction
//! and β is 1 ([`StickingCone`] has the values for others). While the margin is positive, the force is inside the cone and the contact sticks.

use super::block::{Block, MOST_POINTS, count};
use super::cone::{Crossing, StickingCone};
use super::first_slip::UNCLEAR;
use super::forces::AnyForces;
use super::lanes::Packed;
use super::screened::Screened;
use super::tolerances::{LEAST_PRODUCT, MOST_PRODUCT, SHARP_MARGIN};
use super::verdict::{Start, verdicts};
use crate::numerics::Vectors;
use crate::numerics::tolerances::SOLVED_ROUNDING;

/// The load factor at which the force of one contact leaves its cone, and the margin of this contact at load factor zero.
struct Exit<X: Packed> {
    /// The load factor at which the contact force leaves its cone: infinite if it never does, [`UNCLEAR`] if the result depends on rounding.
    factor: X,
    /// The margin `α F_n - β |F_t|` of the contact at load factor zero, N.
    margin: X,
    /// Bound of the rounding error of the margin, N.
    rounding: X,
    /// Minus infinity if a product of forces is so large or small that squares over- or underflow and the load factor is unknown; else zero.
    lost: X,
}

/// The load factor at which the contact force `F + factor · F'` leaves the cone, with F at load factor zero and the rate F'. The margin at load
/// factor zero must not be negative.
///
/// Let n and t be `α F_n` and `β F_t` with α and β of the [`StickingCone`]. The margin `n - |t|` is concave along the line. For large factors the
/// margin decreases at the rate `|t'| - n'`. The force leaves the cone only if this rate exceeds its rounding. In the plane the margin is the smaller
/// of two linear functions. In space the factor at which it vanishes is a root of a quadratic equation ([`Crossing`]).
#[inline(always)]
fn exit<const C: usize, X: Packed>(
    cone: &StickingCone<X>,
    contact: usize,
    base: &AnyForces<C, X>,
    rates: &AnyForces<C, X>,
) -> Exit<X> {
    let zero = X::all(0.0);
    let weight = cone.alpha + cone.beta;
    let noise = weight * rates.of[contact].rounding;
    let (force, rate) = (&base.of[contact], &rates.of[contact]);
    let (n, dn) = (cone.alpha * force.normal, cone.alpha * rate.normal);
    let (factor, margin);
    let mut lost = zero;
    if const { C == 2 } {
        let [t, dt] = [cone.beta * force.tangential[0], cone.beta * rate.tangential[0]];
        let (one, two) = (n - t, n + t);
        let (closing_one, closing_two) = (dt - dn, -(dt + dn));
        margin = one.min(two);
        factor =
            known(one / closing_one, closing_one, noise).min(known(two / closing_two, closing_two, noise));
    } else {
        let (t, dt) = (cone.friction(force), cone.friction(rate));
        let line = Crossing::new((n, &t), (dn, &dt));
        margin = line.margin;
        factor = known(line.last(), line.closing, noise);
        let product = (n.abs() + line.friction) * (dn.abs() + line.friction_rate);
        let all = X::all(f64::NEG_INFINITY);
        let squared =
            product.above(X::all(LEAST_PRODUCT), product.above(X::all(MOST_PRODUCT), all, zero), all);
        lost = line.closing.above(noise, squared, zero);
    }
    Exit { factor, margin, rounding: weight * base.of[contact].rounding, lost }
}

/// Returns `factor`, the load factor at which a margin that decreases at the rate `closing` vanishes. Infinite if the margin does not decrease by
/// more than the rounding `noise` of its rate; [`UNCLEAR`] if rounding would show in the factor.
#[inline(always)]
fn known<X: Packed>(factor: X, closing: X, noise: X) -> X {
    let factor = closing.above(X::all(SHARP_MARGIN) * noise, factor, X::all(UNCLEAR));
    closing.above(noise, factor, X::all(f64::INFINITY))
}

/// The load factor of first slip for the grasps of a block, one grasp in each lane of a SIMD vector. `base` has the contact forces at load factor
/// zero, `rates` the derivatives of these forces with respect to the load factor.
#[inline(never)]
pub(super) fn judge<V: Vectors, const C: usize, X: Packed>(
    v: V,
    block: &Block<'_, C, X>,
    base: &AnyForces<C, X>,
    rates: &AnyForces<C, X>,
) -> X::Each<Screened> {
    v.run(
        #[inline(always)]
        || judged(block, base, rates),
    )
}

#[inline(always)]
fn judged<const C: usize, X: Packed>(
    block: &Block<'_, C, X>,
    base: &AnyForces<C, X>,
    rates: &AnyForces<C, X>,
) -> X::Each<Screened> {
    let zero = X::all(0.0);
    let infinite = X::all(f64::INFINITY);
    let (contacts, friction) = (count(block.contacts), block.friction());
    let mut factors = [zero; MOST_POINTS];
    let (mut first, mut start) = (infinite, Start::new(base.free));
    for i in 0..contacts {
        let exit = exit(&StickingCone::of(friction[i]), i, base, rates);
        factors[i] = exit.factor;
        first = first.min(exit.factor);
        start.add(exit.margin, exit.rounding, exit.lost);
    }
    let until = X::all(1.0 + SOLVED_ROUNDING) * first;
    // A soft fingertip ceases to stick as soon as one of its points does. `until` exceeds the least load factor by rounding, so that all contacts
    // that cease to stick together are listed.
    let (mut leaving, mut leaves, mut finger) = (zero, zero, X::all(1.0));
    for i in 0..contacts {
        leaves = factors[i].above(until, leaves, finger);
        if block.ends >> i & 1 == 1 {
            leaving += leaves;
            (leaves, finger) = (zero, finger + finger);
        }
    }
    let unbalanced = base.unbalanced + rates.unbalanced;
    verdicts((first, leaving), &start, unbalanced, rates.free, Screened)
}
