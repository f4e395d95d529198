//! Where Newton's method on the rates does not arrive, all contacts are asked at once, as those of
//! a short path are. The path ends where they have no answer either.

use super::patch_path::PatchPath;
use crate::contact::{Mode, PolygonState, Stand, State};
use crate::load_path::event::{Loss, PathEnd};
use crate::load_path::loss::{end_of_path, leaving_motion};
use crate::load_path::segment::Segment;
use crate::load_path::transition::everything_slides;
use crate::object::Problem;
use crate::proofs::separates_from_here_on;
use crate::search::{Settled, settle};

/// With more contacts the end of a path is only named, where a motion proves a limit load. What
/// lies beyond it would take longer to find than the path.
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
        segment.rates(segment.laws_of_rates(&stands, &states))
    }

    /// Asks for the states of everything that stands on an edge or slides.
    pub(super) fn ask_about_all(&mut self) -> Result<(), PathEnd<D, C>> {
        self.balance.remember_all();
        let segment = self.segment();
        let rates = self.rates(&segment);
        self.balance.looked_at += rates.len();
        let loss = self.loss(None);
        let many = rates.len() > FEW;
        if many && let Some(limit) = self.proved_limit(&segment, &rates, &loss) {
            return Err(limit);
        }
        let (settled, effort) = settle(&rates, &self.settings);
        let Settled::Found(found, _) = settled else {
            return Err(match settled {
                Settled::FreeMotion(v) if many => {
                    let motion = self.grasp.outside(&v);
                    PathEnd::GivesWay { leg: loss.leg, fraction: loss.fraction, motion }
                }
                Settled::NoneOf(_) | Settled::Separating(_) if many => PathEnd::Ends(loss),
                _ if many => self.undecided(),
                _ => {
                    let (sliding, forces) = (everything_slides(&rates), self.forces());
                    let settled = (settled, &effort);
                    end_of_path(&segment, &rates, settled, &sliding, &forces, loss, &self.settings)
                }
            });
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
        loss: &Loss<D>,
    ) -> Option<PathEnd<D, C>> {
        let here = segment.problem_at(loss.fraction);
        let motion = leaving_motion(rates, &here.wrench, &everything_slides(rates))?;
        separates_from_here_on(&here, &motion, &rates.wrench)
            .then(|| PathEnd::LimitLoad(Loss { motion: Some(self.grasp.outside(&motion)), ..loss.clone() }))
    }
}
