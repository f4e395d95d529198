//! What contacts stand on where the path stands.

use super::PatchPath;
use super::local::{Bound, size};
use crate::contact::Mode;
use crate::contact::ZERO_SLACK;

/// A force below this part of the terms it is made of is none: the contact stands at the apex of its cone. Looser than rounding, since
/// facets that meet near the apex cannot be told apart there.
const WEIGHTLESS: f64 = 1e-12;

/// What a contact stands on: at most C - 1 facets, or the apex of its cone (closed without force, or open without a gap).
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand {
    pub(super) contact: u32,
    facets: [u16; 2],
    count: u8,
    pub(super) apex: bool,
}

impl Stand {
    pub(super) fn nowhere(contact: u32) -> Self {
        Self { contact, facets: [0; 2], count: 0, apex: false }
    }

    pub(super) fn is_nowhere(&self) -> bool {
        self.count == 0 && !self.apex
    }

    pub(super) fn facets(&self) -> &[u16] {
        &self.facets[..usize::from(self.count)]
    }

    /// More facets than an edge of the cone has meet at the apex only.
    pub(super) fn reach<const C: usize>(&mut self, bound: Bound) {
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

impl<const D: usize, const C: usize> PatchPath<'_, D, C> {
    /// What a contact stands on.
    pub(super) fn stand_of(&self, contact: usize) -> Stand {
        let local = &self.locals[contact];
        let mut stand = Stand::nowhere(u32::try_from(contact).unwrap_or(u32::MAX));
        if local.facet_count == 0 && !local.gap {
            return stand;
        }
        let u = local.stretch(&self.y, self.tau);
        let level = local.level(&u, self.y.norm());
        let code = local.code;
        match code {
            Mode::Facet(j) => stand.reach::<C>(Bound::Facet(j)),
            Mode::Corner(j) => {
                stand.reach::<C>(Bound::Facet(j));
                stand.reach::<C>(Bound::Facet((j + 1) % local.facet_count));
            }
            Mode::Open | Mode::Rolling => {}
        }
        local.for_each_bound(&self.facets, |bound, felt| {
            if felt.dot(&u) <= ZERO_SLACK * size(felt) * level {
                stand.reach::<C>(bound);
            }
        });
        if local.code != Mode::Open && local.force(&u, &self.facets).norm() <= WEIGHTLESS * level {
            stand.apex = true;
        }
        stand
    }

    /// Whether a contact holds a tangential force.
    pub(super) fn holds_along(&self, contact: usize) -> bool {
        let local = &self.locals[contact];
        let u = local.stretch(&self.y, self.tau);
        let mut x = local.force(&u, &self.facets);
        x[0] = 0.0;
        x.norm() > WEIGHTLESS * local.level(&u, self.y.norm())
    }

    /// What was looked at and stands on an edge now.
    pub(super) fn stand_where_it_ends(&mut self) {
        self.stands.clear();
        let mut exits = std::mem::take(&mut self.exits);
        exits.sort_unstable_by_key(|exit| exit.contact);
        for exit in &exits {
            if self.stands.last().is_none_or(|stand| stand.contact != exit.contact) {
                let stand = self.stand_of(exit.contact as usize);
                self.stands.push(stand);
            }
            if let Some(stand) = self.stands.last_mut() {
                stand.reach::<C>(exit.bound);
            }
        }
        self.exits = exits;
        for k in 0..self.looked.len() {
            let contact = self.looked[k];
            if self.exits.binary_search_by_key(&contact, |exit| exit.contact).is_err() {
                let stand = self.stand_of(contact as usize);
                // What slides stands on what it slides on, and is not asked unless it stands on more.
                if stand.apex || stand.facets().len() > self.own_facets(contact as usize) {
                    self.stands.push(stand);
                }
            }
        }
    }

    /// How many facets a contact slides on.
    fn own_facets(&self, contact: usize) -> usize {
        let code = self.locals[contact].code;
        match code {
            Mode::Open | Mode::Rolling => 0,
            Mode::Facet(_) => 1,
            Mode::Corner(_) => 2,
        }
    }
}
