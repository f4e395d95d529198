//! Tolerances of load paths: below them a value counts as zero, as rounding or as equal to another.
//!
//! All of them are pure numbers, or angles in rad. The numbers are fractions of the leg, of the largest force, or of the quantity that is compared.

use crate::contact::ZERO_SLACK;

/// First distance beyond the end of a path at which another equilibrium is searched for, as a fraction of the whole load or of all commands, or of
/// the leg if there is no load.
///
/// If smaller, the equilibrium beyond differs from the end by rounding only; if larger, a later event decides.
pub(super) const LITTLE_BEYOND: f64 = 1e-6;

/// The distance beyond the end of a path, at which another equilibrium is searched for, is proportional to the largest force. For this purpose the
/// largest force counts as at least this fraction of the force that the whole leg adds.
///
/// If smaller, an object without force at the end of its path is tried under the same load again and again. If larger, a later event decides.
pub(super) const LEAST_FORCE: f64 = 1e-3;

/// An object that snaps over has come to rest where the imbalance of forces is below this fraction of the imbalance that has set it in motion. The
/// remaining imbalance is removed along a leg.
///
/// If smaller, slow motions take more steps; if larger, the object is still on its way.
pub(super) const AT_REST_AGAIN: f64 = 1e-3;

/// The largest number of steps in which an object snaps over to another equilibrium; some dozens are enough as a rule. With fewer, an object that
/// moves slowly away from the end of its path counts as lost: an object that turns about a stop takes two hundred.
pub(super) const MOST_SNAPPING_STEPS: usize = 1000;

/// The largest number of times that an object snaps over on a leg. If it snaps over more often, the load counts as lost.
///
/// Steps of the load double where the object sticks and snaps over again and again: twenty lead from the shortest step to the whole leg, and forty
/// more to the load at which it is lost. Each time takes as long as a whole question whether the load is held, since the search for rates of forces
/// and motion must fail first.
pub(super) const MOST_SNAPS: usize = 64;

/// While an object snaps over, a step is accepted if the imbalance after it differs from the expected one by less than this fraction of the imbalance
/// before it.
///
/// If smaller, steps are many; if larger, a step passes over changes of contact states.
pub(super) const AS_EXPECTED: f64 = 0.3;

/// The largest ratio of the imbalances after and before a step in which an object snaps over.
///
/// If smaller, steps are many where the motion becomes faster; if larger, an implicit step goes back to an equilibrium that is not stable.
pub(super) const FASTEST_GROWTH: f64 = 4.0;

/// While an object snaps over, a step of at most this length is accepted in any case. The unit is the time in which stuck viscous contacts relax.
///
/// If smaller, steps are many where contacts chatter; if larger, the contacts overshoot.
pub(super) const SHORTEST_SNAPPING_STEP: f64 = 0.25;

/// Largest correction of an event's load factor by a solution computed at the event, as a fraction of the factor. A larger one means that the event
/// itself is wrong.
///
/// If smaller, true corrections are thrown away; if larger, wrong events count as corrected.
pub(super) const LARGEST_CORRECTION: f64 = 1e-6;

/// Where events follow each other so closely that steps become too short to advance, margins below this fraction of the size of their terms count as
/// zero.
///
/// If smaller, a path ends where events accumulate; if larger, it skips separate events.
pub(super) const GATHERED_MARGIN: f64 = 1e-8;

/// A rigid motion below this fraction of the load, in the engine's coordinates, counts as zero: contact forces balance the load, up to their rounding.
///
/// If smaller, rounding moves a grasp that holds; if larger, a slow motion counts as none.
pub(super) const NO_RIGID_MOTION: f64 = 1e-6;

/// A force counts as constant if its relative change is below this number while the object moves by the unit of arclength (as far as the whole load
/// moves it at the start). A direction of sliding within this angle of its limit, rad, counts as having reached the limit.
///
/// If smaller, rounding would seem to turn directions for ever; if larger, directions that still turn count as settled.
pub(super) const STANDS_STILL: f64 = 1e-10;

/// A normal force that is below this fraction of the size of its terms, and decreases, no longer determines the direction of friction: that direction
/// has the error of the steps divided by this fraction.
///
/// If smaller, friction follows directions that the steps have blurred; if larger, a contact that still presses counts as vanishing.
pub(super) const VANISHING_NORMAL: f64 = 1e-7;

/// Shortest step, as a fraction of a leg: a path that needs shorter ones ends there.
///
/// If smaller, steps are made of rounding; if larger, paths end before an equilibrium that they could reach.
pub(super) const SHORTEST_STEP: f64 = 1e-12;

/// Value of a condition on an arc up to which the condition counts as zero, as a fraction of the size of its terms. This is the sum of rounding and
/// of the error of the arc's steps, 1e-13.
///
/// If smaller, events that the steps have blurred are found twice; if larger, conditions that nearly fail count as events.
pub(super) const SLACK_ON_AN_ARC: f64 = ZERO_SLACK + 1e-13;

/// If the normal force of a sliding contact falls below this fraction of the largest force, a grasp is followed as a load path, no longer with the
/// slips as unknowns (`in_slips`). Directions of friction then turn fast.
///
/// If smaller, steps become short, since `in_slips` has no implicit steps; if larger, more grasps of a batch take as long as a load path.
pub(super) const LITTLE_NORMAL_FORCE: f64 = 1e-3;
