//! One load, three laws of friction, one table.

use std::fmt;

use super::associated::AssociatedOutcome;
use super::comparison::Comparison;
use super::minimum::MinimumOutcome;
use crate::Settings;
use crate::equilibrium::Outcome;
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
    /// use grasp_lcp::Settings;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // Twelve newtons are two more than friction holds: an equilibrium for the associated law alone.
    /// let table = grasp.three_laws(&Wrench::force([0.0, -12.0]), &Settings::default())?;
    /// assert!(table.comparison.equilibrium.equilibrium().is_none());
    /// assert!(table.associated.rest().is_some());
    /// assert!(table.to_string().contains("no equilibrium exists"));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn three_laws(&self, load: &Wrench<D>, settings: &Settings) -> Result<ThreeLaws<D, C>, Error> {
        Ok(ThreeLaws {
            comparison: self.compare_with_minimum_energy_with(load, settings)?,
            associated: self.associated_friction(load, settings)?,
            labels: self.contacts().iter().enumerate().map(|(i, c)| c.label_text(i)).collect(),
        })
    }
}

impl<const D: usize, const C: usize> fmt::Display for ThreeLaws<D, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let forces = |f: &mut fmt::Formatter<'_>, force: &[f64]| {
            write!(f, "F_n {:10.6}  F_t", force[0])?;
            force[1..].iter().try_for_each(|t| write!(f, " {t:10.6}"))
        };
        write!(f, "Coulomb (complementarity): ")?;
        match &self.comparison.equilibrium {
            Outcome::Equilibrium(state) => {
                writeln!(f, "an equilibrium")?;
                for (label, c) in self.labels.iter().zip(&state.contacts) {
                    write!(f, "  {label:12} ")?;
                    forces(f, c.force.as_slice())?;
                    writeln!(f, "  slip {:.3e}  gap {:.3e}", c.slip.norm(), c.gap)?;
                }
            }
            Outcome::NoEquilibrium(_) => writeln!(f, "no equilibrium exists")?,
            Outcome::Undecided(_) => writeln!(f, "undecided")?,
        }
        write!(f, "minimum energy under friction constraints: ")?;
        match &self.comparison.minimum {
            MinimumOutcome::Minimum(minimum) => {
                let (force, moment) = minimum.out_of_balance();
                writeln!(f, "out of equilibrium by {force:.6} N, {moment:.6} N m")?;
                for (i, (label, c)) in self.labels.iter().zip(&minimum.contacts).enumerate() {
                    write!(f, "  {label:12} ")?;
                    forces(f, c.force.as_slice())?;
                    let binds = minimum.binding.iter().any(|b| b.contact == i);
                    writeln!(f, "  gap {:.3e}{}", c.gap, if binds { "  constraint binds" } else { "" })?;
                }
            }
            MinimumOutcome::NoMinimum => writeln!(f, "no minimum")?,
            MinimumOutcome::Unbounded { .. } => writeln!(f, "the energy falls for ever")?,
            MinimumOutcome::Unsolved => writeln!(f, "not solved")?,
        }
        write!(f, "associated friction: ")?;
        match &self.associated {
            AssociatedOutcome::Rest(state) => {
                writeln!(f, "at rest")?;
                for (label, c) in self.labels.iter().zip(&state.contacts) {
                    write!(f, "  {label:12} ")?;
                    forces(f, c.force.as_slice())?;
                    writeln!(f, "  slip {:.3e}  dilation {:.3e}", c.slip.norm(), c.dilation())?;
                }
                Ok(())
            }
            AssociatedOutcome::NoBalance => writeln!(f, "no forces in the cones balance the load"),
            AssociatedOutcome::Unsolved => writeln!(f, "not solved"),
        }
    }
}
