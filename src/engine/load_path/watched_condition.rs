//! The conditions that must hold along an arc, a piece of the path on which directions of sliding turn. Each is a value that must stay positive, such
//! as the gap of an open contact. Where such a value becomes zero, the piece ends. A leg is a section of the load program; λ is the fraction of the
//! leg that is done. Rounding errors of a value are proportional to its rounding scale (`size`), the magnitude of the terms from which it is
//! computed.

use super::segment::{PathPoint, Segment};
use super::tolerances::{SLACK_ON_AN_ARC, VANISHING_NORMAL};
use super::trajectory::Trajectory;
use crate::contact::{Line, Mode, State, tangential, tangential_norm};
use crate::numerics::Each;
use crate::prelude::*;

/// The condition that is watched along an arc, named by what it concerns: a contact, the growth of λ, or the end of the leg.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WatchedCondition {
    /// The contact with this index satisfies the condition of its present state, such as a positive gap if it is open.
    Contact(usize),
    /// λ grows along the arc: its rate per unit of arclength is positive.
    Growth,
    /// λ is below 1, its value at the end of the leg.
    Leg,
}

/// The value that a condition requires to be positive, at one point of an arc, with its rounding scale `size`.
#[derive(Debug, Clone, Copy)]
pub(super) struct ConditionValue {
    pub(super) what: WatchedCondition,
    pub(super) value: f64,
    /// The rate of the value per unit of arclength, and the rounding scale of this rate. `None` if the rate is not known.
    rate: Option<[f64; 2]>,
    size: f64,
}

impl ConditionValue {
    /// Whether the value is negative by more than rounding and the integration error of steps.
    pub(super) fn is_violated(&self) -> bool {
        self.value < -SLACK_ON_AN_ARC * self.size
    }

    /// Whether the value is zero up to rounding and the integration error of steps.
    pub(super) fn is_met(&self) -> bool {
        self.value.abs() <= SLACK_ON_AN_ARC * self.size
    }

    /// Whether the value is certainly negative, i.e. by more than a thousand times rounding and the integration error of steps.
    pub(super) fn is_broken(&self) -> bool {
        self.value < -1e3 * SLACK_ON_AN_ARC * self.size
    }

    /// Whether the value decreases along the arc by more than rounding, or has an unknown rate. A constant value, such as a margin that stays zero,
    /// does not decrease. Therefore contacts that do not move stay on the boundary of their cones while others slide.
    pub(super) fn falls(&self) -> bool {
        self.rate.is_none_or(|[rate, size]| rate < -SLACK_ON_AN_ARC * size)
    }

    /// The arclength (positive or negative) after which the value becomes zero by linear extrapolation; `None` if the rate is unknown or zero.
    pub(super) fn way(&self) -> Option<f64> {
        self.rate.map(|[rate, _]| self.value / -rate).filter(|way| way.is_finite())
    }
}

/// Whether the normal force of a sliding contact is at most the fraction `VANISHING_NORMAL` (1e-7) of the terms whose sum it is, and still decreases.
/// Such a force no longer determines the direction of friction.
pub(super) fn is_vanishing(line: &Line) -> bool {
    line.rate[0] < 0.0 && line.force[0] <= VANISHING_NORMAL * line.force_size
}

/// Whether the normal force of a sliding contact is negative by at most the fraction `VANISHING_NORMAL` (1e-7) of the terms whose sum it is. The last
/// step should have ended where the normal force vanishes; it went farther because the direction of friction was not accurate enough.
pub(super) fn has_vanished(line: &Line) -> bool {
    line.force[0] < 0.0 && line.force[0] >= -VANISHING_NORMAL * line.force_size
}

/// The conditions that must hold along an arc while contacts keep the states `states`. They are evaluated at the point `point` of the arc, at the
/// fraction `factor` of the leg. For a sticking contact the value is μ F_n - |F_t|, or F_n where friction is infinite or zero; for an open contact
/// the gap. For a sliding contact the values are the slip rate along the friction force, and F_n.
pub(super) fn watch(
    segment: &Segment<'_>,
    states: &[State],
    (factor, point): (f64, &PathPoint),
) -> Vec<ConditionValue> {
    // The rate of λ per unit of arclength, at most 1, is taken as zero up to 1e-8. When it is zero, λ is at a maximum. Near a maximum, the path turns
    // by about 1 rad per unit of arclength. At a rate of 1e-8, λ thus differs from its maximum by about 1e-16, i.e. by rounding.
    let mut list = vec![
        ConditionValue {
            what: WatchedCondition::Growth,
            value: point.factor_rate,
            rate: None,
            size: 1e-8 / SLACK_ON_AN_ARC,
        },
        ConditionValue {
            what: WatchedCondition::Leg,
            value: 1.0 - factor,
            rate: Some([-point.factor_rate, 1.0]),
            size: 1.0,
        },
    ];
    // If the load changes linearly, a value that changes by less than its rounding error over the rest of the leg is taken as constant. While the
    // load turns, a rate that is zero at this point may grow, so no value is taken as constant.
    let straight = matches!(segment.trajectory, Trajectory::Straight { .. });
    // The rate of a value counts as rounding up to `size * per_length`. A rate of this magnitude changes the value by its rounding error over the
    // rest of the leg. The rest is taken as at least a hundredth of the leg, since at the end of the leg it is zero.
    let per_length = point.factor_rate / (1.0 - factor).max(0.01);
    for (contact, state) in states.iter().enumerate() {
        let (line, local) = (&point.lines[contact], segment.problem.local(contact));
        let mut push = |value, rate: Option<[f64; 2]>, size: f64| {
            let slow = |rate_size: f64| if straight { rate_size.max(size * per_length) } else { 0.0 };
            let rate = rate.map(|[rate, rate_size]| [rate, slow(rate_size)]);
            list.push(ConditionValue { what: WatchedCondition::Contact(contact), value, rate, size });
        };
        match state {
            Mode::Open if local.is_absent() => {}
            Mode::Open => {
                let gap = &point.gaps[contact];
                push(gap.gap, Some([gap.rate, gap.rate_size]), gap.size);
            }
            Mode::Sticking if local.may_slide() => {
                let (friction, change) = (tangential(&line.force), tangential(&line.rate));
                let used = friction.norm();
                let rate = if used > 0.0 { friction.dot(&change) / used } else { change.norm() };
                let cone = local.cone();
                let [size, rate_size] =
                    [line.force_size, line.rate_size].each(|size| size * cone.round_weight());
                let rate = cone.limit(line.rate[0]) - rate;
                push(cone.limit(line.force[0]) - used, Some([rate, rate_size]), size);
            }
            Mode::Sticking if local.may_open() => {
                push(line.force[0], Some([line.rate[0], line.rate_size]), line.force_size);
            }
            Mode::Sticking => {}
            // With almost no normal force, rounding alone determines whether the contact stops sliding. The condition of the contact is therefore
            // taken as satisfied.
            _ if is_vanishing(line) => push(f64::INFINITY, None, 1.0),
            _ => {
                let p = tangential(&line.force) / tangential_norm(&line.force);
                let site = &segment.grasp.sites()[contact];
                let change = segment.change[contact] * point.factor_rate;
                let moving = site.stretch(&change, &point.twist_rate);
                let give = tangential(&site.springs.deflection(&line.rate));
                push(p.dot(&(moving - give)), None, point.gaps[contact].rate_size + give.lp_norm(1));
            }
        }
    }
    list
}
