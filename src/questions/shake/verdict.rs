//! The behaviour of a grasp under a repeated load, and numbers about the cycles that were followed. The base load is constant; each cycle is a load
//! program of several legs (sections) that begins and ends with it. A period is the number of cycles after which the motion repeats itself. In a walk
//! the object moves on by the same motion in every period. A jump is a sudden motion under constant load. The extent of the contacts of an object is
//! the root mean square distance of their points from their centroid. A drive is the spring of a joint or tendon of a hand, with its force limit.

use crate::equilibrium::{Equilibrium, TooFar};
use crate::grasp::{BodyMotion, Motion, PartLabel, WholeContact, Wrench};
use crate::hold::{Lost, Verdict};
use crate::prelude::*;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The answer about a grasp under a repeated load: its behaviour in the long run. Its [`Display`](std::fmt::Display) is a sentence.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Shaken<const C: usize> {
    /// The base load, N and N m, under which every cycle begins and ends.
    pub base: Wrench<C>,
    /// The behaviour of the grasp in the long run: rest, slip to and fro, a walk, a loss, or not known.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub repeats: Repeats<C>,
    /// The period of the repeated motion, as a number of load cycles. It is 1 unless [friction falls](crate::grasp::Contact::kinetic) as contacts
    /// begin to slide.
    #[cfg_attr(feature = "serde", serde(default = "once", skip_serializing_if = "is_once"))]
    pub every: usize,
    /// Number of load cycles up to the verdict, including those skipped by extrapolation and a last cycle in which the object is lost.
    pub cycles: usize,
    /// Number of cycles whose load path was computed, including trial cycles from extrapolated forces and gaps. Of many cycles with the same events
    /// (changes of contact states), only a few are computed.
    pub followed: usize,
    /// The largest change from the beginning to the end of the last cycle or period: of forces relative to the largest contact force, of gaps
    /// relative to the stretch of the softest spring under this force. Apart from rounding and step errors it is zero, unless the verdict is
    /// undecided, lost, or a walk with changing forces.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub change: f64,
    /// The factor by which the difference of successive cycle states (forces and gaps between two cycles) shrinks per cycle. Zero unless the verdict
    /// is derived from an extrapolated limit.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub ratio: f64,
    /// The contacts that open and close again in every period, once the motion repeats itself.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub opens: Vec<WholeContact>,
    /// The suction cups whose lip is open at some point, so that air flows in, in any cycle that was followed to its end.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub leaks: Vec<WholeContact>,
    /// Whether the object jumps in a cycle that was followed: it slips under constant load until a contact catches it, or snaps over. Its momentum is
    /// not counted.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub jumps: bool,
    /// The joints and tendons whose forces reach their limits, so that they yield: in a period, or before the grasp comes to rest.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub yields: Vec<PartLabel>,
    /// The motion of the object, or of each body, from the equilibrium under the base load to the end of the last cycle; if slips die out, to the
    /// limit.
    pub moved: Vec<BodyMotion<C>>,
    /// The motion that first ceases to be [small](crate::Settings::small_motions) within the cycles; from then on answers neglect that the geometry
    /// changes. If a suction cup leaks or the grasp buckles first, this is stated instead. `None` if none of these occurs.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub too_far: Option<TooFar>,
    /// The fraction of the springs' resistance that geometric stiffness adds or takes away, the least at the loads of a cycle; see
    /// [`Verdict::left_out`]. `None` if it is small.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")
    )]
    pub left_out: Option<f64>,
    /// The equilibrium after the last cycle that was followed, before the next one begins; `None` if the load path has ended.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub state: Option<Box<Equilibrium<C>>>,
}

/// The long-term behaviour of a grasp under a repeated load.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "repeats", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Repeats<const C: usize> {
    /// From some cycle on no contact slides any more.
    Rests {
        /// Number of cycles until no contact or drive slides any more; 0 if nothing ever slides.
        after: usize,
        /// The contacts that have slid until then; drives are not listed.
        slid: Vec<WholeContact>,
    },
    /// Slips shrink from cycle to cycle and die out: the grasp comes to rest in the limit.
    DiesOut {
        /// The contacts that slid in the cycles that were followed.
        slid: Vec<WholeContact>,
    },
    /// The object moves to and fro for ever, and is at the same place after every period: contacts slide, or the object jumps from one contact to
    /// another and back.
    Alternates {
        /// The contacts that slide in a period; empty if the object only jumps, or if only joints and tendons [yield](Shaken::yields).
        slides: Vec<WholeContact>,
        /// The longest path of slip of a contact in a period, the slips in both senses added up, m.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        way: f64,
        /// Energy lost in a period by friction and by impacts, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
        /// The number of jumps under constant load in a period, each of which may end in an impact.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "is_zero"))]
        jumps: usize,
    },
    /// The object moves by the same motion in every period. Or it has walked farther than the extent of its contacts while forces still
    /// [change](Shaken::change); such motions are not small, so the walk is not followed further.
    Walks {
        /// The motion in one period, of the object or of each body.
        by: Vec<BodyMotion<C>>,
        /// The contacts that slide in a period.
        slides: Vec<WholeContact>,
        /// Energy lost in a period by friction and by impacts, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        dissipated: f64,
    },
    /// The object is lost: in some cycle no equilibrium exists beyond some load.
    Lost {
        /// The cycle in which the object is lost, from 1.
        cycle: usize,
        /// The leg of this cycle (section of its load program) in which the object is lost, from 0.
        leg: usize,
        /// The load at which the object is lost, N and N m.
        load: Wrench<C>,
        /// The loss of equilibrium. Its load factor is the fraction of the leg that is done when the object is lost.
        lost: Box<Lost<C>>,
    },
    /// The grasp does not hold even the base load.
    NoRest {
        /// The answer of [`hold`](crate::ask::Grasp::hold) for the base load alone.
        rest: Box<Verdict<C>>,
    },
    /// It is not known how the grasp behaves in the long run.
    Undecided {
        /// The reason why the load path could not be followed through the last cycle; `None` if the [allowed](crate::Settings::most_cycles) number of
        /// cycles has passed, and cycles still change.
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
fn is_zero(jumps: &usize) -> bool {
    *jumps == 0
}

#[cfg(feature = "serde")]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
fn is_once(every: &usize) -> bool {
    *every == 1
}

impl<const C: usize> Shaken<C> {
    /// The motion per period of the object or of the bodies if it walks; else `None`.
    #[must_use]
    pub fn drift(&self) -> Option<Motion<C>> {
        let Repeats::Walks { by, .. } = &self.repeats else { return None };
        let bodies = if by.len() > 1 { by.clone() } else { Vec::new() };
        by.first().map(|first| Motion { object: first.twist, joints: Vec::new(), bodies })
    }

    /// Whether the grasp comes to rest, at once or in the limit, and no suction cup [leaks](Self::leaks); `None` if it is not known. Other contacts
    /// may [open](Self::opens) in every cycle. Motions before the grasp rests may be [too large](Self::too_far).
    #[must_use]
    pub fn rests(&self) -> Option<bool> {
        if !self.leaks.is_empty() {
            return Some(false);
        }
        match self.repeats {
            Repeats::Rests { .. } | Repeats::DiesOut { .. } => Some(true),
            Repeats::Alternates { .. }
            | Repeats::Walks { .. }
            | Repeats::Lost { .. }
            | Repeats::NoRest { .. } => Some(false),
            Repeats::Undecided { .. } => None,
        }
    }

    /// Whether the object stays, because the grasp comes to rest or the object moves to and fro for ever; `None` if it is not known. Motions before
    /// that may be [too large](Self::too_far).
    #[must_use]
    pub fn stays(&self) -> Option<bool> {
        match self.repeats {
            Repeats::Alternates { .. } if self.leaks.is_empty() => Some(true),
            _ => self.rests(),
        }
    }
}
