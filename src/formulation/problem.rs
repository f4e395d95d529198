//! The local problem that every room above asks the same way: a law for each contact, a drive, a load.
//!
//! An equilibrium and its continuation are the same kind of problem. At rest each contact has its whole friction cone;
//! in rates (what happens next, on the path) a contact inside its cone is bonded, one on an edge has only that edge,
//! one at the apex has the whole cone again, an open one is absent.

use std::sync::Arc;

use nalgebra::SVector;

use super::cone::Polygon;
use crate::grasp::{Hold, Site};

/// Stands for infinite friction where a contact with infinite friction has to open: only then does it need facets.
const INSTEAD_OF_INFINITE_FRICTION: f64 = 1e8;

/// Which rows a contact takes part with.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Law<const C: usize> {
    /// Open and staying so: no rows, no force.
    Absent,
    /// Its springs act both ways, without limit: no rows.
    Bonded,
    /// The friction cone; with `gap` it may also open.
    Cone {
        /// Whether the contact may open.
        gap: bool,
    },
    /// On an edge of its cone with F_n > 0: only these facets `h·F_t <= μ F_n`, at most C - 1 of them.
    Edge(Vec<SVector<f64, C>>),
}

/// The state of a contact as a complementary basis knows it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum State {
    /// F = 0, gap >= 0.
    Open,
    /// No gap, no slip.
    Rolling,
    /// On one facet, or in space on two at once, in the order of [`Problem::normals`].
    Sliding { first: usize, second: Option<usize> },
}

/// Laws, drives a_i, load: `Σ G_i F_i + W = 0` is sought.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'g, const D: usize, const C: usize> {
    pub(crate) sites: &'g [Site<D, C>],
    pub(crate) polygon: Arc<Polygon<C>>,
    pub(crate) laws: Vec<Law<C>>,
    /// Commanded displacement less clearance and less the slip so far.
    pub(crate) drives: Vec<SVector<f64, C>>,
    /// The slip so far, in the contact frames.
    pub(crate) slips: Vec<SVector<f64, C>>,
    pub(crate) wrench: SVector<f64, D>,
    /// Contacts with infinite friction get facets, as with a very large finite one.
    pub(crate) infinite_friction_has_facets: bool,
}

impl<'g, const D: usize, const C: usize> Problem<'g, D, C> {
    /// Every contact with its whole law.
    pub(crate) fn at_rest(
        sites: &'g [Site<D, C>],
        polygon: Arc<Polygon<C>>,
        drives: Vec<SVector<f64, C>>,
        wrench: SVector<f64, D>,
    ) -> Self {
        let laws = sites.iter().map(whole_law).collect();
        let slips = vec![SVector::zeros(); sites.len()];
        Self { sites, polygon, laws, drives, slips, wrench, infinite_friction_has_facets: false }
    }

    pub(crate) fn len(&self) -> usize {
        self.sites.len()
    }

    pub(crate) fn mu(&self, contact: usize) -> f64 {
        let site = &self.sites[contact];
        if site.mu.is_infinite() && self.infinite_friction_has_facets {
            INSTEAD_OF_INFINITE_FRICTION * (site.k[0] / site.k[C - 1]).sqrt().max(1.0)
        } else {
            site.mu
        }
    }

    /// Whether the contact has a row `0 <= gap ⟂ F_n >= 0`.
    pub(crate) fn may_open(&self, contact: usize) -> bool {
        matches!(self.laws[contact], Law::Cone { gap: true })
    }

    /// The facets the contact has rows for.
    pub(crate) fn normals(&self, contact: usize) -> &[SVector<f64, C>] {
        match &self.laws[contact] {
            Law::Absent | Law::Bonded => &[],
            Law::Edge(normals) => normals,
            Law::Cone { .. } => {
                let mu = self.mu(contact);
                if mu > 0.0 && mu.is_finite() { &self.polygon.normals } else { &[] }
            }
        }
    }

    /// The states the contact can be in, the one that needs no row first.
    pub(crate) fn states(&self, contact: usize) -> Vec<State> {
        if self.laws[contact] == Law::Absent {
            return vec![State::Open];
        }
        let mut states = vec![State::Rolling];
        let facets = self.normals(contact).len();
        states.extend((0..facets).map(|first| State::Sliding { first, second: None }));
        if C == 3 && facets > 1 {
            let corners = if matches!(self.laws[contact], Law::Edge(_)) { 1 } else { facets };
            states.extend((0..corners).map(|j| State::Sliding { first: j, second: Some((j + 1) % facets) }));
        }
        if self.may_open(contact) {
            states.push(State::Open);
        }
        states
    }

    /// The state in which the contact needs no jump: rolling, or absent.
    pub(crate) fn unjumped(&self, contact: usize) -> State {
        if self.laws[contact] == Law::Absent { State::Open } else { State::Rolling }
    }

    /// The state in which these facets of a contact slip. More than an edge or a corner of the cone can only slip
    /// where the cone is a point, F = 0.
    pub(crate) fn slipping_state(&self, contact: usize, facets: &[usize]) -> State {
        let count = self.normals(contact).len();
        match *facets {
            [] => State::Rolling,
            [first] => State::Sliding { first, second: None },
            [a, b] if C == 3 && (b == a + 1 || (a == 0 && b + 1 == count)) => {
                let (first, second) = if b == a + 1 { (a, b) } else { (b, a) };
                State::Sliding { first, second: Some(second) }
            }
            _ => State::Open,
        }
    }
}

/// The law of a contact at rest.
pub(crate) fn whole_law<const D: usize, const C: usize>(site: &Site<D, C>) -> Law<C> {
    match site.hold {
        Hold::Unilateral => Law::Cone { gap: true },
        Hold::KeptClosed => Law::Cone { gap: false },
        Hold::Bonded => Law::Bonded,
    }
}
