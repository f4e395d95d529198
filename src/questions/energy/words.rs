//! The sentence that compares two results for one load: the equilibrium under Coulomb's law, from a complementarity problem, and the minimum of
//! energy, from a quadratic program.

use core::fmt;

use super::comparison::{Comparison, ComparisonVerdict};
use crate::equilibrium::{ContactState, Equilibrium, WholeAnswer};
use crate::numerics::Space;
use crate::prelude::*;
use crate::words::{Words, listed};

impl<const C: usize> fmt::Display for Comparison<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let apart = || {
            let (off, largest) = self.difference.map_or((0.0, 0.0), |d| (d.force, d.force_size));
            words.beside(off, largest)
        };
        match self.verdict {
            ComparisonVerdict::Agree if self.difference.is_some() => {
                f.write_str("AGREES: the minimum of energy is the equilibrium, with the same forces")?;
                let off = apart();
                if off > 0.0 { write!(f, " within {} N", words.number(off)) } else { Ok(()) }
            }
            ComparisonVerdict::Agree => {
                f.write_str("AGREES: the minimum of energy is an equilibrium; the search found none")
            }
            ComparisonVerdict::TwoEquilibria => {
                let off = words.number(apart());
                write!(
                    f,
                    "TWO EQUILIBRIA: the minimum of energy is one, complementarity returned another, with forces up to {off} N apart"
                )
            }
            ComparisonVerdict::OutOfEquilibrium { force, moment } => {
                f.write_str("DIFFERS: ")?;
                if let Some(state) = self.equilibrium.equilibrium() {
                    f.write_str(&slides(state))?;
                }
                write!(f, "the minimum of energy misses the load by {}", wrench(words, force, moment))
            }
            ComparisonVerdict::NoEquilibrium { force, moment } => {
                let missed = wrench(words, force, moment);
                // In space the complementarity problem and the quadratic program both use polygonal cones. The sentence says so, because round cones
                // allow slightly larger forces: an equilibrium on them may exist.
                let cones =
                    if words.space::<C>() == Space::Spatial { " with polygonal friction cones" } else { "" };
                write!(
                    f,
                    "DIFFERS: no equilibrium exists{cones}, and the minimum of energy misses the load by {missed}"
                )
            }
            ComparisonVerdict::Unknown { force, moment } => {
                let missed = wrench(words, force, moment);
                write!(
                    f,
                    "DIFFERS: the minimum of energy misses the load by {missed}; whether an equilibrium exists is undecided"
                )
            }
            ComparisonVerdict::NoMinimum => f.write_str("NO MINIMUM: the quadratic program has none"),
            ComparisonVerdict::Unsolved => f.write_str("UNDECIDED: the quadratic program was not solved"),
        }
    }
}

/// The beginning of a sentence that names the contacts sliding in the equilibrium, such as "left slides, and "; empty if none slides.
fn slides<const C: usize>(state: &Equilibrium<C>) -> String {
    let mut names = Vec::new();
    for whole in state.whole_contacts() {
        let points = match &whole {
            WholeAnswer::Point(contact) => core::slice::from_ref(*contact),
            WholeAnswer::Pad(pad) => &state.contacts[pad.range()],
        };
        if points.iter().any(|point| matches!(point.state, ContactState::Sliding { .. })) {
            names.push(whole.text());
        }
    }
    match names.as_slice() {
        [] => String::new(),
        [one] => format!("{one} slides, and "),
        many => format!("{} slide, and ", listed(many)),
    }
}

/// A force with its unit, followed by a moment unless the moment is zero. A zero force is not written if there is a moment.
fn wrench(words: Words, force: f64, moment: f64) -> String {
    let (force_text, moment_text) = (words.number(force), words.number(moment));
    match (force == 0.0, moment == 0.0) {
        (_, true) => format!("{force_text} N"),
        (true, false) => format!("{moment_text} N m"),
        _ => format!("{force_text} N and {moment_text} N m"),
    }
}
