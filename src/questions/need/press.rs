//! The normal forces with which contacts press under a squeeze, and sentences about these forces. At rest means under the loads that act before the
//! loads of the question. The squeeze is everything by which contacts press at rest without a load: commands (displacements that fingers would make
//! without an object), constant forces, vacuums and torques of joints. If nothing else presses, it consists of overlaps, i.e. of negative clearances
//! between fingers and object. A link (a hinge, spring or cable, for example) joins two bodies, or a body and the ground.

use nalgebra::SVector;

use crate::grasp::{ATMOSPHERE, Contact, WholeContact};
use crate::numerics::{IntoList, Space, largest, mapped, summed};
use crate::prelude::*;
use crate::words::{ALIKE_IN_WORDS, MOST_NAMES, Words, listed};

/// The normal force with which a contact presses at rest under a squeeze, and the number that the user sets at this contact.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactPress {
    /// The contact, or the soft fingertip.
    pub part: WholeContact,
    /// Normal force of the contact, N; for a soft fingertip the sum over its points.
    pub force: f64,
    /// Whether a command, force or vacuum of the contact itself presses it. If not, only the reaction to other contacts presses it. `false` for all
    /// contacts if joints or tendons press.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub is_set: bool,
    /// For a suction cup: how far the pressure in the cup is below the pressure of the surrounding air, Pa. `None` for other contacts.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressure: Option<f64>,
    /// The force that the user sets at the contact for this squeeze, N: the contact's field `pressed_with` or `force`, or the `force` of a suction
    /// cup's vacuum. The normal force at rest differs from it if the object gives way, or if a load acts at rest. `None` for links, and for contacts
    /// with a command across their normal.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub pressed_with: Option<f64>,
    /// For a contact that presses because it overlaps: the overlap, m, i.e. its negative clearance without the sign. `None` unless overlaps are the
    /// squeeze.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub overlap: Option<f64>,
}

/// The normal force that the user sets at these points of one contact, N, summed over the points; for a suction cup in space the force of its vacuum.
/// `None` for links, for contacts with a tangential command, and if no force is set.
pub(super) fn force_set(points: &[Contact<3>]) -> Option<f64> {
    let vacuum: f64 = summed(points, &|point| point.suction);
    if vacuum > 0.0 {
        return pressure_of_cup(points).map(|_| vacuum);
    }
    let of_point = |point: &Contact<3>| {
        let is_plain = point.link.is_none() && point.command[1] == 0.0 && point.command[2] == 0.0;
        let pressed = point.stiffness.series()[0] * (point.command[0] - point.clearance);
        Some(point.force.unwrap_or(pressed)).filter(|force| is_plain && *force > 0.0)
    };
    points.iter().try_fold(-0.0, |sum, point| Some(sum + of_point(point)?))
}

/// How far the pressure in a suction cup is below the pressure of the surrounding air, Pa, if these points in space form its ring-shaped lip. In the
/// plane there is no area, and the result is `None`.
pub(crate) fn pressure_of_cup(points: &[Contact<3>]) -> Option<f64> {
    let count = points.len() as f64;
    let vacuum: f64 = summed(points, &|point| point.suction);
    let middle = points.iter().fold(SVector::<f64, 3>::zeros(), |sum, point| sum + point.point / count);
    let radius = |point: &Contact<3>| (point.point - middle).norm();
    let size = largest(points, &radius);
    let is_ring = points.iter().all(|point| point.space == Space::Spatial)
        && points.len() > 2
        && points.iter().all(|point| size - radius(point) <= ALIKE_IN_WORDS * size);
    (vacuum > 0.0 && size > 0.0 && is_ring).then(|| vacuum / (core::f64::consts::PI * size * size))
}

impl ContactPress {
    /// The force of the contact as text: "16.7 N"; of a suction cup the vacuum, "13.3 kPa (16.7 N)", of an overlap "0.025 mm of overlap (250 N)".
    fn in_words(&self, words: Words) -> String {
        let newtons = words.number(self.named_force());
        match (self.pressure, self.overlap) {
            (Some(pressure), _) if pressure > ATMOSPHERE => format!(
                "{} kPa ({newtons} N; more than an atmosphere: no vacuum does)",
                words.number(1e-3 * pressure)
            ),
            (Some(pressure), _) => format!("{} kPa ({newtons} N)", words.number(1e-3 * pressure)),
            (None, Some(overlap)) => format!("{} of overlap ({newtons} N)", words.length(overlap)),
            (None, None) => format!("{newtons} N"),
        }
    }

    /// The force that the text of [`Self::in_words`] names: for a suction cup that of its vacuum, else the normal force, N.
    fn named_force(&self) -> f64 {
        self.pressed_with.filter(|_| self.pressure.is_some()).unwrap_or(self.force)
    }

    /// Whether the text of [`Self::in_words`] states a number that the user sets: a pressure, an overlap, or a normal force equal to `pressed_with`.
    fn names_itself(&self) -> bool {
        let is_set = |set: f64| (set - self.force).abs() <= ALIKE_IN_WORDS * set;
        self.pressure.is_some() || self.overlap.is_some() || self.pressed_with.is_some_and(is_set)
    }
}

/// The contacts and cables that press at rest by a command, force or vacuum of their own ([`ContactPress::is_set`]). If there are none, because
/// joints or tendons press, all contacts that press at rest are returned.
fn pressing(presses: &[ContactPress]) -> Vec<&ContactPress> {
    let is_one_set = presses.iter().any(|press| press.is_set);
    let most = largest(presses, &|press| press.force);
    let is_meant = |press: &&ContactPress| {
        (press.is_set || !is_one_set) && press.force > 0.0 && press.force >= ALIKE_IN_WORDS * most
    };
    presses.iter().filter(is_meant).list()
}

/// Whether `number` returns the same value for all these contacts, to within the relative difference [`ALIKE_IN_WORDS`] (1e-6), which six digits do
/// not show.
fn is_alike(presses: &[&ContactPress], number: &dyn Fn(&ContactPress) -> Option<f64>) -> bool {
    let number = |press: &ContactPress| number(press).unwrap_or(0.0);
    let is_same =
        |press: &&ContactPress, first: f64| (number(press) - first).abs() <= ALIKE_IN_WORDS * first.abs();
    presses.first().is_some_and(|first| presses.iter().all(|press| is_same(press, number(first))))
}

/// The force that is named of all pressing contacts, N, if it is the same to within the relative difference [`ALIKE_IN_WORDS`] (1e-6); `None` if forces
/// differ.
pub(super) fn alike(presses: &[ContactPress]) -> Option<f64> {
    let pressing = pressing(presses);
    is_alike(&pressing, &|press| Some(press.named_force())).then(|| pressing[0].named_force())
}

/// The text for a normal force that is the same at all pressing contacts: `name(force)`. In parentheses follow the number to set, `pressed_with`, if
/// that is also the same at all contacts, and `times`, the multiple of the given squeeze. The parentheses are left out if the user sets this force
/// itself. `None` if forces, pressures or overlaps differ between contacts.
fn all_alike(
    words: Words,
    presses: &[ContactPress],
    times: &str,
    name: &dyn Fn(String) -> String,
) -> Option<String> {
    let pressing = pressing(presses);
    alike(presses)?;
    let is_same = is_alike(&pressing, &|press| press.pressure) && is_alike(&pressing, &|press| press.overlap);
    let first = pressing.first().filter(|_| is_same)?;
    let named = name(first.in_words(words));
    Some(match first.pressed_with.filter(|_| is_alike(&pressing, &|press| press.pressed_with)) {
        _ if pressing.iter().all(|press| press.names_itself()) => named,
        Some(set) => format!("{named} (`pressed_with` {} N, {times})", words.number(set)),
        None => format!("{named} ({times})"),
    })
}

/// The force at each pressing contact as text without names of contacts: "12 N". If forces differ, the text is `times`, the multiple of the squeeze.
pub(super) fn in_short(words: Words, presses: &[ContactPress], times: String) -> String {
    all_alike(words, presses, &times, &|force| force).unwrap_or(times)
}

/// The forces of all pressing contacts as text: "12 N at left and right". If forces differ, each is given with its contact. If the user sets another
/// number than this force, the text also has the number to set, `pressed_with`, and `times`, the multiple of the given squeeze.
pub(super) fn in_words(words: Words, presses: &[ContactPress], times: String) -> String {
    let pressing = pressing(presses);
    let names: Vec<_> = mapped(&pressing, &|press| press.part.text());
    let is_long = names.len() > MOST_NAMES;
    let named = |force| {
        let place = if is_long { "every contact".to_owned() } else { listed(&names) };
        format!("{force} at {place}")
    };
    match all_alike(words, presses, &times, &named) {
        Some(alike) => alike,
        None if pressing.is_empty() => with_what_is_set(words, presses, times),
        None if is_long => times,
        None => {
            let each: Vec<_> =
                mapped(&pressing, &|press| format!("{} at {}", press.in_words(words), press.part.text()));
            // The words " at rest" mark forces that the user does not set. Entered as `pressed_with`, such a force would give another grasp.
            let at_rest = if pressing.iter().all(|press| press.names_itself()) { "" } else { " at rest" };
            format!("{}{at_rest} ({times})", listed(&each))
        }
    }
}

/// The text if no contact presses at rest: `times`, the multiple of the given squeeze, and the force `pressed_with` if it is the same at all contacts
/// with commands of their own.
fn with_what_is_set(words: Words, presses: &[ContactPress], times: String) -> String {
    let set: Vec<&ContactPress> = presses.iter().filter(|press| press.is_set).list();
    let Some((first, force)) = set.first().and_then(|first| Some((first, first.pressed_with?))) else {
        return times;
    };
    let is_same = is_alike(&set, &|press| press.pressed_with) && is_alike(&set, &|press| press.pressure);
    if !is_same || set.len() > MOST_NAMES {
        return times;
    }
    let names: Vec<_> = mapped(&set, &|press| press.part.text());
    let number = if first.pressure.is_some() {
        first.in_words(words)
    } else {
        format!("`pressed_with` {} N", words.number(force))
    };
    format!("{times} ({number} at {})", listed(&names))
}
