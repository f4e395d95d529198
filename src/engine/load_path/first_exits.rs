//! The first exit along a piece of the path, on which all contacts keep their states (open, sticking or sliding). An exit is the end of a contact
//! state: the force reaches the boundary or the apex (zero force) of its friction cone, or a gap closes. The drives of a hand (the springs of its
//! joints and tendons, with their force limits) are treated like contacts. A step is a change of the parameter along the piece: of the load factor on
//! a ramp, of the fraction of the leg on a load path.

use crate::contact::Exit;
use crate::numerics::keep;
use crate::prelude::*;

/// Contacts whose present state ends, by index. Each has its exits: a facet of its cone that the force reaches, the apex, or a closing gap.
pub(super) type ExitsReached = Vec<(usize, Vec<Exit>)>;

/// The first point along a piece of the path at which the present state of a contact ends. Also, while the load turns, the points before it at which
/// a force touches the boundary of its cone without crossing it.
pub(super) struct FirstExits {
    /// The least step at which the present state of a contact ends, with all contacts whose states end there. `None` if no state ends.
    pub(super) reached: Option<(f64, ExitsReached)>,
    /// While a load turns: contacts and drives whose force touches the boundary of its cone, without crossing it, before the first state ends. Each
    /// entry is the index of the contact or drive, and the angle by which the load has turned, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

/// The smallest step at which a contact's state ends, and all contacts whose states end at this step; `None` if none ends. The argument `ways` lists
/// the exits of each contact, i.e. the ends of its state, with the step at which each occurs. In symmetric grasps several contacts reach the boundary
/// at once: steps that are equal up to the sum of their uncertainties are taken as equal.
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
        keep(exits, &|exit| exit.step - first.step <= exit.uncertainty + first.uncertainty);
        !exits.is_empty()
    });
    Some((first.step, ways))
}
