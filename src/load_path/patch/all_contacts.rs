//! Where Newton's method on the rates does not arrive, all contacts are asked at once, as those of
//! a short path are. The path ends where they have no answer either.

use super::patch_path::PatchPath;
use crate::contact::{Mode, PolygonState, Stand, State};
use crate::load_path::beyond::{Beyond, End, beyond_end};
use crate::load_path::event::{Loss, PathEnd};
use crate::load_path::loss::{end_of_path, leaving_motion};
use crate::load_path::segment::Segment;
use crate::object::Problem;
use crate::proofs::separates_from_here_on;
use crate::search::{Doubt, Settled, settle};

/// Among more contacts what lies beyond the end of a path would take longer to find than the path.
const FEW: usize = 32;

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
        let many = rates.len() > FEW;
        // A motion that proves a limit load is quicker to find than that nothing else is found.
        if many && let Some(limit) = self.proved_limit(&segment, &rates, &loss) {
            return Err(limit);
        }
        let (settled, effort) = settle(&rates, &self.settings);
        let Settled::Found(found, _) = settled else {
            let (sliding, forces) = (rates.yielding(), self.forces());
            let settled = match settled {
                Settled::Undecided(_) if many => return Err(self.undecided()),
                settled => (settled, &effort),
            };
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

    /// A limit load, where the motion with which everything on an edge slides off separates the
    /// load just beyond from all that friction can do.
    fn proved_limit(
        &self,
        segment: &Segment<'g, D, C>,
        rates: &Problem<'g, D, C>,
        loss: &Loss<D, C>,
    ) -> Option<PathEnd<D, C>> {
        let here = segment.problem_at(loss.fraction);
        let motion = leaving_motion(rates, &here.wrench, &rates.yielding())?;
        separates_from_here_on(&here, &motion, &rates.wrench)
            .then(|| PathEnd::Lost(Loss { motion: Some(self.grasp.outside(&motion)), ..loss.clone() }))
    }

    /// Whether another equilibrium exists just beyond where this one was lost; `None` where the path has not been lost. Among
    /// more than 32 contacts only a limit load that the motion of the loss proves is told from the rest.
    #[must_use]
    pub fn beyond(&mut self) -> Option<Beyond<D, C>> {
        let loss = self.end.as_ref()?.loss()?.clone();
        self.balance.remember_all();
        let segment = self.segment();
        let rates = self.rates(&segment);
        if rates.len() > FEW {
            let proved = self.proved_limit(&segment, &rates, &loss).is_some();
            return Some(if proved { Beyond::LimitLoad } else { Beyond::Undecided(Doubt::RayWithoutProof) });
        }
        let motion = loss.motion.map(|motion| self.grasp.inside_twist(&motion));
        let (settled, effort) = settle(&rates, &self.settings);
        let end = End { factor: loss.fraction, forces: &self.forces(), motion };
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, &self.settings))
    }
}
