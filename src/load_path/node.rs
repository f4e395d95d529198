//! A node of the load path: what stands where, and how it goes on from there.

use nalgebra::{Matrix, SVector};

use super::arc::tangential;
use super::edge::Stand;
use super::event::{Change, Loss, PathEnd};
use super::loss::end_of_path;
use super::margin::ROUNDING;
use super::segment::{Here, Segment};
use super::transition::{change, everything_slides, in_the_whole_law, nothing_changes, others};
use crate::equilibrium::{
    ContactState, Effort, Found, Rung, Settings, Settled, Verdict, force_size, polish, settle, solution_near,
    span, try_states,
};
use crate::formulation::{Law, PieceState, Problem, State};
use crate::grasp::Wrench;

/// A motion that is shorter by less than this part is none that is shorter: it is the same up to rounding.
const LESS: f64 = 1e-9;

/// Where the path stands, contact by contact.
pub(super) struct Node<const D: usize, const C: usize> {
    pub(super) states: Vec<State>,
    /// Directions of the sliding contacts, coordinate axes.
    pub(super) directions: Vec<Option<SVector<f64, C>>>,
    pub(super) stands: Vec<Stand<C>>,
    /// Infinite friction holds a tangential force: it cannot vanish with the normal force but has to be let go of.
    pub(super) holds: Vec<bool>,
    /// On the round cone, the unit friction force of what slides, contact frames.
    pub(super) edges: Vec<Option<SVector<f64, C>>>,
    pub(super) at: PieceState<D, C>,
}

/// How the path goes on from a node.
pub(super) struct Onward<const D: usize, const C: usize> {
    pub(super) here: Here<D, C>,
    pub(super) changes: Vec<(usize, Change<C>)>,
    pub(super) other_continuations: Option<usize>,
}

impl<const D: usize, const C: usize> Node<D, C> {
    /// Decides the states of everything that stands on an edge, from the rates.
    pub(super) fn go_on(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        leg: usize,
        factor: f64,
        load: Wrench<D>,
        settings: &Settings,
    ) -> Result<Onward<D, C>, PathEnd<D, C>> {
        let laws: Vec<_> =
            (0..self.states.len()).map(|i| self.stands[i].law(&segment.problem, i, self.states[i])).collect();
        let rates = segment.rates(laws);
        let sliding = everything_slides(&rates);
        let (settled, effort) = match self.guess(segment, factor, &rates, &sliding) {
            Verdict::Holds(found) => (Settled::Found(found, Rung::LoadPath), Effort::default()),
            _ => settle(&rates, settings),
        };
        let stands = |i: &usize| matches!(rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        let loss = |motion| Loss {
            leg,
            fraction: factor,
            load,
            contacts: (0..self.states.len()).filter(stands).collect(),
            motion,
        };
        let Settled::Found(found, _) = settled else {
            let forces = &self.at.forces;
            return Err(end_of_path(
                segment,
                &rates,
                (settled, &effort),
                &sliding,
                forces,
                loss(None),
                settings,
            ));
        };
        let mut found = self.without_dragging(&rates, found);
        for i in 0..self.states.len() {
            if segment.problem.round && grazes(&rates, &found, i) {
                found.states[i] = State::Sliding { first: 0, second: None };
            }
        }
        // Infinite friction keeps its tangential force until the normal force is gone, and then loses it all at once.
        let lets_go =
            |i: usize| self.holds[i] && self.states[i] != State::Open && found.states[i] == State::Open;
        if (0..self.states.len()).any(lets_go) {
            let motion = (found.twist.norm() > 0.0).then(|| segment.grasp.outside(&found.twist.normalize()));
            return Err(PathEnd::Snap(loss(motion)));
        }
        let other_continuations = others(&rates, &found);
        let changes = self.take_over(segment, factor, &rates, &found);
        let here = self.look(segment, factor).map_err(|_| PathEnd::Undecided { leg, fraction: factor })?;
        for (i, stand) in self.stands.iter_mut().enumerate() {
            let [_, rate, _, size] = here.gaps[i];
            stand.leave(&segment.problem, i, self.states[i], &here.lines[i], [rate, size]);
        }
        Ok(Onward { here, changes, other_continuations })
    }

    /// Nothing changes, or else what stands on an edge slides: mostly one of them holds.
    fn guess(
        &self,
        segment: &Segment<'_, D, C>,
        factor: f64,
        rates: &Problem<D, C>,
        sliding: &[State],
    ) -> Verdict<D, C> {
        // Within a leg something has just left its cone, and must change.
        let as_before =
            (factor == 0.0).then(|| nothing_changes(&segment.problem, rates, &self.states)).flatten();
        if let Some(holds @ Verdict::Holds(_)) = as_before.map(|states| try_states(rates, states)) {
            return holds;
        }
        // At the apex there is no telling: every state is as good a guess. On the round cone it opens, or Newton's
        // method starts from two of them.
        let at_the_apex = |i: usize| matches!(rates.laws[i], Law::Cone { .. });
        if (0..rates.len()).any(at_the_apex) {
            if !rates.round {
                return Verdict::Unbalanced;
            }
            if let holds @ Verdict::Holds(_) = try_states(rates, sliding.to_vec()) {
                return holds;
            }
            let closed = (0..rates.len()).map(|i| if at_the_apex(i) { State::Rolling } else { sliding[i] });
            let found = [closed.collect(), sliding.to_vec()]
                .iter()
                .find_map(|states| polish(rates, states, &solution_near(rates, states)?));
            return found.map_or(Verdict::Unbalanced, Verdict::Holds);
        }
        try_states(rates, sliding.to_vec())
    }

    /// What touches without force, and gets none, does not drag the object along: where the contact may as well part from it, and
    /// the object moves less then, it parts. Forces are the same.
    fn without_dragging(&self, rates: &Problem<D, C>, found: Found<D, C>) -> Found<D, C> {
        let largest = found.forces.iter().map(Matrix::norm).fold(rates.wrench.norm(), f64::max);
        let states: Vec<State> = (0..self.states.len())
            .map(|i| {
                let size = force_size(
                    &rates.sites[i],
                    &found.forces[i],
                    span(&rates.sites[i], &rates.drives[i], &found.twist),
                    largest,
                );
                let idle = rates.may_open(i) && found.forces[i].norm() <= ROUNDING * size;
                if idle { State::Open } else { found.states[i] }
            })
            .collect();
        if states == found.states {
            return found;
        }
        match try_states(rates, states) {
            Verdict::Holds(parted) if parted.twist.norm() < found.twist.norm() * (1.0 - LESS) => parted,
            _ => found,
        }
    }

    /// Takes the states of the rates over and says what changed.
    fn take_over(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        factor: f64,
        rates: &Problem<D, C>,
        found: &Found<D, C>,
    ) -> Vec<(usize, Change<C>)> {
        let mut changes = Vec::new();
        let directions = directions(segment, rates, found);
        for (i, direction) in directions.into_iter().enumerate() {
            let (was, before) = (self.states[i], self.directions[i]);
            let is = in_the_whole_law(&segment.problem, i, &rates.laws[i], found.states[i]);
            if was == State::Open && is != State::Open {
                // It closes where its finger now is: F_t = 0 to begin with, its slip has followed the surfaces.
                segment.remember_slip(i, factor, &self.at.twist, &SVector::zeros());
            }
            if segment.problem.round {
                self.edges[i] = match (&rates.laws[i], direction) {
                    (_, None) => None,
                    (Law::Edge(facets), _) => Some(facets[0]),
                    (_, Some(direction)) => Some(segment.grasp.sites()[i].frame.tr_mul(&direction)),
                };
                if let Some(p) = self.edges[i] {
                    self.stands[i].facets = vec![p];
                }
            }
            (self.states[i], self.directions[i]) = (is, direction);
            changes.extend(change((was, before), (is, direction)).map(|change| (i, change)));
        }
        changes
    }
}

/// Whether a rolling contact on the edge of the round cone goes along a tangent of it, which leads outside: it slides, if only
/// with a rate of zero at first.
fn grazes<const D: usize, const C: usize>(
    rates: &Problem<D, C>,
    found: &Found<D, C>,
    contact: usize,
) -> bool {
    let (Law::Edge(facets), State::Rolling) = (&rates.laws[contact], found.states[contact]) else {
        return false;
    };
    let (p, f, mu) = (&facets[0], &found.forces[contact], rates.mu(contact));
    let largest = found.forces.iter().map(Matrix::norm).fold(rates.wrench.norm(), f64::max);
    let site = &rates.sites[contact];
    let size = force_size(site, f, span(site, &rates.drives[contact], &found.twist), largest);
    let outward = p.dot(f);
    let across = (tangential(f) - p * outward).norm();
    (mu * f[0] - outward).abs() <= ROUNDING * size * (1.0 + mu) && across > ROUNDING * size
}

/// In which directions contacts slide.
pub(super) fn directions<const D: usize, const C: usize>(
    segment: &Segment<'_, D, C>,
    problem: &Problem<D, C>,
    found: &Found<D, C>,
) -> Vec<Option<SVector<f64, C>>> {
    (0..problem.len())
        .map(|i| match segment.grasp.contact_answer(problem, found, segment.cone, i).state {
            ContactState::Sliding { direction } => Some(direction),
            _ => None,
        })
        .collect()
}
