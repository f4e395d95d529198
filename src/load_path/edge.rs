//! What a contact stands on at an event, and the law of its rates that follows from it.
//!
//! Inside its cone a contact sticks whatever comes next. On facets of the cone it may slide along these, at the apex and at a
//! closed gap it may do anything: there the rates have the whole law again. The onset and the path decide what comes next
//! from the same laws.

use nalgebra::SVector;

use super::arc::tangential;
use super::margin::{Exit, Line, ROUNDING};
use crate::formulation::{Law, Problem, State};

/// A force below this part of its size is none: the contact stands at the apex of its cone. Looser than rounding, since
/// facets that meet near the apex cannot be told apart there.
const WEIGHTLESS: f64 = 1e-12;

/// What one contact stands on.
#[derive(Debug, Clone)]
pub(super) struct Stand<const C: usize> {
    /// Normals of the facets without margin: those on which it slides, and others it has reached.
    pub(super) facets: Vec<SVector<f64, C>>,
    /// Closed without force, or open without a gap.
    pub(super) apex: bool,
}

impl<const C: usize> Stand<C> {
    /// Inside the cone, or open with a gap.
    pub(super) const NOWHERE: Self = Self { facets: Vec::new(), apex: false };

    pub(super) fn is_nowhere(&self) -> bool {
        !self.apex && self.facets.is_empty()
    }

    /// Whether this force is one that a contact at the apex of its cone carries.
    pub(super) fn is_weightless(force: &SVector<f64, C>, force_size: f64) -> bool {
        force.norm() <= WEIGHTLESS * force_size
    }

    /// Takes up where these ways out lead to.
    pub(super) fn reach(&mut self, state: State, exits: &[Exit<C>]) {
        for exit in exits {
            // Without a facet the normal force itself vanishes, or the gap.
            if state == State::Open || exit.facet.norm() == 0.0 {
                self.apex = true;
            } else if !self.facets.contains(&exit.facet) {
                self.facets.push(exit.facet);
            }
        }
        // More facets than an edge has meet only at the apex.
        self.apex |= self.facets.len() >= C;
    }

    /// Forgets what the contact moves away from. `gap_rate` and its size are those of an open contact.
    pub(super) fn leave<const D: usize>(
        &mut self,
        problem: &Problem<D, C>,
        contact: usize,
        state: State,
        line: &Line<C>,
        [gap_rate, gap_size]: [f64; 2],
    ) {
        let slides_on = match state {
            State::Open => {
                self.apex &= gap_rate <= ROUNDING * gap_size;
                self.facets.clear();
                return;
            }
            _ if problem.round => {
                self.leave_round_cone(problem.mu(contact), state, line);
                return;
            }
            State::Rolling => [None, None],
            State::Sliding { first, second } => [Some(first), second],
        };
        let normals = problem.normals(contact);
        if self.apex {
            self.apex = line.rate[0].abs() <= ROUNDING * line.rate_size;
            self.facets = normals.to_vec();
        }
        let mu = problem.mu(contact);
        self.facets.retain(|h| {
            let rate = mu * line.rate[0] - h.dot(&line.rate);
            slides_on.iter().flatten().any(|&j| normals[j] == *h)
                || rate <= ROUNDING * line.rate_size * (mu + h.norm())
        });
    }

    /// The same on the round cone, whose only facet is that which touches it where the force is.
    fn leave_round_cone(&mut self, mu: f64, state: State, line: &Line<C>) {
        if state != State::Rolling {
            self.apex = false;
            return;
        }
        if self.apex {
            self.apex = line.rate[0].abs() <= ROUNDING * line.rate_size;
            let along = tangential(&line.rate);
            let inside = mu == 0.0 || mu.is_infinite() || along.norm() == 0.0;
            self.facets = if inside { Vec::new() } else { vec![along.normalize()] };
        }
        self.facets
            .retain(|p| mu * line.rate[0] - p.dot(&line.rate) <= ROUNDING * line.rate_size * (mu + 1.0));
    }

    /// The law of the rates of a contact that stands here.
    pub(super) fn law<const D: usize>(
        &self,
        problem: &Problem<D, C>,
        contact: usize,
        state: State,
    ) -> Law<C> {
        let whole = &problem.laws[contact];
        let has_edges = problem.may_open(contact) || !problem.normals(contact).is_empty();
        if *whole == Law::Bonded || !has_edges {
            Law::Bonded
        } else if self.apex {
            whole.clone()
        } else if state == State::Open {
            Law::Absent
        } else if self.facets.is_empty() {
            Law::Bonded
        } else {
            Law::Edge(self.facets.clone())
        }
    }
}
