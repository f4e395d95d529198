//! The equilibrium at the end of a step, along which every stretch goes straight.

use nalgebra::SVector;

use crate::contact::State;
use crate::object::{self, OneByOne, Problem};

/// What Newton's method may leave out of balance, as a part of the forces: below the error of any step.
const SETTLED: f64 = 1e-12;

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

/// Forces of springs are rounded by this part of what their displacements would make; over [`SETTLED`], so that both are one size.
const ROUNDED: f64 = 1e-3;

/// The step from where a path stands to the end of a problem that counts slips from there. `before` has the stretches there, `near` a twist to
/// start from. `None` where Newton's method does not arrive.
pub(super) fn one_step<const D: usize, const C: usize>(
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
