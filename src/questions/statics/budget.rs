//! A [`Budget`] has the upper limits of normal forces, and so determines which wrenches the contacts can exert. A [`WrenchScale`] determines how
//! moments are compared with forces.

use nalgebra::SVector;

use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::Contact;
use crate::numerics::Reals;

/// Upper limits of the normal forces that contacts may exert, and thus of their friction forces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// Each contact may press with this force, N, independently of the other contacts. The possible wrenches are sums of the contacts' wrenches (L∞).
    Each(f64),
    /// The normal forces of all contacts may add up to this force, N. The possible wrenches are the convex hull of the contacts' wrenches (L1).
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

/// The scale in which the magnitude of a wrench is measured: moments about a point, divided by a length, are treated as forces. The magnitude depends
/// on the point and the length.
///
/// By default the point is the centroid of the contacts, and the length the largest distance of a contact from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrenchScale<const C: usize> {
    /// Point about which moments are taken, m: by default the centroid of the contacts; the centre of mass is another common choice.
    pub about: [f64; C],
    /// Length by which moments about this point are divided, m.
    pub length: f64,
}

impl<const C: usize> WrenchScale<C> {
    /// Default scale for these contacts: their centroid, and the largest distance of a contact from it; 1 m if all are at one point.
    pub(crate) fn of(contacts: &[Contact<C>]) -> Self {
        let points = || contacts.iter().map(Contact::point);
        let about = points().sum::<SVector<f64, C>>() / contacts.len() as f64;
        let length = points().map(|point| (point - about).norm()).most();
        // Contacts at one point define no length; 1 m is as good as any other.
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
