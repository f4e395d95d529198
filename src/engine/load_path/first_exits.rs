//! The first exit along a piece of the path, on which all contacts keep their states. An exit is an end of a contact state: the force reaches an edge
//! or the apex of its cone, or a gap closes. Drives of joints and tendons are treated like contacts. The load factor says how far the load has grown.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts whose present state ends, by index. Each has its exits: an edge of its cone that the force reaches, the apex (zero force), or a
/// closing gap.
pub(super) type ExitsReached = Vec<(usize, Vec<Exit>)>;

/// The first point along a piece of the path at which the present state of a contact ends. Also, while the load turns, the points before it at which
/// a force touches the edge of its cone without crossing it.
pub(super) struct FirstExits {
    /// The least step, a change of the load factor, at which the present state of a contact ends, with all contacts whose states end there. `None` if
    /// no state ends.
    pub(super) reached: Option<(f64, ExitsReached)>,
    /// While a load turns: contacts and drives whose force touches the edge of its cone, without crossing it, before the first state ends. Each entry
    /// is the index of the contact or drive, and the angle by which the load has turned, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

/// The smallest step (change of the load factor) at which a contact's state ends, and all contacts whose states end at this step; `None` if none
/// ends. The argument `ways` lists the exits of each contact, i.e. the ends of its state, with the step at which each occurs. In symmetric grasps
/// several contacts reach an edge at once: steps that are equal up to the sum of their uncertainties are taken as equal.
pub(super) fn first_reached(mut ways: ExitsReached) -> Option<(f64, ExitsReached)> {
    let mut first = ways.iter().find_map(|(_, exits)| exits.first()).copied()?;
    for (_, exits) in &ways {
        for exit in exits {
            if exit.step.total_cmp(&first.step).is_lt() {
                first = *exit;
            }
        }
    }
    ways.retain_mut(|(_, exits)| {
        exits.retain(|exit| exit.step - first.step <= exit.uncertainty + first.uncertainty);
        !exits.is_empty()
    });
    Some((first.step, ways))
}
