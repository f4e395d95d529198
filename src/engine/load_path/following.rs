//! A load program together with its follower, the part of a load path that advances along the program: the start, the change of legs, and the end. A
//! leg is a section of the program, along which load and commands change to given values.

use core::fmt::Debug;

use nalgebra::SVector;

use super::beyond::{Beyond, EquilibriumEnd, beyond_end};
use super::end_of_theory::places;
use super::energy::LegEnergy;
use super::event::{LossKind, PathEnd};
use super::follower::{Advance, Follower, StateAtEdge};
use super::leg::Leg;
use super::program_run::ProgramRun;
use super::small_motions::EndOfSmallMotions;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Coordinates, Engine, Wrench};
use crate::numerics::amax;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{Settings, settle};

/// A load path: the load program, its follower, and the end of the path.
#[derive(Debug)]
pub(crate) struct Following<'g, F> {
    pub(super) run: ProgramRun<'g>,
    /// The follower; `None` if no equilibrium was found from which the path could start.
    pub(super) follower: Option<F>,
    end: Option<PathEnd<3>>,
}

impl<'g, F: Follower<'g>> Following<'g, F> {
    /// The path of the load program with the legs `legs`. `begin` makes the follower at the equilibrium under the load `start`. An error of `begin`,
    /// such as that no equilibrium exists, becomes the end of the path.
    pub(super) fn start(
        grasp: &'g Engine,
        (start, legs): (&Wrench<3>, &[Leg<3>]),
        settings: &Settings,
        begin: impl FnOnce(&ProgramRun<'g>, &Problem<'g>) -> Result<F, PathEnd<3>>,
    ) -> Result<Self, Error> {
        Self::of(ProgramRun::new(grasp, start, settings)?, legs, begin)
    }

    /// Starts the path of the load program `run`, which has no legs yet, along the legs `legs`. `begin` makes the follower at the equilibrium at the
    /// start. An error of `begin`, such as that no equilibrium exists, becomes the end of the path.
    pub(super) fn of(
        mut run: ProgramRun<'g>,
        legs: &[Leg<3>],
        begin: impl FnOnce(&ProgramRun<'g>, &Problem<'g>) -> Result<F, PathEnd<3>>,
    ) -> Result<Self, Error> {
        run.extend(legs)?;
        let problem = run.problem_at_start();
        let has_leg = run.program.begin_leg();
        let mut path = match begin(&run, &problem) {
            Ok(follower) => Self { run, follower: Some(follower), end: None },
            Err(end) => Self { run, follower: None, end: Some(end) },
        };
        path.start_leg(has_leg);
        path.end_without_vacuum();
        Ok(path)
    }

    /// Starts the present leg if `has_leg`, otherwise ends the path as completed. Does nothing if the path has no follower because it could not
    /// start.
    fn start_leg(&mut self, has_leg: bool) {
        if let Some(follower) = &mut self.follower {
            self.end = if has_leg { follower.start_leg(&self.run).err() } else { Some(PathEnd::Completed) };
        }
    }

    /// Ends the path, as a loss of equilibrium, if the lip of a suction cup is open all around: the vacuum is then gone, while the computed forces
    /// still include its pull.
    fn end_without_vacuum(&mut self) {
        let Some(follower) = &self.follower else { return };
        let open = follower.cups_open(&self.run);
        if !open.is_empty() {
            let points = self.run.grasp.points_of(&open);
            let loss = self.run.loss(follower.fraction(), LossKind::LetsGo, points, None);
            self.end = Some(PathEnd::Lost(Box::new(loss)));
        }
    }

    /// Calls `advance` on the follower and returns the event or step that it reaches. `None` if there is neither: the path has moved on without
    /// an event, a new leg has begun, or the path has ended.
    pub(super) fn advance_with(
        &mut self,
        advance: impl FnOnce(&mut F, &ProgramRun<'g>) -> Result<Advance<F::Report>, PathEnd<3>>,
    ) -> Option<F::Report> {
        match advance(self.follower.as_mut()?, &self.run) {
            Ok(Advance::Reached(report)) => {
                self.end_without_vacuum();
                return Some(report);
            }
            Ok(Advance::OnTheWay) => {}
            Ok(Advance::EndOfLeg) => {
                let has_leg = self.run.program.next_leg();
                self.start_leg(has_leg);
            }
            Err(end) => self.end = Some(end),
        }
        None
    }
}

/// The functions of a load path for a caller that need not know the type of its follower. The caller's vectors have `C` components. The path returns
/// items of the type `T`: events or steps.
pub(crate) trait AnyPath<const C: usize, T>: Debug {
    fn next(&mut self) -> Option<T>;
    fn end(&self) -> Option<&PathEnd<C>>;
    fn place(&self) -> (usize, f64);
    fn state(&self) -> Option<Equilibrium<C>>;
    fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<C>>;
    fn forces(&self) -> Vec<SVector<f64, C>>;
    fn continue_with(&mut self, legs: &[Leg<C>]) -> Result<(), Error>;
    fn beyond(&self, settings: Option<&Settings>) -> Option<Beyond<C>>;
    fn step_error(&self) -> f64;
    fn energies(&self) -> &[LegEnergy];
    fn next_small(&mut self) -> Option<T>;
    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions>;
    fn farthest(&self) -> f64;
    fn all_slide_from(&self, until: (usize, f64)) -> Option<(usize, f64)>;
    fn sticks_until(&self) -> Vec<(usize, f64)>;
    fn left_out(&self) -> Option<f64>;
}

impl<'g, F: Follower<'g>> AnyPath<3, F::Report> for Following<'g, F> {
    fn next(&mut self) -> Option<F::Report> {
        while self.end.is_none() {
            if let report @ Some(_) = self.advance_with(F::advance) {
                return report;
            }
        }
        None
    }

    fn end(&self) -> Option<&PathEnd<3>> {
        self.end.as_ref()
    }

    fn place(&self) -> (usize, f64) {
        let fraction = self.follower.as_ref().map_or(0.0, Follower::fraction);
        self.run.program.place(fraction)
    }

    fn state(&self) -> Option<Equilibrium<3>> {
        self.follower.as_ref()?.state(&self.run)
    }

    fn state_at(&self, leg: usize, fraction: f64) -> Option<Equilibrium<3>> {
        let follower = self.follower.as_ref()?;
        let is_here = self.place() == (leg, fraction);
        follower.state_behind(leg, fraction).or_else(|| if is_here { self.state() } else { None })
    }

    fn forces(&self) -> Vec<SVector<f64, 3>> {
        let mut forces =
            self.follower.as_ref().map(|follower| follower.forces(&self.run)).unwrap_or_default();
        forces.truncate(self.run.grasp.len());
        forces
    }

    fn continue_with(&mut self, legs: &[Leg<3>]) -> Result<(), Error> {
        self.run.extend(legs)?;
        if matches!(self.end, Some(PathEnd::Completed)) {
            let has_leg = self.run.program.begin_leg();
            self.start_leg(has_leg);
        }
        Ok(())
    }

    fn beyond(&self, settings: Option<&Settings>) -> Option<Beyond<3>> {
        let settings = settings.unwrap_or(&self.run.settings);
        let loss = self.end.as_ref()?.loss()?;
        let follower = self.follower.as_ref()?;
        let cups = follower.cups_open(&self.run);
        if !cups.is_empty() {
            return Some(Beyond::WithoutVacuum { cups });
        }
        if let beyond @ Some(_) = follower.beyond_a_jump(settings) {
            return beyond;
        }
        let StateAtEdge { segment, rates, forces } = follower.edge(&self.run);
        let motion = loss.against.as_ref().map(Coordinates::to);
        let end = EquilibriumEnd { factor: loss.fraction, forces: &forces, motion };
        let (settled, effort) = settle(&rates, settings);
        Some(beyond_end(&segment, &rates, (settled, &effort), &end, settings))
    }

    fn step_error(&self) -> f64 {
        self.follower.as_ref().map_or(0.0, Follower::step_error)
    }

    fn energies(&self) -> &[LegEnergy] {
        self.follower.as_ref().map_or(&[], Follower::energies)
    }

    fn next_small(&mut self) -> Option<F::Report> {
        while self.end.is_none() && self.end_of_small_motions().is_none() {
            if let report @ Some(_) = self.advance_with(F::advance) {
                return report;
            }
        }
        None
    }

    fn end_of_small_motions(&self) -> Option<&EndOfSmallMotions> {
        self.follower.as_ref()?.end_of_small_motions()
    }

    fn farthest(&self) -> f64 {
        self.follower.as_ref().map_or(0.0, Follower::farthest)
    }

    fn all_slide_from(&self, until: (usize, f64)) -> Option<(usize, f64)> {
        self.follower.as_ref()?.all_slide_from(until)
    }

    fn sticks_until(&self) -> Vec<(usize, f64)> {
        self.follower.as_ref().map(Follower::sticks_until).unwrap_or_default()
    }

    fn left_out(&self) -> Option<f64> {
        let rest = self.state_at(0, 0.0).filter(|_| self.run.program.changes_loads_alone());
        // Slips since rest, and the rounding of a load that has come back, would be taken for the motion and the change of the load.
        let is_like = |rest: &&Equilibrium<3>, there: &Equilibrium<3>| {
            let size = |load: &Wrench<3>| amax(load.components());
            rest.local.slips == there.local.slips
                && size(&(there.load - rest.load)) > NEGLIGIBLE * size(&there.load).max(size(&rest.load))
        };
        let part = |(leg, fraction)| {
            let there = self.state_at(leg, fraction)?;
            self.run.grasp.left_out_between(rest.as_ref().filter(|rest| is_like(rest, &there)), &there)
        };
        places(self, self.place()).into_iter().filter_map(part).min_by(f64::total_cmp)
    }
}
