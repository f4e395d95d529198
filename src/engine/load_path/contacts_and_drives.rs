//! Separates contacts from drives in the events of a grasp by a hand. A drive is the spring of a joint or tendon, with its force limit. The engine
//! treats a drive like a contact, with an index after the contacts. Answers name the joint or tendon. An event is a change of contact states, or of
//! drives, at one point of a load path.

use super::drive_change::{DriveChange, PartChange};
use super::event::{Change, ContactChange};
use super::onset::{DepartingContact, Departure};
use super::onset_margins::DepartingPart;
use super::turn::EdgeOf;
use crate::error::ContactLabel;
use crate::grasp::{DriveLaw, Engine, PartLabel};
use crate::numerics::{IntoList, moved};
use crate::prelude::*;

impl Engine {
    /// Divides the list of the changes at an event into changes of contacts and changes of drives. A drive is labelled by its joint or tendon. If two
    /// drives of one joint or tendon change in the same way, one after the other, the change is listed once.
    pub(super) fn contacts_and_drives(
        &self,
        changes: Vec<(usize, Change<3>)>,
    ) -> (Vec<ContactChange<3>>, Vec<PartChange>) {
        let (mut contacts, mut drives) = (Vec::new(), Vec::new());
        for (site, what) in changes {
            if site < self.len() {
                contacts.push(ContactChange { contact: self.contacts()[site].label(site), what });
                continue;
            }
            let frees = matches!(
                what,
                Change::Slides { .. } | Change::Reverses { .. } | Change::Turns { .. } | Change::Opens
            );
            drives.extend(self.part_change(site, frees));
        }
        drives.dedup();
        (contacts, drives)
    }

    /// Divides a list of contacts that stop sticking, and of drives that stop acting as springs, into the contacts and the drives, which yield or
    /// slacken. Contacts get their labels; a drive is labelled by its joint or tendon.
    pub(super) fn leaving_apart(
        &self,
        mut leaving: Vec<DepartingContact<3>>,
    ) -> (Vec<DepartingContact<3>>, Vec<PartChange>) {
        let mut drives = Vec::new();
        leaving.retain_mut(|DepartingContact { contact, how }| {
            let site = contact.index;
            if site < self.len() {
                *contact = self.contacts()[site].label(site);
                return true;
            }
            drives.extend(self.part_change(site, matches!(how, Departure::Slides { .. } | Departure::Opens)));
            false
        });
        (leaving, drives)
    }

    /// Separates the indices `sites` of contacts and drives: the labels of the contacts, and the labels of the joints and tendons of the drives.
    pub(super) fn sites_apart(&self, sites: Vec<usize>) -> (Vec<ContactLabel>, Vec<PartLabel>) {
        let (contacts, drives): (Vec<usize>, Vec<usize>) = sites.into_iter().partition(|i| *i < self.len());
        let contact = |i: usize| self.contacts()[i].label(i);
        (moved(contacts, &contact), drives.into_iter().filter_map(|i| self.part(i)).list())
    }

    /// The joint or tendon of the drive with this index among contacts and drives; `None` for a drive without a joint or tendon.
    pub(crate) fn part(&self, site: usize) -> Option<PartLabel> {
        let linkage = self.linkage()?;
        linkage.part(site - self.len()).map(|part| linkage.label(part))
    }

    /// The contact with this index; for the index of a drive, its joint or tendon. `None` for a drive without joint or tendon, i.e. for a spring of a
    /// stiffness or compliance matrix.
    pub(crate) fn leaver(&self, site: usize) -> Option<DepartingPart> {
        match self.linkage() {
            Some(linkage) if site >= self.len() => linkage.part(site - self.len()).map(DepartingPart::Drive),
            _ => Some(DepartingPart::Contact(site)),
        }
    }

    /// The label of the contact with this index; for the index of a drive, the label of its joint or tendon. `None` for a drive without a joint or
    /// tendon.
    pub(super) fn edge_of(&self, site: usize) -> Option<EdgeOf> {
        match self.contacts().get(site) {
            Some(contact) => Some(EdgeOf::Contact(contact.label(site))),
            None => self.part(site).map(EdgeOf::Drive),
        }
    }

    /// The change of the drive with the index `site` among contacts and drives: it gives way if `frees`, else it holds again.
    pub(crate) fn part_change(&self, site: usize, frees: bool) -> Option<PartChange> {
        let linkage = self.linkage()?;
        let drive = &linkage.drives[site - self.len()];
        let what = match (frees, drive.role, drive.pulls_only()) {
            (true, DriveLaw::Pulls | DriveLaw::LowerHalf, true) => DriveChange::Slackens,
            (false, DriveLaw::Pulls | DriveLaw::LowerHalf, true) => DriveChange::Tightens,
            (true, ..) => DriveChange::Yields,
            (false, ..) => DriveChange::Holds,
        };
        Some(PartChange { part: self.part(site)?, what })
    }
}
