//! Answers in words, for a terminal.

use std::fmt;

use super::answer::{ContactState, Equilibrium, NoEquilibrium, Outcome, Proof, Undecided};
use crate::grasp::Motion;
use crate::search::Doubt;

/// Numbers in brackets, as answers tell them in words; what is rounding beside the largest is zero.
#[must_use]
pub fn row(numbers: &[f64]) -> String {
    let size = numbers.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let number = |x: &f64| match x.abs() {
        a if a <= 1e-14 * size => "0".to_owned(),
        a if a < 1e-3 => format!("{x:.5e}"),
        _ => format!("{x:.6}"),
    };
    format!("({})", numbers.iter().map(number).collect::<Vec<_>>().join(", "))
}

impl<const C: usize> fmt::Display for Outcome<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Equilibrium(state) => write!(f, "equilibrium: {state}"),
            Self::NoEquilibrium(none) => write!(f, "no equilibrium exists: {none}"),
            Self::Undecided(undecided) => write!(f, "undecided: {undecided}"),
        }
    }
}

/// One line for the object, then one for each contact: its state, its force in the contact frame and the margin to the edge of its cone.
impl<const C: usize> fmt::Display for Equilibrium<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let moved = row(self.twist.components());
        write!(f, "the object moves by {moved} m and rad, residual {:.0e}", self.residuals.worst())?;
        if self.is_beyond_small_motions() {
            f.write_str("; far beyond the small motions that this is good for")?;
        }
        for (number, contact) in self.contacts.iter().enumerate() {
            let (force, margin) = (row(contact.force.as_slice()), contact.margin);
            write!(
                f,
                "\n  contact {number} {:12} force {force} N, margin {margin:.6} N",
                word(&contact.state)
            )?;
        }
        Ok(())
    }
}

fn word<const C: usize>(state: &ContactState<C>) -> &'static str {
    match state {
        ContactState::Separated => "open",
        ContactState::Sticking => "sticking",
        ContactState::Sliding { .. } => "sliding",
        ContactState::Frictionless => "frictionless",
    }
}

impl<const C: usize> fmt::Display for NoEquilibrium<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.proof.fmt(f)
    }
}

impl<const C: usize> fmt::Display for Proof<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |motion: &Motion<C>| row(motion.object.components());
        match self {
            Self::FreeMotion { motion, .. } => write!(f, "nothing resists the motion {}", of(motion)),
            Self::SeparatingMotion { motion, .. } => {
                write!(f, "no friction works against the motion {}", of(motion))
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
