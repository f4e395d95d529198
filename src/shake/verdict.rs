//! What becomes of a load that repeats.

use crate::equilibrium::Equilibrium;
use crate::grasp::{BodyMotion, Motion, WholeContact, Wrench};
use crate::hold::{Lost, Verdict};
use crate::prelude::*;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The answer to "does it survive being shaken?"; its [`Display`](std::fmt::Display) says it in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Shaken<const C: usize> {
    /// The load at rest, where every cycle begins and ends.
    pub base: Wrench<C>,
    /// What becomes of it.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub repeats: Repeats<C>,
    /// After how many cycles everything repeats, to which amounts belong that are told of a cycle. One, but where [friction
    /// falls](crate::grasp::Contact::kinetic) as contacts begin to slide.
    #[cfg_attr(feature = "serde", serde(default = "once", skip_serializing_if = "is_once"))]
    pub every: usize,
    /// How many cycles have passed until then, the last of them to its end or to where it is lost.
    pub cycles: usize,
    /// How many were followed for that. Of many in a row with the same events a few are enough.
    pub followed: usize,
    /// By how much forces and gaps differed at both ends of the last cycle, or of so many after which everything repeats, over the largest force and what it stretches springs by. Zero but for rounding, along sliding
    /// arcs of the round cone below the error of their steps, unless it is undecided, lost or walks on changing.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub change: f64,
    /// Zero where the last cycle repeats itself. Else the verdict is that of the cycle which they lead to, and so much of what they differ by from it is left from
    /// one to the next.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub ratio: f64,
    /// What the object, or each of several bodies, has moved by from rest until then. Of slips that die out, in the limit.
    pub moved: Vec<BodyMotion<C>>,
    /// The equilibrium between two cycles, after the last that was followed from rest; `None` where there is none.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
}

/// What becomes of a grasp whose load repeats.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "repeats", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Repeats<const C: usize> {
    /// Nothing slides any more.
    Rests {
        /// After so many cycles: 0 where nothing ever slides.
        after: usize,
        /// Contacts that have slid until then.
        slid: Vec<WholeContact>,
    },
    /// Slips become smaller from cycle to cycle, and die out: it comes to rest in the limit.
    DiesOut {
        /// Contacts that slide.
        slid: Vec<WholeContact>,
    },
    /// Contacts slide to and fro for ever; the object does not leave.
    Alternates {
        /// Contacts that slide.
        slides: Vec<WholeContact>,
        /// The longest way that one of them slides in a cycle, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        way: f64,
        /// Heat from friction in a cycle, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
    },
    /// The object moves on by as much in every cycle. Or it has walked farther than its contacts are apart while forces still
    /// [change](Shaken::change): small motions say nothing there.
    Walks {
        /// By this, or each of several bodies by its own.
        by: Vec<BodyMotion<C>>,
        /// Contacts that slide.
        slides: Vec<WholeContact>,
        /// Heat from friction in a cycle, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
    },
    /// It is lost.
    Lost {
        /// In this cycle, from 1.
        cycle: usize,
        /// On this leg of it, from 0.
        leg: usize,
        /// The load there.
        load: Wrench<C>,
        /// How; its factor is how much of the leg has been gone.
        lost: Box<Lost<C>>,
    },
    /// It does not even hold the load at rest.
    NoRest {
        /// What [`hold`](crate::ask::Grasp::hold) says about it.
        rest: Box<Verdict<C>>,
    },
    /// Not known.
    Undecided {
        /// Why the path ends in the last cycle; `None` where as many cycles as [allowed](crate::Settings::most_cycles) have passed, and
        /// they still change.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        doubt: Option<Doubt>,
    },
}

#[cfg(feature = "serde")]
fn once() -> usize {
    1
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
fn is_once(every: &usize) -> bool {
    *every == 1
}

impl<const C: usize> Shaken<C> {
    /// What the object moves by in every cycle, where it walks.
    #[must_use]
    pub fn drift(&self) -> Option<Motion<C>> {
        let Repeats::Walks { by, .. } = &self.repeats else { return None };
        let bodies = if by.len() > 1 { by.clone() } else { Vec::new() };
        by.first().map(|first| Motion { object: first.twist, joints: Vec::new(), bodies })
    }

    /// Whether the grasp comes to rest; `None` where that is not known.
    #[must_use]
    pub fn rests(&self) -> Option<bool> {
        match self.repeats {
            Repeats::Rests { .. } | Repeats::DiesOut { .. } => Some(true),
            Repeats::Alternates { .. }
            | Repeats::Walks { .. }
            | Repeats::Lost { .. }
            | Repeats::NoRest { .. } => Some(false),
            Repeats::Undecided { .. } => None,
        }
    }

    /// Whether the object stays: it rests, or contacts slide to and fro under it for ever; `None` where that is not known.
    #[must_use]
    pub fn stays(&self) -> Option<bool> {
        match self.repeats {
            Repeats::Alternates { .. } => Some(true),
            _ => self.rests(),
        }
    }
}
