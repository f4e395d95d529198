//! The measure of Ferrari and Canny: the magnitude up to which contact forces within a budget can balance loads of every direction. The budget is an
//! upper limit of the normal force of each contact, or of the sum of all normal forces.
//!
//! C. Ferrari and J. Canny, *Planning optimal grasps*, 1992: the measure is the radius of the largest ball about the origin in the set of wrenches
//! within the budget. With round friction cones this set has no facets to list. It is known by its support points: for each direction, the wrench of
//! the set that does most work along it. They give a lower and an upper bound of the radius.

use super::budget::{Budget, WrenchScale};
use super::wrench_set::WrenchSet;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, largest_ball, simplex};
use crate::search::Settings;

/// The magnitude up to which some contact forces within a budget can balance loads whatever their direction: bounds of the measure ε, and the weakest
/// direction.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WrenchBall<const C: usize> {
    /// Lower bound of ε, N: every load of this magnitude can be balanced. Moments count as forces after division by the length of the
    /// [scale](WrenchScale). Zero if loads in some direction cannot be balanced, however small they are.
    pub at_least: f64,
    /// Upper bound of ε, N. In the plane, on polygonal friction cones, and for most grasps on round cones, both bounds differ by at most 1e-9 of the
    /// largest wrench. On round cones the search approximates the set of wrenches by a polytope. For symmetric grasps its faces may become too thin
    /// or too many: the bounds are then up to a percent apart. They may be farther apart if the search has taken [`Settings::most_steps`] steps.
    pub at_most: f64,
    /// The weakest direction, as a load of magnitude 1 N measured in the scale: more than `at_most` times this load cannot be balanced.
    pub weakest: Wrench<C>,
}

impl Engine {
    pub(crate) fn ferrari_canny(
        &self,
        budget: Budget,
        scale: &WrenchScale<3>,
        settings: &Settings,
    ) -> Result<WrenchBall<3>, Error> {
        let set = self.wrench_set(budget, scale, settings, "ferrari_canny")?;
        let support = |v: &Vector| set.support(v);
        let (at_least, at_most, direction) = match simplex(self.size(), &support) {
            Err(mut flat) => (0.0, 0.0, flat.swap_remove(0)),
            Ok(simplex) => match largest_ball(&support, &simplex, (NEGLIGIBLE, settings.most_steps)) {
                Some(ball) => (ball.at_least.max(0.0), ball.at_most.max(0.0), ball.direction),
                None => (0.0, f64::INFINITY, simplex[0].towards.clone()),
            },
        };
        Ok(WrenchBall { at_least, at_most, weakest: set.outside(-direction) })
    }

    /// The set of wrenches that contact forces within this budget can exert, in this scale. Returns an error for a bad budget or scale, for hands,
    /// and for contacts whose forces a budget does not limit.
    pub(super) fn wrench_set(
        &self,
        budget: Budget,
        scale: &WrenchScale<3>,
        settings: &Settings,
        question: &'static str,
    ) -> Result<WrenchSet, Error> {
        budget.check()?;
        scale.check()?;
        self.refuse_hands(question)?;
        WrenchSet::new(&self.without_load(settings), self, budget, *scale, question)
    }
}
