//! The unit of arclength along an arc: the displacement that counts as much as the whole leg.

use core::f64::consts::FRAC_PI_2;

use nalgebra::SVector;

use super::pieces::Pieces;
use super::segment::Here;
use super::trajectory::Trajectory;
use crate::numerics::Size;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// The object moves no more than so many times as far as the softest spring gives: what counts in arclength as much as the whole leg.
const MOST_AMPLIFIED: f64 = 1e6;

impl<D: Size, const C: usize> Pieces<'_, D, C> {
    /// How far the object moves for one unit of the factor to begin with; while the load turns, at a place where it moves fast.
    pub(super) fn displacement_rate(&self, here: &Here<D, C>) -> f64 {
        let mut size = here.twist_rate.norm();
        if let Trajectory::Turn { angle, .. } = self.segment.course {
            let later = self.segment.course.rate_at(self.factor + FRAC_PI_2 / angle);
            let at_rest = vec![SVector::zeros(); self.node.states.len()];
            if let Ok(rate) = here.piece.solve(self.segment.grasp.sites(), &at_rest, &later) {
                size = size.hypot(rate.twist.norm());
            }
        }
        // Beside a limit load hardly anything resists a motion, and a displacement beyond all bounds would be no measure of any other.
        let size = size.min(MOST_AMPLIFIED * self.springs_give(here));
        if size > 0.0 { size } else { 1.0 }
    }

    /// How far the softest spring gives under all forces that there are or that come for one unit of the factor.
    fn springs_give(&self, here: &Here<D, C>) -> f64 {
        let sites = self.segment.grasp.sites();
        let softest = sites.iter().map(|site| site.springs.softest()).fold(f64::INFINITY, f64::min);
        let drives = self.segment.change.iter().map(SVector::norm).fold(0.0, f64::max);
        let load = self.segment.course.rate_at(self.factor).norm();
        (here.sizes[0] + load) / softest + drives
    }
}
