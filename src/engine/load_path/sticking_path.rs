//! Follows a growing or turning load while no contact slides. Where a gap closes, the path continues with this contact sticking, too. The path ends
//! where a contact stops sticking. The base load acts before the asked load grows. A ramp is a load that grows in proportion to a load factor; along
//! a turn the angle of the load takes the place of the load factor. A drive, the spring of a joint or tendon of a hand with its force limit, is
//! treated like a contact. In names of this file, `edge` is the boundary of a friction cone.

use crate::numerics::{IntoList, keep, mapped};
use nalgebra::SVector;

use super::first_exits::ExitsReached;
use super::onset::{DepartingContact, Departure, Onset, OnsetEvent};
use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, State, ZERO_SLACK};
use crate::equilibrium::{ACCURATE, ContactState, Undecided, WorkDone, site_states};
use crate::grasp::Wrench;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{Doubt, FoundBy, SearchOutcome, SearchSolution, Settings, settle};

/// A ramp or a turn of the load, followed while no contact slides, and the load factor reached so far.
pub(super) struct StickingPath<'a> {
    pub(super) segment: Segment<'a>,
    /// The caller's load (ramp or turn) as a function of the load factor.
    pub(super) trajectory: Trajectory<Wrench<3>>,
    /// The load factor up to which an onset is searched for: infinite along a ramp, the last angle of a turn.
    pub(super) end: f64,
    pub(super) settings: &'a Settings,
    pub(super) rule: FoundBy,
    pub(super) factor: f64,
    /// Contacts and drives, by index, whose force touched the boundary of its cone without crossing it while the load turned. Each comes with the
    /// angle of the load, rad.
    pub(super) touches: Vec<(usize, f64)>,
}

impl StickingPath<'_> {
    pub(super) fn run(&mut self, mut states: Vec<State>) -> Onset<3> {
        let mut reached: Option<ExitsReached> = None;
        // In every iteration an open contact closes and stays closed, or the path ends. Without rounding errors the number of iterations stays below
        // this limit.
        for _ in 0..2 * states.len() + 2 {
            let mut point = match self.segment.point_at(&states, self.factor, None, None) {
                Ok(point) => point,
                Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
            };
            let at_base = reached.is_none();
            let at_edge = reached.take().unwrap_or_else(|| self.at_edge_at_base(&states, &point));
            if !at_edge.is_empty() {
                let active_sets =
                    active_sets_after(self.segment.problem.space().axes(), &states, &point, &at_edge);
                let laws = self.segment.laws_of_rates(&active_sets, &states);
                let rates = self.segment.rates(self.factor, laws);
                let (settled, _) = settle(&rates, self.settings);
                let stays = |found: &SearchSolution| {
                    at_edge.iter().all(|&(i, _)| {
                        let state = &found.states[i];
                        // The path goes on if the contact sticks or was open already. It also goes on if the contact opens under the base load: such
                        // a contact carries no force and did not stick before.
                        state.is_sticking() || state.is_open() && (at_base || states[i].is_open())
                    })
                };
                match settled {
                    SearchOutcome::Found(found, _) if stays(&found) => {
                        for &(i, _) in &at_edge {
                            if states[i].is_open() && found.states[i].is_sticking() {
                                let nothing = SVector::zeros();
                                self.segment.remember_slip(i, self.factor, &point.twist, &nothing);
                            }
                            states[i] = found.states[i];
                        }
                        point = match self.segment.point_at(&states, self.factor, None, None) {
                            Ok(point) => point,
                            Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
                        };
                    }
                    settled => return self.event(states, &point, active_sets, &rates, &settled),
                }
            }
            let first = self.segment.first_exits(&states, &point, self.end - self.factor);
            let passed = self.factor;
            let touch = |(site, angle)| (site, passed + angle);
            first.touches.into_iter().map(touch).append_to(&mut self.touches);
            let Some((step, next)) = first.reached else { return Onset::Never };
            self.factor += step;
            reached = Some(next);
        }
        Onset::Undecided(Undecided { doubt: Doubt::OnTheBoundary, work: WorkDone::default() })
    }

    /// Contacts that are on the boundary of their cones under the base load, each with its exits: facets of the cone that the force has reached, the
    /// apex (zero force), or a closing gap. There are two kinds of such contacts. The force of the first kind is on the boundary up to rounding, so
    /// that the step to an exit has length zero. Contacts of the second kind touch without force. Only the rates of the forces show whether these
    /// forces leave their cones as the load grows.
    fn at_edge_at_base(&self, states: &[State], point: &PathPoint) -> ExitsReached {
        let mut at_edge = Vec::new();
        for (i, state) in states.iter().enumerate() {
            let mut exits = self.segment.ways_out(i, state, point);
            keep(&mut exits, &|exit| exit.step <= exit.uncertainty);
            let line = &point.lines[i];
            let weightless = state.is_sticking()
                && self.segment.problem.local(i).has_edges()
                && line.force.norm() <= ZERO_SLACK * line.force_size;
            if weightless || !exits.is_empty() {
                at_edge.push((i, exits));
            }
        }
        at_edge
    }

    fn event(
        &self,
        states: Vec<State>,
        point: &PathPoint,
        active_sets: Vec<ActiveSet>,
        rates: &Problem,
        settled: &SearchOutcome,
    ) -> Onset<3> {
        let (segment, sites) = (&self.segment, self.segment.grasp.sites());
        let next = match settled {
            SearchOutcome::Found(found, _) => Some(site_states(rates, found)),
            _ => None,
        };
        let at_edge = (0..states.len()).filter(|&i| !active_sets[i].is_empty());
        let leaves = |site: usize| match next.as_ref().map(|states| states[site]) {
            None => {
                let (local, frame) = (segment.problem.local(site), &sites[site].frame);
                Some(DepartingContact::driven_out(site, &active_sets[site], &local, frame))
            }
            Some(ContactState::Sliding { direction }) => {
                Some(DepartingContact::new(site, Departure::Slides { direction }))
            }
            Some(ContactState::Separated) if states[site].is_sticking() => {
                Some(DepartingContact::new(site, Departure::Opens))
            }
            Some(_) => None,
        };
        let leaving: Vec<_> = at_edge.filter_map(leaves).list();
        let sites = mapped(&leaving, &|leaving| leaving.contact.index);
        let forces = mapped(&point.lines, &|line| line.force);
        let found = SearchSolution {
            free_motions: point.free_motions.clone(),
            sizes: point.sizes,
            ..SearchSolution::new(states, forces, point.twist.clone())
        };
        let place = (self.factor, self.trajectory.at(self.factor));
        let event = OnsetEvent::new(
            segment.clone(),
            place,
            (leaving, sites),
            active_sets,
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

/// For every contact its active set: the facets of its cone that its force has reached according to the exits in `at_edge`. Empty for contacts not
/// listed in `at_edge`. A contact listed without exits touches without force, so its force is at the apex of its cone.
fn active_sets_after(
    axes: usize,
    states: &[State],
    point: &PathPoint,
    at_edge: &ExitsReached,
) -> Vec<ActiveSet> {
    let mut active_sets = vec![ActiveSet::EMPTY; states.len()];
    for (i, exits) in at_edge {
        let line = &point.lines[*i];
        active_sets[*i].add_exits(axes, &states[*i], exits);
        active_sets[*i].apex |= exits.is_empty() || ActiveSet::is_weightless(&line.force, line.force_size);
    }
    active_sets
}
