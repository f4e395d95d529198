//! The inequalities that a state of the contacts must satisfy, each beside the size that rounding is measured against.
//!
//! ```text
//! open      gap = n·u_c - a_n                 >= 0
//! rolling   F_n, μ F_n - h·F_t (every facet)  >= 0
//! sliding   F_n, slip across its facets, the other facets' μ F_n - h·F_t >= 0
//! ```
//!
//! All of them are linear in (drives, forces, twist): the same function gives their rates along a load or a motion.

use nalgebra::SVector;

use crate::formulation::{Law, Problem, State};
use crate::grasp::Site;

/// Added to every size: below, numbers are subnormal somewhere on the way and have no relative precision.
const SMALLEST: f64 = 1e-250;

/// Size of the displacements at a contact: translation and rotation may cancel there, their rounding does not.
pub(crate) fn span<const D: usize, const C: usize>(
    site: &Site<D, C>,
    drive: &SVector<f64, C>,
    twist: &SVector<f64, D>,
) -> f64 {
    drive.norm() + site.map.norm() * twist.norm()
}

/// Where a statically determinate grasp carries no force at all, what comes out of three projections is the rounding of
/// the rounding of the rounding (1e-45) of the forces that its springs could have had from displacements of this size. This
/// part of those counts as a force, so that noise is not measured against itself.
pub(crate) const NO_FORCE: f64 = 1e-25;

/// The least force that a spring of the scene could have from displacements of these sizes, contact by contact.
pub(crate) fn least_spring_force<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    spans: impl Iterator<Item = f64>,
) -> f64 {
    let softest = |site: &Site<D, C>| site.k.iter().take(site.axes).fold(f64::INFINITY, |m, k| m.min(*k));
    sites.iter().zip(spans).map(|(site, span)| softest(site) * span).fold(f64::INFINITY, f64::min)
}

/// Size of the largest force of a scene.
pub(crate) fn largest_force<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    drives: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
    load: f64,
    forces: impl Iterator<Item = f64>,
) -> f64 {
    let largest = forces.fold(load, f64::max);
    // The least of them is no larger than the first: mostly that says that it does not count.
    let least_of = |count: usize| {
        let spans = sites.iter().zip(drives).map(|(site, a)| span(site, a, twist));
        NO_FORCE * least_spring_force(&sites[..count], spans)
    };
    if least_of(1) <= largest { largest } else { largest.max(least_of(sites.len())) }
}

/// Size of the largest force of a scene with these forces and this twist.
pub(crate) fn scene_force<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
) -> f64 {
    let sizes = forces.iter().map(nalgebra::Matrix::norm);
    largest_force(problem.sites, &problem.drives, twist, problem.wrench.norm(), sizes)
}

/// What the rounding of a contact force is measured against. `spans` is the size of the displacements at the contact,
/// `largest` that of the largest force of the scene: a stiff contact's force is not known from its (cancelling)
/// displacements but from equilibrium with the others, a soft one's the other way round.
pub(crate) fn force_size<const D: usize, const C: usize>(
    site: &Site<D, C>,
    force: &SVector<f64, C>,
    spans: f64,
    largest: f64,
) -> f64 {
    SMALLEST + force.norm() + largest.min(site.k.amax() * spans)
}

/// Calls `visit(value, size)` for every inequality `value >= 0`; rounding errors of the value are of the order of
/// `size` times the machine precision.
pub(crate) fn for_each_slack<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    states: &[State],
    drives: &[SVector<f64, C>],
    forces: &[SVector<f64, C>],
    twist: &SVector<f64, D>,
    mut visit: impl FnMut(f64, f64),
) {
    let sizes = forces.iter().map(nalgebra::Matrix::norm);
    let largest = largest_force(problem.sites, drives, twist, problem.wrench.norm(), sizes);
    for (contact, state) in states.iter().enumerate() {
        let there = There { drive: &drives[contact], force: &forces[contact], twist, largest };
        there.for_each_slack(problem, contact, *state, problem.normals(contact), &mut visit);
    }
}

/// One contact of a solution.
pub(super) struct There<'s, const D: usize, const C: usize> {
    pub(super) drive: &'s SVector<f64, C>,
    pub(super) force: &'s SVector<f64, C>,
    pub(super) twist: &'s SVector<f64, D>,
    /// Size of the largest force of the scene.
    pub(super) largest: f64,
}

impl<const D: usize, const C: usize> There<'_, D, C> {
    /// The same for one contact with these facets.
    pub(super) fn for_each_slack(
        &self,
        problem: &Problem<D, C>,
        contact: usize,
        state: State,
        normals: &[SVector<f64, C>],
        mut visit: impl FnMut(f64, f64),
    ) {
        let site = &problem.sites[contact];
        let (a, f) = (self.drive, self.force);
        let moved = site.map.tr_mul(self.twist);
        let stretch = a - moved;
        let spans = span(site, a, self.twist);
        let force_size = force_size(site, f, spans, self.largest);
        let motion_size = SMALLEST + spans + (0..site.axes).map(|b| (f[b] / site.k[b]).abs()).sum::<f64>();
        let mu = problem.mu(contact);
        let mut facets_left_alone = |but: [Option<usize>; 2]| {
            for (j, h) in normals.iter().enumerate() {
                if !but.contains(&Some(j)) {
                    visit(mu * f[0] - h.dot(f), force_size * (mu + h.norm()));
                }
            }
        };
        match state {
            State::Open => {
                if problem.may_open(contact) {
                    visit(-stretch[0], motion_size);
                }
            }
            State::Rolling => {
                let whole = matches!(problem.laws[contact], Law::Cone { .. } | Law::Turning { .. });
                if problem.round && whole && site.axes == C && mu.is_finite() {
                    let friction = f.iter().skip(1).fold(0.0, |h: f64, x| h.hypot(*x));
                    visit(mu * f[0] - friction, force_size * (1.0 + mu));
                } else {
                    facets_left_alone([None, None]);
                }
                if problem.may_open(contact) {
                    visit(f[0], force_size);
                }
            }
            State::Sliding { first, second } => {
                facets_left_alone([Some(first), second]);
                if problem.may_open(contact) {
                    visit(f[0], force_size);
                }
                let mut slip = stretch;
                slip[0] = 0.0;
                for axis in 1..C {
                    slip[axis] -= f[axis] / site.k[axis];
                }
                let h1 = normals[first];
                match second {
                    None => visit(slip.dot(&h1) / h1.norm(), motion_size),
                    Some(second) => {
                        // slip = σ₁ h₁ + σ₂ h₂, each σ with the sign of the other normal's right angle to it.
                        let h2 = normals[second];
                        let cross = |u: &SVector<f64, C>, v: &SVector<f64, C>| u[1] * v[2] - u[2] * v[1];
                        let turn = cross(&h1, &h2);
                        visit(cross(&slip, &h2) / turn, motion_size * h2.norm() / turn.abs());
                        visit(cross(&h1, &slip) / turn, motion_size * h1.norm() / turn.abs());
                    }
                }
            }
        }
    }
}
