//! First slip in a verdict (the answer to the question whether a grasp holds a load): the event at which the first contact ceases to stick. The
//! verdict has its load factor, and all contacts whose contact state (open, sticking, sliding) changes at this factor, up to rounding. The load
//! factor is the multiple of the growing load that acts: 0 at rest, 1 under the whole load. A jump is a sudden motion under constant load.

use crate::equilibrium::{ContactState, DriveState, Equilibrium};
use crate::grasp::{Engine, PartLabel};
use crate::load_path::{Change, ContactChange, DepartingContact, Departure, Event, LoadPath, Onset};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, mapped, picked};
use crate::prelude::*;

use super::verdict::FirstSlip;

impl Engine {
    /// The [`FirstSlip`] of a verdict. `onset` gives its load factor and the contacts that cease to stick; `None` if no contact does. Contacts that
    /// begin to slide in `events` at the same load factor, up to rounding, are added, but not those after the first jump. If first slip occurs at the
    /// start of the path, `start` is the equilibrium there, and its sliding contacts are added, too.
    pub(crate) fn first_slip(
        &self,
        onset: &Onset<3>,
        events: &[Event<3>],
        start: Option<&Equilibrium<3>>,
    ) -> Option<FirstSlip> {
        let parts = self.wholes();
        let slides_in = |i: usize, state: &Equilibrium<3>| {
            matches!(state.contacts[i].state, ContactState::Sliding { .. })
        };
        let factor = if let Onset::At(event) = onset { event.factor } else { 0.0 };
        // Events after the first jump are not simultaneous with first slip. Only at load factor 0 may first slip itself be a jump; events with jumps
        // are then kept.
        let before_any_jump = events.iter().take_while(|event| factor == 0.0 || event.jump.is_none());
        let is_at_once = |event: &Event<3>| event.leg == 0 && (event.fraction - factor).abs() <= NEGLIGIBLE;
        let at_once = before_any_jump.filter(|event| is_at_once(event)).list();
        let slides_at_once = |i: usize| {
            at_once.iter().any(|event| begins_to_slide(event, i))
                || start.is_some_and(|start| slides_in(i, start))
        };
        match onset {
            Onset::At(event) => {
                let leaves = |matches: fn(&Departure<3>) -> bool| {
                    let is_meant = |i: usize| {
                        event
                            .leaving
                            .iter()
                            .any(|leaving| leaving.contact.index == i && matches(&leaving.how))
                    };
                    parts.with(&is_meant)
                };
                let slides = |i: usize| {
                    let slides =
                        |leaving: &DepartingContact<3>| matches!(leaving.how, Departure::Slides { .. });
                    event.leaving.iter().any(|leaving| leaving.contact.index == i && slides(leaving))
                };
                Some(FirstSlip {
                    factor,
                    slide: parts.with(&|i| slides(i) || slides_at_once(i)),
                    open: leaves(|how| matches!(how, Departure::Opens)),
                    would_pull: leaves(|how| matches!(how, Departure::WouldPull)),
                    give_way: mapped(&event.drives, &|drive| drive.part.text()),
                })
            }
            Onset::AlreadySliding(state) => Some(FirstSlip {
                factor,
                slide: parts.with(&|i| slides_in(i, state) || slides_at_once(i)),
                open: Vec::new(),
                would_pull: Vec::new(),
                give_way: yielding(state),
            }),
            _ => None,
        }
    }
}

/// The names of the joints and tendons whose drives give way in an equilibrium.
fn yielding(state: &Equilibrium<3>) -> Vec<String> {
    let name = |part: &PartLabel, drive: DriveState| (drive == DriveState::Yields).then(|| part.text());
    let mut names = picked(&state.joints, &|joint| name(&joint.joint, joint.state));
    names.extend(picked(&state.tendons, &|tendon| name(&tendon.tendon, tendon.state)));
    names
}

/// The equilibrium at rest, if a contact slides there already or slips as soon as the load grows; otherwise `None`.
pub(super) fn rest_that_slips(onset: &Onset<3>, path: &LoadPath<'_, 3>) -> Option<Equilibrium<3>> {
    let slips = match onset {
        Onset::At(event) => event.factor <= NEGLIGIBLE,
        Onset::AlreadySliding(_) => true,
        _ => false,
    };
    if slips { path.state_at(0, 0.0) } else { None }
}

/// Whether the contact with this index begins to slide at an event, from sticking or as it closes.
pub(super) fn begins_to_slide(event: &Event<3>, contact: usize) -> bool {
    let begins = |change: &ContactChange<3>| {
        matches!(change.what, Change::Slides { .. } | Change::ClosesSliding { .. })
    };
    event.changes.iter().any(|change| change.contact.index == contact && begins(change))
}
