//! Many questions on all cores, and grasps with uncertain data.

use super::grasp::Grasp;
use crate::equilibrium::Outcome;
use crate::error::Error;
use crate::grasp::{Face, Wrench, all_inside, inside, outside};
use crate::load_path::{Onset, Ramp, Turn, TurnOnset};
use crate::prelude::*;
use crate::sweep::{Reserve, RobustOnset, Uncertainty, each_answered};

impl<const C: usize> Grasp<C> {
    /// The equilibria under many loads, each as from [`Self::solve`], in the order of the loads; an error in one does not stop the others.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let loads = [3.0, 30.0].map(|weight| Wrench::force([0.0, -weight]));
    /// let outcomes = grasp.solve_each(&loads).into_iter().collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!([true, false], [0, 1].map(|i| outcomes[i].equilibrium().is_some()));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn solve_each(&self, loads: &[Wrench<C>]) -> Vec<Result<Outcome<C>, Error>> {
        all_answers(self.engine.solve_each(&all_inside(loads), &self.settings))
    }

    /// The onsets of sliding along many ramps, each as from [`Self::onset`], in the order of the ramps; an error in one does not stop the others.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let tilted = |angle: f64| Ramp::load(Wrench::ZERO, Wrench::force([angle.sin(), -angle.cos()]));
    /// let onsets = grasp.onset_each(&[tilted(0.0), tilted(0.5)]);
    /// let factors = onsets.into_iter().map(|onset| onset.map(|o| o.factor().expect("slides"))).collect::<Result<Vec<_>, _>>()?;
    /// // The contact that the pull relieves slides first: W cos φ / 2 = μ (10 - W sin φ / 2).
    /// assert!((factors[1] - 10.0 / (0.5_f64.cos() + 0.5 * 0.5_f64.sin())).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_each(&self, ramps: &[Ramp<C>]) -> Vec<Result<Onset<C>, Error>> {
        all_answers(self.engine.onset_each(&all_inside(ramps), &self.settings))
    }

    /// The onsets of sliding while each of many loads turns, each as from [`Self::onset_of_turn`], in the order of the turns; an error in one does
    /// not stop the others.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Turn};
    ///
    /// // Two palms that press with 10 N each, μ = 0.5, and boxes that start on their sides.
    /// let palm = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([palm(-1.0), palm(1.0)])?;
    /// let turns = [9.0, 12.0].map(|weight| Turn::force_at([weight, 0.0], [0.0, 0.0]));
    /// for (onset, weight) in grasp.onset_of_turn_each(&turns).into_iter().zip([9.0, 12.0_f64]) {
    ///     // w/2 sin θ + w/4 cos θ = 5 where a palm slides.
    ///     let angle = onset?.onset.factor().expect("slides");
    ///     assert!((weight * (0.5 * angle.sin() + 0.25 * angle.cos()) - 5.0).abs() < 1e-13);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_of_turn_each(&self, turns: &[Turn<C>]) -> Vec<Result<TurnOnset<C>, Error>> {
        all_answers(self.engine.onset_of_turn_each(&all_inside(turns), &self.settings))
    }

    /// The onset of sliding with its mean and standard deviation to first order, from the gradients of the onset. [`Self::onset_of_samples`] has
    /// samples for comparison.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    /// use grasp_lcp::sweep::Uncertainty;
    ///
    /// let finger = |x: f64, mu: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(1.0, 0.4), finger(-1.0, 0.6)])?;
    /// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    ///
    /// // The right finger slides at 2 μ N = 8 newtons, in proportion to its friction, which is known to 5 %.
    /// let robust = grasp.robust_onset(&weight, &Uncertainty::seeded(1).with_friction(0.05))?;
    /// let spread = robust.spread.expect("slides");
    /// assert!((spread.deviation.expect("one leaves") - 0.4).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`], and [`Error::NotForHands`] for uncertain positions of a hand's contacts.
    pub fn robust_onset(&self, ramp: &Ramp<C>, uncertainty: &Uncertainty) -> Result<RobustOnset<C>, Error> {
        self.engine.robust_onset(&inside(ramp), uncertainty, &self.settings).map(outside)
    }

    /// The load up to which everything sticks with `sigmas` standard deviations in reserve, on top of a base load and in any direction. Of all grasps
    /// within the uncertainty at most the fraction Φ(-sigmas) – 0.00135 for three – slides below [`Reserve::along`]. All contacts count, not only the
    /// first one to slide. The effect of each datum on the forces is followed beyond its derivative; a fifth of that fraction is kept for combined
    /// effects of two data. The report `reserve` compares it with samples.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::sweep::Uncertainty;
    ///
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let grasp = Grasp::new([finger(1.0), finger(-1.0)])?;
    /// // Friction is known to 5 %, and each of the two fingers holds half of the load: 10 N by the data, 8.6 N with three deviations
    /// // in reserve, and a little less since either may be the bad one.
    /// let off = Uncertainty::seeded(1).with_friction(0.05);
    /// let held = grasp.reserve(&Wrench::ZERO, &off, 3.0)?.along(&Wrench::force([0.0, -1.0]));
    /// assert!((8.4..8.6).contains(&held));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::solve`]; [`Error::Argument`] unless `sigmas` is above 0 and at most 8; as for [`Self::sample`] if a datum cannot be off so far.
    #[doc(alias = "safety margin")]
    #[doc(alias = "reliability")]
    pub fn reserve(
        &self,
        base: &Wrench<C>,
        uncertainty: &Uncertainty,
        sigmas: f64,
    ) -> Result<Reserve<C>, Error> {
        self.engine.reserve(&inside(base), uncertainty, sigmas, &self.settings).map(outside)
    }

    /// The onsets of sliding ([`Self::onset`]) of the samples 0, 1, …, `samples` - 1 of [`Self::sample`], each under its own load, in this order. The
    /// bits are the same for any number of threads. An error in one does not stop the others.
    #[must_use]
    pub fn onset_of_samples(
        &self,
        ramp: &Ramp<C>,
        uncertainty: &Uncertainty,
        samples: u64,
    ) -> Vec<Result<Onset<C>, Error>> {
        all_answers(self.engine.onset_of_samples(&inside(ramp), uncertainty, samples, &self.settings))
    }

    /// Sample `number` of the grasp within an uncertainty, joint springs of a hand included. It depends on the seed and the number alone, whatever
    /// else is sampled. See [`Uncertainty`]; the load of a sample is in [`Uncertainty::load_factor`].
    ///
    /// # Errors
    /// [`Error::Contact`] if an uncertainty is not a number, or so large that a datum leaves its range (1e50 at most). [`Error::NotForHands`] for
    /// uncertain positions of a hand's contacts, which would move differently with its joints.
    pub fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Result<Self, Error> {
        self.changed(self.engine.sample(uncertainty, number))
    }
}

/// The onsets of sliding of many grasps along one ramp, each as from [`Grasp::onset`], in the order of the grasps; an error in one does not stop the
/// others.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
/// use grasp_lcp::ask::onset_of_each;
///
/// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N: they slide at 2 μ N.
/// let frictions = [0.2, 0.4, 0.8];
/// let pinch = |mu: f64| {
///     let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(mu).command([0.01, 0.0]);
///     Grasp::new([finger(-1.0), finger(1.0)])
/// };
/// let grasps = frictions.into_iter().map(pinch).collect::<Result<Vec<_>, _>>()?;
/// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
/// for (onset, mu) in onset_of_each(&grasps, &weight).into_iter().zip(frictions) {
///     assert!((onset?.factor().expect("slides") - 2.0 * mu * 10.0).abs() < 1e-13);
/// }
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[must_use]
pub fn onset_of_each<const C: usize>(grasps: &[Grasp<C>], ramp: &Ramp<C>) -> Vec<Result<Onset<C>, Error>> {
    each_answered(grasps, &|grasp| grasp.onset(ramp))
}

/// The answers as the caller sees them.
fn all_answers<T: Face>(answers: Vec<Result<T::Inside, Error>>) -> Vec<Result<T, Error>> {
    answers.into_iter().map(|answer| answer.map(outside)).collect()
}
