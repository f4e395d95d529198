//! Answers in words, for a terminal. The margin of a contact is what is left of its friction, `μ F_n - |F_t|`, N.

use core::fmt;

use super::answer::{Equilibrium, Outcome, Undecided};
use super::contact_answer::{ContactAnswer, ContactState};
use super::hand_answer::{DriveState, JointAnswer, TendonAnswer};
use super::no_equilibrium::{NoEquilibrium, Proof};
use super::pad_answer::WholeAnswer;
use crate::grasp::{JointKind, SLIDE_OF, vacuum_is_gone};
use crate::numerics::mapped;
use crate::prelude::*;
use crate::search::Doubt;
use crate::words::Words;

impl<const C: usize> fmt::Display for Outcome<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = Words::of(f).precision();
        match self {
            Self::Equilibrium(state) => write!(f, "equilibrium: {state:.digits$}"),
            Self::NoEquilibrium(none) => write!(f, "no equilibrium exists: {none:.digits$}"),
            Self::Undecided(undecided) => write!(f, "undecided: {undecided}"),
        }
    }
}

/// Writes one line for the object's motion, then one for each contact: its state, its force in the contact frame and its margin. The points of a soft
/// fingertip share a line. Joints and tendons of a hand follow, one line each.
impl<const C: usize> fmt::Display for Equilibrium<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let residual = Words::with_digits(1).number(self.residuals.worst());
        write!(f, "{}, residual {residual}", self.motion_sentences(words).join("; "))?;
        if let Some(caution) = self.caution(words) {
            write!(f, "; {caution}")?;
        }
        self.free_motion_sentences(words).iter().try_for_each(|free| write!(f, "; {free}"))?;
        if let Some(gone) = self.vacuum_gone() {
            write!(f, "; {gone}")?;
        }
        let digits = words.precision();
        for sentence in self.whole_contacts() {
            match sentence.carries(words, self.largest_force()) {
                Some(carries) => write!(f, "\n  {} {carries}", sentence.text())?,
                None => write!(f, "\n  {sentence:.digits$}")?,
            }
        }
        self.joints.iter().try_for_each(|joint| write!(f, "\n  {joint:.digits$}"))?;
        self.tendons.iter().try_for_each(|tendon| write!(f, "\n  {tendon:.digits$}"))
    }
}

/// Writes the name, the state, the force in the contact frame and the margin, for example "left: sticks, force (8, -2.4525) N, margin 1.5475 N".
impl<const C: usize> fmt::Display for WholeAnswer<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let force = words.vector(&self.force());
        write!(f, "{}: {}, force {force} N", self.text(), self.state_text())?;
        if let Self::Pad(pad) = self {
            write!(f, ", moment {} N m", pad.moment_text(words))?;
        }
        if self.margin() > 0.0 { write!(f, ", margin {} N", words.number(self.margin())) } else { Ok(()) }
    }
}

impl<const C: usize> fmt::Display for ContactAnswer<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&WholeAnswer::Point(self), f)
    }
}

/// Writes the name, the torque or force, and its distance from the limit, for example "left base: torque -0.28 N m, 0.1 N m left of its limit".
impl fmt::Display for JointAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, unit) = match self.kind {
            JointKind::Turns => ("torque", "N m"),
            JointKind::Slides => ("force", "N"),
            JointKind::Given => ("torque or force", "N m or N"),
        };
        let (words, name) = (Words::of(f), self.joint.text());
        let force = words.number(self.torque);
        match name.strip_prefix(SLIDE_OF).filter(|_| self.state == DriveState::Absent) {
            Some(contact) => write!(f, "{contact} presses with a constant {force} N")?,
            None => write!(f, "{name}: {what} {force} {unit}")?,
        }
        left_of_limit(f, words, (self.margin, unit), self.state)
    }
}

/// Writes the name, the tension, and the state or the distance from the limit, for example "flexor: tension 4 N, slack".
impl fmt::Display for TendonAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        write!(f, "{}: tension {} N", self.tendon.text(), words.number(self.tension))?;
        left_of_limit(f, words, (self.margin, "N"), self.state)
    }
}

fn left_of_limit(
    f: &mut fmt::Formatter<'_>,
    words: Words,
    (margin, unit): (f64, &str),
    state: DriveState,
) -> fmt::Result {
    match state {
        DriveState::Yields => f.write_str(", yields at its limit"),
        DriveState::Slack => f.write_str(", slack"),
        _ if margin.is_finite() => write!(f, ", {} {unit} left of its limit", words.number(margin)),
        _ => Ok(()),
    }
}

impl<const C: usize> Equilibrium<C> {
    /// The motion of the object in words: "turns 1.9° about …, moves 2.8 mm".
    #[must_use]
    pub fn motion(&self, words: Words) -> String {
        let moved: Vec<_> = mapped(&self.contacts, &|contact| contact.body_core);
        words.motion(&self.twist, &moved)
    }

    /// The motion of the object, "the object moves 2.8 mm along −y", or of each of several bodies.
    #[must_use]
    pub fn motion_sentences(&self, words: Words) -> Vec<String> {
        if self.bodies.is_empty() {
            return vec![format!("the object {}", self.motion(words))];
        }
        mapped(&self.bodies, &|body| words.body_motion(body))
    }

    /// A warning if a motion [is not small](Self::too_far), the grasp buckles, or a suction cup leaks; otherwise `None`.
    #[must_use]
    pub fn caution(&self, words: Words) -> Option<String> {
        self.too_far.as_ref().map(|far| far.caution(words))
    }

    /// The [motions that nothing resists](Self::free_motions): "nothing resists turning about …".
    #[must_use]
    pub fn free_motion_sentences(&self, words: Words) -> Vec<String> {
        let sentence = |motion| format!("nothing resists {}", words.direction_of(motion));
        mapped(&self.free_motions, &sentence)
    }
}

impl<const C: usize> Equilibrium<C> {
    /// A warning if suction cups are [open all around](Self::open_cups); otherwise `None`.
    #[must_use]
    pub fn vacuum_gone(&self) -> Option<String> {
        let is_gone = || format!("{}: this does not hold", vacuum_is_gone(&self.open_cups));
        (!self.open_cups.is_empty()).then(is_gone)
    }
}

impl<const C: usize> ContactAnswer<C> {
    /// The state of the contact in words: "sticks"; "touches" if it is closed without force.
    #[must_use]
    pub fn state_text(&self) -> &'static str {
        match self.state {
            ContactState::Separated if self.gap == 0.0 => "touches",
            state => state.verb(),
        }
    }
}

impl<const C: usize> ContactState<C> {
    /// The state in words: "sticks".
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
            Self::EveryStateTried { combinations: 1 } => {
                f.write_str("the only combination of contact states fails")
            }
            Self::EveryCaseContradicted { cases: 1, .. } => {
                f.write_str("no forces of the contacts balance it, whether they stick, slide or open")
            }
            Self::EveryStateTried { combinations } => {
                write!(f, "all {combinations} combinations of contact states fail")
            }
            Self::EveryCaseContradicted { cases, .. } => {
                write!(
                    f,
                    "no forces of the contacts balance it in any of {cases} cases of sticking, sliding and opening"
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
            Self::OutOfSteps => "the limit of steps along sliding arcs and of jumps was reached",
        })
    }
}
