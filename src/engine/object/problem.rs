//! The local problem, the same for all rooms above: a law and a commanded offset for each contact, and a load.
//!
//! ```text
//! v_i = a_i - G_iᵀq,      F_i from v_i by the law of contact i,      Σ G_i F_i + W = 0
//! ```
//!
//! At rest the offsets a_i are commanded displacements and the laws are whole; in rates both describe what happens next.

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

/// Laws, commanded offsets a_i and load of the equation `Σ G_i F_i + W = 0`.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'g> {
    pub(crate) sites: &'g [Site],
    /// The polygon of every contact without a polygon of its own.
    pub(crate) polygon: Arc<Polygon>,
    /// Polygons turned to the traction: empty, or one for each contact.
    pub(crate) turned: Vec<Polygon>,
    /// Cones in place of the cones at rest: empty, or one for each contact.
    pub(crate) cones: Vec<Coulomb>,
    pub(crate) laws: Vec<Law>,
    /// Commanded displacement less clearance and less the slip so far.
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    /// The slip so far, in the contact frames.
    pub(crate) slips: Vec<SVector<f64, 3>>,
    pub(crate) wrench: Vector,
    /// Rounding error of the load from the move to the centroid.
    pub(crate) wrench_rest: Vector,
    /// Contacts with infinite friction get facets, as with a very large finite one.
    pub(crate) infinite_friction_has_edges: bool,
    /// In space: the round cone limits sticking contacts, and the polygon only proposes states.
    pub(crate) round: bool,
    /// The place of the factors of the elastic trial, at rest.
    pub(crate) trial: Option<&'g Remembered>,
}

/// The lists of a problem, one entry for each contact, as memory for another problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lists {
    pub(crate) laws: Vec<Law>,
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    pub(crate) slips: Vec<SVector<f64, 3>>,
}

impl Engine {
    /// The problem at rest of this grasp.
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

    /// [`Self::problem`] in reused lists, with the offsets in them.
    pub(crate) fn problem_in(
        &self,
        lists: Lists,
        polygon: Arc<Polygon>,
        round: bool,
        load: &Load,
    ) -> Problem<'_> {
        let trial = Some(self.remembered_trial());
        Problem { trial, ..Problem::at_rest(self.sites(), polygon, round, lists, load) }
    }

    /// The problem at rest under a load of the caller's, with polygons in place of round cones.
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
    /// Every contact with its whole law, on the round cone if `round`.
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
        }
    }

    /// The problem of the rates: these laws, and rates of the offsets. The round cone matters only at its apex; on an edge it is a
    /// facet.
    pub(crate) fn at_rates(&self, laws: Vec<Law>, offsets: Vec<SVector<f64, 3>>, wrench: Vector) -> Self {
        let slips = vec![SVector::zeros(); self.len()];
        let wrench_rest = Vector::zeros();
        let mut rates = Self { laws, offsets, slips, wrench, wrench_rest, trial: None, ..self.clone() };
        let round = rates.locals().any(|local| local.may_slide());
        rates.round &= round;
        rates
    }

    /// The load to twice the working precision.
    pub(crate) fn load(&self) -> Load {
        Load { wrench: self.wrench.clone(), rest: self.wrench_rest.clone() }
    }

    /// Number of coordinates.
    #[inline]
    pub(crate) fn size(&self) -> Size {
        size_of(self.sites)
    }

    /// Plane or space.
    pub(crate) fn space(&self) -> Space {
        self.sites.first().map_or(Space::Spatial, |site| site.space)
    }

    pub(crate) fn len(&self) -> usize {
        self.sites.len()
    }

    /// The polygon in place of a contact's round cone.
    #[inline]
    pub(crate) fn polygon(&self, contact: usize) -> &Polygon {
        let own = || self.sites[contact].polygon.as_ref().unwrap_or(&self.polygon);
        self.turned.get(contact).unwrap_or_else(|| own())
    }

    /// The friction cone of a contact: the cone at rest, unless it slides with less friction.
    #[inline]
    pub(crate) fn cone(&self, contact: usize) -> Coulomb {
        self.cones.get(contact).copied().unwrap_or(self.sites[contact].friction)
    }

    /// Which contacts slide with less friction than at rest; empty without such friction.
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

    /// The states in which contacts on an edge slide along it and contacts at the apex open: in rates the common case, found by one
    /// solve.
    pub(crate) fn yielding(&self) -> Vec<State> {
        self.each(|local| local.yielding())
    }

    /// The states with updated slides on the round cone, from these friction forces and the slip at this twist.
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

    /// The slip of a contact with this friction force, in twice the working precision: for a stiff contact it is a small difference.
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
            slip.subtract(site.springs.precise_give_along(a, DoubleDouble::new(friction[a])));
            slip.value()
        })
    }
}

/// The laws of all contacts, in order. Adapters of iterators are compiled once for this type, instead of once for a closure.
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
