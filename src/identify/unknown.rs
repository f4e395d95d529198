//! A number of the grasp that is sought.

use crate::ask::Grasp;
use crate::grasp::{Contact, Wrench};
use crate::prelude::*;
use crate::words::listed;

/// What kind of number is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum UnknownKind {
    /// A coefficient of friction.
    Friction,
    /// The normal force that each contact carries at rest, N.
    Carried,
    /// How many times the squeeze given.
    Squeeze,
    /// How many times the tangential stiffness given.
    Stiffness,
}

/// A number of the grasp that is sought: one for all contacts that are meant, in all layouts or in one.
#[derive(Debug, Clone, PartialEq)]
pub struct Unknown {
    pub(super) kind: UnknownKind,
    /// All if not said.
    pub(super) contacts: Option<Vec<usize>>,
    pub(super) layout: Option<usize>,
    pub(super) name: Option<String>,
    pub(super) start: Option<f64>,
}

/// Where the search begins at a load of a support that nothing is known of, N.
const SOME_LOAD: f64 = 1.0;

impl Unknown {
    fn of(kind: UnknownKind) -> Self {
        Self { kind, contacts: None, layout: None, name: None, start: None }
    }

    /// One coefficient of friction of all contacts.
    #[must_use]
    pub fn friction() -> Self {
        Self::of(UnknownKind::Friction)
    }

    /// The normal force that a contact carries at rest, N: its support's share of a weight. The contact presses with it, and the object is pressed onto the
    /// contact with as much, so that it rests where it is; no base load has to say the weight once more.
    #[must_use]
    pub fn carried() -> Self {
        Self::of(UnknownKind::Carried)
    }

    /// How many times the squeeze given: normal commands, forces and vacuums of these contacts; of all, commands of joints, too.
    #[must_use]
    pub fn squeeze() -> Self {
        Self::of(UnknownKind::Squeeze)
    }

    /// How many times the tangential stiffness given. Gross slip of a load does not depend on it as a rule, first slip on ratios alone.
    #[must_use]
    pub fn stiffness() -> Self {
        Self::of(UnknownKind::Stiffness)
    }

    /// This unknown of some contacts of the grasp, from 0, in place of all.
    #[must_use]
    pub fn of_contacts(mut self, contacts: impl IntoIterator<Item = usize>) -> Self {
        self.contacts = Some(contacts.into_iter().collect());
        self
    }

    /// This unknown of one layout alone, from 0.
    #[must_use]
    pub fn in_layout(mut self, layout: usize) -> Self {
        self.layout = Some(layout);
        self
    }

    /// This unknown with a name of its own for answers, such as "rubber".
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// This unknown with another value to begin the search at than the one that the grasp has, more than zero.
    #[must_use]
    pub fn starting_at(mut self, value: f64) -> Self {
        self.start = Some(value);
        self
    }

    /// Whether it is one of this contact in this layout.
    pub(super) fn is_of(&self, layout: usize, contact: usize) -> bool {
        self.is_in(layout) && self.contacts.as_ref().is_none_or(|those| those.contains(&contact))
    }

    pub(super) fn is_in(&self, layout: usize) -> bool {
        self.layout.is_none_or(|own| own == layout)
    }

    /// How answers call it: its name, or "friction of left and right".
    pub(super) fn called<const C: usize>(&self, grasp: &Grasp<C>) -> String {
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
            let names: Vec<_> = those.iter().map(ToString::to_string).collect();
            format!(" of {}", listed(&names))
        });
        let at = self.layout.map_or_else(String::new, |layout| format!(" in layout {layout}"));
        format!("{kind}{whose}{at}")
    }

    /// Where the search begins.
    pub(super) fn begins_at<const C: usize>(&self, layouts: &[Grasp<C>]) -> f64 {
        if let Some(start) = self.start {
            return start;
        }
        let grasp = &layouts[self.layout.unwrap_or(0)];
        let meant =
            grasp.contacts().iter().enumerate().filter(|(i, _)| self.is_of(self.layout.unwrap_or(0), *i));
        let positive = |x: &f64| *x > 0.0 && x.is_finite();
        match self.kind {
            UnknownKind::Friction => {
                meant.map(|(_, contact)| contact.friction_coefficient()).find(positive).unwrap_or(0.5)
            }
            UnknownKind::Carried => {
                meant.map(|(_, contact)| pressed(contact)).find(positive).unwrap_or(SOME_LOAD)
            }
            UnknownKind::Squeeze | UnknownKind::Stiffness => 1.0,
        }
    }

    /// Puts a value in the contacts of a layout, whose normals are along `normals`, and in what acts besides.
    pub(super) fn put<const C: usize>(
        &self,
        layout: usize,
        value: f64,
        contacts: &mut [Contact<C>],
        base: &mut Wrench<C>,
    ) {
        for (_, contact) in contacts.iter_mut().enumerate().filter(|(i, _)| self.is_of(layout, *i)) {
            match self.kind {
                UnknownKind::Friction => contact.set_friction(value),
                UnknownKind::Carried => {
                    contact.command[0] = value / contact.stiffness.series()[0] + contact.clearance;
                    *base = *base + carried_by(contact, value);
                }
                UnknownKind::Squeeze if self.contacts.is_none() => {}
                UnknownKind::Squeeze => {
                    contact.command[0] *= value;
                    contact.force = contact.force.map(|force| force * value);
                    contact.suction *= value;
                }
                UnknownKind::Stiffness => contact.stiffness = contact.stiffness.scaled_tangentially(value),
            }
        }
    }
}

/// What a contact presses with on an object that stays where it is, N.
fn pressed<const C: usize>(contact: &Contact<C>) -> f64 {
    contact.stiffness.series()[0] * (contact.command[0] - contact.clearance)
}

/// What presses the object onto a contact with so many newtons.
pub(super) fn carried_by<const C: usize>(contact: &Contact<C>, newtons: f64) -> Wrench<C> {
    Wrench::force_through(&contact.point, &(contact.normal.normalize() * -newtons))
}
