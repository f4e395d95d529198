//! Memory that one onset after another uses.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::journey::Rest;
use super::onset::{Leaving, Onset, OnsetEvent};
use super::segment::Segment;
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, Polygon, PolygonCone, State};
use crate::equilibrium::{AnswerFor, Cone};
use crate::grasp::{Coordinates, Engine};
use crate::numerics::Vector;
use crate::object::{Lists, Load, PieceState, SolutionMemory};
use crate::prelude::*;
use crate::search::Settings;

/// The lists that an onset needs.
#[derive(Debug, Clone)]
pub(super) struct OnsetMemory<const C: usize> {
    pub(super) lists: Lists<C>,
    pub(super) change: Vec<SVector<f64, C>>,
    polygon: Option<(PolygonCone, Arc<Polygon<C>>)>,
    pub(super) solution: SolutionMemory,
    /// State at the base, its rate, and state at the onset with the drives there.
    pub(super) base: PieceState<C>,
    pub(super) rate: PieceState<C>,
    pub(super) there: PieceState<C>,
    pub(super) driven: Vec<SVector<f64, C>>,
    pub(super) states: Vec<State<C>>,
    pub(super) stands: Vec<ActiveSet<C>>,
    pub(super) leaving: Vec<Leaving<C>>,
    /// The sites that leave.
    pub(super) sites: Vec<usize>,
    /// Lists of joint coordinates.
    pub(super) coordinates: [Vec<f64>; 3],
    place: Option<Box<OnsetEvent<C>>>,
    /// The settled base, if the last question needed it.
    pub(super) rest: Option<Rest<C>>,
}

impl<const C: usize> Default for OnsetMemory<C> {
    fn default() -> Self {
        Self {
            lists: Lists::default(),
            change: Vec::new(),
            polygon: None,
            solution: SolutionMemory::default(),
            base: PieceState::default(),
            rate: PieceState::default(),
            there: PieceState::default(),
            driven: Vec::new(),
            states: Vec::new(),
            stands: Vec::new(),
            leaving: Vec::new(),
            sites: Vec::new(),
            coordinates: Default::default(),
            place: None,
            rest: None,
        }
    }
}

impl<const C: usize> OnsetMemory<C> {
    /// The segment from a base load, with drive rates from this memory and all contacts at rest.
    pub(super) fn segment<'g>(
        &mut self,
        grasp: &'g Engine<C>,
        settings: &Settings,
        course: Trajectory<Vector>,
    ) -> Segment<'g, C> {
        let answer_for = AnswerFor::of::<C>(settings);
        let mut lists = core::mem::take(&mut self.lists);
        grasp.drives_into(&mut lists.drives);
        let polygon = self.polygon(settings.cone);
        let problem =
            grasp.problem_in(lists, polygon, answer_for.cone == Cone::Round, &Load::from(&course.at(0.0)));
        Segment {
            grasp,
            answer_for,
            problem,
            change: core::mem::take(&mut self.change),
            course,
            largest: 0.0,
        }
    }

    fn polygon(&mut self, cone: PolygonCone) -> Arc<Polygon<C>> {
        match &self.polygon {
            Some((made_for, polygon)) if *made_for == cone => polygon.clone(),
            _ => self.polygon.insert((cone, Polygon::shared(&cone))).1.clone(),
        }
    }

    /// Puts an event into the box of the last one.
    pub(super) fn put(&mut self, event: OnsetEvent<C>) -> Box<OnsetEvent<C>> {
        match self.place.take() {
            Some(mut place) => {
                *place = event;
                place
            }
            None => Box::new(event),
        }
    }

    /// Recovers the lists of an answer that is no longer needed.
    pub(super) fn take_back(&mut self, told: Onset<C>) {
        let Onset::At(mut event) = told else { return };
        let local = &mut event.local;
        self.lists.drives = core::mem::take(&mut local.drives);
        self.lists.slips = core::mem::take(&mut local.slips);
        self.change = core::mem::take(&mut local.drive_rates);
        let coordinates = [&mut local.found.twist, &mut local.wrench, &mut local.wrench_rate];
        self.coordinates = coordinates.map(Coordinates::take_list);
        self.there.forces = core::mem::take(&mut local.found.forces);
        self.states = core::mem::take(&mut local.found.states);
        self.stands = core::mem::take(&mut local.stands);
        self.sites = core::mem::take(&mut local.leaving);
        self.leaving = core::mem::take(&mut event.leaving);
        self.place = Some(event);
    }
}
