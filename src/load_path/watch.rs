//! What has to stay positive along a sliding arc.

use super::arc::tangential;
use super::margin::{Line, ROUNDING};
use super::segment::{Here, Segment};
use crate::formulation::{Law, State};

/// On an arc a value carries the error of the steps besides rounding.
const ERROR_OF_STEPS: f64 = 1e-13;

/// The normal force of a sliding contact on its way to zero is known, and with it the direction of its friction, to the error of the steps over this
/// part of its size: too little below.
const VANISHING: f64 = 1e-7;

/// One condition of one contact, with its rate where it is known, and what its rounding is measured against.
#[derive(Debug, Clone, Copy)]
pub(super) struct Watch {
    pub(super) contact: usize,
    pub(super) value: f64,
    rate: Option<f64>,
    size: f64,
}

impl Watch {
    /// Clearly negative.
    pub(super) fn is_violated(&self) -> bool {
        self.value < -(ROUNDING + ERROR_OF_STEPS) * self.size
    }

    /// Zero, as far as can be told.
    pub(super) fn is_met(&self) -> bool {
        self.value.abs() <= (ROUNDING + ERROR_OF_STEPS) * self.size
    }

    /// Not known to grow.
    pub(super) fn falls(&self) -> bool {
        self.rate.is_none_or(|rate| rate < 0.0)
    }

    /// The way to zero along the tangent.
    pub(super) fn way(&self) -> Option<f64> {
        self.rate.map(|rate| self.value / -rate).filter(|way| way.is_finite())
    }
}

/// Whether a sliding contact has all but lost its normal force.
pub(super) fn is_vanishing<const C: usize>(line: &Line<C>) -> bool {
    line.rate[0] < 0.0 && line.force[0] <= VANISHING * line.force_size
}

/// The conditions in these states.
pub(super) fn watch<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    states: &[State],
    here: &Here<D, C>,
) -> Vec<Watch> {
    let mut list = Vec::new();
    for (contact, state) in states.iter().enumerate() {
        let (line, site) = (&here.lines[contact], &segment.grasp.sites()[contact]);
        let mut push = |value, rate, size| list.push(Watch { contact, value, rate, size });
        match state {
            State::Open if segment.problem.laws[contact] == Law::Absent => {}
            State::Open => {
                let [gap, rate, span, _] = here.gaps[contact];
                push(gap, Some(rate), span);
            }
            State::Rolling if segment.problem.may_slide(contact) => {
                let (friction, change) = (tangential(&line.force), tangential(&line.rate));
                let used = friction.norm();
                let rate = if used > 0.0 { friction.dot(&change) / used } else { change.norm() };
                push(
                    site.mu * line.force[0] - used,
                    Some(site.mu * line.rate[0] - rate),
                    line.force_size * (1.0 + site.mu),
                );
            }
            State::Rolling if segment.problem.may_open(contact) => {
                push(line.force[0], Some(line.rate[0]), line.force_size);
            }
            State::Rolling => {}
            // Whether what is about to vanish sticks on the way there is decided by rounding.
            State::Sliding { .. } if is_vanishing(line) => {
                push(f64::INFINITY, None, 1.0);
            }
            State::Sliding { .. } => {
                let p = tangential(&line.force).normalize();
                let moving = segment.change[contact] - site.map.tr_mul(&here.twist_rate);
                let slip: f64 = (1..C).map(|a| p[a] * (moving[a] - line.rate[a] / site.k[a])).sum();
                let give: f64 = (1..C).map(|a| (line.rate[a] / site.k[a]).abs()).sum();
                let [_, _, _, span_rate] = here.gaps[contact];
                push(slip, None, span_rate + give);
            }
        }
    }
    list
}
