//! A verdict as one row of a table of many verdicts: numbers and words, without contacts and equilibria.

use core::fmt;

use super::verdict::{Holding, Lost, Verdict};
use super::way_out::WayOut;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::Words;

/// The verdict on one of many loads, see [`Grasp::hold_batch`](crate::ask::Grasp::hold_batch).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ShortVerdict {
    /// The conclusion, as in [`Verdict::holding`].
    pub how: How,
    /// The load at the first slip, as a multiple of the load asked about; `None` where nothing slips as far as the load was followed.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub first_slip: Option<f64>,
    /// Largest load factor reached with the load held and motions small; see [`Verdict::held_to`].
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub held_to: f64,
    /// Factor from which on every contact slides: gross slip. See [`Verdict::everything_slides`].
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub everything_slides: Option<f64>,
    /// The motion with which the object leaves; `None` if the load is held as far as it was followed.
    pub motion: Option<LossVerb>,
    /// The reason for a verdict that is undecided.
    pub doubt: Option<Doubt>,
}

/// The conclusion of a verdict without its data; see [`Holding`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum How {
    /// The load is held, and every contact sticks; see [`Holding::Sticks`].
    Sticks,
    /// The load is held, but contacts slide or have slid; see [`Holding::Slides`].
    Slides,
    /// No contact carries a force; see [`Holding::Loose`].
    Loose,
    /// Equilibrium is lost before the whole load is applied; see [`Holding::Lost`].
    Lost,
    /// The base load has no equilibrium, by a proof; see [`Holding::NoRest`].
    NoRest,
    /// The grasp loses the base load as this load grows from zero; see [`Holding::LostAtRest`].
    LostAtRest,
    /// The path could not be followed; see [`Holding::Undecided`].
    Undecided,
}

/// The verb with which the sentence of a verdict says that a load is lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LossVerb {
    /// The object moves down, and no contact with friction holds it back.
    Drops,
    /// All contacts that touch open.
    LiftsOff,
    /// The object moves and hardly turns, or everything slides until motions are no longer small.
    SlipsOut,
    /// The object turns about contacts that stay in place, and other contacts open.
    TipsOver,
    /// The object turns about contacts, a point or an axis.
    TurnsOut,
    /// Suction cups lose their vacuum.
    LetsGo,
    /// Several bodies move, or the motion is not determined.
    GivesWay,
    /// Motions are no longer [small](crate::Settings::small_motions).
    GoesTooFar,
}

impl ShortVerdict {
    /// The verdict where every contact sticks up to the whole load, and the path was not followed further.
    pub(crate) const fn sticks(first_slip: Option<f64>) -> Self {
        let (everything_slides, motion, doubt) = (None, None, None);
        Self { how: How::Sticks, first_slip, held_to: 1.0, everything_slides, motion, doubt }
    }

    /// Whether the whole load is held; `None` where that is undecided.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        match self.how {
            How::Sticks | How::Slides => Some(true),
            How::Loose | How::Lost | How::NoRest | How::LostAtRest => Some(false),
            How::Undecided => None,
        }
    }
}

impl<const C: usize> From<&Verdict<C>> for ShortVerdict {
    fn from(verdict: &Verdict<C>) -> Self {
        let words = Words::default();
        let (mut motion, mut doubt) = (verdict.lost.as_ref().map(|lost| lost.verb(words)), None);
        let how = match &verdict.holding {
            Holding::Sticks => How::Sticks,
            Holding::Slides { .. } => How::Slides,
            Holding::Loose => How::Loose,
            Holding::Lost => How::Lost,
            Holding::NoRest(_) => How::NoRest,
            Holding::LostAtRest { at_rest } => {
                motion = Some(at_rest.verb(words));
                How::LostAtRest
            }
            Holding::Undecided { doubt: why } => {
                doubt = Some(*why);
                How::Undecided
            }
        };
        let first_slip = verdict.first_slip.as_ref().map(|first| first.factor);
        let (held_to, everything_slides) = (verdict.held_to, verdict.everything_slides);
        Self { how, first_slip, held_to, everything_slides, motion, doubt }
    }
}

impl<const C: usize> Lost<C> {
    /// The verb for this loss; `words` has the space, plane or three-dimensional, for the vertical direction.
    pub(crate) fn verb(&self, words: Words) -> LossVerb {
        match &self.way_out {
            _ if self.too_far.is_some() => {
                let slips = self.is_gross_slip && self.factor > NEGLIGIBLE;
                if slips { LossVerb::SlipsOut } else { LossVerb::GoesTooFar }
            }
            way if way.falls(&self.slide, words) => LossVerb::Drops,
            WayOut::LiftsOff { .. } => LossVerb::LiftsOff,
            WayOut::SlidesOut { .. } => LossVerb::SlipsOut,
            WayOut::TipsOver { .. } => LossVerb::TipsOver,
            WayOut::TurnsAbout { .. } | WayOut::Turns { .. } => LossVerb::TurnsOut,
            WayOut::LetsGo { .. } => LossVerb::LetsGo,
            WayOut::Apart { bodies }
                if bodies.iter().all(|body| matches!(body.way, WayOut::SlidesOut { .. })) =>
            {
                LossVerb::SlipsOut
            }
            WayOut::Apart { bodies }
                if bodies.iter().all(|body| matches!(body.way, WayOut::TipsOver { .. })) =>
            {
                LossVerb::TipsOver
            }
            WayOut::Apart { .. } | WayOut::NotKnown => LossVerb::GivesWay,
        }
    }
}

/// Writes the verb as the sentence of the verdict begins: "SLIPS OUT".
impl fmt::Display for LossVerb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Drops => "DROPS",
            Self::LiftsOff => "LIFTS OFF",
            Self::SlipsOut => "SLIPS OUT",
            Self::TipsOver => "TIPS OVER",
            Self::TurnsOut => "TURNS OUT",
            Self::LetsGo => "LETS GO",
            Self::GivesWay => "GIVES WAY",
            Self::GoesTooFar => "GOES TOO FAR",
        })
    }
}
