//! A verdict as one row of a table of many verdicts: numbers and words, without contacts and equilibria. The load factor is the multiple of the
//! growing load that acts; 1 is the whole load. The base load acts already at load factor 0. At first slip the first contact ceases to stick, at
//! gross slip every contact that presses slides. A drive is the spring of a joint or tendon of a hand, with its force limit, and yields at this
//! limit.

use core::fmt;

use super::verdict::{Holding, Lost, Verdict};
use super::way_out::WayOut;
use crate::equilibrium::TooFar;
use crate::load_path::LossKind;
use crate::numerics::largest;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::search::Doubt;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;
use crate::words::Words;

/// The verdict on one row of [`Grasp::hold_batch`](crate::ask::Grasp::hold_batch), a grasp with its load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ShortVerdict {
    /// The conclusion: whether and how the whole load is held. [`Verdict::holding`] is the same conclusion with contacts and proofs.
    pub how: VerdictKind,
    /// The load factor of first slip; `None` if every contact sticks as far as the load was followed.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub first_slip: Option<f64>,
    /// Largest load factor that is reached with the load held and motions small ([`Verdict::held_to`]).
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub held_to: f64,
    /// Load factor from which on every contact slides: gross slip. `None` if a contact sticks under the whole load and at the end of the path.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Option<f64>>"))]
    pub everything_slides: Option<f64>,
    /// The verb for the loss, also for a loss beyond the whole load; `None` if the load is held as far as it was followed.
    pub motion: Option<LossVerb>,
    /// The reason why the verdict is undecided; `None` for every decided verdict.
    pub doubt: Option<Doubt>,
}

/// The conclusion of a verdict without the data of [`Holding`]: contacts, proof and doubt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum VerdictKind {
    /// The load is held, and every contact sticks ([`Holding::Sticks`]).
    Sticks,
    /// The load is held, but contacts slide or have slid before ([`Holding::Slides`]).
    Slides,
    /// No contact carries a force under the whole load ([`Holding::Loose`]).
    Loose,
    /// Equilibrium is lost, or motions cease to be small, before the whole load is applied ([`Holding::Lost`]).
    Lost,
    /// The base load has no equilibrium, and a proof shows this ([`Holding::NoRest`]).
    NoRest,
    /// The grasp loses the base load on a path on which the base load grows from zero ([`Holding::LostAtRest`]).
    LostAtRest,
    /// The path could not be followed to the whole load ([`Holding::Undecided`]).
    Undecided,
    /// Nothing resists a rotation along which the load drives the object on ([`Holding::TurnsOver`]).
    TurnsOver,
}

/// The verb that begins the sentence about a lost load: the motion of the object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum LossVerb {
    /// The object moves down, within 26° of the vertical, and no contact slides at the loss.
    Drops,
    /// All contacts that touch open, and the object does not fall.
    LiftsOff,
    /// The object, or every moving body, moves and hardly turns. This is also the verb if all contacts slide and the object leaves in a screw motion,
    /// or if all contacts slide until motions are no longer small.
    SlipsOut,
    /// The object, or every moving body, turns about contacts that stay in place, and other contacts open.
    TipsOver,
    /// The object turns about contacts that stay in place without tipping over them, or about a point or an axis.
    TurnsOut,
    /// Suction cups lose their vacuum.
    LetsGo,
    /// Several bodies move, neither all sliding nor all tipping, or the motion is not determined.
    GivesWay,
    /// Motions are no longer [small](crate::Settings::small_motions), without gross slip before.
    GoesTooFar,
    /// The points of action of the forces turn with the object, and this takes away all resistance of the springs to a rotation.
    Buckles,
    /// Air flows into a suction cup where its lip opens.
    Leaks,
    /// No spring resists a rotation along which forces drive the object on.
    TurnsOver,
}

impl ShortVerdict {
    /// The verdict if every contact sticks up to the whole load, and the path was not followed further.
    pub(crate) const fn sticks(first_slip: Option<f64>) -> Self {
        let (everything_slides, motion, doubt) = (None, None, None);
        Self { how: VerdictKind::Sticks, first_slip, held_to: 1.0, everything_slides, motion, doubt }
    }

    /// Whether the whole load is held; `None` if that is undecided.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        match self.how {
            VerdictKind::Sticks | VerdictKind::Slides => Some(true),
            VerdictKind::TurnsOver
            | VerdictKind::Loose
            | VerdictKind::Lost
            | VerdictKind::NoRest
            | VerdictKind::LostAtRest => Some(false),
            VerdictKind::Undecided => None,
        }
    }
}

impl<const C: usize> From<&Verdict<C>> for ShortVerdict {
    fn from(verdict: &Verdict<C>) -> Self {
        let words = Words::default();
        let (mut motion, mut doubt) = (verdict.lost.as_ref().map(|lost| lost.verb(words)), None);
        let how = match &verdict.holding {
            Holding::Sticks => VerdictKind::Sticks,
            Holding::Slides { .. } => VerdictKind::Slides,
            Holding::TurnsOver { .. } => VerdictKind::TurnsOver,
            Holding::Loose => VerdictKind::Loose,
            Holding::Lost => VerdictKind::Lost,
            Holding::NoRest { .. } => VerdictKind::NoRest,
            Holding::LostAtRest { at_rest } => {
                motion = Some(at_rest.verb(words));
                VerdictKind::LostAtRest
            }
            Holding::Undecided { doubt: why } => {
                doubt = Some(*why);
                VerdictKind::Undecided
            }
        };
        let first_slip = verdict.first_slip.as_ref().map(|first| first.factor);
        let (held_to, everything_slides) = (verdict.held_to, verdict.everything_slides);
        Self { how, first_slip, held_to, everything_slides, motion, doubt }
    }
}

impl<const C: usize> Lost<C> {
    /// Whether joints of the hand move with the object along a motion that nothing resists, while no contact slides and no drive yields.
    pub(super) fn takes_the_hand_along(&self) -> bool {
        let joints = self.motion.as_ref().map_or(&[][..], |motion| &motion.joints);
        let is_free = self.kind == LossKind::GivesWay && self.slide.is_empty() && self.drives.is_empty();
        is_free && largest(joints, &|joint| joint.abs()) > NEGLIGIBLE
    }

    /// The verb for this loss of equilibrium, such as "slips out". Downward motions have a verb of their own: in the plane down is -y, in space -z, and
    /// `words` says in which of both the grasp is.
    pub(crate) fn verb(&self, words: Words) -> LossVerb {
        if let Some(far) = &self.too_far {
            let slips = far.is_motion() && self.is_gross_slip && self.factor > NEGLIGIBLE;
            return if slips { LossVerb::SlipsOut } else { far.into() };
        }
        match &self.way_out {
            way if way.falls(&self.slide, words) => LossVerb::Drops,
            _ if self.takes_the_hand_along() => LossVerb::GivesWay,
            // A drive at its force limit gives way, and the object moves with it although no contact slides.
            WayOut::SlidesOut { .. } if self.slide.is_empty() && !self.drives.is_empty() => {
                LossVerb::GivesWay
            }
            WayOut::LiftsOff { .. } => LossVerb::LiftsOff,
            WayOut::SlidesOut { .. } => LossVerb::SlipsOut,
            WayOut::TipsOver { .. } => LossVerb::TipsOver,
            // A shaft that turns and leaves along its axis slips out.
            WayOut::Turns { advance, .. } if *advance != 0.0 && self.is_gross_slip => LossVerb::SlipsOut,
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

/// The verb if the theory of small motions ends before gross slip: the grasp buckles, a suction cup leaks, or a motion is too large.
impl From<&TooFar> for LossVerb {
    fn from(far: &TooFar) -> Self {
        match far {
            TooFar::Buckles => Self::Buckles,
            TooFar::TurnsOver => Self::TurnsOver,
            TooFar::Leaks { .. } => Self::Leaks,
            _ => Self::GoesTooFar,
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
            Self::Buckles => "BUCKLES",
            Self::Leaks => "LEAKS",
            Self::TurnsOver => "TURNS OVER",
        })
    }
}
