//! Decision among all contacts at once, as on a path of few contacts, where Newton's method on the rates does not converge. The path ends where this
//! finds no states either.

use super::patch_path::Patch;
use crate::contact::{Mode, State};
use crate::load_path::end_of_path::end_of_path;
use crate::load_path::event::{LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::search::{Settled, settle};

impl<const C: usize> Patch<C> {
    /// Finds the states of all contacts that are on an edge or slide.
    pub(super) fn ask_about_all(&mut self, journey: &Journey<'_, C>) -> Result<(), PathEnd<C>> {
        self.balance.remember_all();
        let edge = self.all_contacts(journey);
        self.balance.looked_at += edge.rates.len();
        let (settled, effort) = settle(&edge.rates, &journey.settings);
        let Settled::Found(found, _) = settled else {
            let loss = self.loss(journey, LossKind::Corner, None);
            return Err(end_of_path(&edge, (settled, &effort), loss, &journey.settings));
        };
        for (contact, (i, state)) in (0_u32..).zip(found.states.iter().enumerate()) {
            let whole = edge.segment.problem.local(i).of_the_rates(&edge.rates.laws[i], *state);
            let state = whole.and_then(State::on_polygon).unwrap_or(Mode::Open);
            // A contact that slid and has not been asked before.
            if state != self.balance.contact(contact).state && !self.stands_here(contact) {
                self.join(contact);
            }
            self.balance.put(contact, state);
        }
        if self.balance.solve_rates(&self.trial) { Ok(()) } else { Err(self.undecided(journey)) }
    }
}
