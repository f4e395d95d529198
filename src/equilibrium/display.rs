//! Answers in words, for a terminal.

use std::fmt;

use super::answer::{ContactState, Equilibrium, NoEquilibrium, Outcome, Proof, Undecided};
use super::pad_answer::Told;
use crate::search::Doubt;
use crate::words::Words;

impl<const C: usize> fmt::Display for Outcome<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = Words::of(f).digits();
        match self {
            Self::Equilibrium(state) => write!(f, "equilibrium: {state:.digits$}"),
            Self::NoEquilibrium(none) => write!(f, "no equilibrium exists: {none:.digits$}"),
            Self::Undecided(undecided) => write!(f, "undecided: {undecided}"),
        }
    }
}

/// One line for the object, then one for each contact: its state, its force in the contact frame and the margin to the edge of its cone. Points of a
/// soft fingertip are one.
impl<const C: usize> fmt::Display for Equilibrium<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let residual = self.residuals.worst();
        write!(f, "the object {}, residual {residual:.0e}", self.motion(words))?;
        if let Some(caution) = self.caution() {
            write!(f, "; {caution}")?;
        }
        for told in self.whole_contacts() {
            let (who, does) = (told.text(), told.doing());
            let force = words.numbers(told.force().as_slice());
            write!(f, "\n  {who}: {does}, force {force} N")?;
            if let Told::Pad(pad) = told {
                write!(f, ", moment {} N m", pad.moment_text(words))?;
            }
            if told.margin() > 0.0 {
                write!(f, ", margin {} N", words.number(told.margin()))?;
            }
        }
        Ok(())
    }
}

impl<const C: usize> Equilibrium<C> {
    /// What the object does: "turns 1.9° about …, moves 2.8 mm".
    #[must_use]
    pub fn motion(&self, words: Words) -> String {
        let moved: Vec<_> = self.contacts.iter().map(|contact| contact.body_core).collect();
        words.motion(&self.twist, &moved)
    }

    /// What is to be said beside the answer: that it [is no small motion](Self::is_beyond_small_motions).
    #[must_use]
    pub fn caution(&self) -> Option<&'static str> {
        self.is_beyond_small_motions().then_some("far beyond the small motions that this is good for")
    }
}

impl<const C: usize> ContactState<C> {
    /// What the contact does: "sticks".
    #[must_use]
    pub fn verb(&self) -> &'static str {
        match self {
            Self::Separated => "open",
            Self::Sticking => "sticks",
            Self::Sliding { .. } => "slides",
            Self::Frictionless => "without friction",
        }
    }
}

impl<const C: usize> fmt::Display for NoEquilibrium<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.proof.fmt(f)
    }
}

impl<const C: usize> fmt::Display for Proof<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        match self {
            Self::FreeMotion { motion, .. } => write!(f, "nothing resists {}", words.direction_of(motion)),
            Self::SeparatingMotion { motion, .. } => {
                write!(f, "no friction works against {}", words.direction_of(motion))
            }
            Self::EveryStateTried { combinations } => {
                write!(f, "all {combinations} combinations of contact states fail")
            }
            Self::EveryCaseContradicted { cases, .. } => {
                write!(
                    f,
                    "all {cases} cases of contact states and directions of friction contradict themselves"
                )
            }
        }
    }
}

impl fmt::Display for Undecided {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.doubt.fmt(f)
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::RayWithoutProof => {
                "no equilibrium was found, and not every combination of contact states was tried"
            }
            Self::OnTheBoundary => {
                "the load is on the boundary of what the grasp can hold, to working precision"
            }
            Self::Inaccurate => "numbers lie so far apart that the answer cannot be written down accurately",
            Self::OutOfPivots => "the limit of pivots was reached",
            Self::OutOfSteps => "the limit of steps along sliding arcs was reached",
        })
    }
}
