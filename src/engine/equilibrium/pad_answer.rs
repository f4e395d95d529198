//! Soft fingertips of an equilibrium, each as one contact with several points.

use core::ops::Range;

use nalgebra::SVector;

use super::answer::Equilibrium;
use super::contact_answer::{ContactAnswer, ContactState};
use crate::error::ContactLabel;
use crate::grasp::{ContactPoints, Engine, Space, Wrench};
use crate::numerics::{IntoList, Reals, Vector, counted, picked};
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::{LinkKind, Words};

/// A soft fingertip of an equilibrium: states and forces of its points together.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PadAnswer<const C: usize> {
    /// Label of the contact. Its index counts a soft fingertip as one contact, as in a scene.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// Index of the fingertip's first point in the list of contacts of the answer.
    pub first: usize,
    /// Number of points of the fingertip.
    pub points: usize,
    /// Number of sliding points.
    pub sliding: usize,
    /// Number of open points.
    pub open: usize,
    /// Force of the finger on the object in the contact frame, N, normal part first, and moment about the middle of the pad, N m. In space the moment
    /// is along the axes of the contact frame, the torsion first; in the plane it is positive from x to y.
    pub wrench: Wrench<C>,
    /// Unused friction of the fingertip, N: the sum of the [margins](ContactAnswer::margin) of its points, `Σ (μ F_n - |F_t|)`. At the same normal
    /// forces the pad can carry an additional tangential force of this magnitude in any direction. Each point then takes a part equal to its own
    /// margin. Zero if the pad slides everywhere or is open; infinite if friction is unlimited.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub margin: f64,
}

impl<const C: usize> PadAnswer<C> {
    /// Range of the fingertip's points in the list of contacts of the answer.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.points
    }

    /// State of the fingertip in words: "sticks", "3 of 12 points slide", "slides everywhere", "open".
    #[must_use]
    pub fn state_text(&self) -> String {
        let Self { points, sliding, open, .. } = *self;
        let some_open = if open > 0 { format!(", {open} of {points} points open") } else { String::new() };
        match (points - open, sliding) {
            (0, _) => "open".to_owned(),
            (_, 0) => format!("sticks{some_open}"),
            (closed, sliding) if sliding == closed => format!("slides everywhere{some_open}"),
            (_, sliding) if open > 0 => format!("{sliding} of {points} points slide, {open} open"),
            (_, sliding) => format!("{sliding} of {points} points slide"),
        }
    }

    /// Force of the finger on the object in the contact frame, N.
    #[must_use]
    pub fn force(&self) -> SVector<f64, C> {
        self.wrench.force_part()
    }

    /// Moment about the middle of the pad, N m: one component in the plane, three in space.
    #[must_use]
    pub fn moment(&self) -> &[f64] {
        &self.wrench.components()[C..]
    }

    pub(crate) fn moment_text(&self, words: Words) -> String {
        match words.space::<C>() {
            Space::Planar => words.number(self.moment()[self.moment().len() - 1]),
            Space::Spatial => words.numbers(self.moment()),
        }
    }
}

/// A contact as users count contacts: all points of a soft fingertip are one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WholeAnswer<'a, const C: usize> {
    /// A contact that is a point itself.
    Point(&'a ContactAnswer<C>),
    /// All points of a soft fingertip.
    Pad(&'a PadAnswer<C>),
}

impl<const C: usize> WholeAnswer<'_, C> {
    /// The name of the contact.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Point(contact) => contact.contact.text(),
            Self::Pad(pad) => pad.contact.text(),
        }
    }

    /// The kind of link between bodies; `None` for a contact, which is no link.
    #[must_use]
    pub fn link(&self) -> Option<LinkKind> {
        match self {
            Self::Point(contact) => contact.contact.link,
            Self::Pad(pad) => pad.contact.link,
        }
    }

    /// Forces of a link in a sentence without its name, "carries 12 N"; forces that are rounding compared with the force `largest`, N, are written as
    /// zero. `None` for a contact, which is no link.
    #[must_use]
    pub fn carries(&self, words: Words, largest: f64) -> Option<String> {
        let force = |x: f64| words.beside(x, largest);
        let moment = match self {
            Self::Pad(pad) => Some(pad.moment().iter().fold(0.0, |h: f64, x| h.hypot(*x))),
            Self::Point(_) => None,
        };
        Some(self.link()?.carries(words, force(self.force()[0]), force(self.force().norm()), moment))
    }

    /// State of the contact in words: "sticks".
    #[must_use]
    pub fn state_text(&self) -> String {
        match self {
            Self::Point(contact) => contact.state_text().to_owned(),
            Self::Pad(pad) => pad.state_text(),
        }
    }

    /// Force of the finger on the object in the contact frame, N.
    #[must_use]
    pub fn force(&self) -> SVector<f64, C> {
        match self {
            Self::Point(contact) => contact.force,
            Self::Pad(pad) => pad.force(),
        }
    }

    /// Magnitude of the friction force, N.
    #[must_use]
    pub fn friction_force(&self) -> f64 {
        self.force().iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f))
    }

    /// Unused friction μ F_n - |F_t|, N ([`ContactAnswer::margin`]); for a fingertip the sum over its points ([`PadAnswer::margin`]).
    #[must_use]
    pub fn margin(&self) -> f64 {
        match self {
            Self::Point(contact) => contact.margin,
            Self::Pad(pad) => pad.margin,
        }
    }
}

impl<const C: usize> Equilibrium<C> {
    /// Contacts in the order of the grasp; the points of each soft fingertip are one contact.
    pub fn whole_contacts(&self) -> impl Iterator<Item = WholeAnswer<'_, C>> {
        let mut pads = self.pads.iter().peekable();
        self.contacts.iter().enumerate().filter_map(move |(i, contact)| {
            while pads.next_if(|pad| pad.range().end <= i).is_some() {}
            match pads.peek() {
                Some(pad) if pad.first == i => Some(WholeAnswer::Pad(pad)),
                Some(pad) if pad.range().contains(&i) => None,
                _ => Some(WholeAnswer::Point(contact)),
            }
        })
    }
}

impl Engine {
    /// The soft fingertips among the contacts, with the states and forces of their points in `solved`, which has one entry for each contact.
    pub(super) fn pads(&self, solved: &[ContactAnswer<3>]) -> Vec<PadAnswer<3>> {
        let contacts = self.contacts();
        picked(self.wholes(), &|whole| {
            let ContactPoints { label, range } = whole;
            contacts[range.start].point_of_pad?;
            let middle = whole.mean(&|i| contacts[i].point);
            let of = &solved[range.clone()];
            let count = |is_so: fn(&ContactState<3>) -> bool| counted(of, &|c| is_so(&c.state));
            Some(PadAnswer {
                contact: label.clone(),
                first: range.start,
                points: range.len(),
                sliding: count(|state| matches!(state, ContactState::Sliding { .. })),
                open: count(|state| matches!(state, ContactState::Separated)),
                wrench: self.wrench_of_pad(of, range.start, &middle),
                margin: of.iter().map(|contact| contact.margin).added(),
            })
        })
    }

    /// The resultant of the forces of a fingertip's points, and their moment about the point `about`. Both are along the axes of the contact frame of
    /// point `first`. Sums that are only rounding errors of their terms are set to zero.
    fn wrench_of_pad(&self, of: &[ContactAnswer<3>], first: usize, about: &SVector<f64, 3>) -> Wrench<3> {
        let frame = &self.sites()[first].frame;
        let (space, axes) = (self.space(), self.space().axes());
        let mut sums = vec![[0.0; 2]; space.of_the_object()];
        let mut add = |k: usize, x: f64| {
            sums[k][0] += x;
            sums[k][1] += x.abs();
        };
        for (i, contact) in (first..).zip(of) {
            // The points of a link between bodies have contact frames of their own. Their forces are turned from coordinate axes into the frame of
            // the first point.
            let force = match contact.contact.link {
                Some(_) => frame.tr_mul(&contact.force_world),
                None => contact.force,
            };
            (0..axes).for_each(|a| add(a, force[a]));
            let arm = self.contacts()[i].point - about;
            // The work of a force along a unit rotation about an axis is its moment about that axis.
            for turn in 0..space.planes().len() {
                let mut unit = Vector::zeros();
                if space == Space::Planar {
                    unit[axes] = 1.0;
                } else {
                    (0..axes).for_each(|a| unit[axes + a] = frame[(a, turn)]);
                }
                add(axes + turn, space.displacement_of(&arm, &unit).dot(&contact.force_world));
            }
        }
        // A sum of forces or moments below 1e-14 of the sum of the absolute values of its terms is rounding.
        let clean = |[sum, size]: &[f64; 2]| if sum.abs() <= 1e-14 * size { 0.0 } else { *sum };
        Wrench::among(space, &Vector::from_slice(&sums.iter().map(clean).list()))
    }
}
