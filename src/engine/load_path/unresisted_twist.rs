//! The component of the twist along motions that nothing resists: free motions stretch no spring; along neutral motions contact forces change but
//! stay in balance. No force determines this component of the twist, so it stays as near as possible to its previous value. It changes only if
//! contacts that touch without force push the object.

use super::segment::Segment;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Vector, add_times};
use crate::object::{ForcesAndTwist, LinearProblem};

impl Segment<'_> {
    /// Returns the rates `rate` of forces and twist, shifted along free and neutral motions: along these motions the returned twist rate agrees with
    /// `pushed`. Other components of the twist rate are not changed. `pushed` is the twist rate that solves the complementarity problem for the rates
    /// of forces and motion. In this problem contacts that touch without force may push the object. If `pushed` is `None`, `rate` is returned
    /// unchanged.
    pub(super) fn pushed_along(
        &self,
        linear_problem: &LinearProblem,
        rate: ForcesAndTwist,
        pushed: Option<&Vector>,
    ) -> ForcesAndTwist {
        let Some(pushed) = pushed else { return rate };
        let apart = pushed - &rate.twist;
        // Along a free or neutral motion the components of two twist rates, that of `rate` and `pushed`, may differ. Their difference is taken as
        // rounding if it is at most the fraction `SOLVED_ROUNDING` of the norm of `pushed`.
        let is_driven = |v: &Vector| v.dot(&apart).abs() > SOLVED_ROUNDING * pushed.norm();
        let moves = linear_problem.free_motions().iter().any(is_driven)
            || linear_problem.neutral_motions().iter().any(is_driven);
        if moves { self.nearest(linear_problem, rate, pushed) } else { rate }
    }

    /// Forces and twist, or their rates, shifted along free and neutral motions of `linear_problem` until the twist (or twist rate) is nearest to
    /// `near`.
    pub(super) fn nearest(
        &self,
        linear_problem: &LinearProblem,
        ForcesAndTwist { mut forces, mut twist }: ForcesAndTwist,
        near: &Vector,
    ) -> ForcesAndTwist {
        for v in linear_problem.free_motions() {
            twist += v * v.dot(&(near - &twist));
        }
        for v in &linear_problem.neutral_motions() {
            let shift = v * v.dot(&(near - &twist));
            twist += &shift;
            add_times(&mut forces, &linear_problem.forces_along(&self.problem, &shift), 1.0);
        }
        ForcesAndTwist { forces, twist }
    }
}
