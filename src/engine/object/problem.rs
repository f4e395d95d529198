//! The problem that the engine solves: a law and a commanded offset for each contact, and a load.
//!
//! ```text
//! v_i = a_i - G_iᵀq,      F_i from v_i by the law of contact i,      Σ G_i F_i + W = 0
//! ```
//!
//! At rest, a_i are commanded displacements and each contact has its full law. In rates, a_i are their derivatives, and each law is that of the rates
//! at the present state ([`Law`]).

use crate::numerics::{IntoList, Size, Vector, by_axis, indexed};
use alloc::sync::Arc;

use nalgebra::SVector;

use super::load::Load;
use super::precise::PreciseTwist;
use crate::contact::{Coulomb, Law, LocalLaw, Mode, Polygon, PolygonCone, Slide, State, tangential};
use crate::error::Error;
use crate::grasp::{Engine, Remembered, Site, Space, Wrench, size_of};
use crate::numerics::{DoubleDouble, cleared_for};
use crate::prelude::*;

/// The problem to solve: contact laws, commanded offsets a_i and load of the equation `Σ G_i F_i + W = 0`, in the engine's coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'g> {
    pub(crate) sites: &'g [Site],
    /// The polygon of every contact without a polygon of its own.
    pub(crate) polygon: Arc<Polygon>,
    /// For each contact a polygon that is rotated so that a corner lies along its friction force in the elastic trial. An empty list stands for `polygon`.
    pub(crate) turned: Vec<Polygon>,
    /// Present friction cones, narrower at contacts that slide with kinetic friction. An empty list stands for the static cones.
    pub(crate) cones: Vec<Coulomb>,
    pub(crate) laws: Vec<Law>,
    /// Commanded displacement minus clearance and accumulated slip, m, in the contact frames.
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    /// Accumulated slip, m, in the contact frames.
    pub(crate) slips: Vec<SVector<f64, 3>>,
    pub(crate) wrench: Vector,
    /// Rounding error of `wrench`, which arises where its moment is moved to the centroid of the contacts.
    pub(crate) wrench_rest: Vector,
    /// Whether contacts with infinite friction get facets, like contacts with a very large coefficient, and so may slide.
    pub(crate) infinite_friction_has_edges: bool,
    /// In space: the round cone limits sticking contacts, and the polygon only proposes states.
    pub(crate) round: bool,
    /// Cache of the factors of the elastic trial; `None` in rates.
    pub(crate) trial: Option<&'g Remembered>,
    /// States near which the search begins, if it has many coordinates; empty in rates, and if there are none.
    pub(crate) near: &'g [State],
}

/// The lists of a problem that have one entry for each contact. Another problem can reuse their memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lists {
    pub(crate) laws: Vec<Law>,
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    pub(crate) slips: Vec<SVector<f64, 3>>,
}

impl Engine {
    /// The problem at rest of this grasp, with these offsets and this load.
    pub(crate) fn problem(
        &self,
        polygon: Arc<Polygon>,
        round: bool,
        offsets: Vec<SVector<f64, 3>>,
        load: &Load,
    ) -> Problem<'_> {
        let lists = Lists { offsets, ..Lists::default() };
        self.problem_in(lists, polygon, round, load)
    }

    /// [`Self::problem`] in reused lists; `lists.offsets` holds the offsets.
    pub(crate) fn problem_in(
        &self,
        lists: Lists,
        polygon: Arc<Polygon>,
        round: bool,
        load: &Load,
    ) -> Problem<'_> {
        let trial = Some(self.remembered_trial());
        Problem { trial, near: &self.near, ..Problem::at_rest(self.sites(), polygon, round, lists, load) }
    }

    /// The problem at rest under the caller's load, with polygons in place of round cones.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub(crate) fn on_polygons(&self, load: &Wrench<3>, cone: &PolygonCone) -> Result<Problem<'_>, Error> {
        let polygon = Polygon::shared(self.space(), cone);
        let wrench = self.load_alone(load, "load")?;
        Ok(self.problem(polygon, false, self.offsets(), &Load::from(&wrench)))
    }
}

impl<'g> Problem<'g> {
    /// The problem in which every contact has its full law, not that of its rates. In space the round cone limits friction if `round`, otherwise the
    /// polygon.
    pub(crate) fn at_rest(
        sites: &'g [Site],
        polygon: Arc<Polygon>,
        round: bool,
        Lists { mut laws, offsets, mut slips }: Lists,
        load: &Load,
    ) -> Self {
        cleared_for(&mut laws, sites.len());
        laws.extend(sites.iter().map(Site::whole_law));
        cleared_for(&mut slips, sites.len());
        slips.resize(sites.len(), SVector::zeros());
        Self {
            sites,
            polygon,
            turned: Vec::new(),
            cones: Vec::new(),
            laws,
            slips,
            offsets,
            wrench: load.wrench.clone(),
            wrench_rest: load.rest.clone(),
            infinite_friction_has_edges: false,
            round,
            trial: None,
            near: &[],
        }
    }

    /// The problem in rates, with these laws, rates of the offsets, and the rate of the load. A round cone remains only for contacts at its apex; a
    /// contact on the edge of its cone has facets instead.
    pub(crate) fn at_rates(&self, laws: Vec<Law>, offsets: Vec<SVector<f64, 3>>, wrench: Vector) -> Self {
        let slips = vec![SVector::zeros(); self.len()];
        let wrench_rest = Vector::zeros();
        let mut rates =
            Self { laws, offsets, slips, wrench, wrench_rest, trial: None, near: &[], ..self.clone() };
        let round = rates.locals().any(|local| local.may_slide());
        rates.round &= round;
        rates
    }

    /// The load in twice the working precision.
    pub(crate) fn load(&self) -> Load {
        Load { wrench: self.wrench.clone(), rest: self.wrench_rest.clone() }
    }

    /// Number of coordinates.
    #[inline]
    pub(crate) fn size(&self) -> Size {
        size_of(self.sites)
    }

    /// Whether the problem is planar or spatial.
    pub(crate) fn space(&self) -> Space {
        self.sites.first().map_or(Space::Spatial, |site| site.space)
    }

    pub(crate) fn len(&self) -> usize {
        self.sites.len()
    }

    /// The polygon that replaces a contact's round cone.
    #[inline]
    pub(crate) fn polygon(&self, contact: usize) -> &Polygon {
        let own = || self.sites[contact].polygon.as_ref().unwrap_or(&self.polygon);
        self.turned.get(contact).unwrap_or_else(|| own())
    }

    /// The friction cone of a contact: that of static friction, unless it slides with a lower kinetic coefficient.
    #[inline]
    pub(crate) fn cone(&self, contact: usize) -> Coulomb {
        self.cones.get(contact).copied().unwrap_or(self.sites[contact].friction)
    }

    /// Whether each contact slides with kinetic friction below its static value; empty if no contact has kinetic friction.
    pub(crate) fn weaker(&self) -> Vec<bool> {
        self.cones.iter().zip(self.sites).map(|(cone, site)| *cone != site.friction).list()
    }

    /// One contact with its law.
    #[inline]
    pub(crate) fn local(&self, contact: usize) -> LocalLaw<'_> {
        let site = &self.sites[contact];
        LocalLaw::new(
            &site.springs,
            self.cone(contact),
            &self.laws[contact],
            self.polygon(contact),
            [self.round, self.infinite_friction_has_edges],
        )
    }

    /// All contacts with their laws, in order.
    pub(crate) fn locals(&self) -> Locals<'_> {
        Locals { problem: self, next: 0 }
    }

    /// The value of `of` for each contact, in order.
    pub(crate) fn each<T>(&self, of: impl Fn(LocalLaw<'_>) -> T) -> Vec<T> {
        let mut answers = Vec::with_capacity(self.len());
        for contact in 0..self.len() {
            answers.push(of(self.local(contact)));
        }
        answers
    }

    /// Stretch of a contact for a motion of the object, `a_i - G_iᵀq`.
    #[inline]
    pub(crate) fn stretch(&self, contact: usize, twist: &Vector) -> SVector<f64, 3> {
        self.sites[contact].stretch(&self.offsets[contact], twist)
    }

    /// The states of the elastic trial: every contact that is present sticks.
    pub(crate) fn unjumped(&self) -> Vec<State> {
        self.each(|local| local.unjumped())
    }

    /// The states in which contacts on the edge of their cone slide, contacts at its apex open, and all others stick. In rates this is the most
    /// common solution, and one linear solve checks it.
    pub(crate) fn yielding(&self) -> Vec<State> {
        self.each(|local| local.yielding())
    }

    /// `states`, with the slide of each contact on the round cone recomputed from its friction force and its slip at `twist`.
    pub(crate) fn slid_on(
        &self,
        states: &[State],
        forces: &[SVector<f64, 3>],
        twist: &PreciseTwist,
    ) -> Vec<State> {
        let slid_on = |(contact, state): (usize, &State)| {
            let friction = tangential(&forces[contact]);
            let square = friction.norm_squared();
            let Mode::Round(_) = state else { return *state };
            if square == 0.0 {
                return *state;
            }
            let slip = self.precise_slip(contact, &friction, twist);
            let lambda = (slip.dot(&friction) / square).max(0.0);
            Mode::Round(Slide::new(&friction, lambda))
        };
        indexed(states, &slid_on)
    }

    /// The slip of a contact with this friction force, in twice the working precision: at a stiff contact it is a small difference of large numbers.
    fn precise_slip(
        &self,
        contact: usize,
        friction: &SVector<f64, 3>,
        twist: &PreciseTwist,
    ) -> SVector<f64, 3> {
        let site = &self.sites[contact];
        by_axis(|a| {
            if a == 0 {
                return 0.0;
            }
            let mut slip = twist.stretch(site, a, self.offsets[contact][a]);
            slip.subtract(site.springs.precise_deflection_along(a, DoubleDouble::new(friction[a])));
            slip.value()
        })
    }
}

/// An iterator over the laws of all contacts, in order. It is a named type so that iterator adapters are compiled once for it, not once for each closure.
pub(crate) struct Locals<'p> {
    problem: &'p Problem<'p>,
    next: usize,
}

impl<'p> Iterator for Locals<'p> {
    type Item = LocalLaw<'p>;

    #[inline]
    fn next(&mut self) -> Option<LocalLaw<'p>> {
        if self.next == self.problem.len() {
            return None;
        }
        self.next += 1;
        Some(self.problem.local(self.next - 1))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.problem.len() - self.next;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Locals<'_> {}
