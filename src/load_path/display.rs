//! Onsets and ends of paths in words, for a terminal.

use std::fmt;

use super::drive_change::{DriveChange, PartChange};
use super::event::{Change, Loss, LossKind, PathEnd};
use super::onset::{Departure, Onset, OnsetEvent};
use crate::equilibrium::row;

impl<const C: usize> fmt::Display for Onset<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::At(event) => event.fmt(f),
            Self::Never => f.write_str("never: everything keeps sticking however far the load goes"),
            Self::AlreadySliding(state) => write!(f, "something slides already at factor 0: {state}"),
            Self::NoBase(none) => write!(f, "no equilibrium exists at factor 0: {none}"),
            Self::GivesWay { factor, reason } => {
                write!(f, "nothing slides, but from factor {factor:.12} on nothing resists: {reason}")
            }
            Self::Undecided(undecided) => write!(f, "undecided at factor 0: {undecided}"),
        }
    }
}

/// What the contact does from the event on.
impl<const C: usize> fmt::Display for Change<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slides { direction } => write!(f, "slides along {}", row(direction.as_slice())),
            Self::Sticks => f.write_str("sticks"),
            Self::Reverses { direction } => write!(f, "slides back along {}", row(direction.as_slice())),
            Self::Turns { direction } => write!(f, "turns to {}", row(direction.as_slice())),
            Self::Opens => f.write_str("opens"),
            Self::Closes => f.write_str("closes"),
            Self::ClosesSliding { direction } => {
                write!(f, "closes, sliding along {}", row(direction.as_slice()))
            }
        }
    }
}

/// The factor, and who stops sticking.
impl<const C: usize> fmt::Display for OnsetEvent<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at factor {:.12}:", self.factor)?;
        let mut between = " ";
        for leaving in &self.leaving {
            let does = if matches!(leaving.how, Departure::Opens) { "opens" } else { "slides" };
            write!(f, "{between}contact {} {does}", leaving.contact.index)?;
            between = ", ";
        }
        for PartChange { part, what } in &self.drives {
            write!(f, "{between}{} {what}", part.part)?;
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
        match self {
            Self::Completed => f.write_str("all legs are held to their end"),
            Self::Lost(loss) => loss.fmt(f),
            Self::NoStart(start) => write!(f, "there is nothing to start from: {start}"),
            Self::Undecided { leg, fraction, doubt } => {
                write!(f, "held to {fraction:.9} of leg {leg}, beyond undecided: {doubt}")
            }
        }
    }
}

impl<const C: usize> fmt::Display for Loss<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "this equilibrium ends at {:.9} of leg {}, under the load ", self.fraction, self.leg)?;
        write!(f, "{}: {}", row(self.load.components()), self.kind)
    }
}

impl fmt::Display for LossKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Fold => "the load has a maximum",
            Self::Corner => "no contact states carry more",
            Self::Asymptote => "the object moves on without bound",
            Self::GivesWay => "nothing resists",
            Self::LetsGo => "a contact lets go",
        })
    }
}
