//! The first edges of their cones that contacts reach along a piece of the path.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts that reach the end of their state, each with its exits: the edges of its cone that it reaches, the apex, or a closed gap.
pub(super) type ExitsReached = Vec<(usize, Vec<Exit>)>;

/// The first places along a piece of the path at which contacts reach the end of their state.
pub(super) struct FirstExits {
    /// The step at which the first contact reaches the end of its state, and all contacts that do so at that step.
    pub(super) reached: Option<(f64, ExitsReached)>,
    /// Contacts and drives that reach the edge of their cone before this step without crossing it, while a load turns; with the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

/// The smallest step to an exit, and all contacts with exits there. In symmetric grasps several contacts reach an edge at once: steps that are equal
/// up to the rounding of both count as equal.
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
