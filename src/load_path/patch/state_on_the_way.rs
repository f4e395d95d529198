//! The equilibrium on the way, and the rates in the form that the follower of few contacts uses.

use nalgebra::SVector;

use super::moving_contact::MovingContact;
use super::patch_path::Patch;
use crate::contact::{ActiveSet, PolygonState, State};
use crate::equilibrium::Equilibrium;
use crate::grasp::Site;
use crate::load_path::follower::StandAtEdge;
use crate::load_path::journey::Journey;
use crate::numerics::Vector;
use crate::prelude::*;
use crate::search::Found;

impl<const C: usize> Patch<C> {
    /// The whole equilibrium, computed in one pass over all contacts. Just after an event the states are those with which the path continues.
    pub(super) fn equilibrium(&self, journey: &Journey<'_, C>) -> Equilibrium<C> {
        let Self { balance, trial, .. } = self;
        let (y, tau) = (balance.balanced(), balance.tau);
        let memory = |contact: &MovingContact<C>| contact.memory;
        let segment = journey.segment(self.slips(journey.grasp.sites(), memory));
        let problem = segment.problem_at(tau);
        let twist = balance.twist(trial, &y);
        // Quantities that vanish here are known up to the rounding of their size at the beginning of the leg.
        let mut largest = problem.wrench.norm() + segment.course.rate_at(tau).norm() * tau;
        let mut travel = 0.0_f64;
        let forces = self.forces_at(problem.sites, &y);
        for (i, (contact, site)) in balance.contacts.iter().zip(problem.sites).enumerate() {
            let rate = balance.force_rate(contact).component_mul(&site.springs.root());
            largest = largest.max(forces[i].norm() + rate.norm() * tau);
            travel = travel.max(site.span(&problem.drives[i], &twist));
        }
        let states = balance.contacts.iter().map(|contact| State::from(contact.state)).collect();
        let found = Found {
            free_motions: balance.free_motions(trial),
            sizes: [largest, travel],
            ..Found::new(states, forces, twist)
        };
        journey.equilibrium(&problem, tau, found)
    }

    /// Forces at a motion on top of the trial state, N.
    pub(super) fn forces_at(&self, sites: &[Site<C>], y: &Vector) -> Vec<SVector<f64, C>> {
        let force = |(contact, site): (&MovingContact<C>, &Site<C>)| {
            let x = contact.force(&contact.stretch(y, self.balance.tau), self.balance.facets(contact));
            x.component_mul(&site.springs.root())
        };
        self.balance.contacts.iter().zip(sites).map(force).collect()
    }

    /// The rates of all contacts, with slips up to here: contacts not decided at the present event slide on or keep their state.
    pub(super) fn all_contacts<'g>(&self, journey: &Journey<'g, C>) -> StandAtEdge<'g, C> {
        let (balance, sites) = (&self.balance, journey.grasp.sites());
        let remembered = |contact: &MovingContact<C>| {
            let mut contact = contact.clone();
            if contact.state.slides() {
                contact.remember(&balance.stretch(&contact), balance.facets(&contact));
            }
            contact.memory
        };
        let segment = journey.segment(self.slips(sites, remembered));
        let normals = &journey.polygon.normals;
        let mut states: Vec<_> = balance.contacts.iter().map(|contact| contact.state).collect();
        let sliding = |state: &PolygonState| {
            let own = state.own_facets(normals.len()).into_iter().flatten();
            ActiveSet { facets: own.map(|j| normals[j]).collect(), apex: false }
        };
        let mut stands: Vec<_> = states.iter().map(sliding).collect();
        for stand in &self.stands {
            let i = stand.contact as usize;
            states[i] = stand.was;
            let facets = stand.facets().iter().map(|&j| normals[usize::from(j)]).collect();
            stands[i] = ActiveSet { facets, apex: stand.apex };
        }
        let states: Vec<State<C>> = states.into_iter().map(State::from).collect();
        let rates = segment.rates(0.0, segment.laws_of_rates(&stands, &states));
        StandAtEdge { segment, rates, forces: self.forces_at(sites, &balance.balanced()) }
    }

    /// Slips, m, from the memory of each contact.
    fn slips(
        &self,
        sites: &[Site<C>],
        memory: impl Fn(&MovingContact<C>) -> SVector<f64, C>,
    ) -> Vec<SVector<f64, C>> {
        let slip = |(contact, site): (&MovingContact<C>, &Site<C>)| {
            let (mut slip, memory) = (SVector::zeros(), memory(contact));
            for axis in 1..site.springs.axes() {
                slip[axis] = memory[axis] / site.springs.root_along(axis);
            }
            slip
        };
        self.balance.contacts.iter().zip(sites).map(slip).collect()
    }
}
