//! How a path ends where the rates have no solution: what can be said of the place alone.

use super::beyond::{Beyond, EquilibriumEnd, beyond_end, no_rates};
use super::event::{Loss, LossKind, PathEnd};
use super::follower::StandAtEdge;
use super::rigid_motion::rigid_motion;
use crate::contact::State;
use crate::numerics::{Size, Vector};
use crate::object::{Piece, Problem};
use crate::prelude::*;
use crate::search::{Effort, Settings, Settled};

/// The end of a path whose rates have no solution.
///
/// The object gives way where a motion meets no resistance. Else it stands at a corner: no combination of the states of what stands on
/// an edge has rates. Where that is not known, the proof that nothing holds beyond will do.
pub(super) fn end_of_path<D: Size, const C: usize>(
    edge: &StandAtEdge<'_, D, C>,
    (settled, effort): (Settled<D, C>, &Effort),
    loss: Loss<C>,
    settings: &Settings,
) -> PathEnd<C> {
    let StandAtEdge { segment, rates, forces } = edge;
    if let Settled::FreeMotion(v) = settled {
        let loss = Loss { kind: LossKind::GivesWay, ..loss };
        return PathEnd::Lost(Box::new(loss.leaving(segment.grasp, Some(&v))));
    }
    let motions = leaving_motions(rates, &segment.course.at(loss.fraction), &rates.yielding());
    let [mut motion, mut against] = motions.map_or([None, None], |motions| motions.map(Some));
    // Where nothing presses yet no spring says how it leaves, and what no friction works against proves it.
    if let Some(rigid) = rigid_motion(rates) {
        motion = Some(rigid);
        if let Settled::Separating(v) = &settled {
            against = Some(v.clone());
        }
    }
    let corner = loss.leaving(segment.grasp, motion.as_ref()).and_virtually(against.as_ref());
    let Settled::Undecided(doubt) = &settled else { return PathEnd::Lost(Box::new(corner)) };
    let doubt = *doubt;
    let end = EquilibriumEnd { factor: corner.fraction, forces, motion: against };
    if no_rates(rates)
        || matches!(beyond_end(segment, rates, (settled, effort), &end, settings), Beyond::LimitLoad)
    {
        return PathEnd::Lost(Box::new(corner));
    }
    PathEnd::Undecided { leg: corner.leg, fraction: corner.fraction, doubt }
}

/// The unit motion with which the object leaves when everything that stands on an edge slides, and the virtual one that proves it.
///
/// It leaves by a motion that changes no force then, and on which the load works. No force of these states does anything on the virtual motion, which
/// leans by friction: a block that slides to the right goes up along the edge of its cone virtually. Where there are none both are the motion of the rates
/// in these states. Their forces balance the load, but their slips are against friction: the motion taken the other way is along it.
pub(super) fn leaving_motions<D: Size, const C: usize>(
    rates: &Problem<D, C>,
    load: &Vector<D>,
    states: &[State<C>],
) -> Option<[Vector<D>; 2]> {
    let piece = Piece::new(rates, states);
    let solved = match piece.solve(rates.sites, &rates.drives, &rates.wrench) {
        Err(unbalanced) => {
            // Where friction is exhausted no spring resists, but the friction forces feel the motion. Where only commands
            // change it is the load itself that drives the object out.
            let along = |motions: &[Vector<D>], wrench: &Vector<D>| {
                let v = motions.iter().fold(Vector::zeros(), |sum, v| sum + v * v.dot(wrench));
                (v.norm() > 0.0).then(|| v.normalize())
            };
            let worked_on =
                |motions: &[Vector<D>]| along(motions, &rates.wrench).or_else(|| along(motions, load));
            let free = piece.free_motions();
            let against = unbalanced.motion.or_else(|| worked_on(free))?;
            let neutral = || worked_on(&piece.neutral_motions());
            let leaves = worked_on(free).or_else(neutral).unwrap_or_else(|| against.clone());
            return Some([leaves, against]);
        }
        Ok(solved) => solved,
    };
    let mut along_friction = 0.0;
    for (i, state) in states.iter().enumerate() {
        let local = rates.local(i);
        if let Some(outward) = local.outward(state) {
            let slip = local.springs.slip(&rates.stretch(i, &solved.twist), &solved.forces[i]);
            along_friction += outward.dot(&slip);
        }
    }
    let size = solved.twist.norm();
    let motion = (size > 0.0).then(|| solved.twist * (1.0_f64.copysign(along_friction) / size))?;
    Some([motion.clone(), motion])
}
