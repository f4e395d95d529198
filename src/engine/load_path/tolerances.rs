//! Tolerances of load paths: below them a value counts as zero, as rounding or as equal to another.
//!
//! All of them are pure numbers, or angles in rad. They are parts of the leg, of the largest force, or of the motion that is compared.

use crate::contact::ZERO_SLACK;

/// First distance beyond the end of a path at which another equilibrium is searched for. It is a part of the whole load or of all commands, or of the
/// leg if there is no load.
///
/// Smaller, the equilibrium beyond differs from the end by rounding only; larger, a later event decides.
pub(super) const LITTLE_BEYOND: f64 = 1e-6;

/// An object that has snapped over rests again where its forces balance up to this part of the excess that has set it in motion. What is left is removed
/// along a leg.
///
/// Smaller, slow motions take more steps; larger, the object is still on its way.
pub(super) const AT_REST_AGAIN: f64 = 1e-3;

/// Most steps in which an object snaps over; dozens suffice as a rule. With fewer, an object that moves slowly away from the end of its path counts as
/// lost.
pub(super) const MOST_SNAPPING_STEPS: usize = 200;

/// Most often that an object snaps over on a leg; beyond that it counts as lost. Steps of the load double where it sticks and snaps over again and
/// again, so that twenty lead from the shortest to the whole leg, and forty more to a place where it is lost.
///
/// Each snap takes as long as a verdict: the search for rates without a solution.
pub(super) const MOST_SNAPS: usize = 64;

/// A step in which an object snaps over is taken where the imbalance after it differs from the expected one by less than this part of that before it.
///
/// Smaller, steps are many; larger, a step passes over changes of contact states.
pub(super) const AS_EXPECTED: f64 = 0.3;

/// The largest ratio of the imbalances after and before a step in which an object snaps over.
///
/// Smaller, steps are many where the motion becomes faster; larger, an implicit step goes back to an equilibrium that is not stable.
pub(super) const FASTEST_GROWTH: f64 = 4.0;

/// Length of a step in which an object snaps over, as a part of the time in which stuck contacts relax, below which it is taken in any case.
///
/// Smaller, steps are many where contacts chatter; larger, they overshoot.
pub(super) const SHORTEST_SNAPPING_STEP: f64 = 0.25;

/// Largest correction of an event's load factor by the solve at the event, as a part of the factor. A larger one means that the event itself is
/// wrong.
///
/// Smaller, true corrections are thrown away; larger, wrong events count as corrected.
pub(super) const LARGEST_CORRECTION: f64 = 1e-6;

/// Margins below this part of their size count as zero where events accumulate towards a point, and steps become too short to advance.
///
/// Smaller, a path ends where events accumulate; larger, it skips separate events.
pub(super) const GATHERED_MARGIN: f64 = 1e-8;

/// A rigid motion below this part of the load, in the engine's coordinates, counts as zero: contact forces balance the load, up to their rounding.
///
/// Smaller, rounding moves a grasp that holds; larger, a slow motion counts as none.
pub(super) const NO_RIGID_MOTION: f64 = 1e-6;

/// A force is constant if its relative change is below this, while the object moves as far as for the whole load at the start. A direction has
/// reached its limit within this angle, rad.
///
/// Smaller, rounding would seem to turn directions for ever; larger, directions that still turn count as settled.
pub(super) const STANDS_STILL: f64 = 1e-10;

/// A normal force that is below this part of its size, and decreases, no longer determines the direction of friction: that direction has the error of
/// the steps divided by this part.
///
/// Smaller, friction follows directions that the steps have blurred; larger, a contact that still presses counts as vanishing.
pub(super) const VANISHING_NORMAL: f64 = 1e-7;

/// Shortest step, as a part of a leg: a path that needs shorter ones ends there.
///
/// Smaller, steps are made of rounding; larger, paths end before an equilibrium that they could reach.
pub(super) const SHORTEST_STEP: f64 = 1e-12;

/// Value of a condition on an arc that counts as zero, as a part of its size. It is made of rounding and of the error of the arc's steps, 1e-13.
///
/// Smaller, events that the steps have blurred are found twice; larger, conditions that nearly fail count as events.
pub(super) const SLACK_ON_AN_ARC: f64 = ZERO_SLACK + 1e-13;

/// Normal force of a sliding contact, as a part of the largest force, below which a grasp is not followed by its slips but as a load path: directions
/// of friction then turn fast.
///
/// Smaller, steps become short, and none is implicit; larger, more rows of a batch take the time of a path.
pub(super) const LITTLE_NORMAL_FORCE: f64 = 1e-3;
