//! Grasps with uncertain data, and random samples of grasps, which depend only on a seed and a number.

use super::contact_errors::{ContactErrors, factor};
use super::panic_as_error::each_answered;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::Engine;
use crate::load_path::{Onset, Ramp};
use crate::numerics::{Draw, Each, IntoList, by_axis};
use crate::prelude::*;

/// Uncertainty of the data of a grasp and of its load. Each friction, stiffness and squeeze of each contact, link, joint and tendon is multiplied by
/// a factor of its own, `exp(σ z)` with z normally distributed (mean 0, variance 1). The median of the product is the given value. The value keeps
/// its sign, and zero and infinity are unchanged. A small σ is a relative standard deviation; with σ = 0 the value is exact. All points of a soft
/// fingertip have the same errors.
///
/// Positions and normals have no natural scale, so their σ are absolute. `σ z` is added to each coordinate of a contact point, and is the angle by
/// which a normal tilts towards each of its tangents. Stiffness, command and clearance stay along the axes of the contact frame, which turns with the
/// normal.
///
/// The load is multiplied by one factor as a whole, base load and growing load alike. An example is a mass that is not known exactly. A factor keeps
/// the line in which the load acts, and needs no length by which moments are compared with forces. An uncertainty in newtons needs a point of action.
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
#[must_use]
pub struct Uncertainty {
    /// Standard deviation σ of the logarithm of the coefficient of friction.
    pub friction: f64,
    /// Standard deviation σ of the logarithm of the stiffness. One random factor multiplies all stiffnesses of a contact: all axes, of object and
    /// finger.
    pub stiffness: f64,
    /// Standard deviation σ of the logarithm of the squeeze. The squeeze of a contact is its command, constant force and vacuum. The squeeze of a
    /// link is its tension without load. The squeeze of a joint or tendon is its command and its constant torque or tension. Overlaps (negative
    /// clearances) and loads of bodies are exact.
    pub squeeze: f64,
    /// Standard deviation σ of the contact points along each coordinate axis, m. It must be zero for a grasp with joints or of several bodies.
    pub position: f64,
    /// Standard deviation σ of the angles by which a normal tilts, rad: one angle in the plane, two in space.
    pub normal: f64,
    /// Standard deviation σ of the logarithm of the factor on the load.
    pub load: f64,
    /// Seed of the random samples: another seed gives other samples.
    pub seed: u64,
}

impl Uncertainty {
    /// An uncertainty with this seed in which all σ are zero.
    pub const fn seeded(seed: u64) -> Self {
        Self { friction: 0.0, stiffness: 0.0, squeeze: 0.0, position: 0.0, normal: 0.0, load: 0.0, seed }
    }

    /// This uncertainty with another standard deviation σ of the logarithms of the coefficients of friction.
    pub const fn with_friction(mut self, sigma: f64) -> Self {
        self.friction = sigma;
        self
    }

    /// This uncertainty with another standard deviation σ of the logarithms of the stiffnesses.
    pub const fn with_stiffness(mut self, sigma: f64) -> Self {
        self.stiffness = sigma;
        self
    }

    /// This uncertainty with another standard deviation σ of the logarithm of the [squeeze](Self::squeeze) of each contact, link, joint and tendon.
    pub const fn with_squeeze(mut self, sigma: f64) -> Self {
        self.squeeze = sigma;
        self
    }

    /// This uncertainty with another standard deviation σ of the contact points along each axis, m.
    pub const fn with_position(mut self, sigma: f64) -> Self {
        self.position = sigma;
        self
    }

    /// This uncertainty with another standard deviation σ of the angles by which normals tilt, rad.
    pub const fn with_normal(mut self, sigma: f64) -> Self {
        self.normal = sigma;
        self
    }

    /// This uncertainty with another standard deviation σ of the logarithm of the factor on the load.
    pub const fn with_load(mut self, sigma: f64) -> Self {
        self.load = sigma;
        self
    }

    /// The random factor on the load in sample `number`, for [`Ramp::with_load_times`]. The grasp of that sample is
    /// [`Grasp::sample`](crate::ask::Grasp::sample).
    ///
    /// ```
    /// use grasp_lcp::sweep::Uncertainty;
    ///
    /// let off = Uncertainty::seeded(7).with_load(0.1);
    /// assert!((off.load_factor(3).ln().abs()) < 0.5 && off.load_factor(3) != off.load_factor(4));
    /// assert_eq!(Uncertainty::seeded(7).load_factor(3), 1.0);
    /// ```
    #[must_use]
    pub fn load_factor(&self, number: u64) -> f64 {
        // Random numbers of the load come from a stream of their own, whose number no contact has.
        factor(self.load * Draw::new([self.seed, number, u64::MAX]).normal())
    }
}

impl Engine {
    pub(crate) fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Result<Self, Error> {
        if uncertainty.position != 0.0 {
            self.refuse_hands("sample with uncertain positions")?;
        }
        let drawn = |i: usize| {
            let mut draw = Draw::new([uncertainty.seed, number, i as u64]);
            let [friction, stiffness, squeeze] =
                [uncertainty.friction, uncertainty.stiffness, uncertainty.squeeze]
                    .each(|sigma| sigma * draw.normal());
            // Displacements and tilts are drawn last, and also if σ = 0. Therefore the other data of a sample do not depend on these σ.
            let mut displaced = |sigma: f64| by_axis(|_| sigma * draw.normal());
            let (moved, tilt) = (displaced(uncertainty.position), displaced(uncertainty.normal));
            ContactErrors { friction, stiffness, squeeze, moved, tilt }
        };
        let mut contacts = self.contacts().to_vec();
        for contact in self.wholes().iter() {
            let off = drawn(contact.range.start);
            for point in &mut contacts[contact.range.clone()] {
                *point = off.applied_to(point);
            }
        }
        self.with_data(contacts, &|part| {
            let ContactErrors { stiffness, squeeze, .. } = drawn(self.len() + part);
            [stiffness, if self.is_driven(part) { squeeze } else { 0.0 }].each(factor)
        })?
        .installed()
    }

    pub(crate) fn onset_of_samples(
        &self,
        ramp: &Ramp<3>,
        uncertainty: &Uncertainty,
        samples: u64,
        settings: &Settings,
    ) -> Vec<Result<Onset<3>, Error>> {
        let numbers: Vec<u64> = (0..samples).list();
        each_answered(&numbers, &|number| {
            let sample = self.sample(uncertainty, *number)?;
            if uncertainty.load == 0.0 {
                return sample.onset(ramp, settings);
            }
            sample.onset(&ramp.clone().with_load_times(uncertainty.load_factor(*number)), settings)
        })
    }
}
