//! The state on the way, as physics.

use nalgebra::SVector;

use super::PatchPath;
use super::local::Local;
use crate::contact::State;
use crate::equilibrium::Equilibrium;
use crate::grasp::Site;
use crate::numerics::orthonormalise_against;
use crate::search::{Effort, Found, Rung};

/// Corrections of the motion from balance summed afresh.
const CORRECTIONS: usize = 2;

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// Where the path stands: the whole equilibrium there, with residuals recomputed from the grasp, the load and the slip so
    /// far; `None` if there was none to start from. Not checked against them: look at the residuals. Just after an event the states are those with which the path goes
    /// on. One pass over all contacts.
    #[must_use]
    pub fn state(&self) -> Option<Equilibrium<D, C>> {
        if self.locals.is_empty() {
            return None;
        }
        let y = self.balanced();
        let segment = self.segment();
        let problem = segment.problem_at(self.tau);
        let travelled = self.travelled + self.travel_rate * self.tau + y / self.weight.sqrt();
        let twist = self.without_free_motions(self.springs.factor.preimage(&travelled));
        // What vanishes here is known up to the rounding of what it was at the beginning of the leg.
        let mut largest = problem.wrench.norm() + segment.direction.norm() * self.tau;
        let mut travel = 0.0_f64;
        let mut forces = Vec::with_capacity(self.locals.len());
        for (i, (local, site)) in self.locals.iter().zip(self.grasp.sites()).enumerate() {
            let root = site.springs.root();
            let force = local.force(&local.stretch(&y, self.tau), &self.facets).component_mul(&root);
            let rate = local.force(&local.stretch_rate(&self.y_rate), &self.facets).component_mul(&root);
            largest = largest.max(force.norm() + rate.norm() * self.tau);
            travel = travel.max(site.span(&problem.drives[i], &twist));
            forces.push(force);
        }
        let states = self.locals.iter().map(|local| State::from(local.code)).collect();
        let found = Found {
            free_motions: self.free_motions(),
            sizes: [largest, travel],
            ..Found::new(states, forces, twist)
        };
        let load = self.program.load_at(self.tau);
        let cone = self.cone_answered();
        Some(self.grasp.equilibrium(&problem, &load, &found, Rung::LoadPath, &Effort::default(), cone))
    }

    /// Forces on the object in the contact frames where the path stands, N: (`F_n`, `F_t`…), in the order of the grasp; empty if there was no
    /// equilibrium to start from. Cheaper than [`Self::state`].
    #[must_use]
    pub fn forces(&self) -> Vec<SVector<f64, C>> {
        let y = self.balanced();
        let force = |(local, site): (&Local<D, C>, &Site<D, C>)| {
            local.force(&local.stretch(&y, self.tau), &self.facets).component_mul(&site.springs.root())
        };
        self.locals.iter().zip(self.grasp.sites()).map(force).collect()
    }

    /// y with what rounding leaves of balance removed from it, summed afresh.
    pub(super) fn balanced(&self) -> SVector<f64, D> {
        let mut y = self.y;
        for _ in 0..CORRECTIONS {
            let mut left = SVector::<f64, D>::zeros();
            for local in &self.locals {
                let x = local.force(&local.stretch(&y, self.tau), &self.facets)
                    - local.trial
                    - local.rate * self.tau;
                left += local.seen.tr_mul(&x);
            }
            y += self.factors.solve(&(left * self.weight));
        }
        y
    }

    /// Unit motions that nothing resists here.
    pub(super) fn free_motions(&self) -> Vec<SVector<f64, D>> {
        let mut motions = self.springs.free.clone();
        for v in self.factors.kernel() {
            let mut v = self.springs.factor.preimage(&v);
            orthonormalise_against(&mut v, &motions);
            motions.push(v);
        }
        motions
    }

    pub(super) fn without_free_motions(&self, mut twist: SVector<f64, D>) -> SVector<f64, D> {
        for v in &self.springs.free {
            twist -= v * v.dot(&twist);
        }
        twist
    }

    /// Nothing drives the object along motions that nothing resists.
    pub(super) fn rest_along_free_motions(&mut self) {
        let kernel = self.factors.kernel();
        if kernel.is_empty() {
            return;
        }
        let scale = self.weight.sqrt();
        let preimage = |y: &SVector<f64, D>| self.springs.factor.preimage(&(y / scale));
        // Pairs of a motion and the same in the coordinates of y, the motions orthonormal.
        let mut known: Vec<(SVector<f64, D>, SVector<f64, D>)> =
            self.springs.free.iter().map(|v| (*v, SVector::zeros())).collect();
        for mut y in kernel {
            let mut v = preimage(&y);
            for _ in 0..2 {
                for (w, z) in &known {
                    let along = w.dot(&v);
                    v -= w * along;
                    y -= z * along;
                }
            }
            let size = v.norm();
            known.push((v / size, y / size));
        }
        let rate = self.springs.factor.preimage(&self.travel_rate) + preimage(&self.y_rate);
        for (v, y) in known {
            self.y_rate -= y * v.dot(&rate);
        }
    }
}
