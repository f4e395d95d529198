//! What becomes of a load that is put on from rest.

use crate::equilibrium::{Equilibrium, NoEquilibrium, TooFar};
use crate::grasp::{Motion, PartLabel, WholeContact, Wrench};
use crate::load_path::LossKind;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

use super::caught::Caught;
use super::way_out::WayOut;
use crate::prelude::*;

/// The answer to "does it hold?"; its [`Display`](std::fmt::Display) says it in a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Verdict<const C: usize> {
    /// The load at rest.
    pub base: Wrench<C>,
    /// What is put on beside it.
    pub load: Wrench<C>,
    /// Whether all of it is held.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub holding: Holding<C>,
    /// When the first contact stops sticking; `None` if none does as far as the load was followed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub first_slip: Option<FirstSlip>,
    /// The jumps on the way of the load, where contacts begin to slide with [less friction](crate::grasp::Contact::kinetic) and the object is caught.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub caught: Vec<Caught>,
    /// How many times the load was put on, and held with [small motions](crate::Settings::small_motions); 0 where the grasp does not hold at rest.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub held_to: f64,
    /// How many times the load is on where everything begins to slide: every contact with friction that presses, from there on up to the whole load, or where
    /// one sticks there up to where the verdict ends. What goes on beyond is held by normal forces alone.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub everything_slides: Option<f64>,
    /// What small motions leave out, where that is more than a tenth of what resists the motion from rest to the whole load, or to where it is lost: the part
    /// that the squeeze takes as its arms turn with the object, below 0, or adds. Told of one object under loads alone.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub left_out: Option<f64>,
    /// Where equilibrium is lost, or its motions cease to be [small](crate::Settings::small_motions); `None` if it holds as far as it was followed.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub lost: Option<Lost<C>>,
    /// The equilibrium under all of the load, with what has slipped on the way; `None` where that is not held.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
}

impl<const C: usize> Verdict<C> {
    /// Whether all of the load is held; `None` where that is not known.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        match self.holding {
            Holding::Sticks | Holding::Slides { .. } => Some(true),
            Holding::Loose | Holding::Lost | Holding::NoRest(_) | Holding::LostAtRest { .. } => Some(false),
            Holding::Undecided { .. } => None,
        }
    }

    /// Whether all of the load is held and nothing has stopped sticking on the way; `None` where that is not known.
    #[must_use]
    pub fn sticks(&self) -> Option<bool> {
        self.holds().map(|_| matches!(self.holding, Holding::Sticks))
    }
}

/// Whether a load is held.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "holding", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Holding<const C: usize> {
    /// It is held, and everything sticks on the way.
    Sticks,
    /// It is held, and contacts slide under it or have slid, opened or given way on the way.
    Slides {
        /// Those that slide or have slid.
        contacts: Vec<WholeContact>,
    },
    /// No contact carries anything: the object lies loose between the fingers, and nothing pulls.
    Loose,
    /// It is lost before all of it is on, or its motions cease to be small.
    Lost,
    /// The grasp does not even hold the base load.
    NoRest(NoEquilibrium<C>),
    /// What is there at rest is lost before all of it is on: followed from nothing, where no proof for all of it was found.
    LostAtRest {
        /// How, as multiples of what is there at rest.
        at_rest: Box<Lost<C>>,
    },
    /// The path could not be followed that far.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

/// The first contacts that stop sticking.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct FirstSlip {
    /// How many times the load is on then: 0 where something slides at rest.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// Contacts that slide from there on.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub slide: Vec<WholeContact>,
    /// Contacts that open.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub open: Vec<WholeContact>,
    /// Contacts that are kept closed and would have to pull.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub would_pull: Vec<WholeContact>,
    /// Joints and tendons that give way, by the names they have.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub give_way: Vec<String>,
}

/// Where an equilibrium is lost as the load is put on, and how.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Lost<const C: usize> {
    /// How many times the load is on then.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub factor: f64,
    /// What ends the equilibrium.
    pub kind: LossKind,
    /// How the object leaves.
    pub way_out: WayOut<C>,
    /// What goes too far there, where no equilibrium is lost but small motions end.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
    /// Contacts that slide there.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub slide: Vec<WholeContact>,
    /// Whether all contacts that press slide: gross slip.
    pub is_gross_slip: bool,
    /// Whether the first slip is the last: friction is [lower](crate::grasp::Contact::kinetic) once contacts slide, and nothing catches the object.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub falls_at_once: bool,
    /// How many times the load it takes from then on, where friction is lower once contacts slide: so much would be held with friction of sliding from the beginning.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub then_takes: Option<f64>,
    /// Whether the load has a [maximum](LossKind::Fold) and another equilibrium holds slightly more: the object snaps over to that one, or is lost.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub snaps: bool,
    /// Joints and tendons of a hand that have reached their limit.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub drives: Vec<PartLabel>,
    /// The unit motion with which the object leaves, if that is determined.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub motion: Option<Motion<C>>,
    /// The equilibrium there.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
    /// Around there nothing holds all of the load: a proof. `None` where the load is held, or where none was found.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub nothing_near: Option<NothingNear>,
}

/// No equilibrium exists near where one was lost, in whatever way contacts have slipped. Good for all motions from there that
/// move the centroid of the contact points by up to `translation` and turn the object by up to `rotation`.
///
/// The sums behind it are bounded with their rounding. The joints of a hand may move their contacts by up to `translation`, too.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct NothingNear {
    /// m; infinite where no equilibrium exists at all.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub translation: f64,
    /// rad.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub rotation: f64,
}
