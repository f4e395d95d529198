//! From no forces to the law, for many contacts or where facets have led nowhere: sweeps, the central path, anchored steps, and a last polish.
//!
//! [`Sweeps`](super::sweeps) find how large forces are, the [`central_path`](super::central_path) what most contacts do, and
//! [anchored](super::alart_curnier) steps of Newton's method go on from there. The best forces on the way are kept, judged contact by contact. Where
//! all that leads nowhere it begins again, with more sweeps or farther inside the cones.

use super::alart_curnier::Anchored;
use super::blocks::Blocks;
use super::central_path;
use super::elimination;
use super::equations::{Equations, Patience, descend, newton_step};
use super::folds::around_folds;
use super::problem::FrictionProblem;
use super::progress::SolveProgress;
use super::settings::Settings;
use super::sweeps::sweep;
use crate::prelude::*;
use core::ops::ControlFlow;
use nalgebra::DVector;

/// A step that has to be shorter than this part of its length is not worth its factorisation.
const SHORTEST: f64 = 1e-2;

/// Sweeps of each start, and where it enters the central path: τ as part of the energy of a contact.
pub(super) const STARTS: [(usize, f64); 4] = [(200, 1e-2), (20, 1.0), (1000, 1e-4), (5, 1e-6)];
/// Sweeps end where forces move no more than this part of themselves.
const STILL: f64 = 1e-15;
/// How firmly the first of the anchored steps are held, and the last.
const HELD: f64 = 1e-3;
const HARDLY: f64 = 1e-10;
/// After a round that arrived they are held less firmly by this factor, after one that did not more firmly by that, and swept so often.
const LOOSER: f64 = 0.1;
const FIRMER: f64 = 3.0;
const SWEPT_BETWEEN: usize = 50;
/// A round has arrived where it leaves this part of what was missed, or this part of the terms.
const ARRIVED: f64 = 1e-3;
const ROUNDED: f64 = 1e-14;
/// A round that leaves this part of its terms has come to where rounding decides.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Forces this close are polished, and what contacts miss is weighed contact by contact.
const CLOSE: f64 = 1e-6;
/// Steps of a polish, each of which must leave no more than this part of the residual.
const POLISHES: usize = 20;
const WORTHWHILE: f64 = 0.9;
/// Sweeps of a polish in place of a step that gains nothing.
const FINAL_SWEEPS: usize = 5;
/// A polish goes on down to this part of the tolerance.
const SPARE: f64 = 0.01;

/// Who watches, and may stop it.
pub(super) type Watcher<'a> = dyn FnMut(&SolveProgress<'_>) -> ControlFlow<()> + 'a;

/// The way, and the best forces on it.
pub(super) struct Approach<'a, 'w, const C: usize> {
    problem: &'a FrictionProblem<C>,
    blocks: &'a Blocks<C>,
    settings: &'a Settings,
    order: Vec<usize>,
    rho: Vec<f64>,
    watch: &'a mut Watcher<'w>,
    /// The contacts by the numbers that the caller knows.
    names: &'a [usize],
    pub(super) best: Best,
}

/// The best forces so far.
#[derive(Debug, Clone)]
pub(super) struct Best {
    pub(super) r: DVector<f64>,
    pub(super) residual: f64,
    /// The contact that misses the law most.
    pub(super) worst: usize,
    /// Newton's steps.
    pub(super) steps: usize,
    /// Whether whoever watches has stopped it.
    pub(super) stopped: bool,
}

impl<'a, 'w, const C: usize> Approach<'a, 'w, C> {
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
            best: Best { r, residual: f64::INFINITY, worst: 0, steps: 0, stopped: false },
        }
    }

    /// Sets out for the nth time. Whether the best forces are now good enough.
    pub(super) fn set_out(&mut self, nth: usize) -> bool {
        let (sweeps, begin) = STARTS[nth];
        let mut r = DVector::zeros(self.problem.q.len());
        self.swept(&mut r, sweeps);
        if self.offer(&r) <= CLOSE && self.polish() || self.best.stopped {
            return self.arrived();
        }
        let (problem, blocks, order) = (self.problem, self.blocks, core::mem::take(&mut self.order));
        let (r, steps) = central_path::follow(problem, blocks, &order, r, begin, |r| {
            let missing = self.offer(r);
            if self.best.stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(missing) }
        });
        self.order = order;
        self.best.steps += steps;
        if self.best.residual <= CLOSE && self.polish() || self.best.stopped {
            return self.arrived();
        }
        self.go_on(r)
    }

    /// Sets out once more for a few contacts, around the folds of the central path.
    pub(super) fn around_folds(&mut self) -> bool {
        let Some(r) = around_folds(self.problem, self.blocks) else { return false };
        if self.offer(&r) <= CLOSE && self.polish() || self.best.stopped {
            return self.arrived();
        }
        self.go_on(r)
    }

    /// Forces that are close, polished.
    pub(super) fn polished(mut self, r: &DVector<f64>) -> DVector<f64> {
        self.offer(r);
        self.polish();
        self.best.r
    }

    /// Rounds of anchored steps.
    fn go_on(&mut self, mut r: DVector<f64>) -> bool {
        let mut delta = HELD;
        for _ in 0..self.settings.rounds {
            let equations = self.near(&r, (delta, self.best.residual < CLOSE));
            let begin = equations.at(r.clone()).size;
            let steps = self.settings.steps;
            let patience = Patience { steps, enough: 0.0, rounding: ROUNDING, shortest: SHORTEST, leaps: 6 };
            let (place, made) = descend(&equations, &self.order, r.clone(), patience);
            self.best.steps += made;
            let missing = self.offer(&place.r);
            if missing <= CLOSE && self.polish() || self.best.stopped {
                break;
            }
            if place.size <= (ARRIVED * begin).max(ROUNDED * place.terms) {
                r = place.r;
                delta = (LOOSER * delta).max(HARDLY);
            } else {
                delta = (FIRMER * delta).min(1.0);
                self.swept(&mut r, SWEPT_BETWEEN);
            }
        }
        self.arrived()
    }

    /// Steps and sweeps from the best forces, for as long as they gain something.
    fn polish(&mut self) -> bool {
        for _ in 0..POLISHES {
            if self.best.residual <= SPARE * self.settings.tolerance || self.best.stopped {
                break;
            }
            let (r, before) = (self.best.r.clone(), self.best.residual);
            let equations = self.near(&r, (0.0, false));
            let step = newton_step(&equations, &self.order, &equations.at(r.clone()));
            self.best.steps += 1;
            if step.is_some_and(|step| self.offer(&(&r + step)) <= WORTHWHILE * before) {
                continue;
            }
            let mut swept = r;
            self.swept(&mut swept, FINAL_SWEEPS);
            if self.offer(&swept) > WORTHWHILE * before {
                break;
            }
        }
        self.arrived()
    }

    /// Sweeps forces so many times, or until they do not move.
    fn swept(&self, r: &mut DVector<f64>, count: usize) {
        for _ in 0..count {
            if sweep(self.problem, self.blocks, r) < STILL {
                break;
            }
        }
    }

    fn arrived(&self) -> bool {
        self.best.residual <= self.settings.tolerance
    }

    fn near(&self, anchor: &DVector<f64>, held: (f64, bool)) -> Anchored<'a, C>
    where
        Self: 'a,
    {
        Anchored::near(self.problem, self.blocks, self.rho.clone(), anchor, held)
    }

    /// Keeps these forces if they are the best so far, and tells whoever watches. Returns how far they miss the law.
    fn offer(&mut self, r: &DVector<f64>) -> f64 {
        if r.iter().any(|r| !r.is_finite()) {
            return f64::INFINITY;
        }
        let tidy = self.problem.tidied(r.clone(), &self.blocks.velocities(r, &self.problem.q), &self.rho);
        let (u, terms) =
            (self.blocks.velocities(&tidy, &self.problem.q), self.blocks.terms(&tidy, &self.problem.q));
        let (residuals, worst) = self.problem.judged(&tidy, &u, &terms);
        let residual = residuals.max();
        if residual < self.best.residual {
            (self.best.r, self.best.residual, self.best.worst) = (tidy, residual, worst);
        }
        let told = SolveProgress {
            contacts: self.names,
            forces: &self.best.r,
            residual: self.best.residual,
            worst: self.names[self.best.worst],
            steps: self.best.steps,
        };
        self.best.stopped |= (self.watch)(&told).is_break();
        residual
    }
}
