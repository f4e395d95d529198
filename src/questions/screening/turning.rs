//! The angle at which the first contact force leaves its friction cone while the load turns.
//!
//! Let n and t be `α F_n` and `β F_t` of a contact, as in [`StickingCone`]. Its margin is `n - |t|`, a function of the angle θ by which the load has
//! turned. Angles are compared by their cotangents `u = cot(θ/2)`, which fall from +∞ to -∞ over a full turn. In the plane each margin is
//! `c + a cos θ + b sin θ`, and its first root solves a quadratic equation:
//!
//! ```text
//! (c + a) u² + 2 b u + (c - a) = 0,   u = (√Δ - b) / (c + a) = (a - c) / (√Δ + b),   Δ = a² + b² - c²
//! ```
//!
//! Of the two forms the one without cancellation is used. At the root the margin falls at the rate √Δ per radian, with the discriminant Δ. In space
//! bounds of n and |t| show for most contacts that they do not leave their cones. For each other contact the first root of `n² - |t|²`, an equation
//! of degree four, is found as in [`Grasp::onset_of_turn`], one grasp at a time. Newton's method on the margin then supplies the last digits.
//!
//! [`Grasp::onset_of_turn`]: crate::ask::Grasp::onset_of_turn

use nalgebra::SVector;

use super::arccotangent::angle_of;
use super::block::{MOST_SCREENED, count};
use super::cone::StickingCone;
use super::first_slip::UNCLEAR;
use super::forces::AnyForces;
use super::lanes::{Packed, dot};
use super::screened::ScreenedTurn;
use super::tolerances::{LEAST_PRODUCT, MOST_PRODUCT, ON_THE_EDGE, SHARP_MARGIN};
use super::verdict::{Start, verdicts};
use crate::contact::ZERO_SLACK;
use crate::numerics::tolerances::{ROUNDED_SUM, SOLVED_ROUNDING};
use crate::numerics::{Harmonic, Turning, Vectors};

/// The first angle at which a contact's margin falls below zero, as a root of the margin.
struct MarginZero<X: Packed> {
    /// cot(θ/2) of this angle θ; the larger the cotangent, the smaller the angle. Minus infinity if the margin does not fall below zero.
    cotangent: X,
    /// Bound of the error of this angle, rad.
    off: X,
    /// Positive if rounding decides whether this root exists, or hides its first six digits, so that the answer is unclear.
    doubt: X,
}

impl<X: Packed> MarginZero<X> {
    /// A root at the angle with this cotangent cot(θ/2), where the margin falls by `slope` per radian. `bend` bounds the change of this slope per
    /// radian, `noise` the rounding of the margin.
    #[inline(always)]
    fn at(cotangent: X, slope: X, bend: X, noise: X) -> Self {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        // The margin must fall below zero by at least a hundred times its rounding before it can rise again. Else rounding could create or hide a
        // root.
        let deep = (slope * slope).above(X::all(2.0 * 100.0) * noise * bend, zero, one);
        let sharp = slope.above(X::all(SHARP_MARGIN) * noise * cotangent, zero, one);
        Self { cotangent, off: noise / slope, doubt: deep + sharp }
    }

    /// The same root, but none (minus infinity) in lanes where `size` is larger than `bound`.
    #[inline(always)]
    fn unless(self, size: X, bound: X) -> Self {
        let never = X::all(f64::NEG_INFINITY);
        Self {
            cotangent: size.above(bound, never, self.cotangent),
            off: size.above(bound, X::all(0.0), self.off),
            doubt: size.above(bound, X::all(0.0), self.doubt),
        }
    }

    /// The root at the smaller angle of two roots; doubts about either of them count.
    #[inline(always)]
    fn or(self, other: &Self) -> Self {
        Self {
            cotangent: self.cotangent.above(other.cotangent, self.cotangent, other.cotangent),
            off: self.cotangent.above(other.cotangent, self.off, other.off),
            doubt: self.doubt + other.doubt,
        }
    }
}

/// The scaled normal force n and friction force t of one contact as functions of the angle of the load, and a bound of the rounding of its margin.
struct Waves<const C: usize, X: Packed> {
    n: Harmonic<X>,
    t: Harmonic<[X; C]>,
    noise: X,
}

impl<const C: usize, X: Packed> Waves<C, X> {
    #[inline(always)]
    fn new(cone: &StickingCone<X>, contact: usize, forces: &Harmonic<&AnyForces<C, X>>) -> Self {
        let Harmonic { constant, cosine, sine } = forces;
        let standing = X::all(ZERO_SLACK / ON_THE_EDGE) * constant.of[contact].rounding;
        let rounding = standing + (cosine.of[contact].rounding + sine.of[contact].rounding);
        Self {
            n: forces.map(|part| cone.alpha * part.of[contact].normal),
            t: forces.map(|part| cone.friction(&part.of[contact])),
            noise: (cone.alpha + cone.beta) * rounding,
        }
    }

    /// The values of n and t, then their derivatives by the angle, at the angle with this cosine and sine.
    #[inline(always)]
    fn at(&self, cos: X, sin: X) -> [(X, [X; C]); 2] {
        let Harmonic { constant, cosine, sine } = &self.t;
        let (mut t, mut rate) = (*constant, *constant);
        for axis in 0..C {
            t[axis] = constant[axis] + (cosine[axis] * cos + sine[axis] * sin);
            rate[axis] = sine[axis] * cos - cosine[axis] * sin;
        }
        let n = &self.n;
        [(n.constant + (n.cosine * cos + n.sine * sin), t), (n.sine * cos - n.cosine * sin, rate)]
    }

    /// The margin `n - |t|` of this contact at angle zero, N.
    #[inline(always)]
    fn margin(&self) -> X {
        let n = self.n.constant + self.n.cosine;
        let mut t = self.t.constant;
        for axis in 0..C {
            t[axis] += self.t.cosine[axis];
        }
        n - if const { C == 2 } { t[0].abs() } else { dot(&t, &t).sqrt() }
    }

    /// The first angle at which the margin of this contact falls below zero; none where the load never takes it there. `sticking` is negative in
    /// lanes whose grasp does not surely stick at angle zero.
    #[inline(always)]
    fn fall(&self, cone: &StickingCone<X>, sticking: X) -> MarginZero<X> {
        if const { C == 2 } {
            let t = self.t.map(|t| t[0]);
            let side = |sign: f64| {
                let part = |n: X, t: X| n + X::all(sign) * t;
                let [constant, cosine, sine] =
                    [(self.n.constant, t.constant), (self.n.cosine, t.cosine), (self.n.sine, t.sine)]
                        .map(|(n, t)| part(n, t));
                straight(&Harmonic { constant, cosine, sine }, self.noise)
            };
            return side(-1.0).or(&side(1.0));
        }
        let round = self.round_fall(cone, sticking);
        let straight = straight(&self.n, self.noise);
        let choose = |round, straight| cone.beta.above(X::all(0.0), round, straight);
        MarginZero {
            cotangent: choose(round.cotangent, straight.cotangent),
            off: choose(round.off, straight.off),
            doubt: choose(round.doubt, straight.doubt),
        }
    }

    /// The first angle at which the margin of a round cone with friction falls below zero, in lanes with `sticking` >= 0.
    #[inline(always)]
    fn round_fall(&self, cone: &StickingCone<X>, sticking: X) -> MarginZero<X> {
        let zero = X::all(0.0);
        let [t0, tc, ts] = [&self.t.constant, &self.t.cosine, &self.t.sine];
        let swing = (self.n.cosine * self.n.cosine + self.n.sine * self.n.sine).sqrt();
        // As the load turns, the end of t runs along an ellipse; its longest half axis is `turning`.
        let (c, s) = (dot(tc, tc), dot(ts, ts));
        let (less, twice) = (c - s, X::all(2.0) * dot(tc, ts));
        let half = X::all(0.5) * (c + s + (less * less + twice * twice).sqrt());
        let (standing, turning) = (dot(t0, t0).sqrt(), half.sqrt());
        let least = self.n.constant - swing - (standing + turning);
        let size = self.n.constant.abs() + swing + (standing + turning);
        let found = X::of(X::each(|lane| {
            let cleared = least.lane(lane) > self.noise.lane(lane);
            if sticking.lane(lane) >= 0.0 && cone.beta.lane(lane) > 0.0 && !cleared {
                self.root_of_square(lane, size.lane(lane))
            } else {
                f64::NEG_INFINITY
            }
        }));
        if found.is_all(f64::NEG_INFINITY) {
            return MarginZero { cotangent: found, off: zero, doubt: zero };
        }
        let bend = swing + turning;
        let (mut cotangent, mut slope, mut left) = (found, zero, zero);
        // The root of the squared margin has an error of about 1e-7, so that the second step of Newton's method leaves only rounding.
        let newton_steps = 2;
        for step in 0..=newton_steps {
            let (u, one) = (cotangent, X::all(1.0));
            let over = one / (u * u + one);
            let [(n, t), (dn, dt)] = self.at((u * u - one) * over, (u + u) * over);
            let friction = dot(&t, &t).sqrt();
            left = n - friction;
            slope = dot(&t, &dt) / friction.max(X::all(f64::MIN_POSITIVE)) - dn;
            if step < newton_steps {
                cotangent -= X::all(0.5) * (left / slope) * (u * u + one);
            }
        }
        let fall = MarginZero::at(cotangent, slope, bend, self.noise);
        let off_the_root = self.noise.above(left.abs(), zero, X::all(1.0));
        MarginZero { doubt: fall.doubt + off_the_root, ..fall }.unless(-found, X::all(f64::MAX))
    }

    /// The first angle at which the squared margin `F_n² μ² - |F_t|²` of this contact falls to the bound of its rounding, as cot(θ/2), for the grasp
    /// in this lane; minus infinity if it does not.
    fn root_of_square(&self, lane: usize, size: f64) -> f64 {
        let of = |x: &X| x.lane(lane) / size;
        let number = self.n.map(of);
        let vector = self.t.map(|t| SVector::<f64, C>::from_fn(|axis, _| of(&t[axis])));
        let mut square = Turning { number, vector }.square();
        square.constant -= 2.0 * of(&self.noise) + ROUNDED_SUM;
        square.first_cotangent().unwrap_or(f64::NEG_INFINITY)
    }

    /// Minus infinity if squares of the forces of this contact over- or underflow, so that its margin is unknown; else zero.
    #[inline(always)]
    fn lost(&self, cone: &StickingCone<X>) -> X {
        let mut size = X::all(0.0);
        for (n, t) in self.n.parts().into_iter().zip(self.t.parts()) {
            size += n.abs();
            for axis in 0..C {
                size += t[axis].abs();
            }
        }
        let all = X::all(f64::NEG_INFINITY);
        let (square, zero) = (size * size, X::all(0.0));
        let lost = square.above(X::all(LEAST_PRODUCT), square.above(X::all(MOST_PRODUCT), all, zero), all);
        cone.alpha.above(zero, lost, zero)
    }
}

/// The first angle at which the margin `c + a cos θ + b sin θ`, positive at angle zero, falls below zero. None if |c| exceeds the other terms by more
/// than `noise`.
#[inline(always)]
fn straight<X: Packed>(margin: &Harmonic<X>, noise: X) -> MarginZero<X> {
    let Harmonic { constant: c, cosine: a, sine: b } = *margin;
    let zero = X::all(0.0);
    let swing = (a * a + b * b).sqrt();
    let root = ((swing - c) * (swing + c)).max(zero).sqrt();
    let u = b.above(zero, a - c, root - b) / b.above(zero, root + b, c + a);
    MarginZero::at(u, root, swing, noise).unless(c, swing + noise)
}

/// The first slip of the grasps of a block, from their contact forces as functions of the angle of the load. The load turns up to `most`, rad,
/// infinite for a full turn.
#[inline(never)]
pub(super) fn judge<V: Vectors, const C: usize, X: Packed>(
    v: V,
    friction: &[X],
    forces: &Harmonic<&AnyForces<C, X>>,
    most: f64,
) -> X::Each<ScreenedTurn> {
    v.run(
        #[inline(always)]
        || judged(friction, forces, most),
    )
}

#[inline(always)]
fn judged<const C: usize, X: Packed>(
    friction: &[X],
    forces: &Harmonic<&AnyForces<C, X>>,
    most: f64,
) -> X::Each<ScreenedTurn> {
    let (zero, one, infinite) = (X::all(0.0), X::all(1.0), X::all(f64::INFINITY));
    let Harmonic { constant, cosine, sine } = forces;
    let mut start = Start::new(constant.free + cosine.free);
    let contacts = count(friction.len());
    for i in 0..contacts {
        let cone = StickingCone::of(friction[i]);
        let waves = Waves::new(&cone, i, forces);
        // The rounding bound of the margin at angle zero is as large as under a growing load, so that a contact on the edge of its cone is unclear.
        let rounding = X::all(ON_THE_EDGE / ZERO_SLACK) * waves.noise;
        start.add(waves.margin(), rounding, waves.lost(&cone));
    }
    let sure = start.sure();
    let mut first = MarginZero { cotangent: -infinite, off: zero, doubt: zero };
    let mut cotangents = [zero; MOST_SCREENED];
    for i in 0..contacts {
        let cone = StickingCone::of(friction[i]);
        let never = X::all(f64::from_bits(1));
        let fall = Waves::new(&cone, i, forces).fall(&cone, sure).unless(never, cone.alpha);
        cotangents[i] = fall.cotangent;
        first = fall.or(&first);
    }
    let u = first.cotangent;
    let angle = angle_of(u);
    let until = u - X::all(0.5 * SOLVED_ROUNDING) * angle * (u * u + one);
    let mut leaving = zero;
    for i in 0..contacts {
        leaving += until.above(cotangents[i], zero, X::all(f64::from(1 << i)));
    }
    let (end, off) = (X::all(most), first.off + X::all(SOLVED_ROUNDING) * angle);
    let within = end.above(angle + off, angle, X::all(UNCLEAR));
    let within = (angle - off).above(end, infinite, within);
    let code = u.above(X::all(f64::MIN), within, infinite);
    let code = first.doubt.above(zero, X::all(UNCLEAR), code);
    let unbalanced = constant.unbalanced + cosine.unbalanced + sine.unbalanced;
    verdicts((code, leaving), &start, unbalanced, sine.free, |first| ScreenedTurn { first, most })
}
