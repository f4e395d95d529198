//! Texts for a terminal: onsets, changes of contact states (open, sticking or sliding), and the situation beyond the end of a path. An onset is the
//! load factor at which the first contact ceases to stick; the load factor is the multiple of the growing load.

use core::fmt;

use super::beyond::Beyond;
use super::drive_change::{DriveChange, PartChange};
use super::event::{Change, Loss, LossKind, PathEnd};
use super::onset::{DepartingContact, Departure, Onset, OnsetEvent};
use crate::equilibrium::Proof;
use crate::grasp::vacuum_is_gone;
use crate::words::{Words, opens};

impl<const C: usize> fmt::Display for Onset<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        match self {
            Self::At(event) => event.fmt(f),
            Self::Never => f.write_str("never: everything keeps sticking however far the load goes"),
            Self::AlreadySliding(state) => {
                write!(f, "something slides already at factor 0: {state:.digits$}")
            }
            Self::NoBase(none) => write!(f, "no equilibrium exists at factor 0: {none:.digits$}"),
            Self::GivesWay { factor, reason } => {
                let factor = words.number(*factor);
                write!(f, "nothing slides, but from factor {factor} on: {reason:.digits$}")
            }
            Self::Undecided(undecided) => write!(f, "undecided at factor 0: {undecided}"),
        }
    }
}

/// The change of a contact's state in words, for example "sticks" or "opens".
impl<const C: usize> fmt::Display for Change<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        match self {
            Self::Slides { direction } => {
                write!(f, "slides over the object along {}", words.along(direction))
            }
            Self::Sticks => f.write_str("sticks"),
            Self::Reverses { direction } => write!(f, "slides back along {}", words.along(direction)),
            Self::Turns { direction } => write!(f, "turns to {}", words.along(direction)),
            Self::Opens => f.write_str("opens"),
            Self::Closes => f.write_str("closes"),
            Self::ClosesSliding { direction } => {
                write!(f, "closes, sliding along {}", words.along(direction))
            }
        }
    }
}

impl<const C: usize> DepartingContact<C> {
    /// The verb for how the contact stops sticking: "slides", "opens" (or another verb for a link, such as "goes slack"), or "would have to pull".
    /// The last is the verb of a contact that is kept closed and whose normal force has fallen to zero.
    #[must_use]
    pub fn verb(&self) -> &'static str {
        match self.how {
            Departure::Opens => opens(self.contact.link),
            how => how.verb(),
        }
    }
}

impl<const C: usize> Departure<C> {
    /// The verb for how the contact stops sticking: "slides", "opens" or, if it is kept closed, "would have to pull".
    #[must_use]
    pub fn verb(&self) -> &'static str {
        match self {
            Self::Slides { .. } => "slides",
            Self::Opens => "opens",
            Self::WouldPull => "would have to pull",
        }
    }
}

/// An onset in words: its load factor, and the contacts that stop sticking.
impl<const C: usize> fmt::Display for OnsetEvent<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at factor {}:", Words::of(f).number(self.factor))?;
        let mut between = " ";
        for leaving in &self.leaving {
            write!(f, "{between}{} {}", leaving.contact.text(), leaving.verb())?;
            between = ", ";
        }
        for PartChange { part, what } in &self.drives {
            write!(f, "{between}{} {what}", part.text())?;
            between = ", ";
        }
        Ok(())
    }
}

impl fmt::Display for DriveChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Yields => "yields",
            Self::Holds => "holds again",
            Self::Slackens => "slackens",
            Self::Tightens => "tightens",
        })
    }
}

impl<const C: usize> fmt::Display for PathEnd<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        match self {
            Self::Completed => f.write_str("all legs are held to their end"),
            Self::Lost(loss) => loss.fmt(f),
            Self::NoStart(start) => write!(f, "there is nothing to start from: {start:.digits$}"),
            Self::Undecided { leg, fraction, doubt } => {
                write!(f, "held to {} of leg {}, beyond undecided: {doubt}", words.number(*fraction), leg + 1)
            }
        }
    }
}

/// The situation beyond an onset or the end of a path in words, for example "no equilibrium; it is the limit load".
impl<const C: usize> fmt::Display for Beyond<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = Words::of(f).precision();
        match self {
            Self::Continues(_) => f.write_str("the grasp still holds at first"),
            Self::LimitLoad => f.write_str("no equilibrium; it is the limit load"),
            Self::Snap => f.write_str("another equilibrium; the grasp snaps over or is lost"),
            Self::Ends { reason } => {
                f.write_str("it is lost, unless another equilibrium catches it")?;
                match reason.proof {
                    Proof::FreeMotion { .. } | Proof::SeparatingMotion { .. } => {
                        write!(f, ": {reason:.digits$}")
                    }
                    _ => Ok(()),
                }
            }
            Self::WithoutVacuum { cups } => {
                write!(f, "{}; what is left is another grasp", vacuum_is_gone(cups))
            }
            Self::Undecided { doubt } => write!(f, "not known: {doubt}"),
        }
    }
}

impl<const C: usize> fmt::Display for Loss<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let (fraction, load) = (words.number(self.fraction), words.load(&self.load));
        write!(f, "this equilibrium ends at {fraction} of leg {}, {load}: {}", self.leg + 1, self.kind)
    }
}

impl fmt::Display for LossKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fold => "the load has a maximum",
            Self::Corner => "no contact states carry more",
            Self::Asymptote => "the object moves on without bound",
            Self::GivesWay => "nothing resists",
            Self::TooFar => "motions are no longer small",
            Self::LetsGo => "a contact lets go",
        })
    }
}
