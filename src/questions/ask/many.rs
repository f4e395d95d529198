//! Grasps whose data are uncertain: random samples of the data, and the load up to which the probability that a contact slides stays below a limit.
//! The base load is constant and acts before the other load grows.

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::{Face, Wrench, inside, outside};
use crate::load_path::{Onset, Ramp};
use crate::numerics::moved;
use crate::prelude::*;
use crate::sweep::{Reserve, Uncertainty};

impl<const C: usize> Grasp<C> {
    /// The loads up to which all contacts stick although the data are uncertain, with a reserve of `sigmas` standard deviations. A load may have any
    /// direction, and acts in addition to the base load. [`Reserve::along`] returns the largest multiple of a load with which all contacts so stick.
    ///
    /// Up to this load, at most the fraction Φ(-`sigmas`) of all grasps with such data has a contact that slides: 0.00135 for three deviations. Φ is
    /// the normal distribution function. Every contact counts, not only the contact that slides first. Contact forces are computed beyond first order
    /// in the uncertain data, at the data with which a contact most probably slides. Three quarters of the allowed fraction are used; the last
    /// quarter allows for the effects that this computation neglects. The program `reserve` in `examples/reports` compares the result with samples.
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
    /// let held = grasp.reserve(Wrench::ZERO, &off, 3.0)?.along(&Wrench::force([0.0, -1.0]));
    /// assert!((8.4..8.6).contains(&held));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`Self::solve`]; [`Error::Argument`] unless `sigmas` is above 0 and at most 8; the errors of [`Self::sample`] if a deviation
    /// leaves a datum's range.
    #[doc(alias = "safety margin")]
    #[doc(alias = "reliability")]
    pub fn reserve(
        &self,
        base: impl Into<Wrench<C>>,
        uncertainty: &Uncertainty,
        sigmas: f64,
    ) -> Result<Reserve<C>, Error> {
        self.engine.reserve(&inside(&base.into()), uncertainty, sigmas, &self.settings).map(outside)
    }

    /// The answers of [`Self::onset`] (load factors of first slip) for the samples 0, 1, …, `samples` - 1 of [`Self::sample`], in this order. Each
    /// sample has its own factor on the load. The results are the same to the last bit for any number of threads. An error in one sample does not
    /// stop the others.
    #[must_use]
    pub fn onset_of_samples(
        &self,
        ramp: impl Into<Ramp<C>>,
        uncertainty: &Uncertainty,
        samples: u64,
    ) -> Vec<Result<Onset<C>, Error>> {
        all_answers(self.engine.onset_of_samples(&inside(&ramp.into()), uncertainty, samples, &self.settings))
    }

    /// A copy of this grasp with random data: sample `number` of its uncertain data, which include the joint springs of a hand. Its random numbers
    /// depend only on the seed and on `number`, whatever else is sampled. [`Uncertainty::load_factor`] gives the factor on the load that belongs to
    /// the sample.
    ///
    /// # Errors
    /// [`Error::Contact`] if an uncertainty is not a number, or so large that a datum leaves its range (1e50 at most). [`Error::Link`] if the grasp
    /// cannot hold the tension of a link with these data. [`Error::NotForHands`] for uncertain positions of contacts if the grasp has joints, because
    /// a joint moves a displaced contact differently.
    pub fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Result<Self, Error> {
        self.changed(self.engine.sample(uncertainty, number))
    }
}

/// Converts answers with vectors of three components to answers with vectors of `C` components.
fn all_answers<T: Face>(answers: Vec<Result<T::Inside, Error>>) -> Vec<Result<T, Error>> {
    moved(answers, &|answer| answer.map(outside))
}
