//! Tolerances of load paths: below them a value counts as zero, as rounding or as equal to another.
//!
//! All of them are pure numbers, or angles in rad. They are parts of the leg, of the largest force, or of the motion that is compared.

use crate::contact::ZERO_SLACK;

/// First distance beyond the end of a path at which another equilibrium is searched for. It is a part of the whole load or of all commands, or of the
/// leg if there is no load.
///
/// If smaller, the equilibrium beyond differs from the end by rounding only; if larger, a later event decides.
pub(super) const LITTLE_BEYOND: f64 = 1e-6;

/// An object that has snapped over rests again where its forces balance up to this fraction of the excess that has set it in motion. What is left is removed
/// along a leg.
///
/// If smaller, slow motions take more steps; if larger, the object is still on its way.
pub(super) const AT_REST_AGAIN: f64 = 1e-3;

/// Most steps in which an object snaps over; dozens suffice as a rule. With fewer, an object that moves slowly away from the end of its path counts as
/// lost.
pub(super) const MOST_SNAPPING_STEPS: usize = 200;

/// Most often that an object snaps over on a leg. One that sticks and snaps over again and again counts as lost then: each time the search for rates
/// without a solution takes as long as a verdict.
pub(super) const MOST_SNAPS: usize = 16;

/// A step in which an object snaps over is taken where the imbalance after it differs from the expected one by less than this fraction of that before it.
///
/// If smaller, steps are many; if larger, a step passes over changes of contact states.
pub(super) const AS_EXPECTED: f64 = 0.3;

/// The largest ratio of the imbalances after and before a step in which an object snaps over.
///
/// If smaller, steps are many where the motion becomes faster; if larger, an implicit step goes back to an equilibrium that is not stable.
pub(super) const FASTEST_GROWTH: f64 = 4.0;

/// Length of a step in which an object snaps over, as a part of the time in which stuck contacts relax, below which it is taken in any case.
///
/// If smaller, steps are many where contacts chatter; if larger, they overshoot.
pub(super) const SHORTEST_SNAPPING_STEP: f64 = 0.25;

/// Largest correction of an event's load factor by the solve at the event, as a part of the factor. A larger one means that the event itself is
/// wrong.
///
/// If smaller, true corrections are thrown away; if larger, wrong events count as corrected.
pub(super) const LARGEST_CORRECTION: f64 = 1e-6;

/// Margins below this fraction of their size count as zero where events accumulate towards a point, and steps become too short to advance.
///
/// If smaller, a path ends where events accumulate; if larger, it skips separate events.
pub(super) const GATHERED_MARGIN: f64 = 1e-8;

/// A rigid motion below this fraction of the load, in the engine's coordinates, counts as zero: contact forces balance the load, up to their rounding.
///
/// If smaller, rounding moves a grasp that holds; if larger, a slow motion counts as none.
pub(super) const NO_RIGID_MOTION: f64 = 1e-6;

/// A force is constant if its relative change is below this, while the object moves as far as for the whole load at the start. A direction has
/// reached its limit within this angle, rad.
///
/// If smaller, rounding would seem to turn directions for ever; if larger, directions that still turn count as settled.
pub(super) const STANDS_STILL: f64 = 1e-10;

/// A normal force that is below this fraction of its size, and decreases, no longer determines the direction of friction: that direction has the error of
/// the steps divided by this fraction.
///
/// If smaller, friction follows directions that the steps have blurred; if larger, a contact that still presses counts as vanishing.
pub(super) const VANISHING_NORMAL: f64 = 1e-7;

/// Shortest step, as a part of a leg: a path that needs shorter ones ends there.
///
/// If smaller, steps are made of rounding; if larger, paths end before an equilibrium that they could reach.
pub(super) const SHORTEST_STEP: f64 = 1e-12;

/// Value of a condition on an arc that counts as zero, as a part of its size. It is made of rounding and of the error of the arc's steps, 1e-13.
///
/// If smaller, events that the steps have blurred are found twice; if larger, conditions that nearly fail count as events.
pub(super) const SLACK_ON_AN_ARC: f64 = ZERO_SLACK + 1e-13;

/// Normal force of a sliding contact, as a part of the largest force, below which a grasp is not followed by its slips but as a load path: directions
/// of friction then turn fast.
///
/// If smaller, steps become short, and none is implicit; if larger, more rows of a batch take the time of a path.
pub(super) const LITTLE_NORMAL_FORCE: f64 = 1e-3;
