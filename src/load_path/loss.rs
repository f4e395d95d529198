//! How a path ends where the rates have no solution.

use nalgebra::SVector;

use super::beyond::just_beyond;
use super::event::{Loss, PathEnd};
use super::segment::Segment;
use crate::equilibrium::{Effort, Settings, Settled, separates_from_here_on};
use crate::formulation::{Piece, Problem, State};

/// Names the end: a motion that nothing resists, a limit load if the motion with which the object leaves proves one, and else
/// what a search among all combinations of states says.
pub(super) fn end_of_path<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    rates: &Problem<D, C>,
    settled: Settled<D, C>,
    effort: &Effort,
    sliding: &[State],
    mut loss: Loss<D>,
    settings: &Settings,
) -> PathEnd<D, C> {
    if let Settled::FreeMotion(v) = settled {
        let motion = segment.grasp.outside(&v);
        return PathEnd::GivesWay { leg: loss.leg, fraction: loss.fraction, motion };
    }
    let here = segment.problem_at(loss.fraction);
    let motion = leaving_motion(rates, &here.wrench, sliding);
    loss.motion = motion.map(|v| segment.grasp.outside(&v));
    if motion.is_some_and(|v| separates_from_here_on(&here, &v, &rates.wrench)) {
        return PathEnd::LimitLoad(loss);
    }
    let beyond = just_beyond(segment.grasp, &here, rates, settled, effort, settings, segment.cone);
    PathEnd::from_beyond(&beyond, loss)
}

/// The unit motion with which the object leaves when everything that stands on an edge slides: a motion that nothing resists
/// then, on which the load works; or else the motion of the rates in these states, which would balance the load if only the
/// slips were not against friction: taken the other way, they are along it.
fn leaving_motion<const D: usize, const C: usize>(
    rates: &Problem<D, C>,
    load: &SVector<f64, D>,
    states: &[State],
) -> Option<SVector<f64, D>> {
    let piece = Piece::new(rates, states);
    let solved = match piece.solve(&rates.drives, &rates.wrench) {
        Err(unbalanced) => {
            // Where friction is exhausted no spring resists, but the friction forces feel the motion. Where only commands
            // change it is the load itself that drives the object out.
            let along = |wrench: &SVector<f64, D>| {
                let v = piece.free_motions().iter().fold(SVector::zeros(), |sum, v| sum + v * v.dot(wrench));
                (v.norm() > 0.0).then(|| v.normalize())
            };
            return unbalanced.motion.or_else(|| along(&rates.wrench)).or_else(|| along(load));
        }
        Ok(solved) => solved,
    };
    let mut along_friction = 0.0;
    for (i, state) in states.iter().enumerate() {
        if let State::Sliding { first, second } = *state {
            let site = &rates.sites[i];
            let stretch = rates.drives[i] - site.map.tr_mul(&solved.twist);
            let normals = rates.normals(i);
            let outward = normals[first] + second.map_or_else(SVector::zeros, |second| normals[second]);
            along_friction += (1..C)
                .map(|axis| outward[axis] * (stretch[axis] - solved.forces[i][axis] / site.k[axis]))
                .sum::<f64>();
        }
    }
    let size = solved.twist.norm();
    (size > 0.0).then(|| solved.twist * (1.0_f64.copysign(along_friction) / size))
}
