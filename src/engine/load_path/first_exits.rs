//! The first places along a piece of the path at which contacts reach an edge of their friction cone, its apex, or a closing gap.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts whose present state stops being valid, each with its exits: the edges of its cone that the force reaches, the apex, or a closing gap.
pub(super) type ExitsReached = Vec<(usize, Vec<Exit>)>;

/// The first places along a piece of the path at which the present states of contacts stop being valid.
pub(super) struct FirstExits {
    /// The first step at which the present state of a contact stops being valid, and all contacts for which that happens at this step.
    pub(super) reached: Option<(f64, ExitsReached)>,
    /// While a load turns: contacts and drives whose force touches the edge of its cone before the step of `reached`, without crossing it, each with
    /// the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

/// The smallest step to an exit (a place where a contact's state stops being valid), and all contacts with exits there. In symmetric grasps several
/// contacts reach an edge at once: steps that are equal up to the rounding of both count as equal.
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
