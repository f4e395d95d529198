//! The least factor on the commands with which all contacts of a grasp stick under each load of a list, for several grasps, one in each lane of a
//! SIMD vector. A command is the displacement that a finger would make if there were no object. A clearance is the gap before the command.
//!
//! Under a load and with the commands multiplied by s the force of a contact is `F + s F'`. Here F is due to the load and the clearances, F' to the
//! commands. As s grows, this force moves along a straight line, the line of forces. A contact sticks while its margin `n - |t|` is not negative,
//! with `n = α F_n` and `t = β F_t`. For a contact with friction α is the coefficient of friction and β is 1 ([`StickingCone`] has the values for
//! others). The margin is concave in s. Therefore it is not negative in an interval of factors s, which may be empty. At the lower end of the
//! interval the force enters the friction cone, at the upper end it leaves the cone. The answer is the least s >= 0 that lies in the intervals of all
//! contacts and loads. In the plane a margin is the smaller of two linear functions of s. In space both ends are roots of one quadratic equation
//! ([`Crossing`]).

use super::block::count;
use super::cone::{Crossing, StickingCone};
use super::first_slip::{GIVES_WAY, UNCLEAR};
use super::forces::AnyForces;
use super::lanes::{Packed, dot};
use super::tolerances::{LEAST_PRODUCT, MOST_PRODUCT, SHARP_MARGIN};
use super::verdict::balanced;
use crate::numerics::Vectors;

/// The code in place of the least factor on the commands, if there is no factor with which all contacts stick. [`UNCLEAR`] stands for an answer that
/// rounding decides, [`GIVES_WAY`] for a load that does work along a motion without resistance.
pub(super) const NO_FACTOR: f64 = -1.0;

/// The interval of factors on the commands, from `first` to `last`, with which one contact sticks under one load, with error bounds of both ends.
struct Interval<X: Packed> {
    first: X,
    first_off: X,
    last: X,
    last_off: X,
}

/// The margin of sticking of one contact, `α F_n - |β F_t|`, as a function of the factor on the commands; in the plane, one of its two linear
/// functions. `value` is the margin at factor zero, and `gain` its increase per unit of the factor. `noise` is a bound of the rounding of `value`,
/// `gain_noise` of the rounding of `gain`.
struct Margin<X: Packed> {
    value: X,
    gain: X,
    noise: X,
    gain_noise: X,
}

impl<X: Packed> Margin<X> {
    /// The interval of factors >= 0 in which this margin, as a linear function of the factor, is not negative, with error bounds of its ends. An
    /// empty interval runs from infinity to minus infinity.
    #[inline(always)]
    fn straight(&self) -> Interval<X> {
        let (zero, infinite) = (X::all(0.0), X::all(f64::INFINITY));
        let Self { value, gain, noise, gain_noise } = *self;
        let root = -(value / gain);
        let off = |at: X, rate: X| (noise + at * gain_noise) / rate;
        // A margin that is negative at factor zero becomes zero at the factor `root`, provided that the commands raise the margin.
        let entered = gain.above(gain_noise, root, infinite);
        let first = self.broken(entered, zero);
        let first_off = self.broken(gain.above(gain_noise, off(root, gain), zero), zero);
        let falls = |yes, no| (-gain).above(gain_noise, yes, no);
        let last = falls(root.max(zero), infinite);
        let last = self.broken(gain.above(gain_noise, infinite, -infinite), last);
        let last_off = self.broken(zero, falls(off(root.max(zero), -gain), zero));
        Interval { first, first_off, last, last_off }
    }

    /// Returns `yes` if the margin is negative at factor zero, beyond its rounding; else `no`.
    #[inline(always)]
    fn broken(&self, yes: X, no: X) -> X {
        (-self.noise).above(self.value, yes, no)
    }

    /// The interval of factors in which this margin of a round friction cone is not negative. Its ends are NaN if rounding determines them.
    #[inline(always)]
    fn round<const C: usize>(
        &self,
        line: &Crossing<X>,
        [(n, t), (dn, dt)]: [(X, &[X; C]); 2],
    ) -> Interval<X> {
        let (zero, infinite) = (X::all(0.0), X::all(f64::INFINITY));
        let Self { noise, gain_noise, .. } = *self;
        // If the line of forces enters and leaves the cone, `n² - |t|²` is largest on it at the factor `deepest`.
        let deepest = line.b / line.a;
        let mut at = *t;
        for axis in 0..C {
            at[axis] = t[axis] + deepest * dt[axis];
        }
        let depth = n + deepest * dn - dot(&at, &at).sqrt();
        // If the line of forces passes inside or outside the cone by less than `needed`, N, rounding may determine whether it crosses the cone. The
        // answer is then unclear. `needed` is four times the bound of the rounding of the margin at its maximum.
        let needed = X::all(4.0) * (noise + deepest * gain_noise);
        let crossing = line.closing.above(gain_noise, X::all(1.0), zero);
        let unknown = X::all(f64::NAN);
        let through = |yes, no| depth.above(needed, yes, (-depth).above(needed, no, unknown));
        // If the margin decreases for large factors, it is positive on a bounded interval or nowhere. If the margin does not decrease for large
        // factors, it stays positive once it is positive. If rounding determines which of the two applies, the interval is known only if the commands
        // cause no force.
        let rate = dn.abs().max(line.friction_rate);
        let idle = rate.above(gain_noise, unknown, infinite);
        let (first, last) = (line.first(), line.last());
        let passing = line.a.above(zero, line.b.above(zero, through(first, infinite), infinite), infinite);
        let entered = (-line.closing).above(gain_noise, first, crossing.above(zero, passing, idle));
        let slope = (line.root / (n + first * dn)).max(self.gain);
        let first_off = (noise + first * gain_noise) / slope;
        let is_entered = X::all(f64::MAX);
        let first_off = entered.above(is_entered, zero, first_off);
        // If the line of forces begins at the apex of the cone (zero force), up to rounding, and leads out of the cone, the force leaves the cone at
        // factor zero. This holds even if rounding gives the quadratic equation other roots.
        let weight = n.abs() + line.friction;
        let left = weight.above(noise, last.max(zero), zero);
        let chord = self.broken(depth / (last - deepest), self.value / last);
        let steeper = chord.max(line.root / (n + last * dn));
        let slope = steeper.above(zero, steeper, chord);
        let left_off = weight.above(noise, (noise + last * gain_noise) / slope, zero);
        let leaves = |yes, no| crossing.above(zero, yes, no);
        let (last, last_off) = (leaves(left, infinite), leaves(left_off, zero));
        Interval {
            first: self.broken(entered, zero),
            first_off: self.broken(first_off, zero),
            last: self.broken(entered.above(is_entered, -infinite, last), last),
            last_off: self.broken(entered.above(is_entered, zero, last_off), last_off),
        }
    }
}

/// The intersection of the intervals in which the margins added so far are not negative, as functions of the factor on the commands. The fields
/// `doubt` and `free` tell whether rounding or a motion without resistance makes the answer invalid.
pub(super) struct LeastFactor<X: Packed> {
    /// Each contact has, under each load, an interval of factors with which it sticks. This is the largest lower end of these intervals, as computed.
    first: X,
    /// A lower bound of the exact value of `first`, the largest lower end of the intervals of factors; `first` has rounding errors.
    first_sure: X,
    /// An upper bound of the exact value of `first`, the largest lower end of the intervals of factors; `first` has rounding errors.
    first_most: X,
    /// A lower bound, in spite of rounding, of the smallest upper end of the intervals of factors of all contacts and loads.
    last_sure: X,
    /// An upper bound, in spite of rounding, of the smallest upper end of the intervals of factors of all contacts and loads.
    last_most: X,
    /// Positive if rounding determines whether some margin is negative, or forces do not balance, so that the answer is unclear.
    doubt: X,
    /// Positive if a load added so far does positive work along a motion that no contact resists.
    free: X,
    /// The contact and the load whose interval has the largest lower end, encoded as `8 · load + contact`.
    binding: X,
}

impl<X: Packed> LeastFactor<X> {
    /// The interval of all factors from zero, before any contact and load is added.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let (zero, infinite) = (X::all(0.0), X::all(f64::INFINITY));
        Self {
            first: zero,
            first_sure: zero,
            first_most: zero,
            last_sure: infinite,
            last_most: infinite,
            doubt: zero,
            free: zero,
            binding: zero,
        }
    }

    /// Intersects the interval of factors with the intervals of all contacts under the load with the index `load`, from 0. `forces` has the contact
    /// forces due to the commands, then the contact forces due to the load and the clearances.
    #[inline(never)]
    pub(super) fn under<V: Vectors, const C: usize>(
        &mut self,
        v: V,
        load: usize,
        friction: &[X],
        forces: [&AnyForces<C, X>; 2],
    ) {
        v.run(
            #[inline(always)]
            || self.add(load, friction, forces),
        );
    }

    #[inline(always)]
    fn add<const C: usize>(
        &mut self,
        load: usize,
        friction: &[X],
        [commands, others]: [&AnyForces<C, X>; 2],
    ) {
        let (zero, one) = (X::all(0.0), X::all(1.0));
        for i in 0..count(friction.len()) {
            let cone = StickingCone::of(friction[i]);
            let weight = cone.alpha + cone.beta;
            let noise = weight * others.of[i].rounding;
            let gain_noise = weight * commands.of[i].rounding;
            let (force, gain) = (&others.of[i], &commands.of[i]);
            let (n, dn) = (cone.alpha * force.normal, cone.alpha * gain.normal);
            let (t, dt) = (cone.friction(force), cone.friction(gain));
            let binding = X::all((8 * load + i) as f64);
            self.require_valid([n.abs(), dn.abs()]);
            if const { C == 2 } {
                for (value, gain) in [(n - t[0], dn - dt[0]), (n + t[0], dn + dt[0])] {
                    let margin = Margin { value, gain, noise, gain_noise };
                    self.narrow(&margin, &margin.straight(), binding);
                }
            } else {
                let line = Crossing::new((n, &t), (dn, &dt));
                let margin = Margin { value: line.margin, gain: -line.closing, noise, gain_noise };
                self.narrow(&margin, &margin.round(&line, [(n, &t), (dn, &dt)]), binding);
                let (size, rate) = (n.abs() + line.friction, dn.abs() + line.friction_rate);
                let product = size * rate;
                let lost =
                    product.above(X::all(LEAST_PRODUCT), product.above(X::all(MOST_PRODUCT), one, zero), one);
                self.doubt += size.above(noise, rate.above(gain_noise, lost, zero), zero);
            }
        }
        self.free += others.free;
        self.doubt += balanced(commands.unbalanced + others.unbalanced, zero, one);
    }

    /// Intersects the interval of factors with the interval of one more margin; `binding` is the code of its contact and load.
    #[inline(always)]
    fn narrow(&mut self, margin: &Margin<X>, interval: &Interval<X>, binding: X) {
        // `noise` bounds the rounding of a margin at factor zero. If a margin is negative by between a quarter of this bound and four times the
        // bound, the answer is unclear. The true rounding of ordinary sums stays below a quarter of the bound.
        let (short, about) = (-margin.value, X::all(4.0));
        let doubt = (about * margin.noise).above(short, X::all(1.0), X::all(0.0));
        self.doubt += (about * short).above(margin.noise, doubt, X::all(0.0));
        let Interval { first, first_off, last, last_off } = *interval;
        self.binding = first.above(self.first, binding, self.binding);
        self.first = self.first.max(first);
        self.first_sure = self.first_sure.max(first - first_off);
        self.first_most = self.first_most.max(first + first_off);
        self.last_sure = self.last_sure.min(last - last_off);
        self.last_most = self.last_most.min(last + last_off);
        self.require_valid([first, first_off, last.abs(), last_off]);
    }

    /// Makes the answer unclear if one of the numbers `sizes`, such as the ends of an interval, is negative or NaN. The other comparisons in this
    /// file ignore NaN.
    #[inline(always)]
    fn require_valid<const K: usize>(&mut self, sizes: [X; K]) {
        for size in sizes {
            self.doubt += size.above(X::all(-f64::MIN_POSITIVE), X::all(0.0), X::all(1.0));
        }
    }

    /// For each lane two numbers. First, the least factor on the commands with which all contacts stick under all loads, or a code if there is no
    /// such factor. Second, the contact and load that determine this factor, encoded as in the field `binding`.
    #[inline(always)]
    pub(super) fn least(&self) -> (X, X) {
        let (zero, unclear) = (X::all(0.0), X::all(UNCLEAR));
        let spread = self.first_most - self.first_sure;
        let code = (X::all(2.0 / SHARP_MARGIN) * self.first).above(spread, self.first, unclear);
        let code = self.first_most.above(self.last_sure, unclear, code);
        let code = self.first_sure.above(self.last_most, X::all(NO_FACTOR), code);
        let code = self.first.above(zero, code, zero);
        let code = self.doubt.above(zero, unclear, code);
        (self.free.above(zero, X::all(GIVES_WAY), code), self.binding)
    }
}
