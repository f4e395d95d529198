//! The numbers below which a load path takes a value for zero, for rounding or for the same.
//!
//! All of them are pure numbers, or angles in rad. They are parts of the leg, of the largest force, or of the motion that is compared.

use crate::contact::ZERO_SLACK;

/// First distance beyond the end, as a part of the whole load or of all commands, or of the leg where there is no load.
///
/// Smaller, the equilibrium beyond differs from the end by rounding only; larger, a later event decides.
pub(super) const LITTLE_BEYOND: f64 = 1e-6;

/// Largest correction of an event's load factor by the solve at the event, as a part of it. A larger one means that something else is wrong.
///
/// Smaller, true corrections are thrown away; larger, wrong events count as corrected.
pub(super) const LARGEST_CORRECTION: f64 = 1e-6;

/// Margins below this part of their size count as zero where steps die out, because events follow each other ever faster there.
///
/// Smaller, a path ends where events gather; larger, it skips events that lie apart.
pub(super) const GATHERED_MARGIN: f64 = 1e-8;

/// A motion below this part of the load's counts as zero, up to the rounding of forces: contacts push it back entirely, or nearly so.
///
/// Smaller, rounding moves a grasp that holds; larger, a slow motion counts as none.
pub(super) const NO_RIGID_MOTION: f64 = 1e-6;

/// A force is constant if its relative change is below this, while the object moves as far as for the whole load at the start. A direction has
/// reached its limit within this angle, rad.
///
/// Smaller, rounding would seem to turn directions for ever; larger, directions that still turn count as settled.
pub(super) const STANDS_STILL: f64 = 1e-10;

/// A normal force below this part of its size, on its way to zero, does not give the direction of friction any more. Its relative error is the error
/// of the steps divided by this part.
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

/// Normal force of a sliding contact, as a part of the largest force, below which a course in slips is left to a path: directions turn fast there.
///
/// Smaller, steps become short, and none is implicit; larger, more rows of a batch take the time of a path.
pub(super) const LITTLE_NORMAL_FORCE: f64 = 1e-3;
