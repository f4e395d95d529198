//! What a path goes by, whoever follows it: the grasp, the program of legs, and what the caller has chosen.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::event::{Loss, LossKind, PathEnd};
use super::leg::Leg;
use super::program::Program;
use super::segment::Segment;
use crate::contact::Polygon;
use crate::equilibrium::{Cone, Equilibrium};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Size, Vector};
use crate::object::{Load, Problem};
use crate::prelude::*;
use crate::search::{Doubt, Effort, Found, Rung, Settings, Settled, settle_at_rest};

/// What an equilibrium to start from settled to.
pub(crate) type Rest<D, const C: usize> = (Settled<D, C>, Effort);

/// A program of legs on its way.
#[derive(Debug)]
pub(crate) struct Journey<'g, D: Size, const C: usize> {
    pub(super) grasp: &'g Engine<D, C>,
    pub(super) settings: Settings,
    pub(super) polygon: Arc<Polygon<C>>,
    pub(super) program: Program<C>,
    /// Where it starts, if that is known already.
    pub(super) rest: Option<Rest<D, C>>,
}

impl<'g, D: Size, const C: usize> Journey<'g, D, C> {
    /// A journey that has not begun yet, from rest under a load.
    pub(super) fn new(
        grasp: &'g Engine<D, C>,
        start: &Wrench<C>,
        settings: &Settings,
    ) -> Result<Self, Error> {
        grasp.load_alone(start, "start load")?;
        let polygon = Polygon::shared(&settings.cone);
        Ok(Self { grasp, settings: *settings, polygon, program: Program::new(grasp, *start), rest: None })
    }

    /// The question of one equilibrium with these drives, for the cone of the journey.
    pub(super) fn problem(&self, drives: Vec<SVector<f64, C>>, load: &Vector<D>) -> Problem<'g, D, C> {
        let round = self.settings.is_round::<C>();
        self.grasp.problem(self.polygon.clone(), round, drives, &Load::from(load))
    }

    /// Of contacts that have not slipped yet: where the journey starts.
    pub(super) fn problem_at_start(&self) -> Problem<'g, D, C> {
        self.problem(self.grasp.drives(), &self.program.inside_course(self.grasp).at(0.0))
    }

    /// The equilibrium to start from; else how the path ends before it begins.
    pub(super) fn start(&self, problem: &Problem<'g, D, C>) -> Result<Found<D, C>, PathEnd<C>> {
        match self.rest.clone().unwrap_or_else(|| settle_at_rest(problem, &self.settings)) {
            (Settled::Found(found, _), _) => Ok(found),
            (nothing, effort) => {
                let load = self.program.load_at(0.0);
                let outcome = self.grasp.outcome(problem, &load, nothing, &effort, self.cone());
                Err(PathEnd::NoStart(Box::new(outcome)))
            }
        }
    }

    /// The present leg, contacts having slipped so far before it. Counted anew from its goals, so that rounding does not add up over many
    /// legs.
    pub(super) fn segment(&self, slips: Vec<SVector<f64, C>>) -> Segment<'g, D, C> {
        let course = self.program.inside_course(self.grasp);
        let [mut drives, change] = self.program.drives(self.grasp);
        drives.iter_mut().zip(&slips).for_each(|(drive, slip)| *drive -= slip);
        let problem = Problem { slips, ..self.problem(drives, &course.at(0.0)) };
        Segment { grasp: self.grasp, cone: self.cone(), problem, change, course, largest: 0.0 }
    }

    /// The cone that answers are for.
    pub(super) fn cone(&self) -> Cone {
        Cone::of::<C>(&self.settings)
    }

    /// What was found at a fraction of the present leg, as physics.
    pub(super) fn equilibrium(
        &self,
        problem: &Problem<'g, D, C>,
        fraction: f64,
        found: Found<D, C>,
    ) -> Equilibrium<C> {
        let (load, effort) = (self.program.load_at(fraction), Effort::default());
        let grasp = self.program.bodies.put_on(self.grasp, fraction);
        let grasp = self.program.torques.put_on(grasp, fraction);
        grasp.equilibrium(problem, &load, found, Rung::LoadPath, &effort, self.cone())
    }

    /// Equilibrium is lost at a fraction of the present leg where these sites stand on an edge, the object leaving with this motion.
    pub(super) fn loss(
        &self,
        fraction: f64,
        kind: LossKind,
        sites: Vec<usize>,
        motion: Option<&Vector<D>>,
    ) -> Loss<C> {
        let (contacts, drives) = self.grasp.sites_apart(sites);
        let (leg, load) = (self.program.leg, self.program.load_at(fraction));
        let loss = Loss {
            leg,
            fraction,
            load,
            kind,
            contacts,
            drives,
            motion: None,
            jumped: Vec::new(),
            against: None,
        };
        loss.leaving(self.grasp, motion)
    }

    /// Where a path stands and cannot be followed further.
    pub(super) fn undecided(&self, fraction: f64, doubt: Doubt) -> PathEnd<C> {
        PathEnd::Undecided { leg: self.program.leg, fraction, doubt }
    }

    /// Appends legs; a follower that takes straight ones alone has its name in the error.
    pub(super) fn extend(
        &mut self,
        legs: &[Leg<C>],
        straight_only: Option<&'static str>,
    ) -> Result<(), Error> {
        self.program.extend(self.grasp, legs, straight_only)
    }
}
