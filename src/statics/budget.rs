//! What bounds the normal forces, and how forces and moments are made comparable.

use nalgebra::SVector;

use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::Contact;

/// What normal forces there may be. Friction follows them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// Each contact may press with so much, N: what every finger can. The wrenches are the sum of those of the contacts (L∞).
    Each(f64),
    /// All together may press with so much, N. The wrenches are the convex hull of those of the contacts (L1).
    Total(f64),
}

impl Budget {
    pub(super) fn check(self) -> Result<(), Error> {
        let (Self::Each(value) | Self::Total(value)) = self;
        if value > 0.0 && is_moderate(value) {
            return Ok(());
        }
        let (what, allowed) = ("budget of normal forces", "more than 0 and at most 1e50");
        Err(Error::Argument { what, value, allowed })
    }
}

/// How wrenches are measured: moments about a point, divided by a length, count as forces. The radius of a ball depends on both.
///
/// By default the point is the centroid of the contacts, and the length the largest distance of a contact from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrenchScale<const C: usize> {
    /// Moments are taken about this point, m; the centre of mass as a rule.
    pub about: [f64; C],
    /// A moment of one newton times this length counts as one newton, m.
    pub length: f64,
}

impl<const C: usize> WrenchScale<C> {
    /// That of a grasp.
    pub(crate) fn of(contacts: &[Contact<C>]) -> Self {
        let points = || contacts.iter().map(Contact::point);
        let about = points().sum::<SVector<f64, C>>() / contacts.len() as f64;
        let length = points().map(|point| (point - about).norm()).fold(0.0, f64::max);
        // Contacts at one point have no length of their own.
        Self { about: about.into(), length: if length > 0.0 { length } else { 1.0 } }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        for value in self.about {
            if !is_moderate(value) {
                return Err(Error::Argument { what: "point of the moments", value, allowed: MODERATE });
            }
        }
        if self.length > 0.0 && is_moderate(self.length) {
            return Ok(());
        }
        let (what, allowed) = ("length of the wrench scale", "more than 0 and at most 1e50");
        Err(Error::Argument { what, value: self.length, allowed })
    }
}
