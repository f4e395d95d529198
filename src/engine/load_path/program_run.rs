//! The data that every method of following a load program needs: the grasp, the load program with its legs (sections), and the caller's settings. The
//! onset is the load factor at which the first contact ceases to stick. A drive, the spring of a joint or tendon of a hand with its force limit, is
//! treated like a contact.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::event::{Loss, LossKind, PathEnd};
use super::leg::Leg;
use super::program::Program;
use super::segment::Segment;
use crate::contact::Polygon;
use crate::equilibrium::{AnswerFor, Equilibrium};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Vector, add_times};
use crate::object::{Load, Problem};
use crate::prelude::*;
use crate::search::{Doubt, FoundBy, SearchCounts, SearchOutcome, SearchSolution, Settings, settle_at_rest};

/// The result of the search for the equilibrium from which a path starts, and the numbers of pivots and of combinations of contact states that it
/// took.
pub(crate) type SearchAtRest = (SearchOutcome, SearchCounts);

/// A load program in progress, with its grasp and settings.
#[derive(Debug)]
pub(crate) struct ProgramRun<'g> {
    pub(super) grasp: &'g Engine,
    pub(super) settings: Settings,
    pub(super) polygon: Arc<Polygon>,
    pub(super) program: Program,
    /// The result of the search for the equilibrium from which the path starts, if the computation of an onset has made this search already.
    pub(super) rest: Option<SearchAtRest>,
}

impl<'g> ProgramRun<'g> {
    /// A load program without legs yet, which starts under the load `start`. Returns an error if this load or the limits of small motions are out of
    /// range.
    pub(super) fn new(grasp: &'g Engine, start: &Wrench<3>, settings: &Settings) -> Result<Self, Error> {
        grasp.load_alone(start, "start load")?;
        settings.small_motions.check()?;
        let polygon = Polygon::shared(grasp.space(), &settings.cone);
        Ok(Self { grasp, settings: *settings, polygon, program: Program::new(grasp, *start), rest: None })
    }

    /// The static problem, whose solution is the equilibrium under the load `load`. The friction cone is that of the settings. `offsets` are those of
    /// the contacts' springs: commands minus clearances and slips.
    pub(super) fn problem(&self, offsets: Vec<SVector<f64, 3>>, load: &Vector) -> Problem<'g> {
        let round = self.settings.is_round(self.grasp.space());
        self.grasp.problem(self.polygon.clone(), round, offsets, &Load::from(load))
    }

    /// The static problem at the start of the program: its first load, the commands of the grasp, and no slips.
    pub(super) fn problem_at_start(&self) -> Problem<'g> {
        self.problem(self.grasp.offsets(), &self.program.inside_trajectory(self.grasp).at(0.0))
    }

    /// The equilibrium from which the path starts, a solution of `problem`. If no equilibrium is found, the error is the end of the path before its
    /// first leg.
    pub(super) fn start(&self, problem: &Problem<'g>) -> Result<SearchSolution, PathEnd<3>> {
        match self.rest.clone().unwrap_or_else(|| settle_at_rest(problem, &self.settings)) {
            (SearchOutcome::Found(found, _), _) => Ok(found),
            (nothing, effort) => {
                let load = self.program.load_at(0.0);
                let outcome = self.grasp.outcome(problem, &load, nothing, &effort, self.answer_for());
                Err(PathEnd::NoStart(Box::new(outcome)))
            }
        }
    }

    /// The present leg as a [`Segment`]: loads, and offsets of contact springs, as functions of the fraction of the leg that is done. `slips` are the
    /// accumulated slips at the beginning of the leg. Loads and commands are computed from their values at the ends of legs, so that rounding errors
    /// do not add up over many legs.
    pub(super) fn segment(&self, slips: Vec<SVector<f64, 3>>) -> Segment<'g> {
        let trajectory = self.program.inside_trajectory(self.grasp);
        let [mut offsets, change] = self.program.offsets(self.grasp);
        add_times(&mut offsets, &slips, -1.0);
        let problem = Problem { slips, ..self.problem(offsets, &trajectory.at(0.0)) };
        Segment {
            grasp: self.grasp,
            answer_for: self.answer_for(),
            problem,
            change,
            trajectory,
            largest: 0.0,
        }
    }

    /// The kind of friction cone (polygonal or round) and the limits of small motions for which equilibria are computed; they are stored with each
    /// answer.
    pub(super) fn answer_for(&self) -> AnswerFor {
        AnswerFor::of(self.grasp.space(), &self.settings)
    }

    /// The solution `found` of `problem` at the fraction `fraction` of the present leg, as an equilibrium in the caller's frames, with residuals.
    pub(super) fn equilibrium(
        &self,
        problem: &Problem<'g>,
        fraction: f64,
        found: SearchSolution,
    ) -> Equilibrium<3> {
        let (load, effort) = (self.program.load_at(fraction), SearchCounts::default());
        let grasp = self.program.bodies.apply(self.grasp, fraction);
        let grasp = self.program.torques.apply(grasp, fraction);
        grasp.equilibrium(problem, &load, found, FoundBy::LoadPath, &effort, self.answer_for())
    }

    /// The loss of equilibrium at the fraction `fraction` of the present leg. The contacts and drives with the indices `sites` are on the boundary of
    /// their cones. The object leaves with the motion `motion`, about the centroid of the contacts; `None` if it is not known.
    pub(super) fn loss(
        &self,
        fraction: f64,
        kind: LossKind,
        sites: Vec<usize>,
        motion: Option<&Vector>,
    ) -> Loss<3> {
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
            leaves: None,
        };
        loss.leaving(self.grasp, motion)
    }

    /// The end of a path that cannot be followed beyond the fraction `fraction` of the present leg, for the reason `doubt`.
    pub(super) fn undecided(&self, fraction: f64, doubt: Doubt) -> PathEnd<3> {
        PathEnd::Undecided { leg: self.program.leg, fraction, doubt }
    }

    /// Appends legs to the program. If a leg is invalid, returns an error and appends none.
    pub(super) fn extend(&mut self, legs: &[Leg<3>]) -> Result<(), Error> {
        self.program.extend(self.grasp, legs)
    }
}
