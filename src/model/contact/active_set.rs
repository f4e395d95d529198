//! The active set of a contact: the facets of its friction cone on which the contact force lies, or the apex of the cone, where the force is zero. It
//! is needed at a load at which a contact changes its state. It determines the law for the rates of force and stretch just beyond this load. Rates
//! are derivatives with respect to the growing load.
//!
//! A contact with its force inside the cone keeps sticking. With its force on facets of the cone it sticks, or slides along the normals of these
//! facets. At the apex, or with a gap that has just closed, every state is possible, so the rates obey the whole contact law.
//!
//! The round cone `|F_t| <= μ F_n` counts as having one facet where the force lies: its tangent plane along the friction force. In code names an edge
//! is the boundary of a cone, round or polygonal; [`Law::Edge`] contains the facets that limit the rates.

use crate::numerics::{IntoList, keep};
use nalgebra::SVector;

use super::exits::{Exit, GapLine, Line};
use super::law::{Law, LocalLaw};
use super::state::{Mode, State};
use super::tangential::tangential;
use super::tolerances::{WEIGHTLESS, ZERO_SLACK};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

/// The facets of the friction cone on which the force of a contact lies, or the apex of the cone. An open contact with a gap of zero is also at the
/// apex.
#[derive(Debug, Clone)]
pub(crate) struct ActiveSet {
    /// Outward normals h of the active facets. These are the facets on which the contact slides, and those at which the friction margin `μ F_n -
    /// h·F_t` is zero.
    pub(crate) facets: Vec<SVector<f64, 3>>,
    /// True if the contact is closed without force, or open with a gap of zero.
    pub(crate) apex: bool,
}

impl ActiveSet {
    /// The empty set: the force lies inside the cone, or the contact is open with a positive gap.
    pub(crate) const EMPTY: Self = Self { facets: Vec::new(), apex: false };

    pub(crate) fn is_empty(&self) -> bool {
        !self.apex && self.facets.is_empty()
    }

    pub(crate) fn clear(&mut self) {
        self.facets.clear();
        self.apex = false;
    }

    /// Whether a force is zero up to rounding. The rounding error of the force is proportional to `force_size`, N.
    pub(crate) fn is_weightless(force: &SVector<f64, 3>, force_size: f64) -> bool {
        force.norm() <= WEIGHTLESS * force_size
    }

    /// Adds to the set the facet, or the apex, that the contact reaches at each exit. An exit is the point at which the contact leaves its state
    /// under a growing load. An open contact is at the apex when its gap closes.
    pub(crate) fn add_exits(&mut self, axes: usize, state: &State, exits: &[Exit]) {
        for exit in exits {
            // A zero vector in `Exit::facet` marks an exit at which the normal force or the gap vanishes. Normals that differ only by rounding count
            // as one facet. They occur if the force reaches the round cone twice in the same direction.
            if state.is_open() || exit.facet.norm() == 0.0 {
                self.apex = true;
            } else if !self.facets.iter().any(|facet| (facet - exit.facet).norm() <= NEGLIGIBLE) {
                self.facets.push(exit.facet);
            }
        }
        // If the force is on as many facets as the contact frame has axes, it is at the apex, their only common point.
        self.apex |= self.facets.len() >= axes;
    }
}

impl LocalLaw<'_> {
    /// The law for the rates of force and stretch of a contact with the active set `active`. Inside the cone, or if no conditions limit the force,
    /// the springs act without conditions ([`Law::Bonded`]). On facets only the conditions of these facets apply ([`Law::Edge`]), and at the apex the
    /// whole contact law. An open contact with a positive gap stays without force ([`Law::Absent`]).
    pub(crate) fn law_of_rates(&self, active: &ActiveSet, state: &State) -> Law {
        if !self.has_edges() {
            Law::Bonded
        } else if active.apex {
            self.law.clone()
        } else if state.is_open() {
            Law::Absent
        } else if active.facets.is_empty() {
            Law::Bonded
        } else {
            Law::Edge(active.facets.clone())
        }
    }

    /// The active set of a closed contact under the force `line.force`: the facets whose friction margin `μ F_n - h·F_t` is zero up to rounding. If
    /// the force is zero up to rounding, the set also contains the apex.
    pub(crate) fn active_set(&self, line: &Line) -> ActiveSet {
        if !self.has_edges() {
            return ActiveSet::EMPTY;
        }
        let apex = line.force.norm() <= ZERO_SLACK * line.force_size;
        let cone = self.cone();
        if !self.on_round_cone {
            let no_margin = |h: &&SVector<f64, 3>| {
                cone.facet_margin(&line.force, h) <= ZERO_SLACK * (line.force_size * cone.facet_weight(h))
            };
            return ActiveSet { apex, facets: self.facets().iter().filter(no_margin).copied().list() };
        }
        let friction = tangential(&line.force);
        let size = line.force_size * cone.round_weight();
        let on_the_edge = self.may_slide()
            && friction.norm() > ZERO_SLACK * size
            && cone.round_margin(&line.force) <= ZERO_SLACK * size;
        ActiveSet { apex, facets: if on_the_edge { vec![friction.normalize()] } else { Vec::new() } }
    }

    /// The sliding state with zero slip that a sticking contact has under the same force if this force lies on the boundary of the cone. `None` if
    /// the force lies inside the cone or at the apex.
    pub(crate) fn on_its_edge(&self, line: &Line) -> Option<State> {
        let ActiveSet { facets, apex } = self.active_set(line);
        if apex || facets.is_empty() {
            return None;
        }
        if self.on_round_cone {
            return Some(State::sliding_along(&facets[0]));
        }
        let numbers = (0_u16..).zip(self.facets()).filter(|(_, h)| facets.contains(h)).map(|(j, _)| j);
        Some(self.slipping_state(&numbers.list()))
    }

    /// Removes from the active set the facets whose friction margin grows at the force rate `line.rate`, except facets on which the contact slides.
    /// Also removes the apex if the normal force or the gap grows. If the force leaves the apex but stays on some facets, the set contains these
    /// facets afterwards.
    pub(crate) fn drop_by_rates(&self, active: &mut ActiveSet, state: &State, line: &Line, gap: &GapLine) {
        let falls_short = |margin_rate: f64, weight: f64| margin_rate <= ZERO_SLACK * line.rate_size * weight;
        let stays_at_the_apex = || line.rate[0].abs() <= ZERO_SLACK * line.rate_size;
        let cone = self.cone();
        if state.is_open() {
            active.apex &= gap.rate <= ZERO_SLACK * gap.rate_size;
            active.facets.clear();
        } else if self.on_round_cone {
            if !matches!(state, Mode::Sticking) {
                active.apex = false;
                return;
            }
            if active.apex {
                active.apex = stays_at_the_apex();
                let along = tangential(&line.rate);
                let edge = cone.has_edges() && along.norm() > 0.0;
                active.facets = if edge { vec![along.normalize()] } else { Vec::new() };
            }
            keep(&mut active.facets, &|p| falls_short(cone.facet_margin(&line.rate, p), cone.round_weight()));
        } else {
            if active.apex {
                active.apex = stays_at_the_apex();
                active.facets = self.facets().to_vec();
            }
            keep(&mut active.facets, &|h| {
                self.slides_on(state, h)
                    || falls_short(cone.facet_margin(&line.rate, h), cone.facet_weight(h))
            });
        }
    }

    /// Removes from the active set the facets, or the apex, on which the force `line.force` does not lie. Facets on which the contact slides stay in
    /// the set.
    pub(crate) fn drop_by_force(&self, active: &mut ActiveSet, state: &State, line: &Line) {
        let reached = self.active_set(line);
        active.apex &= reached.apex;
        if !self.on_round_cone {
            keep(&mut active.facets, &|h| self.slides_on(state, h) || reached.facets.contains(h));
        } else if state.is_sticking() && !active.facets.is_empty() {
            active.facets = reached.facets;
        }
    }

    fn slides_on(&self, state: &State, facet: &SVector<f64, 3>) -> bool {
        let facets = self.facets();
        state.own_facets(facets.len()).iter().any(|own| own.is_some_and(|j| facets[j] == *facet))
    }

    /// Whether the force of a sticking contact on the boundary of the round cone moves along a tangent of the cone, at the force rate `rate`. A
    /// tangent leads out of the cone, thus the contact begins to slide, perhaps with a slip rate of zero. The rounding error of `rate` is
    /// proportional to `size`.
    pub(crate) fn grazes(&self, state: &State, rate: &SVector<f64, 3>, size: f64) -> bool {
        let (Law::Edge(facets), Mode::Sticking) = (self.law, state) else { return false };
        let (p, cone) = (&facets[0], self.cone());
        let across = (tangential(rate) - p * p.dot(rate)).norm();
        cone.facet_margin(rate, p).abs() <= ZERO_SLACK * size * cone.round_weight()
            && across > ZERO_SLACK * size
    }

    /// Whether the force of a sticking contact is on the boundary of the round cone and moves across the friction direction, but not into the cone.
    /// The contact then begins to slide, since even a straight tangent leads out of the cone. `false` if the force moves radially.
    pub(crate) fn leaves_by_a_tangent(&self, line: &Line) -> bool {
        let (friction, cone) = (tangential(&line.force), self.cone());
        if !self.on_round_cone || !self.may_slide() || friction.norm() == 0.0 {
            return false;
        }
        let (p, weight) = (friction.normalize(), cone.round_weight());
        let rate = tangential(&line.rate);
        let across = (rate - p * p.dot(&rate)).norm();
        // When a contact has just stopped sliding, its friction margin and the rate of this margin are zero only up to the integration error.
        let on_the_edge = cone.round_margin(&line.force) <= NEGLIGIBLE * line.force_size * weight;
        // If the force rate across the friction direction is at most 1e-6 of the whole force rate, the force moves radially, outwards or inwards.
        on_the_edge
            && cone.facet_margin(&line.rate, &p) <= NEGLIGIBLE * line.rate_size * weight
            && across > 1e-6 * line.rate_size * weight
    }

    /// Translates a state under the law of the rates, `rates`, to the corresponding state under the whole contact law. [`Law::Edge`] numbers facets
    /// by their index in its list, the whole law by their index on the polygon. On the round cone a slide on a facet becomes a slide along the normal
    /// of the facet. `None` for facets that the whole law does not have.
    pub(crate) fn of_the_rates(&self, rates: &Law, state: State) -> Option<State> {
        let Law::Edge(edge) = rates else { return Some(state) };
        let [first, second] = state.own_facets(edge.len());
        let Some(first) = first else { return Some(state) };
        if self.on_round_cone {
            return Some(State::sliding_along(&edge[first]));
        }
        let number = |k: usize| (0_u16..).zip(self.facets()).find(|(_, h)| **h == edge[k]).map(|(j, _)| j);
        let one = number(first)?;
        let Some(second) = second else { return Some(self.slipping_state(&[one])) };
        let other = number(second)?;
        Some(self.slipping_state(&[one.min(other), one.max(other)]))
    }

    /// Translates a state under the whole contact law to the corresponding state under the law of the rates, `rates`: the inverse of
    /// [`Self::of_the_rates`]. `None` if `rates` has no corresponding state, or does not determine its slip direction.
    pub(crate) fn in_the_rates(&self, rates: &Law, state: State) -> Option<State> {
        if !state.slides() {
            return Some(state);
        }
        let edge = match (rates, state) {
            // On the round cone the list of facets has one entry, whose normal is the direction of the slide.
            (Law::Edge(_), Mode::Round(_)) => return Some(Mode::Facet(0)),
            (Law::Edge(edge), _) => edge,
            // With the bonded law for the rates the contact does not slide. A sliding `state` is possible only if the contact has just stopped
            // sliding, so it sticks now.
            (Law::Bonded, _) => return Some(Mode::Sticking),
            // At the apex of a round cone the law for rates does not determine a slip direction.
            (Law::Absent, _) | (Law::Cone { .. }, Mode::Round(_)) => return None,
            (Law::Cone { .. }, _) => return Some(state),
        };
        let facets = self.facets();
        let [first, second] = state.own_facets(facets.len());
        let at = |k: usize| edge.iter().position(|h| *h == facets[k]);
        match (first, second) {
            (None, _) => Some(state),
            (Some(first), None) => (0_u16..).nth(at(first)?).map(Mode::Facet),
            // The law for rates has at most two facets, and thus at most one corner, with index 0.
            (Some(first), Some(second)) => at(first).and(at(second)).map(|_| Mode::Corner(0)),
        }
    }
}
