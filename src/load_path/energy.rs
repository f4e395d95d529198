//! Where the work goes.

use super::segment::{Here, Segment};
use crate::formulation::State;

/// Energies of one leg, J. Along a straight piece forces and motions are affine, so that every integral is exact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Energy {
    /// Work of the load on the object, `∫ W·dq`.
    pub load_work: f64,
    /// Work of the fingers' drives, `Σ ∫ F·du_f`.
    pub finger_work: f64,
    /// Change of the energy stored in the springs, `Δ Σ ½ F²/k`.
    pub stored: f64,
    /// Heat from friction, `Σ ∫ F_t·ds`, never negative.
    pub dissipated: f64,
    /// Sum of the sizes of all pieces' contributions: what the rounding of the balance is measured against.
    pub turnover: f64,
}

impl Energy {
    /// `(load_work + finger_work - stored - dissipated) / turnover`: zero in exact arithmetic.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let excess = self.load_work + self.finger_work - self.stored - self.dissipated;
        if self.turnover > 0.0 { excess / self.turnover } else { 0.0 }
    }

    /// Adds a straight piece from a factor on.
    pub(super) fn add<const D: usize, const C: usize>(
        &mut self,
        segment: &Segment<D, C>,
        states: &[State],
        here: &Here<D, C>,
        factor: f64,
        step: f64,
    ) {
        let middle = segment.problem.wrench + segment.direction * (factor + 0.5 * step);
        let load_work = middle.dot(&here.twist_rate) * step;
        let (mut finger_work, mut stored, mut dissipated) = (0.0, 0.0, 0.0);
        for (i, (line, site)) in here.lines.iter().zip(segment.grasp.sites()).enumerate() {
            let force = line.force + line.rate * (0.5 * step);
            finger_work += force.dot(&segment.change[i]) * step;
            let slips = matches!(states[i], State::Sliding { .. });
            let moving = segment.change[i] - site.map.tr_mul(&here.twist_rate);
            for axis in 0..site.axes {
                // d(½F²/k) = F dF / k, exact at the middle of the piece.
                stored += force[axis] * line.rate[axis] * step / site.k[axis];
                if slips && axis > 0 {
                    dissipated += force[axis] * (moving[axis] - line.rate[axis] / site.k[axis]) * step;
                }
            }
        }
        self.load_work += load_work;
        self.finger_work += finger_work;
        self.stored += stored;
        self.dissipated += dissipated;
        self.turnover += load_work.abs() + finger_work.abs() + stored.abs() + dissipated.abs();
    }
}
