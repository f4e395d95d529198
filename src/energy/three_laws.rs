//! One load, three laws of friction, one table.

use std::fmt;

use nalgebra::SVector;

use super::associated::{AssociatedContact, AssociatedOutcome};
use super::comparison::Comparison;
use super::minimum::{MinimumContact, MinimumOutcome};
use crate::Settings;
use crate::equilibrium::{ContactAnswer, Outcome};
use crate::error::Error;
use crate::grasp::{Grasp, Wrench};

/// What Coulomb's law, the paper's minimum of energy and the associated law say of one load, in space all on the same polygonal cone. Printed, it is a
/// table: forces in the contact frames, N, slips and gaps, m.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ThreeLaws<const D: usize, const C: usize> {
    /// Coulomb's law by complementarity, and the minimum of energy under the friction constraints.
    pub comparison: Comparison<D, C>,
    /// The associated law.
    pub associated: AssociatedOutcome<D, C>,
    labels: Vec<String>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The same load under three laws of friction; the module [`energy`](crate::energy) has them side by side.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Twelve newtons are two more than friction holds: an equilibrium for the associated law alone.
    /// let table = grasp.three_laws(&Wrench::force([0.0, -12.0]))?;
    /// assert!(table.comparison.equilibrium.equilibrium().is_none());
    /// assert!(table.associated.rest().is_some());
    /// assert!(table.to_string().contains("no equilibrium exists"));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn three_laws(&self, load: &Wrench<D, C>) -> Result<ThreeLaws<D, C>, Error> {
        self.three_laws_with(load, &Settings::default())
    }

    /// [`Self::three_laws`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::three_laws`].
    pub fn three_laws_with(
        &self,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Result<ThreeLaws<D, C>, Error> {
        self.refuse_hands("three_laws")?;
        Ok(ThreeLaws {
            comparison: self.compare_with_minimum_energy_with(load, settings)?,
            associated: self.associated_friction_with(load, settings)?,
            labels: self.contacts().iter().enumerate().map(|(i, c)| c.label_text(i)).collect(),
        })
    }
}

impl<const D: usize, const C: usize> ThreeLaws<D, C> {
    /// A line for each contact: its name, its force, and what else there is to say of it.
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

impl<const D: usize, const C: usize> fmt::Display for ThreeLaws<D, C> {
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
