//! The angle by which a load can turn before a contact leaves its state. The end of a contact's state under a turning load is called an exit.
//!
//! As long as no contact changes its state, a contact force is `F(φ) = F₀ + F_c cos φ + F_s sin φ` at the angle φ of the load. Gaps, and friction
//! margins `μ F_n - h·F_t` at facets with normal h, have the same form. On the round cone `(μF_n)² - |F_t|²` is a trigonometric polynomial of degree
//! two. The apex of a friction cone is zero force.

use nalgebra::SVector;

use super::exits::Exit;
use super::law::LocalLaw;
use super::state::{Mode, State};
use super::tangential::tangential;
use super::tolerances::ZERO_SLACK;
use crate::numerics::tolerances::ROUNDED_SUM;
use crate::numerics::{FirstZero, Harmonic, Trigonometric, Turning};
use crate::prelude::*;

/// A contact force, or a displacement of the body relative to the finger, as a function of the angle φ. The load has turned by φ from its present
/// direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wave {
    pub(crate) of: Harmonic<SVector<f64, 3>>,
    /// Rounding scale of the values of the vector, N or m: the magnitude to which their rounding error is proportional.
    pub(crate) size: f64,
    /// Magnitude of the terms with cos φ and sin φ, N or m, to which the rounding error of the rates is proportional.
    pub(crate) turning_size: f64,
}

impl Wave {
    /// Applies the linear function `by` to this vector. The result is a scalar function of the load's angle φ.
    fn component(&self, by: impl Fn(&SVector<f64, 3>) -> f64) -> Trigonometric {
        Trigonometric::linear(&self.of.map(by))
    }
}

/// What happens at a contact while the load turns: it leaves its state, or its force only touches the boundary of the friction cone.
#[derive(Debug, Clone, Copy)]
pub(crate) enum TurningExit {
    /// The contact leaves its state; `step` of the exit is the angle, rad.
    Leaves(Exit),
    /// At this angle, rad, the force touches the boundary of the cone to within rounding, without crossing it.
    Touches(f64),
}

impl LocalLaw<'_> {
    /// All exits of a contact from a state at angles of the load from 0 to `most`, rad. `force` and `stretch` of the contact are given as functions
    /// of the angle. Each condition of the state has at most one exit, at the first angle where it fails. A slide on the round cone has none in this
    /// list, since its force does not respond linearly to the load.
    pub(crate) fn turning_exits(
        &self,
        state: &State,
        [force, stretch]: [&Wave; 2],
        most: f64,
    ) -> Vec<TurningExit> {
        let nowhere = SVector::zeros();
        let mut exits = Vec::new();
        match state {
            Mode::Round(_) => {}
            Mode::Open => exits.extend(linear_exit(stretch, &|v| -v[0], 1.0, nowhere, most)),
            Mode::Sticking if self.has_a_round_edge() => exits.extend(self.round_turning_exit(force, most)),
            Mode::Sticking | Mode::Facet(_) | Mode::Corner(_) if self.is_bonded() => {}
            Mode::Sticking | Mode::Facet(_) | Mode::Corner(_) => {
                let (cone, facets) = (self.cone(), self.facets());
                let own = state.own_facets(facets.len());
                if facets.is_empty() && self.may_open() {
                    exits.extend(linear_exit(force, &|f| f[0], 1.0, nowhere, most));
                }
                for (j, h) in facets.iter().enumerate().filter(|(j, _)| !own.contains(&Some(*j))) {
                    let margin = |f: &SVector<f64, 3>| cone.facet_margin(f, h);
                    exits.extend(linear_exit(force, &margin, cone.facet_weight(h), facets[j], most));
                }
                exits.extend(self.stops(state, [force, stretch], most));
            }
        }
        exits
    }

    /// The angles at which a sliding contact stops sliding, at most one for each facet on which it slides. At such an angle the rate of the slip
    /// component along the facet's normal, per radian of the turn, becomes negative. Until then the contact stays on its facets.
    fn stops(
        &self,
        state: &State,
        [force, stretch]: [&Wave; 2],
        most: f64,
    ) -> impl Iterator<Item = TurningExit> {
        let rate = Harmonic {
            constant: SVector::zeros(),
            cosine: self.springs.slip(&stretch.of.sine, &force.of.sine),
            sine: -self.springs.slip(&stretch.of.cosine, &force.of.cosine),
        };
        let give = |force: &SVector<f64, 3>| self.springs.deflection(force).lp_norm(1);
        let size = stretch.turning_size + give(&force.of.cosine) + give(&force.of.sine);
        let rate = Wave { of: rate, size, turning_size: size };
        let facets = self.facets();
        let own = state.own_facets(facets.len());
        (0..2).filter_map(move |k| {
            let (facet, [_, weight]) = (facets[own[k]?], self.slips_along(state, &rate.of.cosine)[k]?);
            let along =
                |slip: &SVector<f64, 3>| self.slips_along(state, slip)[k].map_or(0.0, |[value, _]| value);
            linear_exit(&rate, &along, weight, facet, most)
        })
    }

    /// The exit of a force from the round cone while the load turns, at an angle of at most `most`, rad. At this angle `(μF_n)² - |F_t|²` becomes
    /// negative, or F_n if the force passes through the apex. A force that only touches the cone gives [`TurningExit::Touches`]. `None` if the force
    /// stays inside the cone.
    fn round_turning_exit(&self, wave: &Wave, most: f64) -> Option<TurningExit> {
        let cone = self.cone();
        let weight = cone.round_weight();
        let slack = ZERO_SLACK * wave.size * weight;
        let here = wave.of.at(0.0);
        let friction = tangential(&here);
        if cone.round_margin(&here) <= slack && friction.norm() > slack {
            // On the boundary of the cone, the friction margin at the tangent facet decides whether the force moves inwards or outwards.
            let outward = friction.normalize();
            let margin = wave.component(|f| cone.facet_margin(f, &outward));
            if Start::of(&margin, slack, ZERO_SLACK * weight * wave.turning_size) == Start::Falls {
                return linear_exit(wave, &|f| cone.facet_margin(f, &outward), weight, outward, most);
            }
        }
        let apex = linear_exit(wave, &|f| f[0], 1.0, SVector::zeros(), most);
        let Some(step) = self.fall_of_the_square(wave, most) else { return apex };
        let step = match step {
            FirstZero::At(angle) => self.polished(wave, angle),
            FirstZero::Touches(angle) => return apex.or(Some(TurningExit::Touches(angle))),
        };
        // If the force leaves the cone through its apex, normal force and friction force vanish together. The zero of the normal force (`apex`) is
        // then the exit.
        if let Some(TurningExit::Leaves(through)) = apex
            && (through.step <= step || tangential(&wave.of.at(through.step)).norm() <= slack)
        {
            return apex;
        }
        let facet = outward(&wave.of.at(step));
        let rate = cone.facet_margin(&wave.of.rate_at(step), &facet);
        let uncertainty = uncertainty(slack, rate, weight * wave.turning_size);
        Some(TurningExit::Leaves(Exit { step, uncertainty, facet }))
    }

    /// The first angle of the load up to `most`, rad, at which `(μF_n)² - |F_t|²` becomes negative, or touches zero. `None` without such an angle,
    /// and if the difference is not positive just after the start.
    fn fall_of_the_square(&self, wave: &Wave, most: f64) -> Option<FirstZero> {
        let limit = self.cone().limit(1.0);
        let margin = Turning { number: wave.of.map(|x| limit * x[0]), vector: wave.of.map(tangential) };
        let difference = margin.square();
        // Rounding error of the difference (μF_n)² - |F_t|², N².
        let rounding = ROUNDED_SUM * (self.cone().round_weight() * wave.size).powi(2);
        match Start::of(&difference, rounding, rounding) {
            Start::Above { roots } => difference.first_fall(most, rounding, roots),
            // The difference (μF_n)² - |F_t|² is not positive just after the start, as near the apex of the cone. The caller then uses the angle at
            // which the normal force vanishes.
            Start::Falls | Start::Stays => None,
        }
    }

    /// Refines an angle by Newton's method on the margin μF_n - |F_t|. Close to a double root the difference of squares has lost half of its digits,
    /// but the margin has not.
    fn polished(&self, wave: &Wave, angle: f64) -> f64 {
        let cone = self.cone();
        let mut step = angle;
        // Three Newton steps follow; each doubles the number of correct digits of the root.
        for _ in 0..3 {
            let (at, rate) = (wave.of.at(step), wave.of.rate_at(step));
            let slope = cone.facet_margin(&rate, &outward(&at));
            let better = step - cone.round_margin(&at) / slope;
            // A Newton step is accepted only if it ends within 1e-3 rad of the given angle. That limit is well above the error of the given angle,
            // which is the square root of the rounding error of squares.
            if slope < 0.0 && better > 0.0 && (better - angle).abs() <= 1e-3 {
                step = better;
            }
        }
        step
    }
}

/// The unit vector of the friction force, and so the outward normal of the round cone's tangent facet; zero without friction.
fn outward(force: &SVector<f64, 3>) -> SVector<f64, 3> {
    let friction = tangential(force);
    friction / friction.norm().max(f64::MIN_POSITIVE)
}

/// The behaviour of a margin, a quantity that must stay positive, at the start of a turn of the load, φ = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Start {
    /// The margin is positive for small φ > 0. `roots` is the number of its roots that lie at φ = 0 up to rounding.
    Above { roots: usize },
    /// The margin is zero at φ = 0 and negative just after it.
    Falls,
    /// The margin is zero at every angle of the load.
    Stays,
}

impl Start {
    /// Classifies a margin, a quantity that must stay positive, at the start of a turn of the load. A value up to `slack` counts as zero, and so does
    /// a rate up to `rate_slack`.
    fn of(margin: &Trigonometric, slack: f64, rate_slack: f64) -> Self {
        let [value, slope, bend] = margin.at_the_beginning();
        // The load at φ = 0 has a rounding error, since this load is the computed end of the previous part of the load path. A margin that is zero at
        // the start and then grows may therefore appear to decrease first, but by no more than the slack.
        let dips = bend > 0.0 && value - 0.5 * slope * slope / bend >= -slack;
        if value > slack || slope > rate_slack {
            Self::Above { roots: usize::from(value <= slack) }
        } else if slope < -rate_slack && dips {
            Self::Above { roots: 0 }
        } else if slope < -rate_slack || bend < -rate_slack {
            Self::Falls
        } else if bend > rate_slack {
            Self::Above { roots: 2 }
        } else {
            Self::Stays
        }
    }
}

/// The exit at the first angle up to `most` at which `component`, a linear function of the wave's vector, becomes negative or touches zero. `None`
/// without such an angle.
fn linear_exit(
    wave: &Wave,
    component: &dyn Fn(&SVector<f64, 3>) -> f64,
    weight: f64,
    facet: SVector<f64, 3>,
    most: f64,
) -> Option<TurningExit> {
    let margin = wave.component(component);
    let (slack, fastest) = (ZERO_SLACK * weight * wave.size, weight * wave.turning_size);
    let step = match Start::of(&margin, slack, ZERO_SLACK * fastest) {
        Start::Stays => return None,
        Start::Falls => 0.0,
        Start::Above { roots } => match margin.first_fall(most, slack, roots)? {
            FirstZero::At(angle) => angle,
            FirstZero::Touches(angle) => return Some(TurningExit::Touches(angle)),
        },
    };
    let uncertainty = uncertainty(slack, component(&wave.of.rate_at(step)), fastest);
    Some(TurningExit::Leaves(Exit { step, uncertainty, facet }))
}

/// Rounding error of a root of a function of the load's angle. The values of the function have the error `slack`; `slope` is its derivative at the
/// root, and `size` an upper bound of the magnitude of its second derivative.
fn uncertainty(slack: f64, slope: f64, size: f64) -> f64 {
    (slack / slope.abs()).min((2.0 * slack / size).sqrt())
}
