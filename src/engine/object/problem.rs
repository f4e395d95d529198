//! The problem that the engine solves for contact forces and twist: a law and an offset for each contact, and a load on the object.
//!
//! ```text
//! stretch v_i = a_i - G_iᵀq,      contact force F_i from v_i by the law of contact i,      balance Σ G_i F_i + W = 0
//! ```
//!
//! q is the twist of the object, G_i the grasp map of contact i, and W the load. In the static problem, the offset a_i is the commanded displacement
//! minus clearance and slip, and each contact has its full law. In the rate problem, a_i and W are derivatives of offset and load along a path; v_i,
//! q and F_i are the derivatives of stretch, twist and force. Each contact then has a law between the rates of its force and its stretch, valid at
//! its present force ([`Law`]). In the elastic trial all contacts stick.
//!
//! Friction cones are round, or polygonal with plane facets (`edges` in code names). At the apex of a cone the force is zero. The coordinates of q
//! describe the motion of the object, of joints and of further bodies.

use crate::numerics::{DoubleDouble, IntoList, Size, Vector, by_axis, cleared_for, indexed, numbered};
use alloc::sync::Arc;

use nalgebra::SVector;

use super::load::Load;
use super::precise::PreciseTwist;
use crate::contact::{Coulomb, Law, LocalLaw, Mode, Polygon, PolygonCone, Slide, State, tangential};
use crate::error::Error;
use crate::grasp::{CachedValue, Engine, Site, Space, Wrench, size_of};
use crate::prelude::*;

/// The static problem, or the rate problem for derivatives along a load path: the law and the offset a_i of each contact, and the load W. Moments are
/// about the centroid of the contacts.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'g> {
    pub(crate) sites: &'g [Site],
    /// The friction polygon of every contact that has neither a polygon of its own nor a rotated polygon in `turned`.
    pub(crate) polygon: Arc<Polygon>,
    /// For each contact its friction polygon, rotated until a corner lies along the contact's friction force in the elastic trial, in which all
    /// contacts stick. If the list is empty, contacts use their own polygon, or `polygon`.
    pub(crate) turned: Vec<Polygon>,
    /// The present friction cone of each contact: the cone of the lower kinetic coefficient if the contact slides, else the cone of static friction.
    /// If the list is empty, every contact has static friction.
    pub(crate) cones: Vec<Coulomb>,
    pub(crate) laws: Vec<Law>,
    /// For each contact the commanded displacement minus clearance and accumulated slip, m, in its contact frame; in the rate problem the rate of
    /// this offset.
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    /// For each contact the slip accumulated so far, m, in its contact frame; zero in the rate problem.
    pub(crate) slips: Vec<SVector<f64, 3>>,
    pub(crate) wrench: Vector,
    /// Rounding error of the load `wrench`, exact minus rounded, from moving its moment to the centroid of the contacts. Zero in the rate problem.
    pub(crate) wrench_rounding_error: Vector,
    /// True if a contact with infinite friction is treated as if its coefficient of friction were very large. Such a contact has facets of a friction
    /// cone and may slide.
    pub(crate) infinite_friction_has_edges: bool,
    /// True if the round cone limits friction forces in space, so that the polygon only serves to propose contact states. If false, the polygon
    /// limits friction forces.
    pub(crate) round: bool,
    /// Where the grasp stores the factors of the elastic trial, in which all contacts stick, once they are computed. `None` in the rate problem.
    pub(crate) trial: Option<&'g CachedValue>,
    /// Contact states of a similar grasp, from which a search with many coordinates starts. Empty in the rate problem, and if no such states are
    /// given.
    pub(crate) near: &'g [State],
}

/// Three lists of a [`Problem`], each with an entry for each contact. A new problem takes the lists of an earlier one, so that nothing is allocated.
#[derive(Debug, Clone, Default)]
pub(crate) struct ProblemLists {
    pub(crate) laws: Vec<Law>,
    pub(crate) offsets: Vec<SVector<f64, 3>>,
    pub(crate) slips: Vec<SVector<f64, 3>>,
}

impl Engine {
    /// The static problem of this grasp under `load`, with these offsets and without accumulated slip. If `round` is true, the round cone limits
    /// friction in space, otherwise the polygon.
    pub(crate) fn problem(
        &self,
        polygon: Arc<Polygon>,
        round: bool,
        offsets: Vec<SVector<f64, 3>>,
        load: &Load,
    ) -> Problem<'_> {
        let lists = ProblemLists { offsets, ..ProblemLists::default() };
        self.problem_in(lists, polygon, round, load)
    }

    /// The static problem of this grasp under `load`, like [`Self::problem`], but without allocation: its vectors are those of `lists`. The caller
    /// puts the offsets into `lists.offsets`; the laws and slips in `lists` are overwritten.
    pub(crate) fn problem_in(
        &self,
        lists: ProblemLists,
        polygon: Arc<Polygon>,
        round: bool,
        load: &Load,
    ) -> Problem<'_> {
        let trial = Some(self.remembered_trial());
        Problem { trial, near: &self.near, ..Problem::at_rest(self.sites(), polygon, round, lists, load) }
    }

    /// The static problem under the caller's load and the commands of the grasp, with polygonal friction cones in place of round ones.
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
    /// The static problem without accumulated slip: every contact has its full law, not a law of rates. If `round` is true, the round cone limits
    /// friction in space, otherwise the polygon. `trial` is `None`, so that the elastic trial is factorised anew where it is needed.
    pub(crate) fn at_rest(
        sites: &'g [Site],
        polygon: Arc<Polygon>,
        round: bool,
        ProblemLists { mut laws, offsets, mut slips }: ProblemLists,
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
            wrench_rounding_error: load.rounding_error.clone(),
            infinite_friction_has_edges: false,
            round,
            trial: None,
            near: &[],
        }
    }

    /// The rate problem, for derivatives of forces and twist along a load path. `laws` are the contact laws of rates, `offsets` the rates of the
    /// contact offsets, and `wrench` is the rate of the load. In space only contacts at the apex of their cone keep a round cone. The law of a
    /// contact on the boundary of its cone has a plane facet instead.
    pub(crate) fn at_rates(&self, laws: Vec<Law>, offsets: Vec<SVector<f64, 3>>, wrench: Vector) -> Self {
        let slips = vec![SVector::zeros(); self.len()];
        let wrench_rounding_error = Vector::zeros();
        let mut rates = Self {
            laws,
            offsets,
            slips,
            wrench,
            wrench_rounding_error,
            trial: None,
            near: &[],
            ..self.clone()
        };
        let round = rates.locals().any(|local| local.may_slide());
        rates.round &= round;
        rates
    }

    /// The load `wrench` and its rounding error `wrench_rounding_error`: together the load in twice the working precision.
    pub(crate) fn load(&self) -> Load {
        Load { wrench: self.wrench.clone(), rounding_error: self.wrench_rounding_error.clone() }
    }

    /// Number of coordinates of the twist: the coordinates of the object, of all joints and of further bodies.
    #[inline]
    pub(crate) fn size(&self) -> Size {
        size_of(self.sites)
    }

    /// Whether the problem is planar or spatial; spatial without any contact.
    pub(crate) fn space(&self) -> Space {
        self.sites.first().map_or(Space::Spatial, |site| site.space)
    }

    pub(crate) fn len(&self) -> usize {
        self.sites.len()
    }

    /// The polygon that replaces the round cone of this contact: its rotated polygon in `turned`, else its own polygon, else the polygon common to
    /// all contacts.
    #[inline]
    pub(crate) fn polygon(&self, contact: usize) -> &Polygon {
        let own = || self.sites[contact].polygon.as_ref().unwrap_or(&self.polygon);
        self.turned.get(contact).unwrap_or_else(|| own())
    }

    /// The present friction cone of a contact: the cone of static friction, unless the contact slides with a lower kinetic coefficient.
    #[inline]
    pub(crate) fn cone(&self, contact: usize) -> Coulomb {
        self.cones.get(contact).copied().unwrap_or(self.sites[contact].friction)
    }

    /// For each contact, whether its present friction differs from its static friction, because the contact slides with kinetic friction. Empty if
    /// `cones` is empty.
    pub(crate) fn has_kinetic_friction(&self) -> Vec<bool> {
        self.cones.iter().zip(self.sites).map(|(cone, site)| *cone != site.friction).list()
    }

    /// The law of this contact in the problem, with its springs, its present friction cone and its polygon.
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

    /// An iterator over the laws [`Self::local`] of all contacts, in the order of contacts.
    pub(crate) fn locals(&self) -> LocalLaws<'_> {
        LocalLaws { problem: self, next: 0 }
    }

    /// The values of the function `of` for the laws of all contacts, in the order of the contacts.
    pub(crate) fn each<T>(&self, of: impl Fn(LocalLaw<'_>) -> T) -> Vec<T> {
        numbered(self.len(), &|contact| of(self.local(contact)))
    }

    /// Stretch `a_i - G_iᵀq` of contact i, from its offset a_i, its grasp map G_i and the twist q of the object.
    #[inline]
    pub(crate) fn stretch(&self, contact: usize, twist: &Vector) -> SVector<f64, 3> {
        self.sites[contact].stretch(&self.offsets[contact], twist)
    }

    /// The contact states of the elastic trial: contacts whose law is [`Law::Absent`] are open, all others stick.
    pub(crate) fn trial_states(&self) -> Vec<State> {
        self.each(|local| local.trial_state())
    }

    /// Contact states proposed for a rate problem, which determines derivatives of forces and twist along a load path. Contacts on the boundary of
    /// their cone slide, contacts at the apex of their cone (zero force) open, and all others stick. These are the most common contact states of a
    /// solution, and one linear solve checks them.
    pub(crate) fn yielding(&self) -> Vec<State> {
        self.each(|local| local.yielding())
    }

    /// A copy of `states` with new slides for the contacts that slide on the round cone. A slide has two parts: the direction of the friction force,
    /// and the ratio λ of slip to friction force, m/N. λ is slip·friction/|friction|², or 0 if this is negative. The slip is computed at `twist`. A
    /// contact without friction force keeps its state.
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

    /// The slip of a contact at `twist`: its tangential stretch minus the deflection of its springs under `friction`. It is computed in twice the
    /// working precision, since stretch and deflection of a stiff contact nearly cancel.
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

/// An iterator over the laws of all contacts, in the order of contacts. It is a named type so that iterator adapters are compiled once, not for each
/// closure.
pub(crate) struct LocalLaws<'p> {
    problem: &'p Problem<'p>,
    next: usize,
}

impl<'p> Iterator for LocalLaws<'p> {
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

impl ExactSizeIterator for LocalLaws<'_> {}
