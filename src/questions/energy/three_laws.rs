//! A table of one load under three laws of friction.

use core::fmt;

use nalgebra::SVector;

use super::associated::{AssociatedContact, AssociatedOutcome};
use super::comparison::Comparison;
use super::minimum::{MinimumContact, MinimumOutcome};
use crate::Settings;
use crate::equilibrium::{ContactAnswer, Outcome};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::prelude::*;

/// The answers of Coulomb's law, the paper's minimum of energy and the associated law to one load; in space all use the same polygonal cone.
/// `Display` prints a table: forces in the contact frames, N, slips and gaps, m.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ThreeLaws<const C: usize> {
    /// Coulomb's law by complementarity, and the minimum of energy under the friction constraints.
    pub comparison: Comparison<C>,
    /// The associated law.
    pub associated: AssociatedOutcome<C>,
    pub(super) labels: Vec<String>,
}

impl Engine {
    /// [`Energy::three_laws`](crate::ask::Energy::three_laws).
    pub(crate) fn three_laws(&self, load: &Wrench<3>, settings: &Settings) -> Result<ThreeLaws<3>, Error> {
        self.refuse_hands("three_laws")?;
        Ok(ThreeLaws {
            comparison: self.compare_with_minimum_energy(load, settings)?,
            associated: self.associated_friction(load, settings)?,
            labels: self.contacts().iter().enumerate().map(|(i, c)| c.label_text(i)).collect(),
        })
    }
}

impl<const C: usize> ThreeLaws<C> {
    /// Writes a line for each contact: its name, its force, and the remaining text.
    fn lines(
        &self,
        f: &mut fmt::Formatter<'_>,
        contacts: impl Iterator<Item = (SVector<f64, C>, String)>,
    ) -> fmt::Result {
        for (label, (force, rest)) in self.labels.iter().zip(contacts) {
            write!(f, "  {label:12} F_n {:10.6}  F_t", force[0])?;
            force.iter().skip(1).try_for_each(|t| write!(f, " {t:10.6}"))?;
            writeln!(f, "  {rest}")?;
        }
        Ok(())
    }
}

impl<const C: usize> fmt::Display for ThreeLaws<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Coulomb (complementarity): ")?;
        match &self.comparison.equilibrium {
            Outcome::Equilibrium(state) => {
                writeln!(f, "an equilibrium")?;
                let rest = |c: &ContactAnswer<C>| format!("slip {:.3e}  gap {:.3e}", c.slip.norm(), c.gap);
                self.lines(f, state.contacts.iter().map(|c| (c.force, rest(c))))?;
            }
            Outcome::NoEquilibrium(_) => writeln!(f, "no equilibrium exists")?,
            Outcome::Undecided(_) => writeln!(f, "undecided")?,
        }
        write!(f, "minimum energy under friction constraints: ")?;
        match &self.comparison.minimum {
            MinimumOutcome::Minimum(minimum) => {
                let (force, moment) = minimum.out_of_balance();
                writeln!(f, "out of equilibrium by {force:.6} N, {moment:.6} N m")?;
                let contact = |(i, c): (usize, &MinimumContact<C>)| {
                    let binds = minimum.binding.iter().any(|b| b.contact == i);
                    let binds = if binds { "  constraint binds" } else { "" };
                    (c.force, format!("gap {:.3e}{binds}", c.gap))
                };
                self.lines(f, minimum.contacts.iter().enumerate().map(contact))?;
            }
            MinimumOutcome::NoMinimum => writeln!(f, "no minimum")?,
            MinimumOutcome::Unbounded { .. } => writeln!(f, "the energy falls for ever")?,
            MinimumOutcome::Unsolved => writeln!(f, "not solved")?,
        }
        write!(f, "associated friction: ")?;
        match &self.associated {
            AssociatedOutcome::Rest(state) => {
                writeln!(f, "at rest")?;
                let rest = |c: &AssociatedContact<C>| {
                    format!("slip {:.3e}  dilation {:.3e}", c.slip.norm(), c.dilation())
                };
                self.lines(f, state.contacts.iter().map(|c| (c.force, rest(c))))
            }
            AssociatedOutcome::NoBalance => writeln!(f, "no forces in the cones balance the load"),
            AssociatedOutcome::Unsolved => writeln!(f, "not solved"),
        }
    }
}
