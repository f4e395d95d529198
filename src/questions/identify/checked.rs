//! Checks of a question that asks which parameters of a grasp explain observed slip. They return errors for questions that no search can answer. A
//! parameter ([`Unknown`]) is a number of the grasp that is sought, such as a coefficient of friction. A layout is an arrangement of the contact
//! points, with a grasp of its own. The squeeze is everything by which contacts press at rest without a load. A carried force is the normal force of
//! a contact, due to the squeeze and the base load, before the load of an observation grows.

use super::question::{Identify, KnownSum};
use super::slip::Slip;
use super::unknown::{Unknown, UnknownKind};
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Space;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{any_index, chosen, mapped};
use crate::prelude::*;

fn wrong(what: String, field: &'static str, value: f64, allowed: &'static str) -> Result<(), Error> {
    Err(Error::Identify { what, field, value, allowed })
}

impl Identify<3> {
    /// Returns an error for contacts that the grasps of the layouts do not have, and for two parameters that one contact cannot have at once. Also an
    /// error for a base load that presses on a contact whose carried force is sought: the carried force contains that load.
    pub(super) fn check(&self, layouts: &[Grasp<3>]) -> Result<(), Error> {
        self.unknowns.iter().enumerate().try_for_each(|(k, unknown)| unknown.check(k, layouts))?;
        for (k, unknown) in self.unknowns.iter().enumerate() {
            let meets = |other: &Unknown| {
                let both = |(layout, grasp): (usize, &Grasp<3>)| {
                    any_index(grasp.len(), &|i| unknown.is_of(layout, i) && other.is_of(layout, i))
                };
                unknown.clashes_with(other) && layouts.iter().enumerate().any(both)
            };
            if let Some(other) = self.unknowns[..k].iter().position(meets) {
                let allowed =
                    "another one: no contact has two of a kind, or a squeeze beside what it carries";
                return wrong(
                    format!("unknown {k}"),
                    "number of the one that has its contacts, too,",
                    other as f64,
                    allowed,
                );
            }
        }
        for (k, slip) in self.slips.iter().enumerate() {
            let (layout, force) = (slip.layout(), slip.at_rest().force_part());
            for (i, contact) in layouts[layout].contacts().iter().enumerate() {
                let pressed = -contact.normal.normalize().dot(&force);
                let is_sought =
                    |unknown: &Unknown| unknown.kind == UnknownKind::Carried && unknown.is_of(layout, i);
                if pressed > NEGLIGIBLE * force.norm() && self.unknowns.iter().any(is_sought) {
                    let what = format!("slip {k}, {}", layouts[layout].whole_contacts(|j| j == i)[0]);
                    let allowed =
                        "left out where the force that the contact carries is sought: it contains this load";
                    return wrong(what, "force of the base load onto it", pressed, allowed);
                }
            }
        }
        Ok(())
    }

    /// Returns an error for numbers of the question that are out of range, whatever the grasp; `layouts` is the number of layouts.
    pub(crate) fn check_numbers(&self, space: Space, layouts: usize) -> Result<(), Error> {
        for (list, given) in [("unknowns", self.unknowns.len()), ("slips", self.slips.len())] {
            if given == 0 {
                return wrong(list.to_owned(), "number", 0.0, "at least 1");
            }
        }
        self.unknowns.iter().enumerate().try_for_each(|(k, unknown)| unknown.check_numbers(k, layouts))?;
        self.slips.iter().enumerate().try_for_each(|(k, slip)| slip.check(k, space, layouts))?;
        let scatters: Vec<_> = mapped(&self.slips, &|slip| slip.scatter);
        let groups: Vec<_> = mapped(&self.slips, &|slip| slip.group.map(|group| group as f64));
        for (field, column) in [("scatter", scatters), ("group", groups)] {
            let has_none = column.contains(&None);
            if let Some(slip) = column.iter().position(Option::is_some).filter(|_| has_none) {
                let (given, allowed) = (column[slip].unwrap_or(0.0), "given for every slip, or for none");
                return wrong(format!("slip {slip}"), field, given, allowed);
            }
        }
        if self.slips[0].group.is_some() && self.slips.iter().all(|slip| slip.group == self.slips[0].group) {
            let allowed = "at least 2: errors of groups are told by how far they are apart";
            return wrong("slips".to_owned(), "number of groups", 1.0, allowed);
        }
        let carries = |slip: &Slip<3>, unknown: &Unknown| {
            unknown.kind == UnknownKind::Carried && unknown.is_in(slip.layout())
        };
        let squeezed = |slip: &Slip<3>| {
            slip.squeeze() != 1.0 && self.unknowns.iter().any(|unknown| carries(slip, unknown))
        };
        if let Some(slip) = self.slips.iter().position(squeezed) {
            let (given, allowed) = (self.slips[slip].squeeze(), "1 where what contacts carry is sought");
            return wrong(format!("slip {slip}"), "squeeze", given, allowed);
        }
        self.known.iter().enumerate().try_for_each(|(k, known)| known.check(k, self.unknowns.len()))?;
        if self.outliers().is_nan() || self.outliers() < 1.0 {
            let allowed = "at least 1 standard deviation, or infinite";
            return wrong("identify".to_owned(), "bound of outliers", self.outliers(), allowed);
        }
        Ok(())
    }
}

impl KnownSum {
    fn check(&self, number: usize, unknowns: usize) -> Result<(), Error> {
        let what = format!("known sum {number}");
        if self.unknowns.is_empty() {
            return wrong(what, "number of unknowns", 0.0, "at least 1");
        }
        if let Some(number) = self.unknowns.iter().find(|number| **number >= unknowns) {
            return wrong(what, "number of the unknown", *number as f64, "less than the number of unknowns");
        }
        if !(self.value > 0.0 && self.value <= 1e50) {
            return wrong(what, "value", self.value, "more than 0 and at most 1e50");
        }
        if !(self.scatter > 0.0 && self.scatter <= 10.0) {
            return wrong(what, "scatter", self.scatter, "more than 0 and at most 10: 0.05 is five percent");
        }
        Ok(())
    }
}

impl Unknown {
    /// Whether the two parameters exclude each other at one contact. They do if they are of one kind. So do a squeeze and a carried force, since both
    /// determine how hard the contact presses.
    fn clashes_with(&self, other: &Self) -> bool {
        let presses = |kind| matches!(kind, UnknownKind::Carried | UnknownKind::Squeeze);
        self.kind == other.kind || (presses(self.kind) && presses(other.kind))
    }

    /// Returns an error if the layout, the start value or the list of contacts of this parameter is out of range. The message names the parameter by
    /// its index `number`, from 0; `layouts` is the number of layouts.
    fn check_numbers(&self, number: usize, layouts: usize) -> Result<(), Error> {
        let what = format!("unknown {number}");
        if let Some(layout) = self.layout.filter(|layout| *layout >= layouts) {
            return wrong(what, "layout", layout as f64, "less than the number of layouts");
        }
        if let Some(start) = self.start.filter(|start| !(*start >= 1e-6 && *start <= 1e6)) {
            return wrong(what, "start", start, "from 1e-6 to 1e6");
        }
        if self.contacts.as_ref().is_some_and(Vec::is_empty) {
            return wrong(what, "number of contacts", 0.0, "at least 1");
        }
        Ok(())
    }

    /// Returns an error for contacts of this parameter that a layout (arrangement of the contact points) does not have. For a carried force, also an
    /// error for contacts whose pressing force is given. The message names the parameter by its index `number`, from 0.
    fn check(&self, number: usize, layouts: &[Grasp<3>]) -> Result<(), Error> {
        for (layout, grasp) in layouts.iter().enumerate().filter(|(layout, _)| self.is_in(*layout)) {
            let named = self.contacts.as_deref().unwrap_or_default();
            if let Some(contact) = named.iter().find(|contact| **contact >= grasp.len()) {
                let allowed = "less than the number of contacts";
                return wrong(format!("unknown {number}"), "number of the contact", *contact as f64, allowed);
            }
            let meant = chosen(grasp.len(), &|i| self.is_of(layout, *i));
            let held = meant.iter().find_map(|i| grasp.contacts()[*i].force);
            if let Some(force) = held.filter(|_| self.kind == UnknownKind::Carried) {
                let allowed = "left out where the contact carries what is sought";
                return wrong(format!("unknown {number}"), "force of its contact", force, allowed);
            }
        }
        Ok(())
    }
}
