//! From the last basis of a path to forces, with a check of every condition.

use nalgebra::SVector;

use super::basis::TRIAL;
use super::path::Path;
use crate::numerics::Bordered;
use crate::object::Problem;

/// Corrections of the motion by what its forces leave out of balance.
const CORRECTIONS: usize = 2;
/// What is left out of balance by less than this part of its terms is corrected once.
const BALANCED: f64 = 1e-13;
/// After so few pivots the sums have hardly lost anything.
const FRESH: usize = 16;
/// No solution has a larger residual.
const ACCURATE: f64 = 1e-10;
/// Forces below this part of those in the trial state are its rounding.
const ROUNDING: f64 = 1e-5;
/// Below, numbers are subnormal somewhere on the way and have no relative precision.
const SMALLEST: f64 = 1e-250;

#[derive(Debug, Clone)]
pub(super) struct Solution<const D: usize, const C: usize> {
    pub(super) forces: Vec<SVector<f64, C>>,
    /// Motion of the object in the trial state, in the coordinates of Q; then of the solution.
    pub(super) travelled: SVector<f64, D>,
    pub(super) moved: SVector<f64, D>,
    pub(super) residual: f64,
}

impl<const D: usize, const C: usize> Default for Solution<D, C> {
    fn default() -> Self {
        let zero = SVector::zeros();
        Self { forces: Vec::new(), travelled: zero, moved: zero, residual: f64::INFINITY }
    }
}

impl<const D: usize, const C: usize> Solution<D, C> {
    /// Solves the equations of the present states at z₀ = 0; whether every inequality holds there, too.
    pub(super) fn take(&mut self, path: &mut Path<D, C>, problem: &Problem<D, C>) -> bool {
        if path.age <= FRESH && self.check(path, problem) {
            return true;
        }
        path.refresh();
        self.check(path, problem)
    }

    fn check(&mut self, path: &Path<D, C>, problem: &Problem<D, C>) -> bool {
        self.residual = f64::INFINITY;
        let Some(y) = path.vertex() else { return false };
        self.moved = self.travelled + y / path.form.coordinates.weight.sqrt();
        self.forces.clear();
        let mut largest = problem.wrench.norm();
        for (contact, (local, site)) in path.form.locals.iter().zip(problem.sites).enumerate() {
            let x = path.basis.reaction(contact).hold * local.stretch(&y);
            let force = x.component_mul(&site.springs.root());
            largest =
                largest.max(force.norm()).max(ROUNDING * site.springs.stiffest().sqrt() * local.trial.norm());
            self.forces.push(force);
        }
        let mut worst = 0.0_f64;
        let (mut sum, mut size) = (problem.wrench, problem.wrench.norm());
        for (contact, (local, site)) in path.form.locals.iter().zip(problem.sites).enumerate() {
            let (active, reaction) = (&path.basis.active[contact], path.basis.reaction(contact));
            let stretch = local.stretch(&y);
            let x = reaction.hold * stretch;
            let level = SMALLEST + local.trial.norm() + stretch.norm();
            // A force is known from its stretch or from balance with the others, whichever is better.
            let force_level = SMALLEST + x.norm() + level.min(largest / site.springs.softest().sqrt());
            let force = &mut self.forces[contact];
            for (a, pair) in active.iter().enumerate() {
                let z = &reaction.multipliers[a];
                worst = worst.max(z.dot(&stretch) / (level * (1.0 + z.amax())));
                if local.contact.gap && pair == 0 {
                    // Nothing holds an open contact, whatever its friction.
                    worst = worst.max(x.norm() / force_level);
                    force.fill(0.0);
                }
            }
            for pair in (0..local.pairs()).filter(|pair| active.position(*pair).is_none()) {
                let row = path.form.row(local, pair);
                worst = worst.max(-row.dot(&x) / (force_level * row.norm()));
            }
            sum += site.map * *force;
            size += force.norm() + ROUNDING * site.springs.stiffest().sqrt() * level.min(local.trial.norm());
        }
        self.residual = worst.max(sum.norm() / (size + SMALLEST));
        self.residual <= ACCURATE
    }
}

impl<const D: usize, const C: usize> Path<D, C> {
    /// The motion y of the present states at z₀ = 0.
    fn vertex(&self) -> Option<SVector<f64, D>> {
        if self.basis.active.iter().all(|active| active.len() == 0) {
            return Some(SVector::zeros());
        }
        let zero = SVector::zeros();
        let factors = Bordered::new(&self.sums.stiffness, &zero, &zero, 1.0)?;
        let mut y = factors.solve(&self.sums.sides[TRIAL], 0.0).0;
        for _ in 0..CORRECTIONS {
            let (mut left, mut size) = (SVector::<f64, D>::zeros(), 0.0);
            for (contact, local) in self.form.locals.iter().enumerate() {
                let seen = &local.contact.seen;
                let x = self.basis.reaction(contact).hold * local.stretch(&y) - local.trial;
                left += seen.tr_mul(&x);
                size += seen.norm_squared() * x.norm_squared();
            }
            y += factors.solve(&(left * self.form.coordinates.weight), 0.0).0;
            if left.norm_squared() <= BALANCED * BALANCED * size {
                break;
            }
        }
        Some(y)
    }
}
