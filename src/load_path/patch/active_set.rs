//! The active set of a contact at the present place of the path, and the bounds of its way.

use nalgebra::SVector;

use crate::contact::PolygonState;

/// A bound on the way of a contact: a facet by its number; `Apex` for the normal force where no facet bounds it, and for the gap of an open contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Bound {
    Facet(u16),
    Apex,
}

/// The active set of a contact: at most C - 1 facets, or the apex of its cone (closed without force, or open without a gap).
#[derive(Debug, Clone, Copy)]
pub(super) struct FacetsReached<const C: usize> {
    pub(super) contact: u32,
    facets: [u16; 2],
    count: u8,
    pub(super) apex: bool,
    /// The state in which the contact has come here.
    pub(super) was: PolygonState,
    /// Its memory on the way here.
    pub(super) memory: SVector<f64, C>,
}

impl<const C: usize> FacetsReached<C> {
    pub(super) fn nowhere(contact: u32, was: PolygonState, memory: SVector<f64, C>) -> Self {
        Self { contact, facets: [0; 2], count: 0, apex: false, was, memory }
    }

    pub(super) fn is_nowhere(&self) -> bool {
        self.count == 0 && !self.apex
    }

    pub(super) fn facets(&self) -> &[u16] {
        &self.facets[..usize::from(self.count)]
    }

    /// Adds a bound. More facets than an edge of the cone has meet only at the apex.
    pub(super) fn reach(&mut self, bound: Bound) {
        match bound {
            Bound::Apex => self.apex = true,
            Bound::Facet(j) if !self.facets().contains(&j) => {
                if usize::from(self.count) + 1 == C {
                    self.apex = true;
                } else {
                    self.facets[usize::from(self.count)] = j;
                    self.count += 1;
                }
            }
            Bound::Facet(_) => {}
        }
    }
}
