//! Tolerances of load paths: a value below a tolerance is taken as zero, as rounding, or as equal to another. Other constants limit the numbers
//! and lengths of steps.
//!
//! Tolerances are pure numbers, or angles in rad. Unless its comment says otherwise, each number is a fraction of the leg, of the largest force, or
//! of the quantity that is compared. A leg is a section of the load program. The load factor is the multiple of the growing load on a ramp, and the
//! fraction of the leg that is done on a leg. An arc is a part of a leg on which directions of sliding turn. An object snaps over if it moves to
//! another equilibrium under nearly the same load.

use crate::contact::ZERO_SLACK;

/// A leg along which the load turns must begin with the load at which the leg before has ended, unless its first load is zero. Each component of
/// these two loads may differ by this fraction of the largest component of the first load of the leg.
///
/// If smaller, loads that people write with six digits are refused; if larger, loads jump where a leg begins.
pub(super) const AS_WRITTEN: f64 = 1e-6;

/// Beyond the end of a path, another equilibrium is first searched for at this distance, which is a change of the load factor. The unit of the
/// distance is the change that builds up the whole load or all spring offsets from zero at their present rates. If both rates are zero, the unit is
/// the whole leg. For an object that snaps over, this number is the imbalance beyond the end of its path, as a fraction of the largest force.
///
/// If smaller, the equilibrium found differs from the end by rounding only; if larger, the search may find the situation beyond a later event.
pub(super) const LITTLE_BEYOND: f64 = 1e-6;

/// Before an object snaps over, the load is raised by a small step beyond the end of its path, so that forces are out of balance. The step is the
/// fraction [`LITTLE_BEYOND`] of a ratio: the largest force, divided by the imbalance that the whole leg adds. The ratio is taken as at least this
/// number.
///
/// If smaller, an object without force at the end of its path is moved under the same load again and again. If larger, it may be moved under a load
/// beyond a later event.
pub(super) const LEAST_FORCE: f64 = 1e-3;

/// An object that snaps over is at rest once the imbalance of contact forces and load is at most this fraction of the initial imbalance. The
/// remaining imbalance is removed along an additional leg at constant commands.
///
/// If smaller, slow motions take more steps; if larger, an object that still moves is taken as at rest.
pub(super) const AT_REST_AGAIN: f64 = 1e-3;

/// Upper limit of the number of steps in which an object snaps over to another equilibrium; as a rule some dozens are made. With fewer steps, an
/// object that moves slowly away from the end of its path is taken as lost. An object that turns about a stop takes two hundred steps.
pub(super) const MOST_SNAPPING_STEPS: usize = 1000;

/// Upper limit of the number of times that an object snaps over on one leg. If it had to snap over once more, the equilibrium is taken as lost.
///
/// If the object sticks and snaps over again and again, the step in the fraction of the leg doubles each time. At most thirty doublings lead from the
/// shortest step, 1e-9 of the leg, to the whole leg. The limit is larger, because an object may also snap over at separate loads of one leg. A limit
/// is needed because a snap is expensive. It takes as long as a complete search for an equilibrium, and another search (for rates of forces and
/// motion) has failed before it.
pub(super) const MOST_SNAPS: usize = 64;

/// While an object snaps over, a step in time is accepted if the imbalance of forces after it is nearly that expected from the dampers. The
/// difference may be this fraction of the imbalance before the step.
///
/// If smaller, there are more steps; if larger, a step passes over changes of contact states.
pub(super) const AS_EXPECTED: f64 = 0.3;

/// While an object snaps over, the norm of the force imbalance may grow at most by this factor in a step in time.
///
/// If smaller, steps are many when the motion becomes faster; if larger, an implicit step goes back to an equilibrium that is not stable.
pub(super) const FASTEST_GROWTH: f64 = 4.0;

/// While an object snaps over, a step in time of at most this length is accepted in any case. The unit is the time constant of the springs with their
/// dampers, while all contacts stick.
///
/// If smaller, steps are many when contacts chatter; if larger, the contacts overshoot.
pub(super) const SHORTEST_SNAPPING_STEP: f64 = 0.25;

/// The load factor (or angle) of an event is first computed from rates. Then the contact forces at this load factor are computed, and show by how
/// much it must be corrected. The correction may be at most this fraction of the load factor. A larger correction means that the event itself is
/// wrong.
///
/// If smaller, true corrections are thrown away; if larger, wrong events are accepted as corrected.
pub(super) const LARGEST_CORRECTION: f64 = 1e-6;

/// Events may be so close together that the steps between them are too short to advance. A gap or margin is the difference of two terms. Gaps and
/// margins of at most this fraction of their terms are then set to zero, so that these events become one. A margin is the distance of a contact force
/// from the boundary of its cone.
///
/// If smaller, a path ends at an accumulation of events; if larger, it skips separate events.
pub(super) const GATHERED_MARGIN: f64 = 1e-8;

/// `rigid_motion` computes the velocity with which rigid bodies start to move under the load, with the identity as mass matrix. A velocity below this
/// fraction of the norm of the load is taken as zero: contact forces then balance the load up to rounding.
///
/// If smaller, rounding moves a grasp that holds; if larger, a slow motion is taken as rest.
pub(super) const NO_RIGID_MOTION: f64 = 1e-6;

/// A contact force is taken as constant if it changes by at most this fraction of the largest force in a unit of arclength. The fraction of the leg
/// is taken as constant if it changes by at most this number in a unit of arclength. A direction of sliding within this angle (rad) of its final
/// direction has reached it.
///
/// If smaller, rounding seems to turn directions for ever; if larger, directions that still turn are taken as final.
pub(super) const STANDS_STILL: f64 = 1e-10;

/// The normal force of a sliding contact is a sum of terms. If it decreases and is at most this fraction of the terms, the friction force no longer
/// has a certain direction. The error of that direction is the integration error of the steps, divided by this fraction.
///
/// If smaller, friction follows directions that are mere error of steps; if larger, the normal force of a contact that still presses is taken as
/// vanishing.
pub(super) const VANISHING_NORMAL: f64 = 1e-7;

/// Shortest step of a path followed in steps, as a fraction of a leg: if shorter steps are necessary, the path ends.
///
/// If smaller, steps are made whose changes are only rounding; if larger, paths end before an equilibrium that they could reach.
pub(super) const SHORTEST_STEP: f64 = 1e-12;

/// A value that must stay positive along an arc, such as a gap, is taken as zero up to this fraction of its terms. The fraction is the sum of
/// rounding, `ZERO_SLACK`, and of the error of steps along the arc, 1e-13.
///
/// If smaller, events that the error of steps has blurred are found twice; if larger, conditions that nearly fail are taken as events.
pub(super) const SLACK_ON_AN_ARC: f64 = ZERO_SLACK + 1e-13;

/// Directions of friction turn fast if the normal force of a sliding contact is small. The method `in_slips` follows a grasp by the slips of its
/// contacts alone. If a normal force falls below this fraction of the largest contact force at first slip (the event at which the first contact
/// ceases to stick), `in_slips` gives no answer. The grasp is then followed as a load path.
///
/// If smaller, steps become short, since `in_slips` has no implicit steps; if larger, more grasps of a batch take as long as a load path.
pub(super) const LITTLE_NORMAL_FORCE: f64 = 1e-3;
