//! The friction cone of one contact, and where a line of forces crosses it.

use super::forces::Forces;
use super::lanes::{Lanes, dot};

/// A force times a rate outside of these bounds, squared, loses its digits to underflow or
/// overflows.
pub(super) const LEAST: f64 = 1e-140;
pub(super) const MOST: f64 = 1e150;

/// What a contact must obey to stick, `α F_n >= β |F_t|`: α and β are the friction coefficient and
/// one, 1 and 0 if it can only open, both zero if it never leaves.
#[derive(Debug, Clone, Copy)]
pub(super) struct StickingCone<const L: usize> {
    pub(super) alpha: Lanes<L>,
    pub(super) beta: Lanes<L>,
}

/// Instead of a friction coefficient: the contact stops sticking only by opening, for it has no
/// friction, or infinite friction.
pub(super) const OPENS_ONLY: f64 = -1.0;
/// Instead of a friction coefficient: the contact never leaves, for it is bonded, or kept closed
/// without or with infinite friction.
pub(super) const STAYS: f64 = 0.0;

impl<const L: usize> StickingCone<L> {
    /// From a friction coefficient or one of the two codes.
    #[inline(always)]
    pub(super) fn of(friction: Lanes<L>) -> Self {
        let (zero, one) = (Lanes::ZERO, Lanes::all(1.0));
        Self { alpha: friction.abs(), beta: friction.above(zero, one, zero) }
    }
}

impl<const L: usize> StickingCone<L> {
    /// `β F_t` of a contact.
    #[inline(always)]
    pub(super) fn friction<const C: usize, const N: usize>(
        &self,
        forces: &Forces<C, N, L>,
        contact: usize,
    ) -> [Lanes<L>; C] {
        let mut t = forces.friction(contact);
        for axis in 0..C {
            t[axis] = self.beta * t[axis];
        }
        t
    }
}

/// A line of forces `F + τ F'` and a round cone. With n and t for `α F_n` and `β F_t` it crosses
/// the cone, or the other half of it, where
///
/// ```text
/// c + 2 b τ - a τ² = 0,   c = n² - |t|²,   b = n n' - t·t',   a = |t'|² - n'²,   Δ = b² + a c = |n t' - n' t|² - |t × t'|²
/// ```
///
/// In its second form Δ keeps its digits where the line passes close to the apex.
pub(super) struct Crossing<const L: usize> {
    /// `n - |t|` at τ = 0.
    pub(super) margin: Lanes<L>,
    /// The rate `|t'| - n'` at which it closes in the long run.
    pub(super) closing: Lanes<L>,
    pub(super) a: Lanes<L>,
    pub(super) b: Lanes<L>,
    pub(super) c: Lanes<L>,
    /// √Δ, zero if there is none.
    pub(super) root: Lanes<L>,
    /// `|t|` and `|t'|`.
    pub(super) friction: Lanes<L>,
    pub(super) friction_rate: Lanes<L>,
}

impl<const L: usize> Crossing<L> {
    /// From (n, t) and their rates.
    #[inline(always)]
    pub(super) fn new<const C: usize>(
        (n, t): (Lanes<L>, &[Lanes<L>; C]),
        (dn, dt): (Lanes<L>, &[Lanes<L>; C]),
    ) -> Self {
        let zero = Lanes::ZERO;
        let (friction, friction_rate) = (dot(t, t).sqrt(), dot(dt, dt).sqrt());
        let margin = n - friction;
        let closing = friction_rate - dn;
        let a = closing * (friction_rate + dn);
        let b = n * dn - dot(t, dt);
        let c = margin * (n + friction);
        let mut discriminant = zero;
        for axis in 0..C {
            let (next, last) = ((axis + 1) % C, (axis + 2) % C);
            let turn = n * dt[axis] - dn * t[axis];
            let twist = t[next] * dt[last] - t[last] * dt[next];
            discriminant += turn * turn - twist * twist;
        }
        let root = discriminant.max(zero).sqrt();
        Self { margin, closing, a, b, c, root, friction, friction_rate }
    }

    /// The larger root, where the line leaves the cone: of `c / (√Δ - b)` and `(√Δ + b) / a` the one in
    /// which nothing cancels.
    #[inline(always)]
    pub(super) fn last(&self) -> Lanes<L> {
        let Self { a, b, c, root, .. } = *self;
        b.above(Lanes::ZERO, root + b, c) / b.above(Lanes::ZERO, a, root - b)
    }

    /// The other one, where a line from outside enters the cone.
    #[inline(always)]
    pub(super) fn first(&self) -> Lanes<L> {
        let Self { a, b, c, root, .. } = *self;
        b.above(Lanes::ZERO, -c, b - root) / b.above(Lanes::ZERO, b + root, a)
    }
}
