//! An equilibrium in known states, with a check of every condition.

use nalgebra::SVector;

use super::basis::TRIAL;
use super::path::StatePath;
use super::tolerances::{ACCURATE_SOLUTION, BALANCED_SOLUTION, TRIAL_ROUNDING};
use crate::contact::SMALLEST;
use crate::numerics::{Bordered, Vector};
use crate::object::{Facet, Problem};
use crate::prelude::*;

/// An equilibrium, found by Newton's method or from the last basis of a path.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    /// The least motion of the object, in inside coordinates.
    pub(super) twist: Vector,
    pub(super) forces: Vec<SVector<f64, 3>>,
    /// The largest violation of a condition, over the sizes of its terms.
    pub(super) residual: f64,
}

impl Default for Solution {
    fn default() -> Self {
        Self { twist: Vector::zeros(), forces: Vec::new(), residual: f64::INFINITY }
    }
}

impl Solution {
    /// Solves the equations of the present states of a path at z₀ = 0. Returns the motion y on top
    /// of the trial state if every inequality holds there, too.
    pub(super) fn take(&mut self, path: &mut StatePath, problem: &Problem) -> Option<Vector> {
        // Number of pivots up to which the sums have lost hardly any digits, and are not computed afresh for the solution.
        if path.age <= 16
            && let Some(y) = self.check(path, problem)
        {
            return Some(y);
        }
        path.refresh();
        self.check(path, problem)
    }

    fn check(&mut self, path: &StatePath, problem: &Problem) -> Option<Vector> {
        self.residual = f64::INFINITY;
        let y = path.vertex()?;
        self.forces.clear();
        let mut largest = problem.wrench.norm();
        for (contact, (local, site)) in path.form.locals.iter().zip(problem.sites).enumerate() {
            let x = path.basis.reaction(contact).hold * local.stretch(&y);
            let force = x.component_mul(&site.springs.root());
            let trial = site.springs.stiffest().sqrt() * local.trial.norm();
            largest = largest.max(force.norm()).max(TRIAL_ROUNDING * trial);
            self.forces.push(force);
        }
        let mut worst = 0.0_f64;
        let (mut sum, mut size) = (problem.wrench.clone(), problem.wrench.norm());
        for (contact, (local, site)) in path.form.locals.iter().zip(problem.sites).enumerate() {
            let (active, reaction) = (&path.basis.active[contact], path.basis.reaction(contact));
            let stretch = local.stretch(&y);
            let x = reaction.hold * stretch;
            let level = SMALLEST + local.trial.norm() + stretch.norm();
            // A force is known from its stretch or from balance with the others; the smaller error counts.
            let force_level = SMALLEST + x.norm() + level.min(largest / site.springs.softest().sqrt());
            for (z, _) in reaction.multipliers.iter().zip(active.iter()) {
                worst = worst.max(z.dot(&stretch) / (level * (1.0 + z.amax())));
            }
            let mut least = 0.0_f64;
            for (pair, Facet { row, unit }) in path.form.pairs_of(local).iter().enumerate() {
                let value = row.dot(&x);
                if value < 0.0 && !active.has(pair) {
                    least = least.min(value / unit);
                }
            }
            worst = worst.max(-least / force_level);
            let force = &mut self.forces[contact];
            if local.contact.gap && active.has(0) {
                // An open contact carries no force, whatever its friction.
                worst = worst.max(x.norm() / force_level);
                force.fill(0.0);
            }
            sum += &site.map * *force;
            size += force.norm()
                + TRIAL_ROUNDING * site.springs.stiffest().sqrt() * level.min(local.trial.norm());
        }
        self.residual = worst.max(sum.norm() / (size + SMALLEST));
        (self.residual <= ACCURATE_SOLUTION).then_some(y)
    }
}

impl StatePath {
    /// The motion y of the present states at z₀ = 0.
    fn vertex(&self) -> Option<Vector> {
        if self.basis.active.iter().all(|active| active.len() == 0) {
            return Some(Vector::zeros());
        }
        let zero = Vector::zeros();
        let factors = Bordered::new(&self.sums.stiffness, &zero, &zero, 1.0)?;
        let mut y = factors.solve(&self.sums.sides[TRIAL], 0.0).0;
        // Corrections of a motion from such sums by the imbalance of its forces, summed anew: the second removes the rounding of the first.
        for _ in 0..2 {
            let (mut left, mut size) = (Vector::zeros(), 0.0);
            for (contact, local) in self.form.locals.iter().enumerate() {
                let seen = &local.contact.seen;
                let x = self.basis.reaction(contact).hold * local.stretch(&y) - local.trial;
                left += seen.tr_mul(&x);
                size += seen.norm_squared() * x.norm_squared();
            }
            let square = left.norm_squared();
            y += factors.solve(&(left * self.form.coordinates.weight), 0.0).0;
            if square <= BALANCED_SOLUTION * BALANCED_SOLUTION * size {
                break;
            }
        }
        Some(y)
    }
}
