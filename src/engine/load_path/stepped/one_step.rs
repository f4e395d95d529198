//! The equilibrium at the end of a step, along which the stretch of every contact is assumed to change linearly. A path point is what is stored of
//! the grasp at a point of the path: forces, twist, slips and contact states (open, sticking or sliding); its type is `SteppedState`. A leg is a
//! section of the load program. The offset of a contact's springs is the command of its finger (a displacement) minus clearance and accumulated slip.

use nalgebra::SVector;

use crate::contact::{ContactResponse, State};
use crate::load_path::program_run::ProgramRun;
use crate::load_path::tolerances::SHORTEST_STEP;
use crate::load_path::trajectory::Trajectory;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Reals, Vector, cleared_for, largest};
use crate::object::{Problem, newton};
use crate::prelude::*;

/// A path point. The twist is about the centroid of the contacts; lists have an entry for each contact.
#[derive(Debug, Clone)]
pub(super) struct SteppedState {
    /// Fraction of the leg (section of the load program) that is done at this path point, from 0 to 1.
    pub(super) fraction: f64,
    pub(super) twist: Vector,
    /// Accumulated slips since the start of the path, m, in the contact frames.
    pub(super) slips: Vec<SVector<f64, 3>>,
    pub(super) forces: Vec<SVector<f64, 3>>,
    pub(super) states: Vec<State>,
}

impl SteppedState {
    pub(super) fn largest_force(&self) -> f64 {
        largest(&self.forces, &SVector::norm_squared).sqrt()
    }

    /// The difference of two path points, N: the largest difference of a contact force between them.
    pub(super) fn distance_to(&self, other: &Self) -> f64 {
        let pairs = self.forces.iter().zip(&other.forces);
        pairs.map(|(a, b)| (a - b).norm_squared()).most().sqrt()
    }
}

impl SteppedState {
    /// A path point with empty lists, which are filled later and then used again.
    pub(super) fn without_contacts() -> Self {
        let (slips, forces, states) = (Vec::new(), Vec::new(), Vec::new());
        Self { fraction: 0.0, twist: Vector::zeros(), slips, forces, states }
    }

    /// Makes this path point a copy of `other`, in the same storage.
    pub(super) fn join(&mut self, other: &Self) {
        self.fraction = other.fraction;
        self.twist.clone_from(&other.twist);
        self.slips.clone_from(&other.slips);
        self.forces.clone_from(&other.forces);
        self.states.clone_from(&other.states);
    }
}

/// The static problem at the end of a step along the present leg of a load program. Each step overwrites the spring offsets and the load with their
/// values at its end.
#[derive(Debug)]
pub(super) struct StepProblem<'g> {
    pub(super) problem: Problem<'g>,
    /// Two lists with an entry for each contact, m: the command minus clearance at the beginning of the leg, and the change of this value over the
    /// whole leg.
    offsets: [Vec<SVector<f64, 3>>; 2],
    pub(super) trajectory: Trajectory<Vector>,
    /// Stretches (spring deformations) of the contacts at the beginning of a step, m.
    before: Vec<SVector<f64, 3>>,
    /// Force and state of each contact at the end of a step.
    answers: Vec<ContactResponse>,
}

impl<'g> StepProblem<'g> {
    pub(super) fn along(run: &ProgramRun<'g>) -> Self {
        let trajectory = run.program.inside_trajectory(run.grasp);
        let offsets = run.program.offsets(run.grasp);
        let problem = run.problem(offsets[0].clone(), &trajectory.at(0.0));
        Self { problem, offsets, trajectory, before: Vec::new(), answers: Vec::new() }
    }

    /// Adapts this problem, in the same storage, to the present leg of `run` after the path has reached a new leg.
    pub(super) fn start_leg(&mut self, run: &ProgramRun<'g>) {
        self.trajectory = run.program.inside_trajectory(run.grasp);
        run.program.offsets_into(run.grasp, &mut self.offsets);
    }

    /// Change of the offset (command minus clearance, m) of contact i over the whole leg.
    pub(super) fn change(&self, i: usize) -> SVector<f64, 3> {
        self.offsets[1][i]
    }

    /// Makes a step from the path point `from` over the fraction `length` of the leg, and writes the path point at its end to `to`. Newton's method
    /// starts at the twist `near`. `None` if Newton's method does not converge, or if balance requires that a contact pulls although it cannot.
    pub(super) fn step(
        &mut self,
        from: &SteppedState,
        (length, near): (f64, Vector),
        to: &mut SteppedState,
    ) -> Option<()> {
        let fraction =
            if from.fraction + length > 1.0 - SHORTEST_STEP { 1.0 } else { from.fraction + length };
        let Self { problem, offsets: [base, change], trajectory, before, answers } = self;
        cleared_for(before, base.len());
        for (i, site) in problem.sites.iter().enumerate() {
            let offset = |fraction: f64| base[i] + change[i] * fraction - from.slips[i];
            before.push(site.stretch(&offset(from.fraction), &from.twist));
            problem.offsets[i] = offset(fraction);
        }
        (problem.wrench, problem.wrench_rounding_error) = (trajectory.at(fraction), Vector::zeros());
        to.fraction = fraction;
        equilibrium_after((from, before), problem, (near, answers), to)
    }
}

/// Writes to `to` the equilibrium at the end of a step that begins at `from`. The slips of `from` are already subtracted from the offsets of
/// `problem`. `before` are the stretches (spring deformations) at the beginning of the step, m. Newton's method starts at the twist `near`. `None` if
/// Newton's method does not converge, or if balance requires that a contact pulls although it cannot.
fn equilibrium_after(
    (from, before): (&SteppedState, &[SVector<f64, 3>]),
    problem: &Problem<'_>,
    (near, answers): (Vector, &mut Vec<ContactResponse>),
    to: &mut SteppedState,
) -> Option<()> {
    let springs = problem.sites.iter().zip(&problem.offsets);
    // The rounding error of the spring forces limits how far Newton's method can reduce the imbalance. This error is taken as 1e-15 of the sum, over
    // all contacts, of the displacement times the stiffness of the stiffest spring. `newton` multiplies `rounded` by [`SOLVED_ROUNDING`], 1e-12, so
    // the factor here is 1e-3.
    let rounded =
        1e-3 * springs.map(|(site, offset)| site.springs.stiffest() * site.span(offset, &near)).added();
    let answer = |i: usize, stretch: &SVector<f64, 3>, _: &ContactResponse| {
        problem.local(i).answer_after(&before[i], stretch)
    };
    // Newton's method may stop at an imbalance of [`SOLVED_ROUNDING`] relative to the contact forces, which is below the error of any step.
    (to.twist, ..) = newton(problem, (near, SOLVED_ROUNDING, rounded), answers, &answer)?;
    to.slips.clone_from(&from.slips);
    cleared_for(&mut to.forces, answers.len());
    cleared_for(&mut to.states, answers.len());
    for (i, (slip, answer)) in to.slips.iter_mut().zip(answers.iter()).enumerate() {
        let (springs, stretch) = (&problem.sites[i].springs, problem.stretch(i, &to.twist));
        // The slip of a contact that stuck throughout the step is exactly zero. If this slip were computed from the springs, it would have a rounding
        // error.
        if !(answer.state.is_sticking() && answer.force == springs.force(&stretch)) {
            *slip += springs.slip(&stretch, &answer.force);
        }
        to.forces.push(answer.force);
        to.states.push(answer.state);
    }
    // A contact whose law forbids that it opens may pull in the solution. If its friction is limited, the limit `μ F_n` is then negative, so the step
    // fails.
    let least = -SOLVED_ROUNDING * to.largest_force();
    let pulls = |(i, force): (usize, &SVector<f64, 3>)| {
        force[0] < least && problem.local(i).may_slide() && !problem.local(i).may_open()
    };
    if to.forces.iter().enumerate().any(pulls) { None } else { Some(()) }
}
