//! Where forces that turn with the load leave their friction cones.
//!
//! With n and t for `α F_n` and `β F_t` of a contact the margin `n - |t|` turns with the load. Angles
//! are compared by their cotangents `u = cot(θ/2)`, which fall from +∞ to -∞ over a full turn. In the
//! plane each margin is `c + a cos θ + b sin θ`, and its first root a root of a quadratic:
//!
//! ```text
//! (c + a) u² + 2 b u + (c - a) = 0,   u = (√Δ - b) / (c + a) = (a - c) / (√Δ + b),   Δ = a² + b² - c²
//! ```
//!
//! Of the two forms that one is taken in which nothing cancels; at the root the margin falls by √Δ a
//! radian. In space most contacts are cleared by bounds of n and |t|. For each of the others the
//! first root of `n² - |t|²`, an equation of degree four, is found as [`Grasp::onset_of_turn`] does,
//! one scene at a time, and Newton's method on the margin gives it the last digits.
//!
//! [`Grasp::onset_of_turn`]: crate::ask::Grasp::onset_of_turn

use nalgebra::SVector;

use super::arccotangent::angle_of;
use super::cone::{LEAST, MOST, StickingCone};
use super::first_exit::SHARP;
use super::first_slip::UNCLEAR;
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::{Lanes, dot};
use super::screened::ScreenedTurn;
use super::verdict::{Start, TOGETHER, verdicts};
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::numerics::{Harmonic, Turning};

/// A margin must fall below its edge by so many times its rounding before it can bend back, or the
/// root is none that is clear. With a smaller number rounding could invent or lose roots.
const DEPTH: f64 = 100.0;
/// Newton's steps on the margin of a round cone: from 1e-7 off the second leaves rounding.
const POLISHING_STEPS: usize = 2;
/// The square of a margin carries so many roundings of its largest coefficient.
const SQUARED: f64 = 16.0 * f64::EPSILON;

/// Where a margin first falls below zero.
struct Fall<const L: usize> {
    /// cot(θ/2): the larger, the sooner; minus infinity if it does not fall.
    cotangent: Lanes<L>,
    /// How far the angle may be off.
    off: Lanes<L>,
    /// Positive unless this is clear.
    doubt: Lanes<L>,
}

impl<const L: usize> Fall<L> {
    /// With a root there, at which the margin falls by `slope` a radian, less from radian to radian by
    /// `bend` at most.
    #[inline(always)]
    fn at(cotangent: Lanes<L>, slope: Lanes<L>, bend: Lanes<L>, noise: Lanes<L>) -> Self {
        let (zero, one) = (Lanes::ZERO, Lanes::all(1.0));
        let deep = (slope * slope).above(Lanes::all(2.0 * DEPTH) * noise * bend, zero, one);
        let sharp = slope.above(Lanes::all(SHARP) * noise * cotangent, zero, one);
        Self { cotangent, off: noise / slope, doubt: deep + sharp }
    }

    /// This one, but none where `size` is larger than `bound`.
    #[inline(always)]
    fn unless(self, size: Lanes<L>, bound: Lanes<L>) -> Self {
        let never = Lanes::all(f64::NEG_INFINITY);
        Self {
            cotangent: size.above(bound, never, self.cotangent),
            off: size.above(bound, Lanes::ZERO, self.off),
            doubt: size.above(bound, Lanes::ZERO, self.doubt),
        }
    }

    /// The earlier of two.
    #[inline(always)]
    fn or(self, other: &Self) -> Self {
        Self {
            cotangent: self.cotangent.above(other.cotangent, self.cotangent, other.cotangent),
            off: self.cotangent.above(other.cotangent, self.off, other.off),
            doubt: self.doubt + other.doubt,
        }
    }
}

/// How n and t of one contact turn, and what of the margin may be rounding.
struct Waves<const C: usize, const L: usize> {
    n: Harmonic<Lanes<L>>,
    t: Harmonic<[Lanes<L>; C]>,
    noise: Lanes<L>,
}

impl<const C: usize, const L: usize> Waves<C, L> {
    #[inline(always)]
    fn new<const N: usize>(
        cone: &StickingCone<L>,
        contact: usize,
        forces: &Harmonic<Forces<C, N, L>>,
    ) -> Self {
        let Harmonic { constant, cosine, sine } = forces;
        let standing = Lanes::all(ROUNDING / ON_THE_EDGE) * constant.rounding[contact];
        let rounding = standing + (cosine.rounding[contact] + sine.rounding[contact]);
        Self {
            n: forces.map(|part| cone.alpha * part.normal[contact]),
            t: forces.map(|part| cone.friction(part, contact)),
            noise: (cone.alpha + cone.beta) * rounding,
        }
    }

    /// n and t where the cosine and the sine of the angle are these, with their rates.
    #[inline(always)]
    fn at(&self, cos: Lanes<L>, sin: Lanes<L>) -> [(Lanes<L>, [Lanes<L>; C]); 2] {
        let Harmonic { constant, cosine, sine } = &self.t;
        let (mut t, mut rate) = (*constant, *constant);
        for axis in 0..C {
            t[axis] = constant[axis] + (cosine[axis] * cos + sine[axis] * sin);
            rate[axis] = sine[axis] * cos - cosine[axis] * sin;
        }
        let n = &self.n;
        [(n.constant + (n.cosine * cos + n.sine * sin), t), (n.sine * cos - n.cosine * sin, rate)]
    }

    /// The margin at the beginning.
    #[inline(always)]
    fn margin(&self) -> Lanes<L> {
        let n = self.n.constant + self.n.cosine;
        let mut t = self.t.constant;
        for axis in 0..C {
            t[axis] += self.t.cosine[axis];
        }
        n - if C == 2 { t[0].abs() } else { dot(&t, &t).sqrt() }
    }

    /// Where the margin falls below zero.
    #[inline(always)]
    fn fall(&self, cone: &StickingCone<L>, sticking: Lanes<L>) -> Fall<L> {
        if C == 2 {
            let t = self.t.map(|t| t[0]);
            let side = |sign: f64| {
                let part = |n: Lanes<L>, t: Lanes<L>| n + Lanes::all(sign) * t;
                let [constant, cosine, sine] =
                    [(self.n.constant, t.constant), (self.n.cosine, t.cosine), (self.n.sine, t.sine)]
                        .map(|(n, t)| part(n, t));
                straight(&Harmonic { constant, cosine, sine }, self.noise)
            };
            return side(-1.0).or(&side(1.0));
        }
        let round = self.round_fall(cone, sticking);
        let straight = straight(&self.n, self.noise);
        let choose = |round, straight| cone.beta.above(Lanes::ZERO, round, straight);
        Fall {
            cotangent: choose(round.cotangent, straight.cotangent),
            off: choose(round.off, straight.off),
            doubt: choose(round.doubt, straight.doubt),
        }
    }

    /// The same of a round cone with friction, where the scenes stick at the beginning.
    #[inline(always)]
    fn round_fall(&self, cone: &StickingCone<L>, sticking: Lanes<L>) -> Fall<L> {
        let zero = Lanes::ZERO;
        let [t0, tc, ts] = [&self.t.constant, &self.t.cosine, &self.t.sine];
        let swing = (self.n.cosine * self.n.cosine + self.n.sine * self.n.sine).sqrt();
        // The longest half axis of the ellipse of friction.
        let (c, s) = (dot(tc, tc), dot(ts, ts));
        let (less, twice) = (c - s, Lanes::all(2.0) * dot(tc, ts));
        let half = Lanes::all(0.5) * (c + s + (less * less + twice * twice).sqrt());
        let (standing, turning) = (dot(t0, t0).sqrt(), half.sqrt());
        let least = self.n.constant - swing - (standing + turning);
        let size = self.n.constant.abs() + swing + (standing + turning);
        let mut found = Lanes::all(f64::NEG_INFINITY);
        for lane in 0..L {
            let cleared = least.0[lane] > self.noise.0[lane];
            if sticking.0[lane] >= 0.0 && cone.beta.0[lane] > 0.0 && !cleared {
                found.0[lane] = self.root_of_square(lane, size.0[lane]);
            }
        }
        if found.0 == [f64::NEG_INFINITY; L] {
            return Fall { cotangent: found, off: zero, doubt: zero };
        }
        let bend = swing + turning;
        let (mut cotangent, mut slope, mut left) = (found, zero, zero);
        for step in 0..=POLISHING_STEPS {
            let (u, one) = (cotangent, Lanes::all(1.0));
            let over = one / (u * u + one);
            let [(n, t), (dn, dt)] = self.at((u * u - one) * over, (u + u) * over);
            let friction = dot(&t, &t).sqrt();
            left = n - friction;
            slope = dot(&t, &dt) / friction.max(Lanes::all(f64::MIN_POSITIVE)) - dn;
            if step < POLISHING_STEPS {
                cotangent -= Lanes::all(0.5) * (left / slope) * (u * u + one);
            }
        }
        let fall = Fall::at(cotangent, slope, bend, self.noise);
        let off_the_root = self.noise.above(left.abs(), zero, Lanes::all(1.0));
        Fall { doubt: fall.doubt + off_the_root, ..fall }.unless(-found, Lanes::all(f64::MAX))
    }

    /// cot(θ/2) where `n² - |t|²` of one scene first falls to what may be rounding of it, minus infinity
    /// if it does not.
    fn root_of_square(&self, lane: usize, size: f64) -> f64 {
        let of = |x: &Lanes<L>| x.0[lane] / size;
        let number = self.n.map(of);
        let vector = self.t.map(|t| SVector::<f64, C>::from_fn(|axis, _| of(&t[axis])));
        let mut square = Turning { number, vector }.square();
        square.constant -= 2.0 * of(&self.noise) + SQUARED;
        square.first_cotangent().unwrap_or(f64::NEG_INFINITY)
    }

    /// Zero if squares of these forces keep their digits, else minus infinity.
    #[inline(always)]
    fn lost(&self, cone: &StickingCone<L>) -> Lanes<L> {
        let mut size = Lanes::ZERO;
        for (n, t) in self.n.parts().into_iter().zip(self.t.parts()) {
            size += n.abs();
            for axis in 0..C {
                size += t[axis].abs();
            }
        }
        let all = Lanes::all(f64::NEG_INFINITY);
        let (square, zero) = (size * size, Lanes::ZERO);
        let lost = square.above(Lanes::all(LEAST), square.above(Lanes::all(MOST), all, zero), all);
        cone.alpha.above(zero, lost, zero)
    }
}

/// Where `c + a cos θ + b sin θ`, positive at the beginning, falls below zero.
#[inline(always)]
fn straight<const L: usize>(margin: &Harmonic<Lanes<L>>, noise: Lanes<L>) -> Fall<L> {
    let Harmonic { constant: c, cosine: a, sine: b } = *margin;
    let zero = Lanes::ZERO;
    let swing = (a * a + b * b).sqrt();
    let root = ((swing - c) * (swing + c)).max(zero).sqrt();
    let u = b.above(zero, a - c, root - b) / b.above(zero, root + b, c + a);
    Fall::at(u, root, swing, noise).unless(c, swing + noise)
}

/// The verdicts on the scenes of a block, from how forces turn, up to an angle; infinite for a full
/// turn.
#[inline(always)]
pub(super) fn judge<const C: usize, const N: usize, const L: usize>(
    friction: &[Lanes<L>; N],
    forces: &Harmonic<Forces<C, N, L>>,
    most: f64,
) -> [ScreenedTurn; L] {
    let (zero, one, infinite) = (Lanes::ZERO, Lanes::all(1.0), Lanes::all(f64::INFINITY));
    let (mut margin, mut sure) = (infinite, infinite);
    for i in 0..N {
        let cone = StickingCone::of(friction[i]);
        let waves = Waves::new(&cone, i, forces);
        let here = waves.margin();
        margin = margin.min(here);
        // What may be on the edge is judged as for a load that grows.
        let rounding = Lanes::all(ON_THE_EDGE / ROUNDING) * waves.noise;
        sure = sure.min(here - rounding + waves.lost(&cone));
    }
    let mut first = Fall { cotangent: -infinite, off: zero, doubt: zero };
    let mut cotangents = [zero; N];
    for i in 0..N {
        let cone = StickingCone::of(friction[i]);
        let never = Lanes::all(f64::from_bits(1));
        let fall = Waves::new(&cone, i, forces).fall(&cone, sure).unless(never, cone.alpha);
        cotangents[i] = fall.cotangent;
        first = fall.or(&first);
    }
    let u = first.cotangent;
    let angle = angle_of(u);
    let until = u - Lanes::all(0.5 * TOGETHER) * angle * (u * u + one);
    let mut leaving = zero;
    for i in 0..N {
        leaving += until.above(cotangents[i], zero, Lanes::all(f64::from(1 << i)));
    }
    let (end, off) = (Lanes::all(most), first.off + Lanes::all(TOGETHER) * angle);
    let within = end.above(angle + off, angle, Lanes::all(UNCLEAR));
    let within = (angle - off).above(end, infinite, within);
    let code = u.above(Lanes::all(f64::MIN), within, infinite);
    let code = first.doubt.above(zero, Lanes::all(UNCLEAR), code);
    let Harmonic { constant, cosine, sine } = forces;
    let start = Start { margin, sure, free: constant.free + cosine.free };
    let unbalanced = constant.unbalanced + cosine.unbalanced + sine.unbalanced;
    verdicts((code, leaving), &start, unbalanced, sine.free, |first| ScreenedTurn { first, most })
}
