//! The curvature of the search for better finger placement: the Hessian of minus the Lagrangian. The Lagrangian is the sum of constraints and of the
//! values of sticking conditions under loads, weighted by their multipliers, as a function of places and commanded normal forces of contacts. The
//! value of a sticking condition is the load factor that breaks it, or the margin of the contact force to the boundary of its friction cone, N.
//!
//! The Hessian is learnt from the steps of an ascent by the method of Broyden, Fletcher, Goldfarb and Shanno. Powell's damping keeps this matrix
//! positive semidefinite (Nocedal and Wright, Numerical Optimization, 2006, section 18.3).

use nalgebra::{DMatrix, DVector};

/// The approximate Hessian B of minus the Lagrangian. It starts at zero, so that the first steps solve a linear program.
pub(super) struct Curvature(pub(super) DMatrix<f64>);

impl Curvature {
    pub(super) fn flat(size: usize) -> Self {
        Self(DMatrix::zeros(size, size))
    }

    /// Updates B after a step. `decrease` is the gradient of the Lagrangian before the step minus that after the step, both with the same
    /// multipliers.
    pub(super) fn learn(&mut self, step: &DVector<f64>, decrease: &DVector<f64>) {
        let length = step.norm_squared();
        if length == 0.0 {
            return;
        }
        let shown = step.dot(decrease);
        if self.0.amax() == 0.0 {
            if shown > 0.0 {
                let size = self.0.nrows();
                self.0 = DMatrix::identity(size, size) * (shown / length);
            } else {
                return;
            }
        }
        let product = &self.0 * step;
        let known = step.dot(&product);
        // Let d be the step and y the decrease of the gradient. Powell's damping acts if dᵀy is below this fraction of dᵀBd.
        let confirmed = 0.2;
        let part = if shown >= confirmed * known { 1.0 } else { (1.0 - confirmed) * known / (known - shown) };
        let mixed = decrease * part + &product * (1.0 - part);
        let new = step.dot(&mixed);
        if known > 0.0 && new > 0.0 && new.is_finite() {
            for i in 0..step.len() {
                for j in 0..step.len() {
                    self.0[(i, j)] += mixed[i] * mixed[j] / new - product[i] * product[j] / known;
                }
            }
        }
    }
}
