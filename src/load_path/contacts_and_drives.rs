//! Events of a hand: a drive is a site like a contact, and what happens to it has names of its own.

use super::drive_change::DriveChange;
use super::event::Change;
use super::onset::{Departure, Leaving};
use super::onset_margins::Leaver;
use crate::grasp::{Engine, HandPart, Role};
use crate::numerics::Size;

impl<D: Size, const C: usize> Engine<D, C> {
    /// Changes of contacts, and those of drives by the names of their owners.
    pub(super) fn contacts_and_drives(&self, changes: Vec<(usize, Change<C>)>) -> Split<(usize, Change<C>)> {
        let (contacts, drives): (Vec<_>, Vec<_>) = changes.into_iter().partition(|(i, _)| *i < self.len());
        let named = |(i, change): &(usize, Change<C>)| {
            let frees = matches!(
                change,
                Change::Slides { .. } | Change::Reverses { .. } | Change::Turns { .. } | Change::Opens
            );
            self.named(*i, frees)
        };
        let mut drives: Vec<_> = drives.iter().filter_map(named).collect();
        drives.dedup();
        (contacts, drives)
    }

    /// Contacts that stop sticking, and drives that do by the names of their owners.
    pub(super) fn leaving_apart(&self, leaving: Vec<Leaving<C>>) -> Split<Leaving<C>> {
        if leaving.iter().all(|leaving| leaving.contact < self.len()) {
            return (leaving, Vec::new());
        }
        let (contacts, drives): (Vec<_>, Vec<_>) = leaving.into_iter().partition(|l| l.contact < self.len());
        let named = |leaving: &Leaving<C>| {
            self.named(leaving.contact, matches!(leaving.how, Departure::Slides { .. } | Departure::Opens))
        };
        (contacts, drives.iter().filter_map(named).collect())
    }

    /// Contacts among these sites, and the owners of drives.
    pub(super) fn sites_apart(&self, sites: Vec<usize>) -> (Vec<usize>, Vec<HandPart>) {
        let (contacts, drives): (Vec<_>, Vec<_>) = sites.into_iter().partition(|i| *i < self.len());
        let part = |i: &usize| self.linkage().and_then(|linkage| linkage.part(i - self.len()));
        (contacts, drives.iter().filter_map(part).collect())
    }

    /// The contact or the owner of the drive at a site; `None` for springs that nobody owns, which never leave.
    pub(crate) fn leaver(&self, site: usize) -> Option<Leaver> {
        match self.linkage() {
            Some(linkage) if site >= self.len() => linkage.part(site - self.len()).map(Leaver::Drive),
            _ => Some(Leaver::Contact(site)),
        }
    }

    fn named(&self, site: usize, frees: bool) -> Option<(HandPart, DriveChange)> {
        let linkage = self.linkage()?;
        let k = site - self.len();
        let drive = &linkage.drives[k];
        let how = match (frees, drive.role, drive.pulls_only()) {
            (true, Role::Pulls | Role::EndsBelow, true) => DriveChange::Slackens,
            (false, Role::Pulls | Role::EndsBelow, true) => DriveChange::Tightens,
            (true, ..) => DriveChange::Yields,
            (false, ..) => DriveChange::Holds,
        };
        Some((linkage.part(k)?, how))
    }
}

/// Contacts, and drives of a hand.
pub(super) type Split<T> = (Vec<T>, Vec<(HandPart, DriveChange)>);
