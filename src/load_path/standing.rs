//! Where the path stands, and what comes next as long as every contact keeps its state.

use nalgebra::SVector;

use super::arc::{Arc, tangential};
use super::edge::Stand;
use super::margin::{Line, ROUNDING};
use super::node::{Node, directions};
use super::segment::{Here, Segment, Standing};
use super::watch::is_vanishing;
use crate::equilibrium::{Found, NoEquilibrium};
use crate::formulation::{PieceState, Problem, State};
use crate::grasp::Hold;

impl<const D: usize, const C: usize> Node<D, C> {
    /// At the start of the path, finds what stands on an edge: the state comes from a one-shot solution, which does not
    /// say. What slipped from rest to here becomes memory. Without a start there is nowhere to stand.
    pub(super) fn at_start(segment: &mut Segment<'_, D, C>, found: Option<Found<D, C>>) -> Self {
        let n = segment.grasp.len();
        let mut node = Self {
            states: vec![State::Open; n],
            directions: vec![None; n],
            stands: vec![Stand::NOWHERE; n],
            holds: vec![false; n],
            edges: vec![None; n],
            at: PieceState { forces: vec![SVector::zeros(); n], twist: SVector::zeros() },
        };
        let Some(found) = found else { return node };
        node.directions = directions(segment, &segment.problem, &found);
        node.states = found.states;
        node.at = PieceState { forces: found.forces, twist: found.twist };
        if segment.problem.round {
            node.slip_until_now(segment, 0.0);
        }
        if let Ok(here) = node.look(segment, 0.0) {
            node.stand(segment, &here);
        }
        node
    }

    /// Whether something slides on the round cone: then the path is no straight line.
    pub(super) fn turns(&self) -> bool {
        self.edges.iter().any(Option::is_some)
    }

    /// Forces and their rates in the present states.
    pub(super) fn look(
        &self,
        segment: &Segment<'_, D, C>,
        factor: f64,
    ) -> Result<Here<D, C>, NoEquilibrium<D>> {
        if self.turns() {
            // Where a contact has opened, or its force was corrected, the others take its share.
            let memory = vec![SVector::zeros(); self.states.len()];
            let mut arc = Arc::new(segment, &self.states, factor, self.at.clone(), SVector::zeros());
            let poised = arc.poise(factor, &memory, &self.at.twist).map(|poised| poised.at);
            segment.tangent(&self.states, factor, poised.as_ref().unwrap_or(&self.at), &self.edges)
        } else {
            segment.look(&self.states, factor, Some(&self.at.twist))
        }
    }

    /// The same a step further along a sliding arc.
    pub(super) fn tangent_at(
        &self,
        segment: &Segment<'_, D, C>,
        factor: f64,
        at: &PieceState<D, C>,
    ) -> Result<Here<D, C>, NoEquilibrium<D>> {
        let edge =
            |(slides, force): (&Option<_>, &SVector<f64, C>)| slides.map(|_| tangential(force).normalize());
        let edges: Vec<_> = self.edges.iter().zip(&at.forces).map(edge).collect();
        segment.tangent(&self.states, factor, at, &edges)
    }

    /// The slip of what slides becomes memory; on the round cone it slides on along its friction force.
    fn slip_until_now(&mut self, segment: &mut Segment<'_, D, C>, factor: f64) {
        for i in 0..self.states.len() {
            if matches!(self.states[i], State::Sliding { .. }) {
                segment.remember_slip(i, factor, &self.at.twist, &self.at.forces[i]);
                if segment.problem.round {
                    let p = tangential(&self.at.forces[i]).normalize();
                    (self.edges[i], self.stands[i].facets) = (Some(p), vec![p]);
                }
            }
        }
    }

    fn stand(&mut self, segment: &mut Segment<'_, D, C>, here: &Here<D, C>) {
        for (i, line) in here.lines.iter().enumerate() {
            let site = &segment.grasp.sites()[i];
            if self.states[i] == State::Open {
                let [gap, _, span, _] = here.gaps[i];
                self.stands[i].apex = gap <= ROUNDING * span;
                continue;
            }
            if site.hold == Hold::Bonded {
                continue;
            }
            self.stands[i].apex = line.force.norm() <= ROUNDING * line.force_size;
            if segment.problem.round {
                self.stands[i].facets = round_edge(&segment.problem, i, line).into_iter().collect();
                continue;
            }
            if matches!(self.states[i], State::Sliding { .. }) {
                segment.remember_slip(i, 0.0, &here.twist, &line.force);
            }
            let no_margin = |h: &&SVector<f64, C>| {
                let size = line.force_size * (site.mu + h.norm());
                site.mu * line.force[0] - h.dot(&line.force) <= ROUNDING * size
            };
            self.stands[i].facets = segment.problem.normals(i).iter().filter(no_margin).copied().collect();
        }
    }

    /// What was reached on the way here.
    pub(super) fn reach(&mut self, reached: &Standing<C>) {
        for (i, exits) in reached {
            self.stands[*i].reach(self.states[*i], exits);
        }
    }

    /// Moves to the end of a piece: the slip of what slid becomes memory.
    pub(super) fn arrive(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        here: &Here<D, C>,
        factor: f64,
        there: &PieceState<D, C>,
    ) {
        self.at = there.clone();
        for (i, (line, force)) in here.lines.iter().zip(&there.forces).enumerate() {
            let closed = self.states[i] != State::Open;
            if closed && line.force.norm() > 0.0 && Stand::is_weightless(force, line.force_size) {
                self.stands[i].apex = true;
            }
            let infinite = segment.grasp.sites()[i].mu.is_infinite();
            self.holds[i] = infinite && !Stand::is_weightless(&tangential(force), line.force_size);
        }
        self.slip_until_now(segment, factor);
    }

    /// What slides and has all but lost its normal force is at the apex: its friction cannot be followed any further. Whether there is
    /// such a contact.
    pub(super) fn let_go(&mut self, here: &Here<D, C>) -> bool {
        let mut any = false;
        for (i, line) in here.lines.iter().enumerate() {
            let slides = matches!(self.states[i], State::Sliding { .. });
            if slides && !self.stands[i].apex && is_vanishing(line) {
                (self.stands[i].apex, any) = (true, true);
            }
        }
        any
    }

    /// What slid no more does: inside its cone from here on.
    pub(super) fn stick(&mut self, contact: usize) {
        self.stands[contact] = Stand::NOWHERE;
    }
}

/// Where the force of a contact is on the edge of the round cone.
fn round_edge<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    line: &Line<C>,
) -> Option<SVector<f64, C>> {
    let (mu, friction) = (problem.mu(contact), tangential(&line.force));
    let size = line.force_size * (1.0 + mu);
    let edge = problem.may_slide(contact)
        && friction.norm() > ROUNDING * size
        && mu * line.force[0] - friction.norm() <= ROUNDING * size;
    edge.then(|| friction.normalize())
}
