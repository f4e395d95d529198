//! Scratch buffers (lists whose storage is used again) that the computation of one onset passes on to the computation of the next; in the code they
//! are called memory. The onset is the load factor at which the first contact stops sticking. The base load acts from the start, and the load of the
//! question, times a growing load factor, in addition. A drive, the spring of a joint or tendon of a hand with its force limit, is treated like a
//! contact. The twist is the motion of the object, of joints and of further bodies.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::onset::{DepartingContact, Onset, OnsetEvent};
use super::program_run::SearchAtRest;
use super::segment::Segment;
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, Polygon, PolygonCone, State};
use crate::equilibrium::{AnswerFor, Cone};
use crate::grasp::{Coordinates, Engine, Space};
use crate::numerics::{Each, Vector};
use crate::object::{ForcesAndTwist, Load, ProblemLists, SolutionMemory};
use crate::prelude::*;
use crate::search::Settings;

/// The scratch buffers for the computation of an onset, which the next computation uses again. Only `rest` is a result.
#[derive(Debug, Clone, Default)]
pub(super) struct OnsetMemory {
    pub(super) lists: ProblemLists,
    pub(super) change: Vec<SVector<f64, 3>>,
    polygon: Option<((Space, PolygonCone), Arc<Polygon>)>,
    pub(super) solution: SolutionMemory,
    /// Contact forces and twist under the base load.
    pub(super) base: ForcesAndTwist,
    /// The derivatives of contact forces and twist with respect to the load factor.
    pub(super) rate: ForcesAndTwist,
    /// Contact forces and twist at the onset.
    pub(super) there: ForcesAndTwist,
    /// The offsets of the contacts' springs at the onset: commands minus clearances and slips.
    pub(super) offsets: Vec<SVector<f64, 3>>,
    pub(super) states: Vec<State>,
    pub(super) active_sets: Vec<ActiveSet>,
    pub(super) leaving: Vec<DepartingContact<3>>,
    /// Indices of the contacts and drives that stop sticking.
    pub(super) sites: Vec<usize>,
    /// Scratch buffers for those parts of three vectors that belong to joints and further bodies, in this order: twist, load and load rate at the
    /// onset. The parts that belong to the object itself need no such buffers, since their number is fixed.
    pub(super) coordinates: [Vec<f64>; 3],
    place: Option<Box<OnsetEvent<3>>>,
    /// The result of the search for the equilibrium under the base load; `None` if the last onset was found without this search.
    pub(super) rest: Option<SearchAtRest>,
}

impl OnsetMemory {
    /// A [`Segment`] along which the load follows `trajectory`, before any contact has slipped. The rates of the offsets of the contacts' springs are
    /// taken from the field `change`.
    pub(super) fn segment<'g>(
        &mut self,
        grasp: &'g Engine,
        settings: &Settings,
        trajectory: Trajectory<Vector>,
    ) -> Segment<'g> {
        let answer_for = AnswerFor::of(grasp.space(), settings);
        let mut lists = core::mem::take(&mut self.lists);
        grasp.offsets_into(&mut lists.offsets);
        let polygon = self.polygon(grasp.space(), settings.cone);
        let problem = grasp.problem_in(
            lists,
            polygon,
            answer_for.cone == Cone::Round,
            &Load::from(&trajectory.at(0.0)),
        );
        Segment {
            grasp,
            answer_for,
            problem,
            change: core::mem::take(&mut self.change),
            trajectory,
            largest: 0.0,
        }
    }

    fn polygon(&mut self, space: Space, cone: PolygonCone) -> Arc<Polygon> {
        match &self.polygon {
            Some((made_for, polygon)) if *made_for == (space, cone) => polygon.clone(),
            _ => self.polygon.insert(((space, cone), Polygon::shared(space, &cone))).1.clone(),
        }
    }

    /// Puts an event into the box that [`Self::reclaim`] last took back, so that its storage is used again. Without such a box it makes a new one.
    pub(super) fn put(&mut self, event: OnsetEvent<3>) -> Box<OnsetEvent<3>> {
        match self.place.take() {
            Some(mut place) => {
                *place = event;
                place
            }
            None => Box::new(event),
        }
    }

    /// Takes back the lists and the box of an onset that the caller no longer needs.
    pub(super) fn reclaim(&mut self, returned: Onset<3>) {
        let Onset::At(mut event) = returned else { return };
        let local = &mut event.local;
        self.lists.offsets = core::mem::take(&mut local.offsets);
        self.lists.slips = core::mem::take(&mut local.slips);
        self.change = core::mem::take(&mut local.offset_rates);
        let coordinates = [&mut local.found.twist, &mut local.wrench, &mut local.wrench_rate];
        self.coordinates = coordinates.each(Coordinates::take_list);
        self.there.forces = core::mem::take(&mut local.found.forces);
        self.states = core::mem::take(&mut local.found.states);
        self.active_sets = core::mem::take(&mut local.active_sets);
        self.sites = core::mem::take(&mut local.leaving);
        self.leaving = core::mem::take(&mut event.leaving);
        self.place = Some(event);
    }
}
