//! The sequence of iterative methods for many contacts. It is also used for a few contacts if the problem with polygons in place of the friction
//! cones has given no solution.
//!
//! One run of the sequence is a start. [`Sweeps`](super::sweeps), which solve one contact after another, find the magnitude of the forces. The
//! [`central_path`] finds the contact states of most contacts. Newton steps continue from the forces at the end of the path, and a proximal term
//! holds them near given forces, the [anchor](super::alart_curnier). Newton steps without this term come last. The forces whose largest residual over
//! all contacts is smallest are kept. If a start fails, the next start makes another number of sweeps. It also begins the central path nearer to the
//! boundaries of the friction cones, or farther inside.

use super::alart_curnier::Anchored;
use super::blocks::Blocks;
use super::equations::{Equations, IterationLimits, descend, newton_step};
use super::folds::around_folds;
use super::problem::FrictionProblem;
use super::progress::SolveProgress;
use super::settings::Settings;
use super::sweeps::sweep;
use super::tolerances::{ROUND_CONVERGED, WORTH_POLISHING};
use super::{central_path, elimination};
use crate::numerics::tolerances::FEW_ROUNDINGS;
use crate::prelude::*;
use core::ops::ControlFlow;
use nalgebra::DVector;

/// The starts in order: number of Gauss–Seidel sweeps, and the initial parameter τ of the central path. This τ is a multiple of the mean energy
/// ‖r_i‖² / ρ_i of a contact. Here r_i is the force of contact i after the sweeps, and ρ_i converts its velocity to a force.
pub(super) const STARTS: [(usize, f64); 4] = [(200, 1e-2), (20, 1.0), (1000, 1e-4), (5, 1e-6)];

/// The caller's function that receives the progress and may stop the solve.
pub(super) type Watcher<'a> = dyn FnMut(&SolveProgress<'_>) -> ControlFlow<()> + 'a;

/// A solve of one island by the methods of this file, with the best forces so far. An island is a set of contacts that the matrix W from contact
/// forces to relative velocities couples, directly or through other contacts.
pub(super) struct IslandSolve<'a, 'w, const C: usize> {
    problem: &'a FrictionProblem<C>,
    blocks: &'a Blocks<C>,
    settings: &'a Settings,
    order: Vec<usize>,
    rho: Vec<f64>,
    watch: &'a mut Watcher<'w>,
    /// The index of each contact in the caller's problem.
    names: &'a [usize],
    pub(super) best: BestForces,
}

/// The best forces so far. Of all forces that the methods have produced, these have the smallest residual, i.e. the smallest value of the largest
/// residual over all contacts.
#[derive(Debug, Clone)]
pub(super) struct BestForces {
    pub(super) r: DVector<f64>,
    pub(super) residual: f64,
    /// The contact with the largest residual at these forces: its index within the island, counted from 0.
    pub(super) worst: usize,
    /// Number of Newton steps of all starts so far.
    pub(super) steps: usize,
    /// Whether the caller's function (the watcher), which receives the progress, has stopped the solve.
    pub(super) stopped: bool,
}

impl<'a, 'w, const C: usize> IslandSolve<'a, 'w, C> {
    pub(super) fn new(
        problem: &'a FrictionProblem<C>,
        blocks: &'a Blocks<C>,
        settings: &'a Settings,
        (names, watch): (&'a [usize], &'a mut Watcher<'w>),
    ) -> Self {
        let r = DVector::zeros(problem.q.len());
        Self {
            problem,
            blocks,
            settings,
            order: elimination::order(blocks),
            rho: blocks.scales(),
            watch,
            names,
            best: BestForces { r, residual: f64::INFINITY, worst: 0, steps: 0, stopped: false },
        }
    }

    /// Runs start number `nth` of [`STARTS`], counted from 0. Returns whether the residual of the best forces is then within the tolerance.
    pub(super) fn run_start(&mut self, nth: usize) -> bool {
        let (sweeps, tau) = STARTS[nth];
        let mut r = DVector::zeros(self.problem.q.len());
        self.run_sweeps(&mut r, sweeps);
        if self.record_if_best(&r) <= WORTH_POLISHING && self.polish() || self.best.stopped {
            return self.is_converged();
        }
        let (problem, blocks, order) = (self.problem, self.blocks, core::mem::take(&mut self.order));
        let (r, steps) = central_path::follow(problem, blocks, &order, r, tau, |r| {
            let missing = self.record_if_best(r);
            if self.best.stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(missing) }
        });
        self.order = order;
        self.best.steps += steps;
        if self.best.residual <= WORTH_POLISHING && self.polish() || self.best.stopped {
            return self.is_converged();
        }
        self.anchored_rounds(r)
    }

    /// Follows the central path around its folds, for a few contacts, and continues from the forces at its end. Returns whether the residual of
    /// the best forces is then within the tolerance; false if the path has no starting point.
    pub(super) fn around_folds(&mut self) -> bool {
        let Some(r) = around_folds(self.problem, self.blocks) else { return false };
        if self.record_if_best(&r) <= WORTH_POLISHING && self.polish() || self.best.stopped {
            return self.is_converged();
        }
        self.anchored_rounds(r)
    }

    /// Returns the forces with the smallest residual, after Newton steps from the given forces (see [`Self::polish`]).
    pub(super) fn polished(mut self, r: &DVector<f64>) -> DVector<f64> {
        self.record_if_best(r);
        self.polish();
        self.best.r
    }

    /// Runs rounds of anchored Newton steps, in which a proximal term holds the forces near an anchor. After a round that converges, the anchor moves
    /// to the forces of this round. After a round that fails, the anchor becomes the old anchor improved by sweeps. Returns whether the residual of
    /// the best forces is within the tolerance.
    fn anchored_rounds(&mut self, mut r: DVector<f64>) -> bool {
        // Weight of the proximal term, which holds the forces near the anchor, in the first round.
        let mut delta = 1e-3;
        for _ in 0..self.settings.rounds {
            let equations = self.anchored_at(&r, (delta, self.best.residual < WORTH_POLISHING));
            let initial_size = equations.at(r.clone()).size;
            let steps = self.settings.steps;
            // The line search gives up below a hundredth of a Newton step (`shortest`). A shorter step gains less than the factorisation of its
            // matrix costs.
            let patience =
                IterationLimits { steps, enough: 0.0, rounding: FEW_ROUNDINGS, shortest: 1e-2, leaps: 6 };
            let (point, made) = descend(&equations, &self.order, r.clone(), patience);
            self.best.steps += made;
            let missing = self.record_if_best(&point.r);
            if missing <= WORTH_POLISHING && self.polish() || self.best.stopped {
                break;
            }
            // A round has converged if its residual is a thousandth of the residual at its start, or is at the level of the rounding of its terms.
            if point.size <= (1e-3 * initial_size).max(ROUND_CONVERGED * point.terms) {
                r = point.r;
                // A converged round reduces the weight of the proximal term, which holds the forces near the anchor; a failed round increases
                // it.
                delta = (0.1 * delta).max(1e-10);
            } else {
                delta = (3.0 * delta).min(1.0);
                self.run_sweeps(&mut r, 50);
            }
        }
        self.is_converged()
    }

    /// Makes at most twenty Newton steps from the best forces while they reduce the residual; sweeps replace a step that fails. Returns whether the
    /// residual of the best forces is within the tolerance.
    fn polish(&mut self) -> bool {
        for _ in 0..20 {
            // Forces whose residual is at most a hundredth of the tolerance need no further Newton steps.
            if self.best.residual <= 0.01 * self.settings.tolerance || self.best.stopped {
                break;
            }
            let (r, before) = (self.best.r.clone(), self.best.residual);
            let equations = self.anchored_at(&r, (0.0, false));
            let step = newton_step(&equations, &self.order, &equations.at(r.clone()));
            self.best.steps += 1;
            // A Newton step, or the sweeps that replace it, must reduce the residual to at most this fraction of its previous value; otherwise the
            // polish ends.
            let worthwhile = 0.9;
            if step.is_some_and(|step| self.record_if_best(&(&r + step)) <= worthwhile * before) {
                continue;
            }
            let mut swept = r;
            self.run_sweeps(&mut swept, 5);
            if self.record_if_best(&swept) > worthwhile * before {
                break;
            }
        }
        self.is_converged()
    }

    /// Makes `count` sweeps over the contacts, or fewer if a sweep changes the forces only by rounding.
    fn run_sweeps(&self, r: &mut DVector<f64>, count: usize) {
        for _ in 0..count {
            if sweep(self.problem, self.blocks, r) < FEW_ROUNDINGS {
                break;
            }
        }
    }

    fn is_converged(&self) -> bool {
        self.best.residual <= self.settings.tolerance
    }

    fn anchored_at(&self, anchor: &DVector<f64>, weights: (f64, bool)) -> Anchored<'a, C>
    where
        Self: 'a,
    {
        Anchored::with_anchor(self.problem, self.blocks, self.rho.clone(), anchor, weights)
    }

    /// Projects the forces r onto the friction cones, keeps them if their residual is the smallest so far, and reports the progress to the
    /// watcher. Returns their largest residual over all contacts; infinite if a force is not finite.
    fn record_if_best(&mut self, r: &DVector<f64>) -> f64 {
        if r.iter().any(|r| !r.is_finite()) {
            return f64::INFINITY;
        }
        let tidy =
            self.problem.snapped_to_cones(r.clone(), &self.blocks.velocities(r, &self.problem.q), &self.rho);
        let (u, terms) =
            (self.blocks.velocities(&tidy, &self.problem.q), self.blocks.terms(&tidy, &self.problem.q));
        let (residuals, worst) = self.problem.residuals_from(&tidy, &u, &terms);
        let residual = residuals.max();
        if residual < self.best.residual {
            (self.best.r, self.best.residual, self.best.worst) = (tidy, residual, worst);
        }
        let progress = SolveProgress {
            contacts: self.names,
            forces: &self.best.r,
            residual: self.best.residual,
            worst: self.names[self.best.worst],
            steps: self.best.steps,
        };
        self.best.stopped |= (self.watch)(&progress).is_break();
        residual
    }
}
