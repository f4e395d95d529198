//! Contacts as users count them, called whole contacts: a soft fingertip is one contact with several points.

use alloc::borrow::Cow;
use alloc::sync::Arc;
use core::fmt;
use core::ops::{Deref, Range};

use nalgebra::SVector;

use super::contact::Contact;
use crate::error::ContactLabel;
use crate::numerics::{mapped, picked};
use crate::prelude::*;
use crate::words::{LinkKind, printable};

/// A contact in a list of an answer, such as the contacts that slide. Of a soft fingertip perhaps only some points slide; `points` is their number.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct WholeContact {
    /// Position in the list of contacts, from 0; a soft fingertip counts as one.
    pub contact: usize,
    /// The user's name, or "contact" and the position.
    pub label: String,
    /// Kind of the link between bodies that this contact represents; omitted for an ordinary contact.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub link: Option<LinkKind>,
    /// Number of points to which the list applies, such as the points that slide; 1 for a contact that is a single point.
    pub points: usize,
    /// Number of all points of the contact.
    pub of: usize,
}

impl WholeContact {
    /// Whether the list applies to all points of the contact, for example whether all of its points slide.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.points == self.of
    }

    /// The name of the contact, safe to print.
    pub(crate) fn text(&self) -> Cow<'_, str> {
        printable(&self.label)
    }
}

/// Writes the name, with the number of points if not all are meant: "left", or "left (3 of 12 points)".
impl fmt::Display for WholeContact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())?;
        if self.is_whole() { Ok(()) } else { write!(f, " ({} of {} points)", self.points, self.of) }
    }
}

/// A contact of a grasp with its points: all points of a soft fingertip or of a link, or the one point of any other contact.
#[derive(Debug)]
pub(crate) struct ContactPoints {
    /// Number and name of the contact, where a soft fingertip counts as one contact.
    pub(crate) label: ContactLabel,
    /// Indices of the points of the contact.
    pub(crate) range: Range<usize>,
}

impl ContactPoints {
    /// The name of the contact, or "contact" and its number.
    pub(crate) fn text(&self) -> String {
        self.label.text()
    }

    /// Mean of a vector over the points of this contact.
    pub(crate) fn mean(&self, of: &dyn Fn(usize) -> SVector<f64, 3>) -> SVector<f64, 3> {
        self.range.clone().fold(SVector::zeros(), |sum, i| sum + of(i)) / self.range.len() as f64
    }

    /// The entry of this contact in a list of an answer, such as the contacts that slide. `points` is the number of its points to which the list
    /// applies.
    pub(crate) fn with(&self, points: usize) -> WholeContact {
        let ContactLabel { index: contact, link, .. } = self.label;
        WholeContact { contact, label: self.text(), link, points, of: self.range.len() }
    }
}

/// The contacts of a grasp as users count them, each with its points; made once, when the grasp is validated.
#[derive(Debug, Clone)]
pub(crate) struct WholeContacts(Arc<[ContactPoints]>);

impl Deref for WholeContacts {
    type Target = [ContactPoints];

    fn deref(&self) -> &[ContactPoints] {
        &self.0
    }
}

impl WholeContacts {
    pub(super) fn of(points: &[Contact<3>]) -> Self {
        let mut all: Vec<ContactPoints> = Vec::with_capacity(points.len());
        for (i, point) in points.iter().enumerate() {
            match all.last_mut() {
                Some(contact) if !point.begins_a_whole() => contact.range.end = i + 1,
                _ => {
                    let (index, name) = (all.len(), point.whole_name());
                    let label = ContactLabel { index, point: None, name, link: point.link };
                    all.push(ContactPoints { label, range: i..i + 1 });
                }
            }
        }
        Self(all.into())
    }

    /// The contact, as users count them, to which the contact point with this index belongs: for example the soft fingertip with all of its points.
    pub(crate) fn at(&self, point: usize) -> &ContactPoints {
        &self.0[self.0.partition_point(|contact| contact.range.end <= point)]
    }

    /// The contacts that have a point for which `is_meant` is true, by ascending index, each with the number of such points.
    pub(crate) fn with(&self, is_meant: &dyn Fn(usize) -> bool) -> Vec<WholeContact> {
        picked(self, &|contact| {
            let points = contact.range.clone().filter(|i| is_meant(*i)).count();
            (points > 0).then(|| contact.with(points))
        })
    }

    /// Mean of a vector over the points of each contact.
    pub(crate) fn mean(&self, of: &dyn Fn(usize) -> SVector<f64, 3>) -> Vec<SVector<f64, 3>> {
        mapped(self, &|contact| contact.mean(of))
    }
}

impl<const C: usize> Contact<C> {
    /// Whether the contact is the first point of a soft fingertip or of a link, or a single point.
    pub(crate) fn begins_a_whole(&self) -> bool {
        self.point_of_pad.unwrap_or(0) == 0
    }

    /// The name of the contact; for a point of a soft fingertip or of a link, the name of the whole fingertip or link. `None` without a name.
    pub(crate) fn whole_name(&self) -> Option<Arc<str>> {
        let name = self.name.as_ref()?;
        let of_the_pad = self.point_of_pad.and_then(|point| name.strip_suffix(&format!(" {point}")));
        Some(of_the_pad.map_or_else(|| Arc::clone(name), Arc::from))
    }
}
