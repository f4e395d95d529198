//! The law of one contact: springs, friction cone, and the conditions that apply.
//!
//! The forces of an equilibrium, and their rates as the load grows, solve problems of the same kind. In the equilibrium problem every contact has its
//! whole cone. In the problem for the rates, a contact with its force inside the cone is bonded: it neither opens nor slides. An open contact is
//! absent: it has no force. If the force lies on the boundary of the cone, only the facets on which it lies are conditions. A contact at the apex,
//! where the force is zero, has the whole cone again.
//!
//! The round cone is |F_t| <= μ F_n; its tangent plane along the friction force counts as a facet. A polygonal cone replaces it by plane facets
//! `h·F_t <= μ F_n`, where h is the outward normal of a facet in the tangent plane. Two neighbouring facets meet at a corner. In code names an edge
//! is the boundary of a cone, or the facets on which the force lies.

use nalgebra::SVector;

use super::compliance::Compliance;
use super::coulomb::Coulomb;
use super::polygon::Polygon;
use super::state::{Mode, State};
use crate::numerics::{IntoList, least};
use crate::prelude::*;

/// The conditions that limit a contact, in an equilibrium or for the rates of its force and stretch as the load grows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Law {
    /// The contact stays open: no conditions, no force.
    Absent,
    /// The springs push and pull without limit: no conditions.
    Bonded,
    /// The contact force stays in a friction cone.
    Cone {
        /// `true` if the contact may also open: then gap and normal force are complementary.
        gap: bool,
    },
    /// The force lies on the boundary of the cone with F_n > 0. Only the facets `h·F_t <= μ F_n` with these normals h are conditions. The list has at
    /// most as many facets as the contact frame has tangents: one in the plane, two in space.
    Edge(Vec<SVector<f64, 3>>),
}

/// One contact, with its springs, its friction and the law that its force and stretch obey. Nothing here refers to the other contacts or to the
/// object.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LocalLaw<'c> {
    pub(crate) springs: &'c Compliance,
    pub(crate) law: &'c Law,
    /// The polygonal cone that approximates the round cone.
    pub(crate) polygon: &'c Polygon,
    pub(super) friction: Coulomb,
    /// `true` if the round cone limits the contact, which is possible in space only. The polygonal cone then only supplies the contact states that
    /// are tried first.
    pub(super) on_round_cone: bool,
    /// `true` if a contact with infinite friction gets the facets of a cone with a very large finite coefficient. They are needed in a
    /// complementarity problem, where only facets remove the tangential force of an open contact.
    pub(super) infinite_friction_has_edges: bool,
}

impl<'c> LocalLaw<'c> {
    pub(crate) fn new(
        springs: &'c Compliance,
        friction: Coulomb,
        law: &'c Law,
        polygon: &'c Polygon,
        [on_round_cone, infinite_friction_has_edges]: [bool; 2],
    ) -> Self {
        Self { springs, law, polygon, friction, on_round_cone, infinite_friction_has_edges }
    }

    /// The friction cone of the contact. If a contact with infinite friction has facets (`infinite_friction_has_edges`), the coefficient of this cone
    /// is very large but finite.
    pub(crate) fn cone(&self) -> Coulomb {
        if self.infinite_friction_has_edges { self.friction.with_edges(self.springs) } else { self.friction }
    }

    /// Whether the contact frame has only one tangent, as in the plane.
    #[inline(always)]
    pub(crate) fn is_planar(&self) -> bool {
        self.polygon.is_interval()
    }

    /// Whether the contact has the condition `0 <= gap ⟂ F_n >= 0`.
    #[inline(always)]
    pub(crate) fn may_open(&self) -> bool {
        matches!(self.law, Law::Cone { gap: true })
    }

    /// Whether the contact has a whole friction cone, with friction neither zero nor infinite.
    #[inline(always)]
    pub(crate) fn may_slide(&self) -> bool {
        self.has_a_whole_cone() && self.friction.has_edges()
    }

    /// Whether conditions limit the force of the contact while it is closed. A bonded or absent contact has no such conditions. Nor has a
    /// frictionless contact that is kept closed, like a wheel enclosed by a rail.
    pub(crate) fn has_edges(&self) -> bool {
        !self.is_bonded() && (self.may_open() || !self.facets().is_empty())
    }

    /// Whether the whole friction cone limits the contact force. In an equilibrium this is so for every contact that is not bonded; for the rates it
    /// is so at the apex.
    #[inline(always)]
    pub(super) fn has_a_whole_cone(&self) -> bool {
        matches!(self.law, Law::Cone { .. })
    }

    /// Whether the normal spring of a closed contact pushes and pulls. Only a contact that can neither open nor slide may pull.
    pub(crate) fn may_pull(&self) -> bool {
        !self.may_open() && !self.may_slide() && !self.is_absent()
    }

    /// Whether the whole round cone, with friction neither zero nor infinite, limits the contact.
    pub(crate) fn is_round(&self) -> bool {
        self.on_round_cone && self.may_slide()
    }

    pub(crate) fn is_absent(&self) -> bool {
        matches!(self.law, Law::Absent)
    }

    pub(crate) fn is_bonded(&self) -> bool {
        matches!(self.law, Law::Bonded)
    }

    pub(crate) fn is_on_an_edge(&self) -> bool {
        matches!(self.law, Law::Edge(_))
    }

    /// Whether friction is infinite. Then the contact slides only when its normal force vanishes.
    pub(crate) fn never_slides(&self) -> bool {
        self.friction.is_infinite()
    }

    /// Whether the contact has no tangential spring.
    pub(crate) fn is_frictionless(&self) -> bool {
        !self.springs.resists_tangentially()
    }

    /// Outward normals h of the facets `h·F_t <= μ F_n` that are conditions of the contact.
    #[inline]
    pub(crate) fn facets(&self) -> &'c [SVector<f64, 3>] {
        match self.law {
            Law::Edge(normals) => normals,
            Law::Cone { .. } if self.cone().has_edges() => &self.polygon.normals,
            Law::Absent | Law::Bonded | Law::Cone { .. } => &[],
        }
    }

    /// Number of complementary pairs of the contact: one for the gap, one for each facet.
    pub(crate) fn pairs(&self) -> usize {
        usize::from(self.may_open()) + self.facets().len()
    }

    /// The state in the elastic trial, in which no contact slips or opens: sticking. An absent contact is open.
    pub(crate) fn trial_state(&self) -> State {
        if self.is_absent() { Mode::Open } else { Mode::Sticking }
    }

    /// The state in which the contact has the least stiffness: sliding if the force is on the boundary of the cone, open if the contact may open.
    /// Under any other law it is sticking, or open for an absent contact.
    pub(crate) fn yielding(&self) -> State {
        match self.law {
            Law::Edge(facets) if facets.len() == 2 => Mode::Corner(0),
            Law::Edge(_) => Mode::Facet(0),
            Law::Cone { gap: true } => Mode::Open,
            _ => self.trial_state(),
        }
    }

    /// All states (sticking, sliding on a facet or at a corner, open) that the law allows on the polygonal cone, sticking first.
    pub(crate) fn states(&self) -> Vec<State> {
        if self.is_absent() {
            return vec![Mode::Open];
        }
        let facets = self.facets();
        let numbers = || (0_u16..).zip(facets).map(|(j, _)| j);
        let mut states = vec![Mode::Sticking];
        numbers().map(Mode::Facet).append_to(&mut states);
        if !self.is_planar() && facets.len() > 1 {
            let corners = if self.is_on_an_edge() { 1 } else { facets.len() };
            numbers().take(corners).map(Mode::Corner).append_to(&mut states);
        }
        if self.may_open() {
            states.push(Mode::Open);
        }
        states
    }

    /// The state in which the contact slides on all facets in `facets` at once. Facets are given by their indices among [`Self::facets`], counted
    /// from 0, in ascending order. On facets without a common corner the contact can only slip at the apex, where F = 0; the state is then open.
    pub(crate) fn slipping_state(&self, facets: &[u16]) -> State {
        let count = self.facets().len();
        match *facets {
            [] => Mode::Sticking,
            [facet] => Mode::Facet(facet),
            _ if self.is_planar() => Mode::Open,
            [a, b] if b == a + 1 => Mode::Corner(a),
            [a, b] if a == 0 && usize::from(b) + 1 == count => Mode::Corner(b),
            _ => Mode::Open,
        }
    }

    /// A slip direction of a sliding state, of any length: the facet normal, or at a corner the sum of the two normals. `None` if the state does not
    /// slide.
    pub(crate) fn outward(&self, state: &State) -> Option<SVector<f64, 3>> {
        if let Mode::Round(slide) = state {
            return Some(slide.direction);
        }
        let facets = self.facets();
        let [first, second] = state.own_facets(facets.len());
        let first = facets[first?];
        Some(second.map_or(first, |second| first + facets[second]))
    }

    /// Friction margin of a contact under a force, N, positive inside the cone. On the round cone it is `μ F_n - |F_t|`, on a polygonal cone the
    /// least `μ F_n - h·F_t` over its facet normals h. Infinite for infinite friction.
    pub(crate) fn margin(&self, force: &SVector<f64, 3>) -> f64 {
        if self.never_slides() {
            return f64::INFINITY;
        }
        if self.on_round_cone {
            return self.friction.round_margin(force);
        }
        let margin = |h: &SVector<f64, 3>| self.friction.facet_margin(force, h);
        least(&self.polygon.normals, &margin)
    }

    /// Whether the law rules out this state, because the contact cannot open or because its friction is infinite.
    pub(crate) fn excludes(&self, state: &State) -> bool {
        match state {
            Mode::Open => !self.is_absent() && !self.may_open(),
            Mode::Sticking => false,
            Mode::Facet(_) | Mode::Corner(_) | Mode::Round(_) => self.never_slides(),
        }
    }
}
