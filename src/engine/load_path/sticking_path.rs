//! Follows a ramp or a turn while nothing slides, from one closing contact to the next, up to the first contact that stops sticking.

use crate::numerics::IntoList;
use nalgebra::SVector;

use super::first_exits::PathState;
use super::onset::{Departure, Leaving, Onset, OnsetEvent};
use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, State, ZERO_SLACK};
use crate::equilibrium::{ACCURATE, ContactState, Undecided, WorkDone, site_states};
use crate::grasp::Wrench;
use crate::numerics::mapped;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{Doubt, Found, FoundBy, Settings, Settled, settle};

/// A ramp or a turn being followed while nothing slides.
pub(super) struct StickingPath<'a> {
    pub(super) segment: Segment<'a>,
    /// Trajectory of the load, in the coordinates of the question.
    pub(super) course: Trajectory<Wrench<3>>,
    /// The largest factor considered.
    pub(super) end: f64,
    pub(super) settings: &'a Settings,
    pub(super) rule: FoundBy,
    pub(super) factor: f64,
    /// Sites that touched their edge without crossing it, with the angle, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

impl StickingPath<'_> {
    pub(super) fn run(&mut self, mut states: Vec<State>) -> Onset<3> {
        let mut reached: Option<PathState> = None;
        // Every iteration closes a contact for good or ends the path; the bound only guards against rounding.
        for _ in 0..2 * states.len() + 2 {
            let mut here = match self.segment.look(&states, self.factor, None, None) {
                Ok(here) => here,
                Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
            };
            let at_base = reached.is_none();
            let standing = reached.take().unwrap_or_else(|| self.standing_at_base(&states, &here));
            if !standing.is_empty() {
                let stands = stands(self.segment.problem.space().axes(), &states, &here, &standing);
                let laws = self.segment.laws_of_rates(&stands, &states);
                let rates = self.segment.rates(self.factor, laws);
                let (settled, _) = settle(&rates, self.settings);
                let stays = |found: &Found| {
                    standing.iter().all(|&(i, _)| {
                        let state = &found.states[i];
                        // A contact that carried no force at the base and opens at once never stuck.
                        state.is_sticking() || state.is_open() && (at_base || states[i].is_open())
                    })
                };
                match settled {
                    Settled::Found(found, _) if stays(&found) => {
                        for &(i, _) in &standing {
                            if states[i].is_open() && found.states[i].is_sticking() {
                                let nothing = SVector::zeros();
                                self.segment.remember_slip(i, self.factor, &here.twist, &nothing);
                            }
                            states[i] = found.states[i];
                        }
                        here = match self.segment.look(&states, self.factor, None, None) {
                            Ok(here) => here,
                            Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
                        };
                    }
                    settled => return self.event(states, &here, stands, &rates, &settled),
                }
            }
            let first = self.segment.first_exits(&states, &here, self.end - self.factor);
            let passed = self.factor;
            let touch = |(site, angle)| (site, passed + angle);
            self.touches.extend(first.touches.into_iter().map(touch));
            let Some((step, next)) = first.standing else { return Onset::Never };
            self.factor += step;
            reached = Some(next);
        }
        Onset::Undecided(Undecided { doubt: Doubt::OnTheBoundary, work: WorkDone::default() })
    }

    /// Contacts on an edge at the base: those whose distance to an exit is zero within its uncertainty, and those that touch without force. Only the
    /// rates decide about both.
    fn standing_at_base(&self, states: &[State], here: &PathPoint) -> PathState {
        let mut standing = Vec::new();
        for (i, state) in states.iter().enumerate() {
            let mut exits = self.segment.ways_out(i, state, here);
            exits.retain(|exit| exit.step <= exit.uncertainty);
            let line = &here.lines[i];
            let weightless = state.is_sticking()
                && self.segment.problem.local(i).has_edges()
                && line.force.norm() <= ZERO_SLACK * line.force_size;
            if weightless || !exits.is_empty() {
                standing.push((i, exits));
            }
        }
        standing
    }

    fn event(
        &self,
        states: Vec<State>,
        here: &PathPoint,
        stands: Vec<ActiveSet>,
        rates: &Problem,
        settled: &Settled,
    ) -> Onset<3> {
        let (segment, sites) = (&self.segment, self.segment.grasp.sites());
        let next = match settled {
            Settled::Found(found, _) => Some(site_states(rates, found)),
            _ => None,
        };
        let standing = (0..states.len()).filter(|&i| !stands[i].is_nowhere());
        let leaves = |site: usize| match next.as_ref().map(|states| states[site]) {
            None => {
                let (local, frame) = (segment.problem.local(site), &sites[site].frame);
                Some(Leaving::driven_out(site, &stands[site], &local, frame))
            }
            Some(ContactState::Sliding { direction }) => {
                Some(Leaving::new(site, Departure::Slides { direction }))
            }
            Some(ContactState::Separated) if states[site].is_sticking() => {
                Some(Leaving::new(site, Departure::Opens))
            }
            Some(_) => None,
        };
        let leaving: Vec<_> = standing.filter_map(leaves).list();
        let sites = mapped(&leaving, &|leaving| leaving.contact.index);
        let forces = mapped(&here.lines, &|line| line.force);
        let found = Found {
            free_motions: here.free_motions.clone(),
            sizes: here.sizes,
            ..Found::new(states, forces, here.twist.clone())
        };
        let place = (self.factor, self.course.at(self.factor));
        let event = OnsetEvent::new(
            segment.clone(),
            place,
            (leaving, sites),
            stands,
            (found, self.rule),
            &mut Default::default(),
        );
        match segment.grasp.state_at_onset(&event, self.settings) {
            Some(state) if state.residuals.worst() > ACCURATE => {
                Onset::Undecided(Undecided { doubt: Doubt::Inaccurate, work: state.work })
            }
            _ => Onset::At(Box::new(event)),
        }
    }
}

/// The active sets after these exits. A contact without an exit touches without force.
fn stands(axes: usize, states: &[State], here: &PathPoint, standing: &PathState) -> Vec<ActiveSet> {
    let mut stands = vec![ActiveSet::NOWHERE; states.len()];
    for (i, exits) in standing {
        let line = &here.lines[*i];
        stands[*i].reach(axes, &states[*i], exits);
        stands[*i].apex |= exits.is_empty() || ActiveSet::is_weightless(&line.force, line.force_size);
    }
    stands
}
