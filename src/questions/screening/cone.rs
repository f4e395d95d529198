//! The friction cone of one contact, and the load factors at which a contact force that is linear in the load factor crosses it.
//!
//! τ is the load factor, by which the growing load is multiplied. F_n is the normal part and F_t the tangential part of the contact force. The scaled
//! forces are `n = α F_n` and `t = β F_t`, with the numbers α and β of a [`StickingCone`]; the contact sticks while `n >= |t|`. A prime is the
//! derivative with respect to τ.

use super::finger::Force;
use super::lanes::{Packed, dot};

/// The condition for a contact to stick, `α F_n >= β |F_t|`. F_n is the normal force and F_t the friction force. For a contact with friction, α is
/// the coefficient of friction and β is 1. The pair (α, β) is (1, 0) for a contact that can only open, and (0, 0) for a contact that never ceases to
/// stick.
#[derive(Debug, Clone, Copy)]
pub(super) struct StickingCone<X: Packed> {
    pub(super) alpha: X,
    pub(super) beta: X,
}

/// The code in place of a coefficient of friction that is zero or infinite: such a contact ceases to stick only by opening.
pub(super) const OPENS_ONLY: f64 = -1.0;
/// The code stored in place of a coefficient of friction for a contact that never ceases to stick. Such a contact is bonded (it neither opens nor
/// slides), or it is kept closed by assumption and has zero or infinite friction.
pub(super) const STAYS: f64 = 0.0;

impl<X: Packed> StickingCone<X> {
    /// The friction cone for a stored coefficient of friction, or for one of the two codes stored in its place.
    #[inline(always)]
    pub(super) fn of(friction: X) -> Self {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        Self { alpha: friction.abs(), beta: friction.above(zero, one, zero) }
    }
}

impl<X: Packed> StickingCone<X> {
    /// The scaled friction force `β F_t` of a contact, N. Here β is 1 for a contact with friction. It is 0 for a contact that is bonded or has zero
    /// or infinite friction, since its friction force does not limit sticking.
    #[inline(always)]
    pub(super) fn friction<const C: usize>(&self, force: &Force<C, X>) -> [X; C] {
        let mut t = force.tangential;
        for axis in 0..C {
            t[axis] = self.beta * t[axis];
        }
        t
    }
}

/// The contact force `F + τ F'` as a line in the load factor τ, and a round friction cone. Let `n = α F_n` and `t = β F_t` be the scaled normal and
/// friction force at τ = 0, n' and t' their derivatives with respect to τ. The line crosses the cone, or the mirror image of the cone at its apex, at
/// the roots of
///
/// ```text
/// c + 2 b τ - a τ² = 0,   c = n² - |t|²,   b = n n' - t·t',   a = |t'|² - n'²,   Δ = b² + a c = |n t' - n' t|² - |t × t'|²
/// ```
///
/// The second form of Δ does not lose digits if the line passes close to the apex.
pub(super) struct Crossing<X: Packed> {
    /// The margin `n - |t|` of the contact, N, at load factor τ = 0: `n = α F_n` is the scaled normal force, `t = β F_t` the scaled friction force.
    pub(super) margin: X,
    /// The decrease `|t'| - n'` of the margin `n - |t|` per unit of τ, N, in the limit of large τ. n' and t' are the derivatives of the scaled
    /// forces.
    pub(super) closing: X,
    pub(super) a: X,
    pub(super) b: X,
    pub(super) c: X,
    /// The square root of the discriminant Δ of the quadratic equation; zero if Δ is negative.
    pub(super) root: X,
    /// The magnitude `|t|` of the scaled friction force at τ = 0, N.
    pub(super) friction: X,
    /// The magnitude `|t'|` of the derivative of the scaled friction force with respect to τ, N.
    pub(super) friction_rate: X,
}

impl<X: Packed> Crossing<X> {
    /// The crossing of a round cone by the contact force as a line in τ. At τ = 0 the scaled normal and friction force are (n, t), and their
    /// derivatives with respect to τ are (n', t').
    #[inline(always)]
    pub(super) fn new<const C: usize>((n, t): (X, &[X; C]), (dn, dt): (X, &[X; C])) -> Self {
        let zero = X::all(0.0);
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

    /// The larger root τ, at which a contact force that is inside the cone at τ = 0 leaves it. Of the two forms `c / (√Δ - b)` and `(√Δ + b) / a` the
    /// one without cancellation is used.
    #[inline(always)]
    pub(super) fn last(&self) -> X {
        let Self { a, b, c, root, .. } = *self;
        b.above(X::all(0.0), root + b, c) / b.above(X::all(0.0), a, root - b)
    }

    /// The smaller root τ, at which a contact force that is outside the cone at τ = 0 enters it.
    #[inline(always)]
    pub(super) fn first(&self) -> X {
        let Self { a, b, c, root, .. } = *self;
        b.above(X::all(0.0), -c, b - root) / b.above(X::all(0.0), b + root, a)
    }
}
