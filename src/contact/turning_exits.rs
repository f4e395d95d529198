//! How far a load can turn before a contact leaves its state.
//!
//! While states last, a force is `F(φ) = F₀ + F_c cos φ + F_s sin φ`, and so is a gap. The margin at a facet is such a sum of numbers. On
//! the round cone `(μF_n)² - |F_t|²` is one of degree two.

use nalgebra::SVector;

use super::exits::Exit;
use super::law::LocalLaw;
use super::state::{Mode, State};
use super::tangential::tangential;
use super::tolerances::ZERO_SLACK;
use crate::numerics::{Fall, Trigonometric};

/// Newton's steps on the margin of a round cone: each doubles the digits that its square has left.
const POLISHING_STEPS: usize = 3;
/// The square of a margin carries so many roundings of its largest coefficient.
const SQUARED: f64 = 16.0 * f64::EPSILON;
/// Polishing moves an angle by this many radians at most: the square root of what squares have lost, with room.
const NEAR: f64 = 1e-3;

/// A force, or a gap in its first component, for an angle φ from here on, with the size that its rounding is measured against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wave<const C: usize> {
    pub(crate) constant: SVector<f64, C>,
    pub(crate) cosine: SVector<f64, C>,
    pub(crate) sine: SVector<f64, C>,
    pub(crate) size: f64,
}

impl<const C: usize> Wave<C> {
    /// At this angle.
    pub(crate) fn at(&self, angle: f64) -> SVector<f64, C> {
        let (sin, cos) = angle.sin_cos();
        self.constant + self.cosine * cos + self.sine * sin
    }

    /// Its rate there, for one radian.
    pub(crate) fn rate_at(&self, angle: f64) -> SVector<f64, C> {
        let (sin, cos) = angle.sin_cos();
        self.sine * cos - self.cosine * sin
    }

    /// The largest that its rate can be.
    fn fastest(&self) -> f64 {
        self.cosine.norm() + self.sine.norm()
    }

    /// What a linear function takes from it.
    fn seen(&self, by: impl Fn(&SVector<f64, C>) -> f64) -> Trigonometric {
        Trigonometric::linear([by(&self.constant), by(&self.cosine), by(&self.sine)])
    }
}

/// What a contact does on the way.
#[derive(Debug, Clone, Copy)]
pub(crate) enum TurningExit<const C: usize> {
    /// It leaves its state; the step is the angle.
    Leaves(Exit<C>),
    /// At this angle it comes as near to an edge as rounding, and does not cross it.
    Touches(f64),
}

impl<const C: usize> LocalLaw<'_, C> {
    /// The ways out of a state, rolling or open, within an angle of `most`, each where it is first reached. What turns is the force, or
    /// the gap.
    pub(crate) fn turning_exits(
        &self,
        state: &State<C>,
        [force, gap]: [&Wave<C>; 2],
        most: f64,
    ) -> Vec<TurningExit<C>> {
        let along_n = |x: &SVector<f64, C>| x[0];
        let nowhere = SVector::zeros();
        if matches!(state, Mode::Open) {
            return linear_exit(gap, along_n, 1.0, nowhere, most).into_iter().collect();
        }
        if self.has_a_round_edge() {
            return self.round_turning_exit(force, most).into_iter().collect();
        }
        let mut exits = Vec::new();
        if !self.is_bonded() {
            let (cone, facets) = (self.cone(), self.facets());
            if facets.is_empty() && self.may_open() {
                exits.extend(linear_exit(force, along_n, 1.0, nowhere, most));
            }
            for h in facets {
                let margin = |f: &SVector<f64, C>| cone.facet_margin(f, h);
                exits.extend(linear_exit(force, margin, cone.facet_weight(h), *h, most));
            }
        }
        exits
    }

    /// Where a force leaves the round cone: where `(μF_n)² - |F_t|²` falls below zero, or through the apex, where F_n does.
    fn round_turning_exit(&self, wave: &Wave<C>, most: f64) -> Option<TurningExit<C>> {
        let cone = self.cone();
        let weight = cone.round_weight();
        let slack = ZERO_SLACK * wave.size * weight;
        let here = wave.at(0.0);
        let friction = tangential(&here);
        if cone.round_margin(&here) <= slack && friction.norm() > slack {
            // On the edge the facet that touches it tells whether the force goes in or out.
            let outward = friction.normalize();
            let margin = wave.seen(|f| cone.facet_margin(f, &outward));
            if Start::of(&margin, slack, ZERO_SLACK * weight * wave.fastest()) == Start::Falls {
                return linear_exit(wave, |f| cone.facet_margin(f, &outward), weight, outward, most);
            }
        }
        let apex = linear_exit(wave, |f| f[0], 1.0, SVector::zeros(), most);
        let Some(step) = self.fall_of_the_square(wave, most) else { return apex };
        let step = match step {
            Fall::At(angle) => self.polished(wave, angle),
            Fall::Touches(angle) => return apex.or(Some(TurningExit::Touches(angle))),
        };
        // Through the apex both are one root.
        if let Some(TurningExit::Leaves(through)) = apex
            && (through.step <= step || tangential(&wave.at(through.step)).norm() <= slack)
        {
            return apex;
        }
        let facet = outward(&wave.at(step));
        let rate = cone.facet_margin(&wave.rate_at(step), &facet);
        let uncertainty = uncertainty(slack, rate, weight * wave.fastest());
        Some(TurningExit::Leaves(Exit { step, uncertainty, facet }))
    }

    /// Where `(μF_n)² - |F_t|²` first falls below zero.
    fn fall_of_the_square(&self, wave: &Wave<C>, most: f64) -> Option<Fall> {
        let square = |axis: usize, times: f64| {
            Trigonometric::square_of([&wave.constant, &wave.cosine, &wave.sine].map(|x| x[axis] * times))
        };
        let limit = square(0, self.cone().limit(1.0));
        let difference = (1..C).fold(limit, |sum, axis| sum.minus(&square(axis, 1.0)));
        let rounding = SQUARED * (self.cone().round_weight() * wave.size).powi(2);
        match Start::of(&difference, rounding, rounding) {
            Start::Above { roots } => difference.first_fall(most, rounding, roots),
            // What comes so near the apex is for the normal force to tell.
            Start::Falls | Start::Stays => None,
        }
    }

    /// Close to a double root the square has lost half the digits. The margin itself, μF_n - |F_t|, has not.
    fn polished(&self, wave: &Wave<C>, angle: f64) -> f64 {
        let cone = self.cone();
        let mut step = angle;
        for _ in 0..POLISHING_STEPS {
            let (at, rate) = (wave.at(step), wave.rate_at(step));
            let slope = cone.facet_margin(&rate, &outward(&at));
            let better = step - cone.round_margin(&at) / slope;
            if slope < 0.0 && better > 0.0 && (better - angle).abs() <= NEAR {
                step = better;
            }
        }
        step
    }
}

/// The direction of friction.
fn outward<const C: usize>(force: &SVector<f64, C>) -> SVector<f64, C> {
    let friction = tangential(force);
    friction / friction.norm().max(f64::MIN_POSITIVE)
}

/// How a margin begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Start {
    /// Above zero, at once or from so many roots on.
    Above { roots: usize },
    /// At zero, and below it from here on.
    Falls,
    /// It is zero all the way.
    Stays,
}

impl Start {
    /// Values are zero within `slack`, rates within `rate_slack`.
    fn of(margin: &Trigonometric, slack: f64, rate_slack: f64) -> Self {
        let [value, slope, bend] = margin.at_the_beginning();
        if value > slack || slope > rate_slack {
            Self::Above { roots: usize::from(value <= slack) }
        } else if slope < -rate_slack || bend < -rate_slack {
            Self::Falls
        } else if bend > rate_slack {
            Self::Above { roots: 2 }
        } else {
            Self::Stays
        }
    }
}

/// Where a linear function of what turns falls below zero.
fn linear_exit<const C: usize>(
    wave: &Wave<C>,
    seen: impl Fn(&SVector<f64, C>) -> f64,
    weight: f64,
    facet: SVector<f64, C>,
    most: f64,
) -> Option<TurningExit<C>> {
    let margin = wave.seen(&seen);
    let (slack, fastest) = (ZERO_SLACK * weight * wave.size, weight * wave.fastest());
    let step = match Start::of(&margin, slack, ZERO_SLACK * fastest) {
        Start::Stays => return None,
        Start::Falls => 0.0,
        Start::Above { roots } => match margin.first_fall(most, slack, roots)? {
            Fall::At(angle) => angle,
            Fall::Touches(angle) => return Some(TurningExit::Touches(angle)),
        },
    };
    let uncertainty = uncertainty(slack, seen(&wave.rate_at(step)), fastest);
    Some(TurningExit::Leaves(Exit { step, uncertainty, facet }))
}

/// How well a root is known of a function with this slope there, which is known to `slack` and bends as a wave of this size does.
fn uncertainty(slack: f64, slope: f64, size: f64) -> f64 {
    (slack / slope.abs()).min((2.0 * slack / size).sqrt())
}
