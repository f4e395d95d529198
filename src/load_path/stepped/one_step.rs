//! The equilibrium at the end of a step, along which every stretch goes straight.

use nalgebra::SVector;

use crate::contact::State;
use crate::load_path::course::Course;
use crate::load_path::journey::Journey;
use crate::object::{self, OneByOne, Problem};

/// What Newton's method may leave out of balance, as a part of the forces: below the error of any step.
const SETTLED: f64 = 1e-12;

/// Forces of springs are rounded by this part of what their displacements would make; over [`SETTLED`], so that both are one size.
const ROUNDED: f64 = 1e-3;
/// Shorter parts of a leg than this are not tried: the path has an end there.
pub(super) const SHORTEST: f64 = 1e-12;

/// Where a path stands, inside.
#[derive(Debug, Clone)]
pub(super) struct Standing<const D: usize, const C: usize> {
    /// Part of the leg that has been gone.
    pub(super) fraction: f64,
    pub(super) twist: SVector<f64, D>,
    /// Slips so far, in the contact frames.
    pub(super) slips: Vec<SVector<f64, C>>,
    pub(super) forces: Vec<SVector<f64, C>>,
    pub(super) states: Vec<State<C>>,
}

impl<const D: usize, const C: usize> Standing<D, C> {
    /// The largest contact force, N.
    pub(super) fn largest_force(&self) -> f64 {
        self.forces.iter().map(SVector::norm_squared).fold(0.0, f64::max).sqrt()
    }

    /// The largest difference of a contact force, N.
    pub(super) fn apart(&self, other: &Self) -> f64 {
        let pairs = self.forces.iter().zip(&other.forces);
        pairs.map(|(a, b)| (a - b).norm_squared()).fold(0.0, f64::max).sqrt()
    }
}

/// What a step along a leg solves; drives and load are put in for each.
#[derive(Debug)]
pub(super) struct StepProblem<'g, const D: usize, const C: usize> {
    pub(super) problem: Problem<'g, D, C>,
    /// Commands less clearances at the beginning of the leg, and what they change by.
    drives: [Vec<SVector<f64, C>>; 2],
    pub(super) course: Course<SVector<f64, D>>,
}

impl<'g, const D: usize, const C: usize> StepProblem<'g, D, C> {
    /// That of the present leg.
    pub(super) fn along(journey: &Journey<'g, D, C>) -> Self {
        let course = journey.program.inside_course(journey.grasp);
        let drives = journey.program.drives(journey.grasp);
        Self { problem: journey.problem(drives[0].clone(), &course.at(0.0)), drives, course }
    }

    /// What the drive of a contact changes by along the leg.
    pub(super) fn change(&self, i: usize) -> SVector<f64, C> {
        self.drives[1][i]
    }

    /// The step of a length from where a path stands, sought near a twist. `None` where Newton's method does not arrive.
    pub(super) fn step(
        &mut self,
        from: &Standing<D, C>,
        length: f64,
        near: SVector<f64, D>,
    ) -> Option<Standing<D, C>> {
        let fraction = if from.fraction + length > 1.0 - SHORTEST { 1.0 } else { from.fraction + length };
        let Self { problem, drives: [base, change], course } = self;
        let mut before = Vec::with_capacity(base.len());
        for (i, site) in problem.sites.iter().enumerate() {
            let drive = |fraction: f64| base[i] + change[i] * fraction - from.slips[i];
            before.push(site.stretch(&drive(from.fraction), &from.twist));
            problem.drives[i] = drive(fraction);
        }
        (problem.wrench, problem.wrench_rest) = (course.at(fraction), SVector::zeros());
        equilibrium_after(from, &before, problem, (fraction, near))
    }
}

/// The equilibrium of a problem that counts slips from where a path stands. `before` has the stretches there, `near` a twist to
/// start from. `None` where Newton's method does not arrive.
fn equilibrium_after<const D: usize, const C: usize>(
    from: &Standing<D, C>,
    before: &[SVector<f64, C>],
    problem: &Problem<'_, D, C>,
    (fraction, near): (f64, SVector<f64, D>),
) -> Option<Standing<D, C>> {
    let springs = problem.sites.iter().zip(&problem.drives);
    let rounded =
        ROUNDED * springs.map(|(site, drive)| site.springs.stiffest() * site.span(drive, &near)).sum::<f64>();
    let mut answers =
        OneByOne::new(problem, rounded, |i, stretch, _| problem.local(i).answer_after(&before[i], stretch));
    let (twist, ..) = object::newton(&mut answers, near, SETTLED)?;
    let mut slips = from.slips.clone();
    for (i, (slip, answer)) in slips.iter_mut().zip(&answers.contacts).enumerate() {
        let (springs, stretch) = (&problem.sites[i].springs, problem.stretch(i, &twist));
        // What has rolled all the way has not slipped by the rounding of its spring either.
        if !(answer.state.is_rolling() && answer.force == springs.force(&stretch)) {
            *slip += springs.slip(&stretch, &answer.force);
        }
    }
    let (states, forces) = answers.contacts.iter().map(|answer| (answer.state, answer.force)).unzip();
    Some(Standing { fraction, twist, slips, forces, states })
}
