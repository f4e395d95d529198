//! Contacts as users count them: a soft fingertip is one contact with several points.

use alloc::borrow::Cow;
use alloc::sync::Arc;
use core::fmt;
use core::ops::Range;

use nalgebra::SVector;

use super::contact::Contact;
use crate::error::ContactLabel;
use crate::numerics::mapped;
use crate::prelude::*;
use crate::words::{LinkKind, printable};

/// A contact in an answer; of a soft fingertip, possibly only some of its points.
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
    /// Number of points to which the answer applies; 1 for a contact that is a single point.
    pub points: usize,
    /// Number of all points of the contact.
    pub of: usize,
}

impl WholeContact {
    /// Whether the answer applies to all points of the contact.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.points == self.of
    }

    /// The name, safe to print.
    pub(crate) fn text(&self) -> Cow<'_, str> {
        printable(&self.label)
    }
}

/// "left", or "left (3 of 12 points)".
impl fmt::Display for WholeContact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())?;
        if self.is_whole() { Ok(()) } else { write!(f, " ({} of {} points)", self.points, self.of) }
    }
}

/// The contacts of a grasp, grouped so that the points of a soft fingertip form one part.
pub(crate) struct WholeContacts<'c, const C: usize> {
    contacts: &'c [Contact<C>],
    ranges: Vec<Range<usize>>,
}

impl<'c, const C: usize> WholeContacts<'c, C> {
    pub(crate) fn of(contacts: &'c [Contact<C>]) -> Self {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for (i, contact) in contacts.iter().enumerate() {
            match ranges.last_mut() {
                Some(range) if !contact.begins_a_whole() => range.end = i + 1,
                _ => ranges.push(i..i + 1),
            }
        }
        Self { contacts, ranges }
    }

    /// Range of contact points of each part.
    pub(crate) fn ranges(&self) -> &[Range<usize>] {
        &self.ranges
    }

    /// The parts that have points for which `is_meant` is true, in order.
    pub(crate) fn with(&self, is_meant: &dyn Fn(usize) -> bool) -> Vec<WholeContact> {
        let mut parts = Vec::new();
        for (contact, range) in self.ranges.iter().enumerate() {
            let points = range.clone().filter(|i| is_meant(*i)).count();
            if points > 0 {
                let (label, link) = (self.label(contact), self.link(contact));
                parts.push(WholeContact { contact, label, link, points, of: range.len() });
            }
        }
        parts
    }

    /// Label of a part in answers.
    pub(crate) fn whole(&self, number: usize) -> ContactLabel {
        ContactLabel {
            index: number,
            point: None,
            name: self.name(number).map(Arc::from),
            link: self.link(number),
        }
    }

    /// Mean of a vector over the points of each part.
    pub(crate) fn mean(&self, of: &dyn Fn(usize) -> SVector<f64, C>) -> Vec<SVector<f64, C>> {
        let mean = |range: &Range<usize>| {
            range.clone().fold(SVector::zeros(), |sum, i| sum + of(i)) / range.len() as f64
        };
        mapped(&self.ranges, &mean)
    }

    /// Sum of a number over the points of each part.
    pub(crate) fn sum(&self, of: &dyn Fn(usize) -> f64) -> Vec<f64> {
        mapped(&self.ranges, &|range| range.clone().map(of).sum())
    }

    /// Kind of link that a part represents, if any.
    fn link(&self, number: usize) -> Option<LinkKind> {
        self.contacts[self.ranges[number].start].link
    }

    /// The user's name of a part, if any.
    fn name(&self, number: usize) -> Option<&str> {
        self.contacts[self.ranges[number].start].whole_name()
    }

    /// The user's name of a part, or its number.
    pub(crate) fn label(&self, number: usize) -> String {
        self.name(number).map_or_else(|| format!("contact {number}"), |name| printable(name).into_owned())
    }
}

impl<const C: usize> Contact<C> {
    /// Whether the contact is the first point of a soft fingertip, or a single point.
    pub(crate) fn begins_a_whole(&self) -> bool {
        self.point_of_pad.unwrap_or(0) == 0
    }

    /// The user's name; for a point of a soft fingertip, the name of the fingertip.
    pub(crate) fn whole_name(&self) -> Option<&str> {
        let name = self.name.as_deref()?;
        let of_the_pad = self.point_of_pad.and_then(|point| name.strip_suffix(&format!(" {point}")));
        Some(of_the_pad.unwrap_or(name))
    }
}
