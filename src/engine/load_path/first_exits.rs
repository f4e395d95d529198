//! The first edges that contacts reach on the way.

use crate::contact::Exit;
use crate::prelude::*;

/// Contacts on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
pub(super) type PathState = Vec<(usize, Vec<Exit>)>;

/// The first exits of contacts on the way.
pub(super) struct FirstExits {
    /// The step to the first edge, and all contacts that reach one there.
    pub(super) standing: Option<(f64, PathState)>,
    /// Sites that come to the edge of their cone before, without crossing it, while a load turns; with the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

/// The smallest step to an exit, and all contacts with exits there. Symmetric grasps reach several edges at once: steps equal up to the rounding of
/// both count as tied.
pub(super) fn first_standing(mut ways: PathState) -> Option<(f64, PathState)> {
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
