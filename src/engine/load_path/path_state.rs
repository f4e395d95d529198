//! What the load path stores of contacts at a node (an event, or the start of a leg): active sets and accumulated slips. The active set of a contact
//! consists of the facets of its friction cone on which its force lies. On the round cone the tangent plane at the force takes the place of a facet.
//! A leg is a section of the load program. A piece is a part of a leg with fixed contact states; an arc is a piece on which directions of sliding
//! turn. At the apex of its cone a contact force is zero.

use crate::numerics::{IntoList, Vector, largest};
use nalgebra::SVector;

use super::first_exits::ExitsReached;
use super::node::{Node, directions};
use super::segment::{PathPoint, Segment};
use super::tolerances::GATHERED_MARGIN;
use super::trajectory::Trajectory;
use super::watched_condition::{has_vanished, is_vanishing};
use crate::contact::{ActiveSet, Line, State, ZERO_SLACK, tangential};
use crate::equilibrium::NoEquilibrium;
use crate::numerics::tolerances::ROUNDED_SUM;
use crate::object::{ForcesAndTwist, Problem, least_spring_force};
use crate::prelude::*;
use crate::search::SearchSolution;

/// Whether load and all contact forces are at most as large as the force that rounding of the displacements causes in the softest spring. If so,
/// rounding alone determines which contacts press, and no contact is treated as pressing. In a problem for rates, load, forces and motions are rates.
pub(super) fn forces_are_rounding(problem: &Problem<'_>, forces: &[SVector<f64, 3>], twist: &Vector) -> bool {
    let largest = largest(forces, &SVector::norm).max(problem.wrench.norm());
    // `ROUNDED_SUM` is the rounding error of a sum of about sixteen terms, relative to its largest term. Below this fraction of the force that the
    // displacements cause in the softest spring, forces are rounding errors.
    largest <= ROUNDED_SUM * softest_spring_force(problem, twist)
}

/// The least force, N, that the displacements in the equilibrium cause in a spring: for each contact its displacement times the stiffness of its
/// softest spring, and of these forces the least. Rounding errors of contact forces are proportional to this force, however small the contact forces
/// are.
pub(super) fn softest_spring_force(problem: &Problem<'_>, twist: &Vector) -> f64 {
    let spans = (0..problem.len()).map(|contact| problem.span(contact, twist));
    least_spring_force(problem.sites, spans)
}

impl Node {
    /// The node at the start of the path, in the equilibrium `found`. The active sets are derived from forces and gaps, since the search for an
    /// equilibrium does not return them. The slip of sliding contacts in `found` becomes their accumulated slip.
    pub(super) fn at_start(segment: &mut Segment<'_>, found: SearchSolution) -> Self {
        let n = segment.problem.len();
        let mut node = Self {
            directions: directions(&segment.problem, &found),
            states: found.states,
            active_sets: vec![ActiveSet::EMPTY; n],
            holds: vec![false; n],
            starts_at_apex: false,
            stopped: Vec::new(),
            at: ForcesAndTwist { forces: found.forces, twist: found.twist },
            ahead: 0.0,
        };
        if forces_are_rounding(&segment.problem, &node.at.forces, &node.at.twist) {
            node.at.forces.fill(SVector::zeros());
        }
        if segment.problem.round {
            node.slip_until_now(segment, 0.0);
        }
        // The point is computed with constant load and commands, because active sets depend on forces and gaps alone, not on their rates.
        if let Ok(point) = node.point_at(&segment.at_rest(0.0), 0.0, None) {
            node.set_active_sets(segment, &point);
        }
        node
    }

    /// Whether a contact slides on the round cone. The path is then an arc, along which directions of sliding turn.
    pub(super) fn turns(&self) -> bool {
        self.states.iter().any(|state| state.slide().is_some())
    }

    /// Forces, twist, gaps and their rates at the fraction `factor` of the leg, in the contact states of this node. Along motions that no spring
    /// resists, the object moves at the twist rate `pushed`, because contacts that touch without force push it. Returns an error if forces cannot
    /// balance the load or its rate.
    pub(super) fn point_at(
        &self,
        segment: &Segment<'_>,
        factor: f64,
        pushed: Option<&Vector>,
    ) -> Result<PathPoint, NoEquilibrium<3>> {
        if self.turns() {
            segment.tangent(&self.states, factor, &self.at, pushed)
        } else {
            segment.point_at(&self.states, factor, Some(&self.at.twist), pushed)
        }
    }

    /// Adds the slip of sliding contacts up to the fraction `factor` of the leg to their accumulated slip. On the round cone the direction of the
    /// present friction force is stored in the contact state and the active set of each sliding contact.
    fn slip_until_now(&mut self, segment: &mut Segment<'_>, factor: f64) {
        for i in 0..self.states.len() {
            if self.states[i].slides() {
                segment.remember_slip(i, factor, &self.at.twist, &self.at.forces[i]);
                if segment.problem.round {
                    let state = State::sliding_along(&self.at.forces[i]);
                    self.active_sets[i].facets =
                        state.slide().map(|slide| slide.direction).into_iter().list();
                    self.states[i] = state;
                }
            }
        }
    }

    fn set_active_sets(&mut self, segment: &mut Segment<'_>, point: &PathPoint) {
        for (i, line) in point.lines.iter().enumerate() {
            if self.states[i].is_open() {
                self.active_sets[i].apex = point.gaps[i].gap <= ZERO_SLACK * point.gaps[i].size;
                continue;
            }
            self.active_sets[i] = segment.problem.local(i).active_set(line);
            if !segment.problem.round && self.states[i].slides() {
                segment.remember_slip(i, 0.0, &point.twist, &line.force);
            }
        }
    }

    /// Adds to the active set of each contact in `reached` the facet or the apex of the cone that the contact's force has reached: there the contact
    /// stops sticking or sliding. A gap that has closed counts as the apex (zero force), since the contact starts without force.
    pub(super) fn add_exits(&mut self, axes: usize, reached: &ExitsReached) {
        for (i, exits) in reached {
            self.active_sets[*i].add_exits(axes, &self.states[*i], exits);
        }
    }

    /// Moves the node to the end of a piece of the path, at the fraction `factor` of the leg. `point` is the beginning of the piece and `end` its
    /// end. The slip on the piece is added to the accumulated slip.
    pub(super) fn move_to_end(
        &mut self,
        segment: &mut Segment<'_>,
        point: &PathPoint,
        factor: f64,
        end: &ForcesAndTwist,
    ) {
        self.at = end.clone();
        if matches!(segment.trajectory, Trajectory::Turn { .. }) {
            self.drop_by_force(segment, point, factor);
        }
        segment.largest = segment.largest.max(point.sizes[0]);
        for (i, (line, force)) in point.lines.iter().zip(&end.forces).enumerate() {
            let closed = !self.states[i].is_open();
            // A sticking contact whose force is zero at the beginning of the piece was at the apex of its cone already. It has not come to the apex
            // on this piece. A contact that began to slide from the apex, and still has no force, is at the apex.
            let comes_there = line.force.norm() > 0.0 || self.states[i].slides();
            if closed && comes_there && ActiveSet::is_weightless(force, line.force_size) {
                self.active_sets[i].apex = true;
            }
            let infinite = segment.problem.local(i).never_slides();
            self.holds[i] = infinite && !ActiveSet::is_weightless(&tangential(force), line.force_size);
        }
        self.slip_until_now(segment, factor);
    }

    /// While the load turns, removes from active sets the facets from which contact forces have moved away since the last event. At that event the
    /// rates of these forces did not yet show the motion away from the facets.
    fn drop_by_force(&mut self, segment: &Segment<'_>, point: &PathPoint, factor: f64) {
        let offsets = segment.offsets(factor);
        for (i, (active, state)) in self.active_sets.iter_mut().zip(&self.states).enumerate() {
            if state.is_open() {
                let gap = -segment.grasp.sites()[i].stretch(&offsets[i], &self.at.twist)[0];
                active.apex &= gap <= ZERO_SLACK * point.gaps[i].size;
            } else {
                let line = Line { force: self.at.forces[i], ..point.lines[i] };
                segment.problem.local(i).drop_by_force(active, state, &line);
            }
        }
    }

    /// Sets each sliding contact whose normal force at `point` has almost vanished to the apex of its cone, as if it had no force. The direction of
    /// its friction can no longer be computed. Returns whether there is such a contact.
    pub(super) fn release_vanishing(&mut self, point: &PathPoint) -> bool {
        let mut any = false;
        for (i, line) in point.lines.iter().enumerate() {
            let slides = self.states[i].slides();
            if slides && !self.active_sets[i].apex && (is_vanishing(line) || has_vanished(line)) {
                (self.active_sets[i].apex, any) = (true, true);
            }
        }
        any
    }

    /// Records that a contact has stopped sliding. Its active set becomes empty, so that it sticks as if its force were inside its cone.
    pub(super) fn stick(&mut self, contact: usize) {
        self.active_sets[contact] = ActiveSet::EMPTY;
        self.stopped.push(contact);
    }

    /// Returns the index of a contact that has stopped sliding at this node, if its force leaves the friction cone along a tangent while it sticks.
    /// On a straight piece such a contact can neither stick nor slide on: if it slid on, friction would drive its slip instead of opposing it. `None`
    /// if there is no such contact, on arcs, and while the load turns.
    pub(super) fn neither_slides_nor_sticks(
        &self,
        segment: &Segment<'_>,
        point: &PathPoint,
    ) -> Option<usize> {
        let leaves = |i: &&usize| {
            self.states[**i].is_sticking()
                && segment.problem.local(**i).leaves_by_a_tangent(&point.lines[**i])
        };
        let straight = matches!(segment.trajectory, Trajectory::Straight { .. }) && !self.turns();
        self.stopped.iter().find(leaves).copied().filter(|_| straight)
    }

    /// Called when steps have become too short to advance. A force counts as on the boundary of its cone if its distance from the boundary is at most
    /// 1e-8 ([`GATHERED_MARGIN`]) of the terms from which the force is computed. A gap counts as closed if it is at most this fraction of its own
    /// terms. Events nearer to each other than the error of steps thus happen at one point of the path.
    ///
    /// Each gap that is neglected in this way, and each distance of a force from the boundary of its cone, is divided by the magnitude of its terms.
    /// Returns the largest of these ratios, which the caller adds to the error of the path. The caller then computes anew how the path continues. If
    /// nothing had to be neglected, the caller does so only if contacts slide on the round cone and the load does not turn: the result is then zero.
    /// Otherwise the result is `None`, and the path ends undecided.
    pub(super) fn gather(&mut self, segment: &Segment<'_>, point: &PathPoint) -> Option<f64> {
        let mut apart: Option<f64> = None;
        for (i, (line, gap)) in point.lines.iter().zip(&point.gaps).enumerate() {
            let (local, active) = (segment.problem.local(i), &mut self.active_sets[i]);
            if self.states[i].is_open() && local.may_open() && gap.gap <= GATHERED_MARGIN * gap.size {
                active.apex = true;
                apart = Some(apart.unwrap_or(0.0).max(gap.gap / gap.size));
            } else if self.states[i].is_sticking() && local.may_slide() {
                let (friction, size) =
                    (tangential(&line.force), line.force_size * local.cone().round_weight());
                let margin = local.cone().round_margin(&line.force) / size;
                if margin <= GATHERED_MARGIN && friction.norm() > GATHERED_MARGIN * size {
                    active.facets = vec![friction.normalize()];
                    apart = Some(apart.unwrap_or(0.0).max(margin));
                }
            }
        }
        let slides = matches!(segment.trajectory, Trajectory::Straight { .. }) && self.turns();
        apart.or(slides.then_some(0.0))
    }
}
