//! One onset after another in the same memory.

use std::sync::Arc;

use nalgebra::SVector;

use super::course::Course;
use super::onset::{Leaving, Onset, OnsetEvent};
use super::ramp::Ramp;
use super::segment::Segment;
use crate::contact::{Polygon, PolygonCone, Stand, State};
use crate::equilibrium::Cone;
use crate::error::Error;
use crate::grasp::Grasp;
use crate::object::{Lists, Load, PieceState, SolutionMemory};
use crate::search::Settings;

/// Memory for one onset after another, for loops that must not wait for an allocator: [`Grasp::onset`] with the same answers.
///
/// From the second question on nothing is allocated for grasps with no more contacts, where one contact leaves rolling before all others. Where
/// several reach the edge of their cones together, a gap closes on the way, or the base does not clearly roll, rates decide what happens, and they
/// take memory of their own. So do the factors of a grasp that is asked for the first time, and those of more than 256 contacts at every question.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, OnsetWorkspace, Ramp, Wrench};
///
/// // A box between two fingers of which the second rubs less. Whatever it weighs, it slides there first.
/// let finger = |x: f64, mu: f64| {
///     Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0])
/// };
/// let grasp = Grasp::new([finger(-1.0, 0.5), finger(1.0, 0.4)])?;
/// let mut workspace = OnsetWorkspace::default();
/// for weight in [1.0, 2.0, 4.0] {
///     let onset = workspace.onset(&grasp, &Ramp::load(Wrench::ZERO, Wrench::force([0.0, -weight])))?;
///     let event = onset.event().expect("slides");
///     assert!((event.factor - 8.0 / weight).abs() < 1e-14);
///     assert_eq!(event.leaving[0].contact, 1);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct OnsetWorkspace<const D: usize, const C: usize> {
    settings: Settings,
    memory: OnsetMemory<D, C>,
    /// The last answer.
    told: Option<Onset<D, C>>,
}

impl<const D: usize, const C: usize> OnsetWorkspace<D, C> {
    /// A workspace without memory yet, for answers as [`Grasp::onset_with`] gives them.
    #[must_use]
    pub fn new(settings: Settings) -> Self {
        Self { settings, ..Self::default() }
    }

    /// The onset of a grasp along a ramp, as [`Grasp::onset_with`] tells it, up to the next question. Clone it to keep it.
    ///
    /// # Errors
    /// As for [`Grasp::onset`].
    pub fn onset(&mut self, grasp: &Grasp<D, C>, ramp: &Ramp<D, C>) -> Result<&Onset<D, C>, Error> {
        if let Some(told) = self.told.take() {
            self.memory.take_back(told);
        }
        let onset = grasp.onset_in(ramp, &self.settings, &mut self.memory)?;
        Ok(self.told.insert(onset))
    }
}

/// The lists that an onset is made of.
#[derive(Debug, Clone)]
pub(super) struct OnsetMemory<const D: usize, const C: usize> {
    pub(super) lists: Lists<C>,
    pub(super) change: Vec<SVector<f64, C>>,
    polygon: Option<(PolygonCone, Arc<Polygon<C>>)>,
    pub(super) solution: SolutionMemory,
    /// At the base, its rate, and at the onset with the drives there.
    pub(super) base: PieceState<D, C>,
    pub(super) rate: PieceState<D, C>,
    pub(super) there: PieceState<D, C>,
    pub(super) driven: Vec<SVector<f64, C>>,
    pub(super) states: Vec<State<C>>,
    pub(super) stands: Vec<Stand<C>>,
    pub(super) leaving: Vec<Leaving<C>>,
    /// The sites that leave.
    pub(super) sites: Vec<usize>,
    place: Option<Box<OnsetEvent<D, C>>>,
}

impl<const D: usize, const C: usize> Default for OnsetMemory<D, C> {
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
            place: None,
        }
    }
}

impl<const D: usize, const C: usize> OnsetMemory<D, C> {
    /// The stretch from a base load on, along which drives change as noted in this memory, all contacts at rest.
    pub(super) fn segment<'g>(
        &mut self,
        grasp: &'g Grasp<D, C>,
        settings: &Settings,
        course: Course<SVector<f64, D>>,
    ) -> Segment<'g, D, C> {
        let cone = Cone::of::<C>(settings);
        let mut lists = std::mem::take(&mut self.lists);
        grasp.drives_into(&mut lists.drives);
        let polygon = self.polygon(settings.cone);
        let problem = grasp.problem_in(lists, polygon, cone == Cone::Round, &Load::from(&course.at(0.0)));
        Segment { grasp, cone, problem, change: std::mem::take(&mut self.change), course, largest: 0.0 }
    }

    fn polygon(&mut self, cone: PolygonCone) -> Arc<Polygon<C>> {
        match &self.polygon {
            Some((made_for, polygon)) if *made_for == cone => polygon.clone(),
            _ => self.polygon.insert((cone, Polygon::shared(&cone))).1.clone(),
        }
    }

    /// An event in the place of the last one.
    pub(super) fn put(&mut self, event: OnsetEvent<D, C>) -> Box<OnsetEvent<D, C>> {
        match self.place.take() {
            Some(mut place) => {
                *place = event;
                place
            }
            None => Box::new(event),
        }
    }

    /// Takes the lists of an answer that is not needed any more.
    fn take_back(&mut self, told: Onset<D, C>) {
        let Onset::At(mut event) = told else { return };
        let local = &mut event.local;
        self.lists.drives = std::mem::take(&mut local.drives);
        self.lists.slips = std::mem::take(&mut local.slips);
        self.change = std::mem::take(&mut local.drive_rates);
        self.there.forces = std::mem::take(&mut local.found.forces);
        self.states = std::mem::take(&mut local.found.states);
        self.stands = std::mem::take(&mut local.stands);
        self.sites = std::mem::take(&mut local.leaving);
        self.leaving = std::mem::take(&mut event.leaving);
        self.place = Some(event);
    }
}
