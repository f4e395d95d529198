//! Steps along an arc, a piece of the load path on which contacts keep their states (open, sticking or sliding) and directions of sliding turn. The
//! lengths of steps are arclengths. A leg is a section of the load program.
//!
//! Along an [`Arc`] the twist q, the fraction λ of the leg and the friction forces F_t satisfy a differential equation. Its right-hand side depends
//! on the directions of sliding alone:
//!
//! ```text
//! (q', λ') the null vector of [T | -b],     F_t' = C (a' λ' - Gᵀq')_t
//! ```
//!
//! T is the tangent stiffness of the object, and b the rate of its load (and of the forces of commands) per unit of λ, so that T q' = b λ'. Each
//! contact has the tangent stiffness C, the rate a' per unit of λ of the offset of its springs (commanded displacement minus clearance and slip), and
//! the grasp map G; the index t means tangential components. The rates q', λ' and F_t' are per unit of arclength. Thus a fold, where the load has a
//! maximum, is passed like any other point. The balance of forces is linear in all variables, and steps preserve it. The integration error of a step
//! moves friction forces off the surfaces of their cones. Newton's method transverse to the path puts them back.

use nalgebra::SVector;

use super::arc::{Arc, Direction};
use super::energy::LegEnergy;
use super::relaxation::Relaxation;
use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use super::watched_condition::is_vanishing;
use crate::contact::{State, Tangent, tangential, tangential_norm};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{
    Each, IntoList, Reals, Size, Stepped, Vector, explicit_step, implicit_step, mapped, summed,
};
use crate::object::{ForcesAndTwist, largest_force};
use crate::prelude::*;

/// The rule by which the differential equation is integrated in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    /// A straight step along the tangent, for steps so short that no direction of friction turns.
    Straight,
    /// An explicit rule of order 8, for directions of friction that turn about as fast as the object moves.
    Explicit,
    /// An implicit rule with the allowed relative error `tolerance`, for directions of friction that turn much faster than the object moves.
    Implicit { tolerance: f64 },
}

impl Rule {
    fn with_larger_error(self, times: f64) -> Self {
        if let Self::Implicit { tolerance } = self {
            Self::Implicit { tolerance: tolerance * times }
        } else {
            self
        }
    }
}

/// The fraction of the leg at which a step should end, and the distance from it within which the step is extended to end there.
#[derive(Debug, Clone, Copy)]
pub(super) struct StepGoal {
    factor: f64,
    /// A step that ends within this distance of the goal, as a fraction of the leg, is extended to the goal along the tangent.
    near: f64,
}

impl StepGoal {
    /// The goal at the fraction `factor` of the leg, after `trials` steps that missed it. Implicit steps have large rounding errors and may miss it
    /// again and again.
    pub(super) fn after(factor: f64, trials: usize) -> Self {
        // The distance `near`, within which a step is extended to the goal, is larger after sixteen trials, and again after thirty-two. The largest
        // distance, 1e-9, is no larger than the default error of steps.
        let near = match trials / 16 {
            0 => 2e-13,
            1 => 1e-11,
            _ => 1e-9,
        };
        Self { factor, near }
    }
}

/// The differential equation of an arc, on which contacts keep their states, with its initial point `point` on the path, at the fraction `from` of
/// the leg.
pub(super) struct Flow<'s, 'g> {
    arc: Arc<'s, 'g>,
    from: f64,
    /// The point of the path at the start of the step, with rates per unit of arclength.
    point: &'s PathPoint,
    /// Friction forces of the sliding contacts at the start of the step, N, in the order in which the arc lists them.
    begin: Vec<SVector<f64, 3>>,
    /// For each sliding contact: true if its normal force is at most 1e-7 of the terms whose sum it is, and still decreases. Its friction force must
    /// then be computed with a smaller error, so that the direction of this force stays accurate.
    vanishing: Vec<bool>,
    /// The largest force, N, and the largest displacement, m, at the start of the step, with which errors are compared.
    sizes: [f64; 2],
}

/// The fraction `to` of the leg and the path point at the end of a step, with the works that fingers, friction and load do in this step.
#[derive(Debug, Clone)]
pub(super) struct FlowStep {
    pub(super) to: f64,
    /// The path point at the end of the step: forces and twist, with their rates per unit of arclength.
    pub(super) point: PathPoint,
    pub(super) energy: LegEnergy,
    /// Estimated relative error of the step, computed by [`Flow::error_size`]. It is roughly the larger of two ratios: error of forces to largest
    /// force, and error of the twist to largest displacement. Zero for a straight step.
    pub(super) error: f64,
    /// Whether, anywhere in the step, some contact slipped against its friction force, or λ decreased. While the direction of the load turns, a
    /// decrease of λ does not count.
    pub(super) backwards: bool,
}

impl FlowStep {
    pub(super) fn state(&self) -> ForcesAndTwist {
        ForcesAndTwist {
            forces: mapped(&self.point.lines, &|line| line.force),
            twist: self.point.twist.clone(),
        }
    }
}

impl<'s, 'g> Flow<'s, 'g> {
    /// The differential equation of an arc on which contacts keep the states `states`, with its initial point `point` on the path, at the fraction
    /// `from` of the leg. Arclength is measured along the curve (q/`unit`, λ), with the twist q and the fraction λ.
    pub(super) fn new(
        segment: &'s Segment<'g>,
        states: &'s [State],
        from: f64,
        point: &'s PathPoint,
        unit: f64,
    ) -> Self {
        let sites = segment.grasp.sites();
        let offsets = segment.offsets(from);
        let load = segment.trajectory.at(from).norm();
        let forces = mapped(&point.lines, &|line| line.force.norm());
        let force =
            largest_force(sites, &offsets, &point.twist, load, forces.into_iter()).max(segment.largest);
        let span = sites.iter().zip(&offsets).map(|(site, a)| site.span(a, &point.twist)).most();
        let sizes = [force, span];
        // Along motions that no spring resists, the balance of forces does not determine the velocity of the object. The object keeps its present
        // velocity along them.
        let pushed = |v: &Vector| {
            let rate = v.dot(&point.twist_rate);
            // A velocity of the object along a free motion (a motion that no spring resists) is taken as rounding below the fraction `NEGLIGIBLE` of
            // the norm of the twist rate.
            if rate.abs() > NEGLIGIBLE * point.twist_rate.norm() { rate / point.factor_rate } else { 0.0 }
        };
        let free_motions = point.free_motions.iter().map(|v| (v, pushed(v)));
        let arc = Arc::new(segment, states, free_motions, (unit, point.fixed.clone()));
        // The friction force of a contact that has just closed is mere rounding, so its direction is taken from the contact state.
        let friction = |&i: &usize| {
            let size = tangential_norm(&point.lines[i].force);
            states[i].slide().map_or_else(SVector::zeros, |slide| slide.direction * size)
        };
        let begin = mapped(&arc.sliding, &friction);
        let vanishing = mapped(&arc.sliding, &|&i| is_vanishing(&point.lines[i]));
        Self { arc, from, point, begin, vanishing, sizes }
    }

    /// The direction of the path (the rates of the twist and of λ) at the start of the step.
    fn initial_direction(&self) -> Direction {
        Direction { twist: self.point.twist_rate.clone(), factor: self.point.factor_rate }
    }

    /// The largest rate at which the friction force of a sliding contact turns towards its slip, per unit of arclength. Zero if all
    /// [`Self::relaxations`] are negative.
    pub(super) fn fastest_relaxation(&self) -> f64 {
        self.relaxations().map(|(_, rate)| rate).most()
    }

    /// For each sliding contact its index and the rate, per unit of arclength, at which its friction force at the start turns towards its slip. The
    /// rate is the stiffness across the slip times the slip rate along the friction force, divided by the friction force. Zero without friction
    /// force.
    pub(super) fn relaxations(&self) -> impl Iterator<Item = (usize, f64)> {
        let rate = |(&i, friction): (&usize, &SVector<f64, 3>)| {
            let tangent = self.arc.tangent(i, friction);
            let Tangent::Sliding { stiffness, .. } = tangent else { return 0.0 };
            let [stretch, force] = self.arc.rates(i, &tangent, &self.initial_direction());
            let slip = self.arc.sites()[i].springs.slip(&stretch, &force);
            let square = friction.norm_squared();
            if square > 0.0 { stiffness * slip.dot(friction) / square } else { 0.0 }
        };
        self.arc.sliding.iter().zip(&self.begin).map(move |(i, friction)| (*i, rate((i, friction))))
    }

    /// Makes a step of the arclength `length`. If λ at its end is within the distance `goal.near` of `goal.factor`, the step is extended to end at
    /// `goal.factor`. `None` if the integration does not converge, if friction forces cannot be put back onto their cones, or if the path has no
    /// unique direction.
    pub(super) fn step(&self, length: f64, goal: StepGoal, rule: Rule) -> Option<FlowStep> {
        let mut backwards = false;
        let mut rate = |y: &[f64], out: &mut [f64]| self.rate(y, out).map(|back| backwards |= back);
        let [load, works] = self.places();
        // The works of fingers, friction and load, and the sum of their absolute values, are integrated together with forces and twist.
        let mut first = vec![0.0; works + 4];
        rate(&first.clone(), &mut first)?;
        let size = |error: &[f64]| self.error_size(error, length);
        let Stepped { change: y, error } = match rule {
            Rule::Straight => Stepped { change: mapped(&first, &|rate| rate * length), error: 0.0 },
            Rule::Explicit => explicit_step(length, &first, rate, size)?,
            Rule::Implicit { tolerance } => {
                let relaxation = Relaxation::new(&self.arc, &self.begin, self.from, self.initial_direction());
                let damped = |part: f64| {
                    let factors = relaxation.damped(part)?;
                    let relaxation = &relaxation;
                    Some(move |x: &mut [f64]| relaxation.solve(&factors, x))
                };
                implicit_step(length, &first, rate, damped, size, tolerance)?
            }
        };
        let twist = &self.point.twist + self.twist_change(&y);
        let factor = self.from + y[load];
        let mut frictions: Vec<_> = self.frictions(&y).list();
        let tangents = self.arc.tangents(frictions.iter().copied());
        let direction = self.arc.direction(&tangents, factor, &self.initial_direction())?;
        let stays = |factor: f64| (factor - goal.factor).abs() <= goal.near;
        // If the integrated step ends farther than `near` from its goal, friction forces are corrected onto their cones. This correction also changes
        // λ, which may then be within the distance `near` of the goal.
        let arrived = if stays(factor) {
            None
        } else {
            Some(self.arc.balanced(twist.clone(), factor, &direction, &frictions)?)
        };
        let (twist, factor) = arrived.as_ref().map_or((twist, factor), |(at, to)| (at.twist.clone(), *to));
        let (at, to) = match arrived {
            Some(arrived) if !stays(factor) => arrived,
            _ => {
                // The rest of the step, up to the goal, follows the tangent of the path, and friction forces change along it.
                let rest = (goal.factor - factor) / direction.factor;
                for ((&i, tangent), friction) in self.arc.sliding.iter().zip(&tangents).zip(&mut frictions) {
                    *friction += tangential(&self.arc.rates(i, tangent, &direction)[1]) * rest;
                }
                self.arc.balanced(
                    twist + &direction.twist * rest,
                    goal.factor,
                    &Direction::forward(),
                    &frictions,
                )?
            }
        };
        let rate =
            ForcesAndTwist { forces: self.arc.force_rates(&tangents, &direction), twist: direction.twist };
        let [finger_work, dissipated, load_work, turnover] = [0, 1, 2, 3].each(|k| y[works + k]);
        let mut energy = LegEnergy { load_work, finger_work, stored: 0.0, dissipated, turnover };
        let before: Vec<_> = mapped(&self.point.lines, &|line| line.force);
        energy.store(self.arc.sites(), &before, &at.forces);
        let point = self.arc.segment.point_on_arc(self.point, to, &at, &rate, direction.factor);
        Some(FlowStep { to, point, energy, error, backwards })
    }

    /// Indices, from 0 in the list of integrated variables, of λ and of the first of four works. The list begins with two friction components for
    /// each sliding contact, then the twist and λ. Then come the works of fingers, friction and load, and the sum of their absolute values.
    fn places(&self) -> [usize; 2] {
        let load = 2 * self.begin.len() + self.size().count();
        [load, load + 1]
    }

    fn size(&self) -> Size {
        self.arc.segment.grasp.size()
    }

    /// The change of the twist since the start of a step, from the list `y` of the changes of all variables.
    fn twist_change(&self, y: &[f64]) -> Vector {
        let first = 2 * self.begin.len();
        Vector::from_fn(self.size(), |k| y[first + k])
    }

    /// Writes the rates of all integrated variables, per unit of arclength, to `out`; `y` are their changes since the start of the step. Returns
    /// whether a contact slips against its friction force or, unless the load turns, λ decreases. `None` if the path has no unique direction.
    fn rate(&self, y: &[f64], out: &mut [f64]) -> Option<bool> {
        let [load, works] = self.places();
        let segment = self.arc.segment;
        let tangents = self.arc.tangents(self.frictions(y));
        let direction = self.arc.direction(&tangents, self.from + y[load], &self.initial_direction())?;
        let count = self.size().count();
        out[load - count..load].iter_mut().enumerate().for_each(|(k, out)| *out = direction.twist[k]);
        out[load] = direction.factor;
        let [mut heat, mut turnover, mut backwards] = [0.0, 0.0, 0.0_f64];
        let own = out.chunks_exact_mut(2).zip(&self.arc.sliding).zip(&self.vanishing).zip(&tangents);
        for ((((out, &i), &vanishes), tangent), friction) in own.zip(self.frictions(y)) {
            let [stretch, force] = self.arc.rates(i, tangent, &direction);
            out.copy_from_slice(&force.as_slice()[1..]);
            let site = &self.arc.sites()[i];
            let dissipated = friction.dot(&site.springs.slip(&stretch, &force));
            // The power of friction (friction force times slip rate) may be negative by rounding. The allowed amount is 1e-13 times the friction
            // force times the displacement rate of the contact.
            let rounding = 1e-13
                * friction.norm()
                * site.span(&(segment.change[i] * direction.factor), &direction.twist);
            if !vanishes {
                backwards = backwards.max(-dissipated - rounding);
            }
            heat += dissipated;
            turnover += dissipated.abs();
        }
        let fingers = if self.arc.driven { self.power_of_fingers(y) * direction.factor } else { 0.0 };
        let worked = segment.trajectory.at(self.from + y[load]).component_mul(&direction.twist);
        turnover += fingers.abs() + worked.map(f64::abs).sum();
        out[works..].copy_from_slice(&[fingers, heat, worked.sum(), turnover]);
        let is_straight = matches!(segment.trajectory, Trajectory::Straight { .. });
        // A rate λ' above -1e-8 per unit of arclength does not count as a decrease. The path turns by about 1 rad per unit of arclength. At the
        // distance s beyond a maximum λ* of λ, λ' is therefore about -s, and λ about λ* - s²/2. At the rate λ' = -1e-8, λ is below its maximum by
        // less than 1e-16, i.e. by rounding.
        Some(backwards > 0.0 || is_straight && direction.factor < -1e-8)
    }

    /// Friction forces of the sliding contacts, N, in the order in which the arc lists them, after the changes `y` of all variables since the start.
    fn frictions(&self, y: &[f64]) -> impl Iterator<Item = SVector<f64, 3>> {
        self.begin.iter().zip(y.chunks_exact(2)).map(|(begin, change)| {
            let mut force = *begin;
            change.iter().enumerate().for_each(|(a, change)| force[a + 1] += change);
            force
        })
    }

    /// Work that the commanded fingers do, per unit of λ: the sum of F·a' over the contacts. F is the contact force, and a' the rate of the offset of
    /// the contact's springs. `y` are the changes of all integrated variables since the start of the step.
    fn power_of_fingers(&self, y: &[f64]) -> f64 {
        let [load, _] = self.places();
        let (moved, further) = (self.twist_change(y), y[load]);
        let mut frictions = self.frictions(y);
        let mut sum = 0.0;
        for (i, (state, site)) in self.arc.states.iter().zip(self.arc.sites()).enumerate() {
            let change = &self.arc.segment.change[i];
            let mut force = self.point.lines[i].force;
            let more = site.springs.force(&site.stretch(&(change * further), &moved));
            if state.slides() {
                let normal = force[0] + more[0];
                force = frictions.next().unwrap_or(force);
                force[0] = normal;
            } else if state.is_sticking() {
                force += more;
            }
            sum += force.dot(change);
        }
        sum
    }

    /// Relative magnitude of the integration error `error` of all variables in a step of arclength `length`: the largest of several ratios. Errors of
    /// friction forces and of the load are compared with the largest force, the error of the twist with the largest displacement.
    fn error_size(&self, error: &[f64], length: f64) -> f64 {
        let count = self.size().count();
        let size = |k: usize| self.sizes[k] + length * self.point.rate_sizes[k];
        let [force, travel] = [0, 1].each(size);
        let (of_frictions, others) = error.split_at(2 * self.arc.sliding.len());
        let norm = |part: &[f64]| summed(part, &|e| e * e).sqrt();
        let of_forces = of_frictions.chunks_exact(2).map(norm).most();
        let with_sizes = of_frictions.chunks_exact(2).zip(&self.begin).zip(&self.vanishing);
        let vanishing = with_sizes.filter(|(_, vanishes)| **vanishes).map(|(of_one, _)| of_one);
        // An error of a friction force is compared with the largest force. For a vanishing friction force, 1e-6 times its error is also compared with
        // the force itself. The error of this force's direction is thus at most 1e6 times the allowed error of a step; without this comparison it has
        // no bound.
        let of_itself = |(error, friction): (&[f64], &SVector<f64, 3>)| 1e-6 * norm(error) / friction.norm();
        let of_themselves = vanishing.map(of_itself).most();
        let of_load = others[count].abs() * self.arc.load_rate(self.from);
        (norm(&others[..count]) / travel).max(of_forces / force).max(of_load / force).max(of_themselves)
    }

    /// The step from the starting point of this arc to the fraction `goal` of the leg, if its arclength is less than `most`. `None` if sixty trials
    /// do not find it or a trial fails.
    pub(super) fn step_to_factor(&self, goal: f64, most: f64, rule: Rule) -> Option<FlowStep> {
        let (mut low, mut high) = (0.0, most);
        let mut length = (goal - self.from) / self.point.factor_rate;
        for trial in 0..60 {
            if !(length > low && length < high) {
                length = 0.5 * (low + high);
            }
            // After sixteen trials a step may end farther from the goal and still be extended to it (up to 1e-9 of the leg, by [`StepGoal::after`]).
            let goal_here = StepGoal::after(goal, trial);
            // The allowed error of an implicit rule is multiplied by these factors in turn, since rounding may prevent smaller errors.
            let mut rules = [1.0, 10.0, 100.0, 1000.0].into_iter().map(|times| rule.with_larger_error(times));
            let reached = rules.find_map(|rule| self.step(length, goal_here, rule))?;
            if reached.to == goal {
                return Some(reached);
            }
            if reached.to > goal {
                high = length;
            } else {
                low = length;
            }
            length += (goal - reached.to) / reached.point.factor_rate;
        }
        None
    }
}
