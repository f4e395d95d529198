//! A proof, case by case, that no equilibrium exists on the round cone.

use crate::error::Error;
use crate::grasp::{Grasp, Wrench};
use crate::proofs::{self, Step};
use crate::search::{self, Settings};

/// A proof that no equilibrium exists on the round cone, to be kept and to be checked.
///
/// What contacts do is divided into cases: open or closed, rolling or sliding, friction between two angles. Each case is contradicted by a
/// virtual motion of the object and virtual forces of the contacts that balance one another. Together they do work on every
/// equilibrium that no contact can do in that case. [`Self::check`] repeats that from the data, in closed form for
/// every contact, and that no case is left out; it knows nothing of how the proof was found.
#[derive(Debug, Clone)]
pub struct Refutation<const D: usize, const C: usize> {
    steps: Vec<Step<D, C>>,
    cases: usize,
}

impl<const D: usize, const C: usize> Refutation<D, C> {
    /// The number of cases, those that were divided further among them.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.cases
    }

    /// Checks the proof against a grasp and a load: the factor by which an equilibrium that rounding has hidden would have to exceed
    /// the data, at least. Stretches and forces of all contacts together are measured in √J, against those of the elastic trial
    /// state. `None` where the proof does not hold for this grasp and this load, or by a factor below 1e4.
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn check(&self, grasp: &Grasp<D, C>, load: &Wrench<D, C>) -> Result<Option<f64>, Error> {
        Ok(proofs::check(&grasp.problem_under(load, &Settings::default())?, &self.steps))
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The proof, case by case, that no equilibrium exists under a load on the round cone. `None` where none was found: there is an
    /// equilibrium, [`Settings::most_states`] allows too few cases, or no cone is round, as in the plane.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    ///
    /// // Three fingers around a jar press with 10 N each, μ = 0.5: they hold 15 N, and more if they squeezed more.
    /// let finger = |angle: f64| {
    ///     let (s, c) = angle.sin_cos();
    ///     Contact::new([c, s, 0.0], [-c, -s, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let jar = Grasp::new([0.0, 2.0, 4.0].map(finger))?;
    /// let load = Wrench::force([0.0, 0.0, -16.0]);
    ///
    /// let proof = jar.refutation(&load)?.expect("too heavy");
    /// assert!(proof.check(&jar, &load)?.is_some_and(|escape| escape > 1e4));
    /// // It says nothing about a load that is held.
    /// assert!(proof.check(&jar, &Wrench::force([0.0, 0.0, -1.0]))?.is_none());
    /// assert!(jar.refutation(&Wrench::force([0.0, 0.0, -1.0]))?.is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if the load is not finite, or beyond 1e50.
    pub fn refutation(&self, load: &Wrench<D, C>) -> Result<Option<Refutation<D, C>>, Error> {
        self.refutation_with(load, &Settings::default())
    }

    /// [`Self::refutation`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::refutation`].
    pub fn refutation_with(
        &self,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Result<Option<Refutation<D, C>>, Error> {
        let problem = self.problem_under(load, &Settings { round: true, ..*settings })?;
        Ok(search::refute(&problem, settings).map(|(steps, cases)| Refutation { steps, cases }))
    }
}
