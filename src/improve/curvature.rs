//! What steps have shown of how the binding events bend: the method of Broyden, Fletcher, Goldfarb and Shanno, damped as Powell has it, so that it stays
//! positive semidefinite (Nocedal and Wright, Numerical Optimization, 2006, section 18.3).

use nalgebra::{DMatrix, DVector};

/// Where less of the curvature told so far is confirmed, what is learnt is mixed with that.
const CONFIRMED: f64 = 0.2;

/// Starts flat: the first steps are those of a linear program.
pub(super) struct Curvature(pub(super) DMatrix<f64>);

impl Curvature {
    pub(super) fn flat(size: usize) -> Self {
        Self(DMatrix::zeros(size, size))
    }

    /// After a step along which the gradient of what is least, with the multipliers as weights, fell by so much.
    pub(super) fn learn(&mut self, step: &DVector<f64>, fell: &DVector<f64>) {
        let length = step.norm_squared();
        if length == 0.0 {
            return;
        }
        let shown = step.dot(fell);
        if self.0.amax() == 0.0 {
            if shown > 0.0 {
                let size = self.0.nrows();
                self.0 = DMatrix::identity(size, size) * (shown / length);
            } else {
                return;
            }
        }
        let told = &self.0 * step;
        let known = step.dot(&told);
        let part = if shown >= CONFIRMED * known { 1.0 } else { (1.0 - CONFIRMED) * known / (known - shown) };
        let mixed = fell * part + &told * (1.0 - part);
        let new = step.dot(&mixed);
        if known > 0.0 && new > 0.0 && new.is_finite() {
            self.0 += &mixed * mixed.transpose() / new - &told * told.transpose() / known;
            self.0 = (&self.0 + self.0.transpose()) * 0.5;
        }
    }
}
