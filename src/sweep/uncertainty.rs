//! Grasps whose data are not known exactly: samples of what they may be, the same ones for the same
//! seed.

use super::in_order::map_in_order;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Contact, Grasp};
use crate::load_path::{Onset, Ramp};
use crate::numerics::Draw;

/// How far the data of a grasp may be off. Each datum of each contact is multiplied by a factor of
/// its own, `exp(σ z)` with z normally distributed (mean 0, variance 1): its median is the datum,
/// it keeps its sign, and zero and infinity stay what they are. For small σ that is the relative
/// standard deviation; σ = 0 leaves the datum alone.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Onset, Ramp, Wrench};
/// use grasp_lcp::sweep::Uncertainty;
///
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.4).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(1.0), finger(-1.0)])?;
/// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
///
/// // How often does it hold 6 N without sliding, if friction is known to 20 % and stiffness to 10 %?
/// let off = Uncertainty::seeded(7).with_friction(0.2).with_stiffness(0.1);
/// let onsets = grasp.onset_of_samples(&weight, &off, 1000);
/// let holds = onsets.iter().filter(|o| o.as_ref().is_ok_and(|o| o.factor().is_some_and(|w| w > 6.0))).count();
/// assert!((700..950).contains(&holds));
///
/// // One sample as a grasp of its own.
/// let third = grasp.sample(&off, 3)?.onset(&weight)?;
/// assert_eq!(third.factor(), onsets[3].as_ref().ok().and_then(Onset::factor));
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Uncertainty {
    /// σ of the coefficient of friction.
    pub friction: f64,
    /// σ of the stiffness, one factor for all axes of a contact, body and finger.
    pub stiffness: f64,
    /// σ of the normal command: how well the squeeze is known.
    pub squeeze: f64,
    /// Samples with another seed are others.
    pub seed: u64,
}

impl Uncertainty {
    /// No uncertainty yet, with a seed.
    #[must_use]
    pub const fn seeded(seed: u64) -> Self {
        Self { friction: 0.0, stiffness: 0.0, squeeze: 0.0, seed }
    }

    /// This uncertainty with the σ of the coefficients of friction.
    #[must_use]
    pub const fn with_friction(mut self, sigma: f64) -> Self {
        self.friction = sigma;
        self
    }

    /// This uncertainty with the σ of the stiffnesses.
    #[must_use]
    pub const fn with_stiffness(mut self, sigma: f64) -> Self {
        self.stiffness = sigma;
        self
    }

    /// This uncertainty with the σ of the normal commands.
    #[must_use]
    pub const fn with_squeeze(mut self, sigma: f64) -> Self {
        self.squeeze = sigma;
        self
    }
}

/// The least factor on a datum, and its reciprocal the largest: numbers that are no longer moderate
/// are refused, and none becomes zero or infinite, which would mean something else.
const LEAST_FACTOR: f64 = 1e-200;

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// What the grasp may be, joint springs of a hand included: sample `number` of those with the seed, whatever else is sampled. See
    /// [`Uncertainty`].
    ///
    /// # Errors
    /// [`Error::Contact`] if an uncertainty is not a number, or so large that a datum leaves its
    /// range (1e50 at most).
    pub fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Result<Self, Error> {
        let factors = |i: usize| {
            let mut draw = Draw::new([uncertainty.seed, number, i as u64]);
            [uncertainty.friction, uncertainty.stiffness, uncertainty.squeeze]
                .map(|sigma| (sigma * draw.normal()).exp().clamp(LEAST_FACTOR, LEAST_FACTOR.recip()))
        };
        let contacts = self.contacts().iter().enumerate().map(|(i, contact)| {
            let [friction, stiffness, squeeze] = factors(i);
            let mut sampled: Contact<C> = contact.clone();
            sampled.friction *= friction;
            sampled.command[0] *= squeeze;
            sampled.stiffness = contact.stiffness.scaled(stiffness);
            sampled
        });
        self.with_data(contacts.collect(), |drive| factors(self.len() + drive)[1])
    }

    /// The onsets of sliding ([`Self::onset`]) of so many samples, in the order of their numbers,
    /// which are [`Self::sample`] 0, 1, …: the same bits for any number of threads. An error in one
    /// does not stop the rest.
    #[must_use]
    pub fn onset_of_samples(
        &self,
        ramp: &Ramp<D, C>,
        uncertainty: &Uncertainty,
        samples: u64,
    ) -> Vec<Result<Onset<D, C>, Error>> {
        self.onset_of_samples_with(ramp, uncertainty, samples, &Settings::default())
    }

    /// [`Self::onset_of_samples`] with other [`Settings`].
    #[must_use]
    pub fn onset_of_samples_with(
        &self,
        ramp: &Ramp<D, C>,
        uncertainty: &Uncertainty,
        samples: u64,
        settings: &Settings,
    ) -> Vec<Result<Onset<D, C>, Error>> {
        let numbers: Vec<u64> = (0..samples).collect();
        map_in_order(&numbers, |number| self.sample(uncertainty, *number)?.onset_with(ramp, settings))
    }
}
