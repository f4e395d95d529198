//! A parameter: a number of the grasp that is to be estimated from observed slip, such as a coefficient of friction. An observation is a load or
//! angle at which slip was observed. A layout is one arrangement of the contact points. The squeeze is everything by which contacts press at rest
//! without a load.

use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Contact, Wrench};
use crate::numerics::{IntoList, any_index, chosen, mapped, numbered};
use crate::prelude::*;
use crate::words::listed;

/// The kind of a parameter, i.e. of a number of the grasp that is estimated from observed slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum UnknownKind {
    /// A coefficient of friction.
    Friction,
    /// The normal force, N, that each contact carries before the load grows.
    Carried,
    /// The factor on the given squeeze.
    Squeeze,
    /// The factor on the given tangential stiffness.
    Stiffness,
}

/// A parameter, i.e. an unknown number of the grasp: one value for all its contacts, in all layouts or in one layout.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[must_use]
pub struct Unknown {
    /// The kind of the parameter: friction, carried force, squeeze or stiffness.
    #[cfg_attr(feature = "serde", serde(rename = "quantity"))]
    pub(super) kind: UnknownKind,
    /// The contacts of the parameter, from 0, a soft fingertip counted as one. If left out, all contacts except links; for friction all that have
    /// friction.
    #[cfg_attr(
        feature = "serde",
        serde(default, deserialize_with = "some_contacts", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "Vec<usize>"))]
    pub(crate) contacts: Option<Vec<usize>>,
    /// The layout of the parameter, 0 for the scene itself; all layouts if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) layout: Option<usize>,
    /// The name of the parameter in answers.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) name: Option<String>,
    /// The value at the start of the search; the value of the scene if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) start: Option<f64>,
    /// For each layout, the indices of the contact points whose data contain this parameter, such as those that have this coefficient of friction.
    /// Empty until [`Self::of_points`] fills it in.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) points: Vec<Vec<usize>>,
}

/// Reads the contacts of a parameter from a file; an empty list becomes `None`, which means all contacts.
#[cfg(feature = "serde")]
fn some_contacts<'de, S: serde::Deserializer<'de>>(deserializer: S) -> Result<Option<Vec<usize>>, S::Error> {
    let contacts: Vec<usize> = serde::Deserialize::deserialize(deserializer)?;
    Ok(Some(contacts).filter(|contacts| !contacts.is_empty()))
}

impl Unknown {
    /// A parameter of this kind, common to all contacts in all layouts.
    pub fn of(kind: UnknownKind) -> Self {
        Self { kind, contacts: None, layout: None, name: None, start: None, points: Vec::new() }
    }

    /// One coefficient of friction common to all contacts that have friction.
    pub fn friction() -> Self {
        Self::of(UnknownKind::Friction)
    }

    /// The normal force, N, that each contact carries before the load of an observation grows: for a support, its share of a weight. The contact
    /// presses with this force, and an equal load presses the object onto the contact, so that the object does not move. The weight must not be given
    /// again as a base load: a base load onto such a contact is refused.
    pub fn carried() -> Self {
        Self::of(UnknownKind::Carried)
    }

    /// A factor on the given squeeze. The factor multiplies commands, forces and vacuums of the parameter's contacts and links. If the parameter
    /// belongs to all contacts, the factor also multiplies commands, constant torques and tensions of joints and tendons.
    pub fn squeeze() -> Self {
        Self::of(UnknownKind::Squeeze)
    }

    /// The factor on the given tangential stiffness. The load of first slip depends on ratios of tangential stiffnesses only. The load of gross slip
    /// as a rule does not depend on them, because all friction is then exhausted.
    pub fn stiffness() -> Self {
        Self::of(UnknownKind::Stiffness)
    }

    setters! {
        /// This parameter common to these contacts of the grasp, from 0, instead of all. A soft fingertip counts as one contact.
        pub fn of_contacts(mut self, contacts: impl IntoIterator<Item = usize>) {
            self.contacts = Some(contacts.into_iter().list());
        }

        /// This parameter for one layout alone, given by the number of the layout, from 0.
        pub fn in_layout(mut self, layout: usize) { self.layout = Some(layout); }

        /// This parameter with a name that answers show, such as "rubber".
        pub fn named(mut self, name: impl Into<String>) { self.name = Some(name.into()); }

        /// This parameter with another value at the start of the search than the value of the grasp; it must be more than zero.
        pub fn starting_at(mut self, value: f64) { self.start = Some(value); }
    }

    /// This parameter with the indices of contact points in place of contacts: all points of each soft fingertip. Returns an error for contacts that
    /// the grasp does not have. If the parameter belongs to all contacts, links (such as cables) are left out, except for a squeeze. Friction of all
    /// contacts then belongs to the contacts with friction, if there are any.
    pub(super) fn of_points(&self, number: usize, layouts: &[Grasp<3>]) -> Result<Self, Error> {
        let mut points = self.clone();
        if let Some(contacts) = &self.contacts {
            let of_points = layouts[self.layout.unwrap_or(0)].points_of(contacts);
            points.contacts = Some(of_points.map_err(|error| match error {
                Error::Argument { what: field, value, allowed } => {
                    Error::Identify { what: format!("unknown {number}"), field, value, allowed }
                }
                other => other,
            })?);
        }
        points.points = numbered(layouts.len(), &|layout| {
            let all = layouts[layout].contacts();
            let is_meant = |i: &usize| self.kind == UnknownKind::Squeeze || all[*i].link.is_none();
            let rubs = |i: &usize| is_meant(i) && all[*i].friction > 0.0;
            match &points.contacts {
                _ if !self.is_in(layout) => Vec::new(),
                Some(those) => those.clone(),
                None if self.kind == UnknownKind::Friction && any_index(all.len(), &|i| rubs(&i)) => {
                    chosen(all.len(), &rubs)
                }
                None => chosen(all.len(), &is_meant),
            }
        });
        Ok(points)
    }

    /// Whether this parameter (such as a coefficient of friction) belongs to this contact point in this layout (arrangement of the contact points).
    pub(super) fn is_of(&self, layout: usize, contact: usize) -> bool {
        self.points[layout].contains(&contact)
    }

    pub(super) fn is_in(&self, layout: usize) -> bool {
        self.layout.is_none_or(|own| own == layout)
    }

    /// The name of the parameter in answers: the name that the user gave, or a name such as "friction of left and right".
    pub(super) fn called(&self, grasp: &Grasp<3>) -> String {
        if let Some(name) = &self.name {
            return crate::words::printable(name).into_owned();
        }
        let kind = match self.kind {
            UnknownKind::Friction => "friction",
            UnknownKind::Carried => "load",
            UnknownKind::Squeeze => "squeeze",
            UnknownKind::Stiffness => "tangential stiffness",
        };
        let whose = self.contacts.as_ref().map_or_else(String::new, |contacts| {
            let those = grasp.whole_contacts(|i| contacts.contains(&i));
            let names: Vec<_> = mapped(&those, &ToString::to_string);
            format!(" of {}", listed(&names))
        });
        let at = self.layout.map_or_else(String::new, |layout| format!(" in layout {layout}"));
        format!("{kind}{whose}{at}")
    }

    /// The value of the parameter at the start of the search. It is the given start, or else the first positive value that its contacts have in the
    /// grasp. If there is none, it is 0.5 for friction and 1 N for a carried force. Factors on squeeze and stiffness start at 1.
    pub(super) fn begins_at(&self, layouts: &[Grasp<3>]) -> f64 {
        if let Some(start) = self.start {
            return start;
        }
        let grasp = &layouts[self.layout.unwrap_or(0)];
        let first = |number: fn(&Contact<3>) -> f64| {
            let meant = chosen(grasp.len(), &|i| self.is_of(self.layout.unwrap_or(0), *i));
            let numbers = mapped(&meant, &|i| number(&grasp.contacts()[*i]));
            numbers.into_iter().find(|x| *x > 0.0 && x.is_finite())
        };
        match self.kind {
            UnknownKind::Friction => first(Contact::friction_coefficient).unwrap_or(0.5),
            UnknownKind::Carried => first(pressed).unwrap_or(1.0),
            UnknownKind::Squeeze | UnknownKind::Stiffness => 1.0,
        }
    }

    /// Puts a value of the parameter into the contacts of a layout. A carried force, with which a contact presses before the load grows, becomes a
    /// command. The equal load that balances it is added to `base`, so that the object does not move. The caller, not this function, applies a factor
    /// on the squeeze of all contacts.
    pub(super) fn put(&self, layout: usize, value: f64, contacts: &mut [Contact<3>], base: &mut Wrench<3>) {
        for (_, contact) in contacts.iter_mut().enumerate().filter(|(i, _)| self.is_of(layout, *i)) {
            match self.kind {
                UnknownKind::Friction => contact.set_friction(value),
                UnknownKind::Carried => {
                    contact.command[0] = value / contact.stiffness.series()[0] + contact.clearance;
                    *base = *base + carried_by(contact, value);
                }
                UnknownKind::Squeeze if self.contacts.is_none() => {}
                UnknownKind::Squeeze => contact.squeeze(value),
                UnknownKind::Stiffness => contact.stiffness = contact.stiffness.scaled_tangentially(value),
            }
        }
    }
}

/// The normal force with which the command of a contact presses on an object that does not move, N.
fn pressed(contact: &Contact<3>) -> f64 {
    contact.stiffness.series()[0] * (contact.command[0] - contact.clearance)
}

/// The load that presses the object onto a contact with the force `newtons`, N: a force through the contact point, against the contact normal.
pub(super) fn carried_by(contact: &Contact<3>, newtons: f64) -> Wrench<3> {
    Wrench::force_through(&contact.point, &(contact.normal.normalize() * -newtons))
}
