//! The unit u of displacement in the arclength along an arc, a piece of the load path on which directions of sliding turn. Arclength is measured
//! along the curve (q/u, λ) of the twist q and the fraction λ of the leg. Over a whole leg (a section of the load program) λ grows by 1.

use core::f64::consts::FRAC_PI_2;

use nalgebra::SVector;

use super::piecewise_follower::PiecewiseFollower;
use super::segment::PathPoint;
use super::trajectory::Trajectory;
use crate::numerics::{largest, least};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl PiecewiseFollower<'_> {
    /// Norm of the twist rate at the beginning of an arc, m per unit of λ. Taken as the unit u of displacement, it gives twist and λ equal weight in
    /// the arclength at that point. While the load turns, the present twist rate may be small. Therefore the twist rate after a further quarter
    /// revolution of the load is computed, too, and its norm is added in quadrature. The result is at most 1e6 times the displacement
    /// [`Self::springs_give`], by which the springs give. It is 1 instead of zero.
    pub(super) fn displacement_rate(&self, point: &PathPoint) -> f64 {
        let mut size = point.twist_rate.norm();
        if let Trajectory::Turn { angle, .. } = self.segment.trajectory {
            let later = self.segment.trajectory.rate_at(self.factor + FRAC_PI_2 / angle);
            let at_rest = vec![SVector::zeros(); self.node.states.len()];
            if let Ok(rate) = point.linear_problem.solve(self.segment.grasp.sites(), &at_rest, &later) {
                size = size.hypot(rate.twist.norm());
            }
        }
        // Near a limit load hardly anything resists a motion, and its huge displacement is no useful unit. The displacement is therefore limited to
        // this multiple of the displacement by which the springs give.
        let size = size.min(1e6 * self.springs_give(point));
        if size > 0.0 { size } else { 1.0 }
    }

    /// A scale of displacement, m, the sum of a deflection and the largest change of a contact spring's offset (command minus clearance and slip). It
    /// is the deflection of the softest spring under the sum of the largest present force and the change of the load. Both changes are per unit of λ.
    fn springs_give(&self, point: &PathPoint) -> f64 {
        let sites = self.segment.grasp.sites();
        let softest = least(sites, &|site| site.springs.softest());
        let offsets = largest(&self.segment.change, &SVector::norm);
        let load = self.segment.trajectory.rate_at(self.factor).norm();
        (point.sizes[0] + load) / softest + offsets
    }
}
