//! The normal forces with which the contacts press at rest, for a given multiple of the squeeze, or of the overlaps of contacts if these are sought.
//! At rest means under the loads that act before the loads of the question. The squeeze consists of all commands (displacements that fingers would
//! make without an object), constant forces and torques, tensions and vacuums. A drive is the spring of a joint or tendon of a hand, with its force
//! limit.

use super::checked_need::{CheckedNeed, Sought};
use super::press::{ContactPress, force_set, pressure_of_cup};
use crate::ask::Grasp;
use crate::equilibrium::DriveState;
use crate::error::Error;
use crate::grasp::{ContactPoints, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{largest, mapped};
use crate::prelude::*;

/// Two lists for a grasp whose squeeze (or overlaps) are multiplied by `squeeze`. The first has the normal force of each contact, N; the second has
/// the names of the joints and tendons whose drives are at their limit.
///
/// The forces are those of the equilibrium without any load. If this equilibrium is not known, or if no contact with a command, force or vacuum of
/// its own presses in it, the equilibrium under the load at rest is used. If that is not known either, the constant forces that are given for
/// contacts are returned. They are returned only if every contact with a command, force or vacuum of its own has such a force; otherwise the list is
/// empty.
pub(super) fn presses(
    grasp: &Grasp<3>,
    squeeze: f64,
    need: &CheckedNeed,
) -> Result<(Vec<ContactPress>, Vec<String>), Error> {
    let (is_by_overlap, base) = (need.sought == Sought::Overlaps, need.base);
    let squeezed = if is_by_overlap { grasp.with_overlaps(squeeze)? } else { grasp.squeezed(squeeze)? };
    let nothing = NEGLIGIBLE * need.largest_force();
    let list = |force: &dyn Fn(usize) -> f64| {
        let press = |contact: &ContactPoints| {
            let points = contact.range.clone();
            let force = points.clone().fold(0.0, |sum, point| sum + force(point));
            let set = &squeezed.contacts()[points.clone()];
            let overlap = largest(set, &|point| -point.clearance);
            ContactPress {
                part: contact.with(points.len()),
                force: if force.abs() <= nothing { 0.0 } else { force },
                pressure: pressure_of_cup(set),
                pressed_with: force_set(set).filter(|_| !is_by_overlap),
                overlap: Some(overlap).filter(|overlap| is_by_overlap && *overlap > 0.0),
                is_set: points.into_iter().any(|point| grasp.is_set_by_itself(point))
                    || is_by_overlap && overlap > 0.0,
            }
        };
        mapped(grasp.engine.wholes(), &press)
    };
    let loads = [Wrench::ZERO, base];
    for load in &loads[usize::from(base == Wrench::ZERO)..] {
        // Contacts that slide at rest may have kinetic friction. A load path takes it into account; a direct search for an equilibrium does not.
        let Some(state) = squeezed.follow(*load, &[])?.state() else { continue };
        let presses = list(&|i| state.contacts[i].force[0]);
        let mut set = presses.iter().filter(|press| press.is_set).peekable();
        if *load != base && set.peek().is_some() && set.all(|press| press.force <= 0.0) {
            continue;
        }
        // A contact that presses with a given constant force is modelled by a drive that is always at its limit. This says nothing about the squeeze,
        // so the contact is not listed.
        let mut at_their_limit = Vec::new();
        for joint in &state.joints {
            if joint.state == DriveState::Yields {
                at_their_limit.push(joint.joint.text());
            }
        }
        for tendon in &state.tendons {
            if tendon.state == DriveState::Yields {
                at_their_limit.push(tendon.tendon.text());
            }
        }
        return Ok((presses, at_their_limit));
    }
    let held = |i: usize| squeezed.contacts()[i].force.unwrap_or(0.0);
    let mut set = (0..grasp.contacts().len()).filter(|i| grasp.is_set_by_itself(*i)).peekable();
    let all_held = set.peek().is_some() && set.all(|i| held(i) != 0.0);
    Ok((if all_held { list(&held) } else { Vec::new() }, Vec::new()))
}
