//! Suction cups whose lips are open all around: their vacuum is gone, whatever the other contacts would hold.

use crate::equilibrium::ContactState;
use crate::grasp::{Engine, WholeContact, WholeContacts};
use crate::load_path::{Change, Event, LossKind};
use crate::numerics::Size;

use super::verdict::Lost;
use super::way_out::WayOut;

impl<D: Size, const C: usize> Engine<D, C> {
    /// The first of some events behind which no point of a cup's lip touches, and the cups.
    pub(super) fn cups_let_go<'e>(
        &self,
        mut events: impl Iterator<Item = &'e Event<C>>,
    ) -> Option<(&'e Event<C>, Vec<WholeContact>)> {
        self.vacuum()?;
        let parts = WholeContacts::of(self.contacts());
        events.find_map(|event| {
            let is_open = |i: usize| match event.changes.iter().find(|change| change.contact.index == i) {
                Some(change) => change.what == Change::Opens,
                None => event.state.contacts[i].state == ContactState::Separated,
            };
            let of_a_cup = |i: usize| self.contacts()[i].suction > 0.0;
            let mut cups = parts.with(|i| of_a_cup(i) && is_open(i));
            cups.retain(WholeContact::is_whole);
            (!cups.is_empty()).then_some((event, cups))
        })
    }
}

impl<const C: usize> Lost<C> {
    /// Where cups let go.
    pub(super) fn without_vacuum(factor: f64, event: &Event<C>, cups: Vec<WholeContact>) -> Self {
        Self {
            factor,
            kind: LossKind::LetsGo,
            way_out: WayOut::LetsGo { cups },
            slide: Vec::new(),
            is_gross_slip: false,
            drives: Vec::new(),
            motion: None,
            state: Some(Box::new(event.state.clone())),
            nothing_near: None,
        }
    }
}
