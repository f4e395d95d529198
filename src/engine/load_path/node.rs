//! A node of the load path: the point between two pieces (parts of a leg with fixed contact states), i.e. an event or the start of a leg. For each
//! contact it stores the facets of its friction cone on which its force lies (its active set; on the round cone, the tangent plane at the force). At
//! a node the solution of the rate problem, the complementarity problem for the rates of forces and motion, determines how the path continues. An arc
//! is a piece on which directions of sliding turn. A drive, the spring of a joint or tendon of a hand with its force limit, is treated like a
//! contact.

use nalgebra::SVector;

use super::end_of_path::end_of_path;
use super::event::{Change, LossKind, PathEnd};
use super::follower::StateAtEdge;
use super::path_state::forces_are_rounding;
use super::program_run::ProgramRun;
use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use super::transition::{change, nothing_changes, other_solutions};
use crate::contact::{ActiveSet, Law, Mode, State, ZERO_SLACK};
use crate::equilibrium::{ContactState, site_states};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, any_index, chosen, every_index, largest, moved, numbered};
use crate::object::{ForcesAndTwist, Problem};
use crate::prelude::*;
use crate::search::{
    CandidateOutcome, Doubt, FoundBy, SearchCounts, SearchOutcome, SearchSolution, Settings,
    on_the_solution_interval, polish, settle, solution_near, try_states,
};

/// The rate problem at a node. `settled` is the outcome of the search for its solution.
struct NodeRates<'g> {
    /// The fraction of the leg at which the rates of load and commands in `rates` are taken. It is that of the node or, while the load turns, a
    /// slightly larger one.
    ahead: f64,
    rates: Problem<'g>,
    settled: SearchOutcome,
    effort: SearchCounts,
}

/// What the path stores at a node, or at the end of the last piece. Each list has an entry for each contact and drive.
#[derive(Debug, Clone)]
pub(super) struct Node {
    /// Contact states. The state of a contact that slides on the round cone is stored with the direction of its friction force.
    pub(super) states: Vec<State>,
    /// For each contact the unit direction, along the coordinate axes, in which the finger slides over the object; `None` if the contact does not
    /// slide.
    pub(super) directions: Vec<Option<SVector<f64, 3>>>,
    pub(super) active_sets: Vec<ActiveSet>,
    /// For each contact: true if it has infinite friction and carries a tangential force. Such a contact loses its tangential force at once when
    /// its normal force vanishes.
    pub(super) holds: Vec<bool>,
    /// Whether some contact starts to slide from the apex of its cone, so that it has a direction of sliding, but no friction force yet.
    pub(super) starts_at_apex: bool,
    /// Indices of contacts that have stopped sliding at this node.
    pub(super) stopped: Vec<usize>,
    pub(super) at: ForcesAndTwist,
    /// The fraction of the leg whose rates of load and commands determined the continuation: that of the node or, while the load turns, a slightly
    /// larger one.
    pub(super) ahead: f64,
}

/// The continuation of the path from a node: the path point there with the rates along the next piece, the changes of contact states, and the number
/// of other ways in which the path could continue.
pub(super) struct NextPiece {
    pub(super) point: PathPoint,
    pub(super) changes: Vec<(usize, Change<3>)>,
    pub(super) other_continuations: Option<usize>,
}

impl Node {
    /// Solves the rate problem at the fraction `factor` of the leg. The solution decides the states of all contacts on the boundary of their cones,
    /// and so how the path continues. If there is no solution, the error is the end of the path.
    pub(super) fn continue_path(
        &mut self,
        segment: &mut Segment<'_>,
        run: &ProgramRun<'_>,
        factor: f64,
    ) -> Result<NextPiece, PathEnd<3>> {
        let settings = &run.settings;
        let NodeRates { ahead, rates, settled, effort } = self.decided(segment, factor, settings);
        self.ahead = ahead;
        let is_at_edge = |i: &usize| matches!(rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        let loss = |kind, motion| {
            let edge = chosen(self.states.len(), &is_at_edge);
            run.loss(factor, kind, edge, motion)
        };
        let SearchOutcome::Found(found, _) = settled else {
            let loss = loss(LossKind::Corner, None);
            let edge = StateAtEdge { segment: segment.clone(), rates, forces: self.at.forces.clone() };
            return Err(end_of_path(&edge, (settled, &effort), loss, settings));
        };
        let mut found = self.without_dragging(&rates, found);
        if segment.problem.round {
            slide_where_they_graze(&rates, &mut found);
        }
        // If all contact forces are zero, several motions solve the rate problem, because a contact found sticking may slide as well. The path takes
        // the shortest of these motions.
        if self.at.forces.iter().all(|force| force.norm() == 0.0) {
            found = on_the_solution_interval(&rates, found);
        }
        // A contact with infinite friction keeps its tangential force until the normal force is gone, and then loses it at once.
        let lets_go = |i: usize| self.holds[i] && !self.states[i].is_open() && found.states[i].is_open();
        if any_index(self.states.len(), &lets_go) {
            let motion = (found.twist.norm() > 0.0).then(|| found.twist.normalize());
            return Err(PathEnd::Lost(Box::new(loss(LossKind::LetsGo, motion.as_ref()))));
        }
        let other_continuations = other_solutions(&rates, &found);
        let changes = self.apply_rates(segment, factor, &rates, &found);
        let point = self.point_at(segment, factor, Some(&found.twist));
        let point = point.map_err(|_| run.undecided(factor, Doubt::Inaccurate))?;
        if self.neither_slides_nor_sticks(segment, &point).is_some() {
            let motion = (point.twist_rate.norm() > 0.0).then(|| point.twist_rate.normalize());
            return Err(PathEnd::Lost(Box::new(run.loss(
                factor,
                LossKind::Corner,
                core::mem::take(&mut self.stopped),
                motion.as_ref(),
            ))));
        }
        self.stopped.clear();
        for (i, active) in self.active_sets.iter_mut().enumerate() {
            segment.problem.local(i).drop_by_rates(active, &self.states[i], &point.lines[i], &point.gaps[i]);
        }
        Ok(NextPiece { point, changes, other_continuations })
    }

    /// Solves the rate problem at the node. The rates of load and commands are taken at the node or, while the load turns, at a slightly larger
    /// fraction of the leg ("ahead").
    ///
    /// While the load turns, a contact may stop sliding, or a force may touch the boundary of its cone, exactly at the node. The rates at the node
    /// then do not show whether the slip reverses or the force leaves the cone; rates slightly ahead do. The load rates for which given contact
    /// states hold form a convex cone. So states that hold for the rates at the node and for the rates ahead also hold in between.
    fn decided<'g>(&self, segment: &Segment<'g>, factor: f64, settings: &Settings) -> NodeRates<'g> {
        let laws = segment.laws_of_rates(&self.active_sets, &self.states);
        let at = |ahead: f64| {
            let rates = segment.rates(ahead, laws.clone());
            let (settled, effort) = match self.guess(segment, factor, &rates) {
                CandidateOutcome::Holds(found) => {
                    (SearchOutcome::Found(found, FoundBy::LoadPath), SearchCounts::default())
                }
                _ => settle(&rates, settings),
            };
            NodeRates { ahead, rates, settled, effort }
        };
        let Trajectory::Turn { angle, .. } = segment.trajectory else { return at(factor) };
        let mut last = None;
        // While the load turns, the rate of the load a little beyond the node determines how the path continues. `little` is the angle, rad, by which
        // the load turns from the node. Smaller angles are tried in turn, because another event may occur within the larger angle.
        for little in [1e-3, 1e-5, 1e-7, 1e-9] {
            let decided = at(factor + little / angle);
            let SearchOutcome::Found(found, _) = &decided.settled else {
                last = Some(decided);
                continue;
            };
            // On the round cone these states are accepted: they contain directions of sliding, which turn with the load, so that they cannot hold at
            // two angles. On other cones the states must also solve the rate problem 1e-12 rad beyond the node, so that they hold in the whole range
            // up to `little`. The angle of an event has an error of about 1e-12 rad: closer to the node, the rate of a load that turns back might
            // have the wrong sign.
            let rates_beyond = segment.rates(factor + 1e-12 / angle, laws.clone());
            if decided.rates.round
                || matches!(try_states(&rates_beyond, found.states.clone()), CandidateOutcome::Holds(_))
            {
                return decided;
            }
            last = Some(NodeRates { settled: SearchOutcome::Undecided(Doubt::OnTheBoundary), ..decided });
        }
        match last {
            Some(last) if !segment.problem.round => last,
            // If no angle gives a solution on the round cone, the rates at the node itself are taken. At the end of an arc, the fraction of the leg
            // of a node has the error of the integration steps. These rates are therefore as good as rates beyond it.
            _ => at(factor),
        }
    }

    /// Tries the usual solutions of the rate problem `rates`: all contacts keep their states, or contacts on the boundary of their cones slide.
    /// Returns [`CandidateOutcome::Holds`] with the first of these solutions that meets all conditions of its contact states.
    fn guess(&self, segment: &Segment<'_>, factor: f64, rates: &Problem) -> CandidateOutcome {
        // All contact states may stay as they are only at the start of a leg: within a leg the path comes to a node because the present state of some
        // contact has just ended.
        let as_before =
            (factor == 0.0).then(|| nothing_changes(&segment.problem, rates, &self.states)).flatten();
        if let Some(holds @ CandidateOutcome::Holds(_)) = as_before.map(|states| try_states(rates, states)) {
            return holds;
        }
        let sliding = rates.yielding();
        // For a contact with zero force (the apex of its cone) no state is more likely than another. On polygonal cones no solution is then guessed.
        // On the round cone such a contact is first tried open. If that fails, Newton's method starts once with the contact sticking, and once with
        // the contact sliding.
        let at_the_apex = |i: usize| matches!(rates.laws[i], Law::Cone { .. });
        if any_index(rates.len(), &at_the_apex) {
            if !rates.round {
                return CandidateOutcome::Unbalanced;
            }
            if let holds @ CandidateOutcome::Holds(_) = try_states(rates, sliding.clone()) {
                return holds;
            }
            let closed = (0..rates.len()).map(|i| if at_the_apex(i) { Mode::Sticking } else { sliding[i] });
            let found = [closed.list(), sliding.clone()]
                .iter()
                .find_map(|states| polish(rates, states, &solution_near(rates, states)?));
            return found.map_or(CandidateOutcome::Unbalanced, CandidateOutcome::Holds);
        }
        try_states(rates, sliding)
    }

    /// Opens contacts that touch but gain no force in `found`, the solution of the rate problem. If they stayed closed, their springs would drag the
    /// object along. If no contact gains a force, and a contact slides on the round cone, all contacts that may open are opened. This requires that
    /// the object moves towards none of them. In all other cases the contacts are opened only if the rate problem still has a solution, in which the
    /// object moves less.
    fn without_dragging(&self, rates: &Problem, found: SearchSolution) -> SearchSolution {
        let largest = largest(&found.forces, &SVector::norm).max(rates.wrench.norm());
        // On the round cone a contact slides along its friction force. If all forces are zero up to rounding, sliding has no direction, and contacts
        // that may open are opened.
        let slides = rates.round && found.twist.norm() > 0.0 && found.states.iter().any(State::slides);
        let nothing = slides && forces_are_rounding(rates, &found.forces, &found.twist);
        let state = |i: usize| {
            let (local, force) = (rates.local(i), &found.forces[i]);
            let size = local.force_size(force, rates.span(i, &found.twist), largest);
            let idle = local.may_open() && (nothing || force.norm() <= ZERO_SLACK * size);
            if idle { Mode::Open } else { found.states[i] }
        };
        let states: Vec<State> = numbered(self.states.len(), &state);
        if states == found.states {
            return found;
        }
        let comes_no_nearer = |i: usize| {
            let nearer = rates.stretch(i, &found.twist)[0];
            !states[i].is_open() || nearer <= ZERO_SLACK * rates.span(i, &found.twist)
        };
        if nothing && every_index(states.len(), &comes_no_nearer) {
            return SearchSolution { forces: vec![SVector::zeros(); states.len()], states, ..found };
        }
        // The solution with opened contacts is taken if its motion is shorter, by more than the fraction `NEGLIGIBLE`. If a contact slides in `found`
        // without force on the round cone, the solution with opened contacts is taken also if both motions are equally long: the direction of such
        // sliding is only rounding.
        let rubs =
            rates.round && any_index(states.len(), &|i| states[i].is_open() && found.states[i].slides());
        let most = if rubs { 1.0 + NEGLIGIBLE } else { 1.0 - NEGLIGIBLE };
        match try_states(rates, states) {
            CandidateOutcome::Holds(parted) if parted.twist.norm() < found.twist.norm() * most => parted,
            _ => found,
        }
    }

    /// Sets the states of all contacts to those in `found`, the solution of the rate problem `rates`. Returns the changes of states, each with the
    /// index of its contact or drive.
    pub(super) fn apply_rates(
        &mut self,
        segment: &mut Segment<'_>,
        factor: f64,
        rates: &Problem,
        found: &SearchSolution,
    ) -> Vec<(usize, Change<3>)> {
        let mut changes = Vec::new();
        self.starts_at_apex = false;
        let directions = directions(rates, found);
        for (i, direction) in directions.into_iter().enumerate() {
            let (was, before) = (self.states[i], self.directions[i]);
            let is = segment.problem.local(i).of_the_rates(&rates.laws[i], found.states[i]);
            let is = is.unwrap_or(Mode::Open);
            self.starts_at_apex |= is.slide().is_some() && matches!(rates.laws[i], Law::Cone { .. });
            if was.is_open() && !is.is_open() {
                // The contact closes at the present position of its finger, and its friction starts from zero. The tangential displacement of the
                // surfaces so far is therefore stored as slip.
                segment.remember_slip(i, factor, &self.at.twist, &SVector::zeros());
            }
            if let Mode::Round(slide) = &is {
                self.active_sets[i].facets = vec![slide.direction];
            }
            (self.states[i], self.directions[i]) = (is, direction);
            changes.extend(change((was, before), (is, direction)).map(|change| (i, change)));
        }
        changes
    }
}

/// Changes the state of contacts of `found` from sticking to sliding if their force, on the boundary of the round cone, moves along a tangent of the
/// cone. A straight tangent leads out of a round cone, so that the contact cannot stick ([`LocalLaw::grazes`](crate::contact::LocalLaw::grazes)).
fn slide_where_they_graze(rates: &Problem, found: &mut SearchSolution) {
    let largest = largest(&found.forces, &SVector::norm).max(rates.wrench.norm());
    for (i, state) in found.states.iter_mut().enumerate() {
        let (local, rate) = (rates.local(i), &found.forces[i]);
        let size = local.force_size(rate, rates.span(i, &found.twist), largest);
        if local.grazes(state, rate, size) {
            *state = Mode::Facet(0);
        }
    }
}

/// For each contact the unit direction, along the coordinate axes, in which the finger slides over the object in the solution `found`; `None` if the
/// contact does not slide.
pub(super) fn directions(problem: &Problem, found: &SearchSolution) -> Vec<Option<SVector<f64, 3>>> {
    let direction =
        |state| if let ContactState::Sliding { direction } = state { Some(direction) } else { None };
    moved(site_states(problem, found), &direction)
}
