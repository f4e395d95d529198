//! Determines the kind of the end of a load path, from the contact states and forces at this end. There no rates of forces and motion satisfy the
//! contact laws. Rates are derivatives along the path.

use super::beyond::{Beyond, EquilibriumEnd, beyond_end, no_rates};
use super::event::{Loss, LossKind, PathEnd};
use super::follower::StateAtEdge;
use super::rigid_motion::rigid_motion;
use crate::contact::State;
use crate::numerics::{Each, Vector};
use crate::object::{LinearProblem, Problem};
use crate::prelude::*;
use crate::search::{SearchCounts, SearchOutcome, Settings};

/// The end of a path at a point where no rates of forces and motion satisfy the contact laws, or none were found. `settled` is the outcome of the
/// search for such rates. Returns `loss`, completed by its kind and by the motion with which the object leaves, or an undecided end.
///
/// The kind is `GivesWay` if nothing resists some motion. Otherwise the kind is `Corner`: such rates exist for no combination of states of the
/// contacts on the boundary of their cones. If the search was undecided, the end is a corner only if a proof excludes rates, or excludes an
/// equilibrium just beyond. Without such a proof the end is undecided.
pub(super) fn end_of_path(
    edge: &StateAtEdge<'_>,
    (settled, effort): (SearchOutcome, &SearchCounts),
    loss: Loss<3>,
    settings: &Settings,
) -> PathEnd<3> {
    let StateAtEdge { segment, rates, forces } = edge;
    if let SearchOutcome::FreeMotion(v) = settled {
        let loss = Loss { kind: LossKind::GivesWay, ..loss };
        return PathEnd::Lost(Box::new(loss.leaving(segment.grasp, Some(&v))));
    }
    let motions = leaving_motions(rates, &segment.trajectory.at(loss.fraction), &rates.yielding());
    let [mut motion, mut against] = motions.map_or([None, None], |motions| motions.each(Some));
    // If no contact carries a force, the springs do not determine the motion with which the object leaves. `rigid_motion` then computes the motion
    // with which the object starts to move if contacts are rigid.
    if let Some(rigid) = rigid_motion(rates) {
        motion = Some(rigid);
        if let SearchOutcome::Separating(v) = &settled {
            against = Some(v.clone());
        }
    }
    let corner = loss.leaving(segment.grasp, motion.as_ref()).and_virtually(against.as_ref());
    let SearchOutcome::Undecided(doubt) = &settled else { return PathEnd::Lost(Box::new(corner)) };
    let doubt = *doubt;
    let end = EquilibriumEnd { factor: corner.fraction, forces, motion: against };
    if effort.no_slips
        || no_rates(rates)
        || matches!(beyond_end(segment, rates, (settled, effort), &end, settings), Beyond::LimitLoad)
    {
        return PathEnd::Lost(Box::new(corner));
    }
    PathEnd::Undecided { leg: corner.leg, fraction: corner.fraction, doubt }
}

/// Two unit motions at a loss of equilibrium, computed with the contact states `states`. The first is the motion with which the object leaves,
/// the second a virtual motion that proves the loss. `None` if nothing moves or no motion can be determined.
///
/// The object leaves by a motion that changes no contact force, and along which the load does work. The virtual motion is a motion along which no
/// contact force that these contact states allow does work. Because of friction the two motions differ: for a block that slides to the right on a
/// floor, the virtual motion also points upwards, at a right angle to the contact force. If rates exist in these states, both motions are the
/// normalised twist rate. Its sign is chosen so that contacts slip along their friction forces: it is reversed if the components of the slip rates
/// along the friction forces have a negative sum over all contacts.
pub(super) fn leaving_motions(rates: &Problem, load: &Vector, states: &[State]) -> Option<[Vector; 2]> {
    let linear_problem = LinearProblem::new(rates, states);
    let solved = match linear_problem.solve(rates.sites, &rates.offsets, &rates.wrench) {
        Err(unbalanced) => {
            // If friction is at its limit at all contacts, there may be motions that no spring resists. Of several unit motions of this kind, the one
            // along which the rate of the load does the most work is taken. If only commands change, the load itself takes the place of its rate.
            let along = |motions: &[Vector], wrench: &Vector| {
                let v = motions.iter().fold(Vector::zeros(), |sum, v| sum + v * v.dot(wrench));
                (v.norm() > 0.0).then(|| v.normalize())
            };
            let worked_on =
                |motions: &[Vector]| along(motions, &rates.wrench).or_else(|| along(motions, load));
            let free = linear_problem.free_motions();
            let against = unbalanced.motion.or_else(|| worked_on(free))?;
            let neutral = || worked_on(&linear_problem.neutral_motions());
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
