//! Snapping over: the equilibrium of a load path ends, and the object moves on under nearly the same load until it rests in another equilibrium. The
//! path ends at a fold, a corner or an asymptote ([`LossKind`]). A fold is a maximum of the load; at a corner no contact states continue the path; it
//! approaches the load of an asymptote but never reaches it. A leg is a section of the load program. A jump is a motion of the object, at constant
//! load, to another equilibrium; a piece is a section of the path on which all contacts keep their states.
//!
//! Other equilibria may exist beyond the end of a path. Which of them the object reaches depends on its motion after the end. This motion is
//! computed in an artificial model with a viscous damper at each contact, in proportion to the stiffness K_i of its springs. The load W is
//! slightly beyond the end of the path, and q is the twist of the object. Contact i has the grasp map G_i, the spring offset a_i (commanded
//! displacement minus clearance), the accumulated slip s_i, and the force F_i as a function of its stretch. R is the imbalance of forces:
//!
//! ```text
//! Σ G_i K_i G_iᵀ dq/dt = R(q),      R(q) = Σ G_i F_i(a_i - s_i - G_iᵀq) + W
//! ```
//!
//! A step in time of length h solves `(T + D/h) Δq = R`, where D is the matrix `Σ G_i K_i G_iᵀ` and T the tangent stiffness. Then the slip of every
//! contact in this step is added to its accumulated slip s_i. Steps become longer as long as the imbalance after each step is nearly D Δq/h, the
//! value expected from the dampers. Once forces nearly balance, the imbalance R that is left is removed along an additional leg. Along this leg
//! commands stay constant, and only the imbalance changes the load. The path continues at the end of this leg. If the motion exceeds the limits of
//! small motions, the equilibrium is taken as lost.

use nalgebra::SVector;

use super::event::{Change, Event, Loss, LossKind};
use super::jump::Jump;
use super::jump_leg::JumpInProgress;
use super::node::{Node, directions};
use super::path_state::softest_spring_force;
use super::piecewise_follower::PiecewiseFollower;
use super::program_run::ProgramRun;
use super::segment::Segment;
use super::tolerances::{
    AS_EXPECTED, AT_REST_AGAIN, FASTEST_GROWTH, LEAST_FORCE, LITTLE_BEYOND, MOST_SNAPPING_STEPS, MOST_SNAPS,
    SHORTEST_SNAPPING_STEP,
};
use super::trajectory::Trajectory;
use super::transition::change;
use crate::contact::ContactResponse;
use crate::grasp::{Engine, Site};
use crate::numerics::{IntoList, PartialPivoting, Vector, largest};
use crate::object::{Problem, tangent_stiffness, uses_band};
use crate::prelude::*;
use crate::search::{SearchSolution, SmallMotions};

/// The moving object at one time: its twist, the force and state of each contact, and the imbalance `left` of contact forces and load.
struct MovingObject {
    twist: Vector,
    contacts: Vec<ContactResponse>,
    left: Vector,
}

/// The equilibrium in which the object rests again after it has snapped over. Its contact forces balance the load up to a small remainder.
pub(super) struct StateAfterSnap<'g> {
    /// The static problem with the slips after the motion. Its load is changed by the small imbalance that remains, so that the contact forces
    /// balance the load exactly.
    problem: Problem<'g>,
    contacts: Vec<ContactResponse>,
    twist: Vector,
}

impl<'g> StateAfterSnap<'g> {
    /// Moves the object from the twist `start`, at which forces do not balance, to a twist at which they nearly balance. The motion is that of the
    /// model with dampers. `None` if the motion exceeds the limits `small` or does not end, or for a grasp of so many coordinates that it is solved
    /// with band matrices.
    pub(super) fn near(
        grasp: &Engine,
        small: &SmallMotions,
        mut problem: Problem<'g>,
        start: &Vector,
    ) -> Option<Self> {
        // If a grasp has so many coordinates that matrices are stored as bands, each step in time takes longer than following the whole path.
        if uses_band(problem.size()) {
            return None;
        }
        let damper = |problem: &Problem, i: usize| {
            let local = problem.local(i);
            local.tangent(&local.trial_state()).matrix()
        };
        let damping = tangent_stiffness(problem.sites, &|i| damper(&problem, i));
        let none = vec![ContactResponse::open(); problem.len()];
        // The call of `MovingObject::at` below decides whether a contact that slides with kinetic friction sticks and regains static friction. At the
        // start this depends on rounding alone, so the friction cones from before the call are restored after it.
        let cones = problem.cones.clone();
        // At the start it also depends on rounding alone whether a contact on the boundary of its cone sticks. In the matrix of the first step in
        // time all contacts are therefore taken as open, so that this matrix has the dampers alone.
        let mut here =
            MovingObject { contacts: none.clone(), ..MovingObject::at(start.clone(), none, &mut problem) };
        problem.cones = cones;
        let (at_first, mut length) = (here.left.norm(), 1.0);
        for _ in 0..MOST_SNAPPING_STEPS {
            if here.left.norm() <= AT_REST_AGAIN * at_first {
                problem.wrench -= &here.left;
                return Some(Self { problem, contacts: here.contacts, twist: here.twist });
            }
            let both = |i: usize| {
                problem.local(i).tangent(&here.contacts[i].state).matrix() + damper(&problem, i) / length
            };
            let factors = PartialPivoting::new(&tangent_stiffness(problem.sites, &both));
            // Near an unstable equilibrium a long implicit step goes back to this equilibrium. The determinant of the matrix of the step is then not
            // positive, and a shorter step is tried.
            let Some(factors) = factors.filter(PartialPivoting::is_positive) else {
                length *= SHORTER;
                if length < SHORTEST_SNAPPING_STEP {
                    return None;
                }
                continue;
            };
            let step = factors.solve(&here.left);
            let expected = &damping * &step * (1.0 / length);
            let before = (problem.slips.clone(), problem.offsets.clone(), problem.cones.clone());
            let next = MovingObject::at(&here.twist + &step, here.contacts.clone(), &mut problem);
            let is_as_expected = (&next.left - &expected).norm() <= AS_EXPECTED * here.left.norm();
            let grows = next.left.norm() > FASTEST_GROWTH * here.left.norm() || step.dot(&here.left) <= 0.0;
            if length > SHORTEST_SNAPPING_STEP && (grows || !is_as_expected) {
                (problem.slips, problem.offsets, problem.cones) = before;
                length *= SHORTER;
                continue;
            }
            if !is_small(grasp, small, &(&next.twist - start)) {
                return None;
            }
            length *= LONGER;
            here = next;
        }
        None
    }
}

/// The step, in the fraction of the leg, by which the load is increased beyond a loss of equilibrium, so that the object moves to another
/// equilibrium. The step puts forces out of balance by the fraction `LITTLE_BEYOND`, 1e-6, of the largest force `largest`, N. `change` are the rates
/// of the contacts' spring offsets and `rate` is the rate of the load, both per unit of the fraction of the leg.
///
/// `largest` is replaced by [`LEAST_FORCE`] times the imbalance that the whole leg adds, if that is more. If this were not done, the step would be
/// zero for a grasp without any force.
pub(super) fn a_little(sites: &[Site], change: &[SVector<f64, 3>], mut rate: Vector, largest: f64) -> f64 {
    for (site, change) in sites.iter().zip(change) {
        site.map.push(&site.springs.force(change), &mut rate);
    }
    LITTLE_BEYOND * (largest / rate.norm()).max(LEAST_FORCE)
}

/// How often the object has snapped over to another equilibrium on a leg so far, and where on the leg it last came to rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct SnapCount {
    count: usize,
    /// The fraction of the leg at which the object last came to rest after it had snapped over; NaN if it has not snapped over yet.
    at: f64,
    /// The fraction of the leg at which the object last came to rest, minus that of the loss from which it had snapped over.
    step: f64,
}

impl SnapCount {
    /// The value at the start of each leg, before the object has snapped over.
    pub(super) const NEVER: Self = Self { count: 0, at: f64::NAN, step: 0.0 };
}

/// Whether the motion `moved` is small: no body turns by more than the limit of small motions for rotations, and no contact point moves by more
/// than the limit for slips.
fn is_small(grasp: &Engine, small: &SmallMotions, moved: &Vector) -> bool {
    let turns_little =
        grasp.each_moves(moved).iter().all(|body| body.twist.parts().1.size() <= small.rotation);
    let most = small.slip * grasp.size_of_grasp();
    turns_little && grasp.sites()[..grasp.len()].iter().all(|site| site.map.tr_mul(moved).norm() <= most)
}

/// Factor by which the length of a step grows after an accepted step, both for steps in time and for steps in the fraction of the leg.
const LONGER: f64 = 2.0;
/// Factor by which the length of a step is multiplied after a refused step.
const SHORTER: f64 = 0.25;

impl MovingObject {
    /// The moving object at the twist `twist`. `contacts` are the last responses, from which the new responses are computed. The slip of each contact
    /// is added to the slips in `problem`.
    fn at(twist: Vector, mut contacts: Vec<ContactResponse>, problem: &mut Problem) -> Self {
        let left = problem.yield_to(&twist, &mut contacts);
        Self { twist, contacts, left }
    }
}

impl<'g> PiecewiseFollower<'g> {
    /// The event that replaces the loss `loss`: the object snaps over to another equilibrium at a slightly larger fraction of the leg, from which the
    /// path continues. `None` if the object does not come to rest within small motions. Also `None`, without a try, for losses of the kinds `LetsGo`,
    /// `TooFar` and `GivesWay`, and for grasps with suction cups. `None` also at the end of a leg, after a jump that failed, and if the object has
    /// snapped over [`MOST_SNAPS`] times on this leg.
    pub(super) fn snaps_over(&mut self, run: &ProgramRun<'g>, loss: &Loss<3>) -> Option<Event<3>> {
        let ends_in_balance = !matches!(loss.kind, LossKind::LetsGo | LossKind::TooFar | LossKind::GivesWay);
        // The model with dampers keeps the pull of a vacuum even if its cup opens during the motion, so grasps with cups are excluded.
        let has_cups = self.segment.grasp.vacuum().is_some();
        if !ends_in_balance
            || has_cups
            || self.factor >= 1.0
            || self.failed_jump.is_some()
            || self.snapped.count >= MOST_SNAPS
        {
            return None;
        }
        let Segment { grasp, change, trajectory, .. } = &self.segment;
        let (load, rate) = (trajectory.at(self.factor), trajectory.rate_at(self.factor));
        // Contacts may carry no force at all. The largest force is therefore the maximum over the contact forces, the load, and the least force that
        // the displacements cause in a spring.
        let springs = softest_spring_force(&self.segment.problem_at(self.factor), &self.node.at.twist);
        let most = largest(&self.node.at.forces, &SVector::norm).max(load.norm()).max(springs);
        let least = a_little(grasp.sites(), change, rate, most);
        // If an object snaps over again before the fraction of the leg has grown by the step of the last snap, this step is doubled. If it were not,
        // an object that sticks and snaps over again and again would need too many snaps.
        let is_again = self.factor - self.snapped.at <= self.snapped.step;
        let mut step = if is_again { (LONGER * self.snapped.step).max(least) } else { least };
        loop {
            if let event @ Some(_) = self.snaps_within(step, run) {
                return event;
            }
            if step <= least {
                return None;
            }
            step = (SHORTER * step).max(least);
        }
    }

    /// The event at which the object snaps over and comes to rest under a slightly larger load. The fraction of the leg grows by `step`, but not
    /// beyond 1. `None` if the object does not come to rest.
    fn snaps_within(&mut self, step: f64, run: &ProgramRun<'g>) -> Option<Event<3>> {
        let state = self.state_before_event().or_else(|| self.present_state(run))?;
        let beyond = (self.factor + step).min(1.0);
        let goal = self.segment.trajectory.at(beyond);
        // Just before the end of a leg the rest of the leg changes the load by rounding only, too little to move the object. The object therefore
        // moves under the load at `factor + step`, even if that is beyond the end of the leg.
        let rests = self.rests_again(self.factor + step)?;
        let (leg, changes) = self.back_to_balance(rests, beyond);
        let mut jump = JumpInProgress::after(leg, &self.segment.problem.slips);
        jump.leg.pace.steps = self.pace.steps + 1;
        jump.note(&changes);
        // The event itself lists the changes of contact states at the end of the path; the jump lists only the changes after them.
        jump.changes.clear();
        jump.run(&goal, run).ok()?;
        let event = self.caught(run, changes, state);
        // An equilibrium at a fraction of the leg is computed later from the stored piece of the path that contains this fraction. If the object
        // snaps over at the very start of a leg, no such piece is stored yet, so a piece is made from the present path point.
        let is_first = self.piece_behind(run.program.leg, self.factor).is_none();
        let start = is_first.then(|| self.present_piece(run)).flatten();
        let end = core::mem::replace(&mut self.factor, beyond);
        let Ok(jump) = self.end_jump(run, &goal, jump) else {
            self.factor = end;
            return None;
        };
        let rests = self.behind.pop();
        self.behind.extend(start.into_iter().chain(rests));
        self.at_node = true;
        self.snapped = SnapCount { count: self.snapped.count + 1, at: beyond, step };
        Some(Event { jump: Some(Box::new(Jump { snaps: true, ..jump })), ..event })
    }

    /// The equilibrium in which the object, moving from its present twist, comes to rest. The load is that at the fraction `beyond` of the leg,
    /// slightly larger than at the loss. `None` if the object does not come to rest.
    fn rests_again(&self, beyond: f64) -> Option<StateAfterSnap<'g>> {
        let Segment { grasp, answer_for, .. } = &self.segment;
        StateAfterSnap::near(grasp, &answer_for.small, self.segment.problem_at(beyond), &self.node.at.twist)
    }

    /// The follower of an additional leg, along which the remaining imbalance of forces in `rests` is removed while the fraction of the leg stays at
    /// `factor`. Also returns the changes from the present contact states to those of `rests`.
    fn back_to_balance(&self, rests: StateAfterSnap<'g>, factor: f64) -> (Self, Vec<(usize, Change<3>)>) {
        let StateAfterSnap { problem, contacts, twist } = rests;
        let mut segment = self.segment.at_rest(factor);
        let (from, goal) = (problem.wrench.clone(), segment.trajectory.at(0.0));
        segment.trajectory = Trajectory::Straight { rate: goal - &from, from };
        segment.problem = problem;
        let forces = contacts.iter().map(|contact| contact.force).list();
        let found = SearchSolution::new(contacts.iter().map(|contact| contact.state).list(), forces, twist);
        let (states, before) = (found.states.clone(), &self.node);
        let ways = directions(&segment.problem, &found);
        let node = Node { holds: before.holds.clone(), ..Node::at_start(&mut segment, found) };
        let changes = (0..states.len()).filter_map(|i| {
            let was = (before.states[i], before.directions[i]);
            change(was, (states[i], ways[i])).map(|change| (i, change))
        });
        let changes = changes.list();
        (Self { at_node: true, ..Self::at_segment_start(segment, node) }, changes)
    }
}

impl Problem<'_> {
    /// Writes the response of each contact to a twist into `contacts`, and adds the slip of each contact to the slips in this problem. Returns
    /// the imbalance of contact forces and load.
    fn yield_to(&mut self, twist: &Vector, contacts: &mut [ContactResponse]) -> Vector {
        let mut left = self.wrench.clone();
        for i in 0..contacts.len() {
            let (local, stretch) = (self.local(i), self.stretch(i, twist));
            let near = contacts[i].state.slide().map_or(0.0, |slide| slide.lambda);
            let response = local.response(&stretch, near);
            let springs = local.springs;
            if !response.state.is_sticking() && springs.resists_tangentially() {
                let slip = springs.slip(&stretch, &response.force);
                self.slips[i] += slip;
                self.offsets[i] -= slip;
            }
            if let Some(cone) = self.cones.get_mut(i) {
                let site = &self.sites[i];
                *cone = site.kinetic.filter(|_| response.state.slides()).unwrap_or(site.friction);
            }
            self.sites[i].map.push(&response.force, &mut left);
            contacts[i] = response;
        }
        left
    }
}
