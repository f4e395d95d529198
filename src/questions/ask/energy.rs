//! Questions about the quadratic program of minimum energy, and its comparison with the complementarity problem.

use super::grasp::Grasp;
use crate::energy::{Agreement, Comparison, MinimumOutcome};
use crate::error::Error;
use crate::grasp::{Wrench, inside, outside};
use crate::load_path::Ramp;

/// Questions about the quadratic program of minimum energy, compared with the complementarity problem, made by [`Grasp::energy`]. The module
/// [`energy`](crate::energy) describes both.
#[derive(Debug, Clone, Copy)]
pub struct Energy<'g, const C: usize>(pub(super) &'g Grasp<C>);

impl<const C: usize> Energy<'_, C> {
    /// The load factors of a ramp, from 0, for which the minimum of energy under friction constraints is an equilibrium. In space the friction cone
    /// is the polygonal cone of the settings.
    ///
    /// If every contact has friction and touches at factor 0, the range ends at the load factor of [first slip](Grasp::onset) on the polygonal cone,
    /// at which the first contact ceases to stick. This end is computed by another method than that load factor, and thus checks it. A frictionless
    /// contact may open or close before this end without ending the range.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let factor = grasp.energy().agreement(&ramp)?.factor().expect("agrees at first");
    /// assert!((factor - 10.0).abs() < 1e-12); // the onset of sliding
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load of the ramp, [`Error::Contact`] if a command change is not finite or beyond 1e50; [`Error::Size`] if there are
    /// more or fewer command changes than contacts.
    pub fn agreement(&self, ramp: impl Into<Ramp<C>>) -> Result<Agreement<C>, Error> {
        self.0.engine.agreement_with_minimum_energy(&inside(&ramp.into()), &self.0.settings).map(outside)
    }

    /// Compares the equilibrium of the complementarity problem under a load with the minimum of energy under friction constraints; in space on the
    /// polygonal cone of the settings.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::energy::ComparisonVerdict;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let within = grasp.energy().compare(Wrench::force([0.0, -4.0]))?;
    /// assert_eq!(within.verdict, ComparisonVerdict::Agree);
    /// // Beyond 10 N nothing holds, but the program returns numbers.
    /// let beyond = grasp.energy().compare(Wrench::force([0.0, -11.0]))?;
    /// assert!(matches!(beyond.verdict, ComparisonVerdict::NoEquilibrium { force, .. } if force > 0.1));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn compare(&self, load: impl Into<Wrench<C>>) -> Result<Comparison<C>, Error> {
        self.0.engine.compare_with_minimum_energy(&inside(&load.into()), &self.0.settings).map(outside)
    }

    /// The minimum of energy under friction constraints and a load: a quadratic program. In space the friction cone is the polygonal cone of the
    /// settings.
    ///
    /// The paper on which the crate is based (section 5.1, cited in [`energy`](crate::energy)) poses a quadratic program with all displacements as
    /// variables. Its minimum is the minimum returned here, unless a contact with infinite friction opens in the paper's program. The springs of
    /// finger and object are combined in series here, so that rigid sides and series stiffness are allowed. Orthogonal factors (QR) keep the accuracy
    /// at large ratios of stiffnesses.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let outcome = grasp.energy().minimum(Wrench::force([0.0, -6.0]))?;
    /// let minimum = outcome.minimum().expect("everything sticks");
    /// assert!((minimum.contacts[0].force[0] - 10.0).abs() < 1e-14 && (minimum.contacts[0].force[1].abs() - 3.0).abs() < 1e-14);
    /// assert!(minimum.imbalance.to_vector().amax() < 1e-14);
    /// // Σ ½ F²/k = 10²/1000 + 3²/800.
    /// assert!((minimum.stored_energy - 0.11125).abs() < 1e-16);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn minimum(&self, load: impl Into<Wrench<C>>) -> Result<MinimumOutcome<C>, Error> {
        self.0.engine.minimum_energy(&inside(&load.into()), &self.0.settings).map(outside)
    }
}
