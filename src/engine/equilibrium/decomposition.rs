//! Contact forces in two parts: equilibrating forces, which balance the load, and interaction forces between contacts.

use alloc::borrow::Cow;

use nalgebra::SVector;

use super::answer::Equilibrium;
use super::contact_answer::ContactState;
use crate::grasp::{Engine, Site};
use crate::numerics::{IntoList, Map, paired};
use crate::object::least_forces;
use crate::prelude::*;

/// The contact forces of an equilibrium as the sum of two parts. Each part has one force for each contact, along the coordinate axes, N.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Decomposition<const C: usize> {
    /// The forces of least norm that balance the load W: `F_E = -G⁺W`, with the pseudo-inverse G⁺ of the grasp map G of the contacts that carry
    /// force.
    pub equilibrating: Vec<SVector<f64, C>>,
    /// Forces that contacts exert on each other only: `F_I = F - F_E` with the contact forces F of the equilibrium. The resultant of F_I is zero.
    pub interaction: Vec<SVector<f64, C>>,
}

impl Engine {
    pub(crate) fn decompose(&self, equilibrium: &Equilibrium<3>) -> Decomposition<3> {
        let contact = |i: usize| equilibrium.contacts.get(i);
        let carries: Vec<bool> =
            (0..self.len()).map(|i| contact(i).is_some_and(|c| c.state != ContactState::Separated)).list();
        let load = self.inside_unchecked(&self.with_vacuum(&equilibrium.load));
        // The equilibrating forces balance only the load on the object. Components of the load on joints are left out.
        let load = self.space().object_alone(&load);
        let on_object = |site: &Site| {
            let mut map = Map::zeros(site.map.size());
            for a in 0..3 {
                map.set_column(a, &self.space().object_alone(&site.map.column(a)));
            }
            site.with_map(map)
        };
        let sites: Cow<'_, [Site]> = match self.linkage() {
            None => self.sites().into(),
            Some(_) => self.sites()[..self.len()].iter().map(on_object).list().into(),
        };
        let equilibrating: Vec<_> = least_forces(&sites, &carries, &load)
            .into_iter()
            .zip(self.sites())
            .take(equilibrium.contacts.len())
            .map(|(force, site)| site.frame * force)
            .list();
        let interaction = paired(&equilibrium.contacts, &equilibrating, &|(c, e)| c.force_world - e);
        Decomposition { equilibrating, interaction }
    }
}
