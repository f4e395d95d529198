//! The normal forces with which contacts press under a squeeze, and sentences about these forces.

use nalgebra::SVector;

use crate::grasp::{Contact, WholeContact};
use crate::numerics::{Space, mapped};
use crate::prelude::*;
use crate::words::{ALIKE_IN_WORDS, MOST_NAMES, Words, listed};

/// The normal force of a contact.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Press {
    /// The contact, or the soft fingertip.
    pub part: WholeContact,
    /// Normal force of the contact, N; for a soft fingertip the sum over its points.
    pub force: f64,
    /// Whether a command, force or vacuum of the contact itself presses it; otherwise it is pressed by reaction. `false` for all contacts where
    /// joints or tendons press.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub is_set: bool,
    /// Of a suction cup: the pressure of its vacuum below that of the air around, Pa.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressure: Option<f64>,
}

/// The pressure of a suction cup's vacuum below that of the air, Pa, if these points in space form its ring-shaped lip. In the plane there is no area.
pub(super) fn pressure_of_cup(points: &[Contact<3>]) -> Option<f64> {
    let count = points.len() as f64;
    let vacuum: f64 = points.iter().map(|point| point.suction).sum();
    let middle = points.iter().fold(SVector::<f64, 3>::zeros(), |sum, point| sum + point.point / count);
    let radius = |point: &Contact<3>| (point.point - middle).norm();
    let size = points.iter().map(radius).fold(0.0, f64::max);
    let is_ring = points.iter().all(|point| point.space == Space::Spatial)
        && points.len() > 2
        && points.iter().all(|point| size - radius(point) <= ALIKE_IN_WORDS * size);
    (vacuum > 0.0 && size > 0.0 && is_ring).then(|| vacuum / (core::f64::consts::PI * size * size))
}

impl Press {
    /// The force of the contact as text: "16.7 N"; of a suction cup "13.3 kPa (16.7 N)".
    fn in_words(&self, words: Words) -> String {
        let newtons = words.number(self.force);
        match self.pressure {
            Some(pressure) => format!("{} kPa ({newtons} N)", words.number(1e-3 * pressure)),
            None => format!("{newtons} N"),
        }
    }
}

/// The contacts and cables that have commands of their own and press at rest; if there are none, because joints or tendons press, all contacts that
/// press.
fn pressing(presses: &[Press]) -> Vec<&Press> {
    let is_one_set = presses.iter().any(|press| press.is_set);
    let most = presses.iter().map(|press| press.force).fold(0.0, f64::max);
    let is_meant = |press: &&Press| (press.is_set || !is_one_set) && press.force >= ALIKE_IN_WORDS * most;
    presses.iter().filter(is_meant).collect()
}

/// The normal force that is the same at all pressing contacts, to within [`ALIKE_IN_WORDS`], N; `None` if forces differ.
pub(super) fn alike(presses: &[Press]) -> Option<f64> {
    let pressing = pressing(presses);
    let first = pressing.first()?.force;
    pressing.iter().all(|press| (press.force - first).abs() <= ALIKE_IN_WORDS * first).then_some(first)
}

/// The normal force that is the same at all pressing contacts, as text; `None` if forces differ.
pub(super) fn all_alike(words: Words, presses: &[Press]) -> Option<String> {
    alike(presses)?;
    pressing(presses).first().map(|press| press.in_words(words))
}

/// The forces of all pressing contacts as text: "12 N at left and right". If forces differ, each is given with its contact, followed by `times`, the
/// multiple of the given squeeze.
pub(super) fn in_words(words: Words, presses: &[Press], times: String) -> String {
    let pressing = pressing(presses);
    let names: Vec<_> = mapped(&pressing, &|press| press.part.text());
    match all_alike(words, presses) {
        Some(force) if names.len() > MOST_NAMES => format!("{force} at every contact"),
        Some(force) => format!("{force} at {}", listed(&names)),
        None if pressing.is_empty() || names.len() > MOST_NAMES => times,
        None => {
            let each: Vec<_> =
                mapped(&pressing, &|press| format!("{} at {}", press.in_words(words), press.part.text()));
            format!("{} ({times})", listed(&each))
        }
    }
}
