//! Limits of the search for better finger placement: at which an ascent has reached an optimum, and below which a gain is rounding. The variables of
//! the search are places (positions of contacts on their curves or surfaces) and commanded normal forces; a design point is one choice of all of
//! them.
//!
//! All limits are without units. Variables are divided by their units. The gain is the increase of the value that is maximised. If this value is the
//! load factor of first slip, gains are divided by that factor. If it is the reserve, gains are divided by the greatest contact force under the base
//! load. The reserve is the least margin of a contact force to the boundary of its friction cone.

/// A design point is called an optimum to first order if its residual is at most this number. Gradients of sticking conditions and limits, weighted
/// by their multipliers, sum to zero at an optimum. The residual is the largest component of this sum or, if larger, the residual of complementarity.
///
/// If it were smaller, the search would end as stalled at optima where two sticking conditions of one contact are active. If it were larger, a design
/// point that could still be improved would be called an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// The ascent stops once the residual of first-order optimality is at most this number, which is smaller than [`OPTIMAL`].
///
/// If it were smaller, the last steps would gain rounding only. If it were larger, places of contacts would lose digits.
pub(super) const ARRIVED_AT_TOP: f64 = 1e-10;

/// An ascent ends if the gain that a step predicts is at most this number, because so small a gain is rounding.
///
/// If it were smaller, an ascent would continue until its steps are used up. If it were larger, an ascent would end where the gradient is small.
pub(super) const ROUNDED_GAIN: f64 = 1e-14;

/// A multiplier of the quadratic program (in its scaled numbers) below this is due to rounding, so its sticking condition or limit is not reported.
///
/// If it were smaller, inactive limits would be named. If it were larger, limits with small multipliers would not be named.
pub(super) const ROUNDED_MULTIPLIER: f64 = 1e-7;

/// A contact is refused if its distance from its surface exceeds this number times a length, the sum of the grasp's size and the contact's distance
/// from the origin. It is also refused if the angle between the contact's normal and the normal of the surface exceeds this number, rad.
///
/// If it were smaller, contacts that a file gives with six digits would be refused. If it were larger, the search would visibly displace a contact
/// when it puts the contact on the surface.
pub(super) const OFF_THE_SURFACE: f64 = 1e-6;

/// A contact is at its friction limit under the base load if it uses all but this fraction of its friction. The answer then has a caution.
///
/// If it were smaller, a grasp would get no caution although it slides once its places are rounded to the six digits that are printed. If it were
/// larger, grasps that have friction left would get a caution, too.
pub(super) const AT_ITS_LIMIT: f64 = 1e-4;
