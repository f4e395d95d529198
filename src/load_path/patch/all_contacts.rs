//! Where Newton's method on the rates does not arrive, all contacts are asked at once, as those of
//! a short path are. The path ends where they have no answer either.

use super::patch_path::PatchPath;
use crate::contact::{Mode, PolygonState, Stand, State};
use crate::load_path::beyond::{Beyond, End, beyond_end};
use crate::load_path::event::PathEnd;
use crate::load_path::loss::end_of_path;
use crate::load_path::segment::Segment;
use crate::object::Problem;
use crate::search::{Settled, settle};

impl<'g, const D: usize, const C: usize> PatchPath<'g, D, C> {
    /// The rates of all contacts: those that do not stand here slide on or stay as they are.
    fn rates(&self, segment: &Segment<'g, D, C>) -> Problem<'g, D, C> {
        let normals = &self.polygon.normals;
        let mut states: Vec<_> = self.balance.contacts.iter().map(|contact| contact.state).collect();
        let sliding = |state: &PolygonState| {
            let own = state.own_facets(normals.len()).into_iter().flatten();
            Stand { facets: own.map(|j| normals[j]).collect(), apex: false }
        };
        let mut stands: Vec<_> = states.iter().map(sliding).collect();
        for stand in &self.stands {
            let i = stand.contact as usize;
            states[i] = stand.was;
            let facets = stand.facets().iter().map(|&j| normals[usize::from(j)]).collect();
            stands[i] = Stand { facets, apex: stand.apex };
        }
        let states: Vec<State<C>> = states.into_iter().map(State::from).collect();
        segment.rates(0.0, segment.laws_of_rates(&stands, &states))
    }

    /// Asks for the states of everything that stands on an edge or slides.
    pub(super) fn ask_about_all(&mut self) -> Result<(), PathEnd<D, C>> {
        self.balance.remember_all();
        let segment = self.segment();
        let rates = self.rates(&segment);
        self.balance.looked_at += rates.len();
        let loss = self.loss(None);
        let (settled, effort) = settle(&rates, &self.settings);
        let Settled::Found(found, _) = settled else {
            let (sliding, forces, settled) = (rates.yielding(), self.forces(), (settled, &effort));
            return Err(end_of_path(&segment, &rates, settled, &sliding, &forces, loss, &self.settings));
        };
        for (contact, (i, state)) in (0_u32..).zip(found.states.iter().enumerate()) {
            let whole = segment.problem.local(i).of_the_rates(&rates.laws[i], *state);
            let state = whole.and_then(State::on_polygon).unwrap_or(Mode::Open);
            // A contact that slid and has not been asked before.
            if state != self.balance.contact(contact).state && !self.stands_here(contact) {
                self.join(contact);
            }
            self.balance.put(contact, state);
        }
        if self.balance.solve_rates(&self.trial) { Ok(()) } else { Err(self.undecided()) }
    }

    /// Whether another equilibrium exists just beyond where this one was lost; `None` where the path has not been lost. Among more contacts
    /// than all states can be tried of, a limit load is told from other ends where a motion proves it.
    #[must_use]
    pub fn beyond(&mut self) -> Option<Beyond<D, C>> {
        let loss = self.end.as_ref()?.loss()?.clone();
        self.balance.remember_all();
        let segment = self.segment();
        let rates = self.rates(&segment);
        let motion = loss.motion.map(|motion| self.grasp.inside_twist(&motion));
        let (settled, effort) = settle(&rates, &self.settings);
        let end = End { factor: loss.fraction, forces: &self.forces(), motion };
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, &self.settings))
    }
}
