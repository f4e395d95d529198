//! The local problem that every room above asks the same way: a law for each contact, a drive, a load.
//!
//! An equilibrium and its continuation are the same kind of problem. At rest each contact has its whole friction cone;
//! in rates (what happens next, on the path) a contact inside its cone is bonded, one on an edge has only that edge,
//! one at the apex has the whole cone again, an open one is absent.

use std::sync::Arc;

use nalgebra::SVector;

use super::cone::Polygon;
use super::excess::PreciseTwist;
use super::return_map::Slide;
use crate::grasp::{Hold, Site};
use crate::numerics::DoubleDouble;

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
    /// Sliding on the round cone, to first order: one facet that turns with the slip.
    Turning {
        /// Whether the contact may open.
        gap: bool,
        /// The direction of the slip, [`Slide::direction`], as the normal of the only facet.
        facet: [SVector<f64, C>; 1],
        /// How the springs hold across it.
        slide: Slide<C>,
    },
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
    /// The polygon of every contact that has none of its own.
    pub(crate) polygon: Arc<Polygon<C>>,
    /// Polygons of their own, turned to the traction: none, or one a contact.
    pub(crate) turned: Vec<Polygon<C>>,
    pub(crate) laws: Vec<Law<C>>,
    /// Commanded displacement less clearance and less the slip so far.
    pub(crate) drives: Vec<SVector<f64, C>>,
    /// The slip so far, in the contact frames.
    pub(crate) slips: Vec<SVector<f64, C>>,
    pub(crate) wrench: SVector<f64, D>,
    /// What rounding took from the load when it was moved to the centroid.
    pub(crate) wrench_rest: SVector<f64, D>,
    /// Contacts with infinite friction get facets, as with a very large finite one.
    pub(crate) infinite_friction_has_facets: bool,
    /// In space: rolling contacts are held by the round cone; the polygon only proposes.
    pub(crate) round: bool,
}

/// A load, and what rounding took from it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load<const D: usize> {
    pub(crate) wrench: SVector<f64, D>,
    pub(crate) rest: SVector<f64, D>,
}

impl<const D: usize> From<&SVector<f64, D>> for Load<D> {
    fn from(wrench: &SVector<f64, D>) -> Self {
        Self { wrench: *wrench, rest: SVector::zeros() }
    }
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
        Self {
            sites,
            polygon,
            turned: Vec::new(),
            laws,
            drives,
            slips,
            wrench,
            wrench_rest: SVector::zeros(),
            infinite_friction_has_facets: false,
            round: false,
        }
    }

    /// The load to twice the working precision.
    pub(crate) fn load(&self) -> Load<D> {
        Load { wrench: self.wrench, rest: self.wrench_rest }
    }

    pub(crate) fn len(&self) -> usize {
        self.sites.len()
    }

    /// The polygon that stands for the cone of a contact.
    pub(crate) fn polygon(&self, contact: usize) -> &Polygon<C> {
        self.turned.get(contact).unwrap_or(&self.polygon)
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
        matches!(self.laws[contact], Law::Cone { gap: true } | Law::Turning { gap: true, .. })
    }

    /// The law of a contact that slides on the round cone, to first order.
    pub(crate) fn turning(&self, contact: usize, slide: Slide<C>) -> Law<C> {
        Law::Turning { gap: self.may_open(contact), facet: [slide.direction], slide }
    }

    /// The same problem to first order about contacts that slide on the round cone with these forces. Facets play no part in it.
    pub(crate) fn along(
        &self,
        slides: &[Option<Slide<C>>],
        forces: &[SVector<f64, C>],
        twist: &PreciseTwist<D>,
    ) -> Self {
        let law = |(contact, law): (usize, &Law<C>)| {
            let Some(slide) = slides[contact] else { return law.clone() };
            let site = &self.sites[contact];
            let mut friction = forces[contact];
            friction[0] = 0.0;
            let square = friction.norm_squared();
            if square == 0.0 {
                return self.turning(contact, slide);
            }
            let slip = self.slip(contact, &friction, twist);
            let lambda = (slip.dot(&friction) / square).max(0.0);
            self.turning(contact, Slide::new(site, &friction, lambda))
        };
        self.with_laws(self.laws.iter().enumerate().map(law).collect())
    }

    /// The slip of a contact with this friction force: of a stiff one a small difference.
    fn slip(&self, contact: usize, friction: &SVector<f64, C>, twist: &PreciseTwist<D>) -> SVector<f64, C> {
        let site = &self.sites[contact];
        SVector::from_fn(|a, _| {
            if a == 0 {
                return 0.0;
            }
            let mut slip = twist.stretch(site, a, self.drives[contact][a]);
            let give = DoubleDouble::new(friction[a]).over(site.k[a]);
            slip.add(-give.high);
            slip.add(-give.low);
            slip.value()
        })
    }

    /// The same problem with laws in which the polygons play no part.
    pub(crate) fn with_laws(&self, laws: Vec<Law<C>>) -> Self {
        Self {
            polygon: self.polygon.clone(),
            turned: Vec::new(),
            laws,
            drives: self.drives.clone(),
            slips: self.slips.clone(),
            ..*self
        }
    }

    /// Whether the contact has a friction cone of its own, neither empty nor without limit.
    pub(crate) fn may_slide(&self, contact: usize) -> bool {
        let mu = self.sites[contact].mu;
        matches!(self.laws[contact], Law::Cone { .. }) && mu > 0.0 && mu.is_finite()
    }

    /// The facets the contact has rows for.
    pub(crate) fn normals(&self, contact: usize) -> &[SVector<f64, C>] {
        match &self.laws[contact] {
            Law::Absent | Law::Bonded => &[],
            Law::Edge(normals) => normals,
            Law::Turning { facet, .. } => facet,
            Law::Cone { .. } => {
                let mu = self.mu(contact);
                if mu > 0.0 && mu.is_finite() { &self.polygon(contact).normals } else { &[] }
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
