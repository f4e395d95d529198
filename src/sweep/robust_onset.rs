//! The onset of sliding of a grasp that is not known exactly, to first order: no samples, a few linear solves.
//!
//! Close to the data the factor at which something leaves is linear in them, `τ_j = τ + g_j·z`. Here z is normally distributed (mean 0,
//! variance 1 each), and g_j the derivative by each datum times its σ. So it is normally distributed with the standard deviation `|g_j|`.
//! Where two leave together the onset is the lesser of two such factors (Clark, The greatest of a finite set of random variables, 1961):
//!
//! ```text
//! θ = |g_1 - g_2|:      mean = τ - θ / √(2π),      variance = (|g_1|² + |g_2|²) / 2 - θ² / (2π)
//! ```

use crate::numerics::Size;
use std::f64::consts::TAU;

use super::in_order::map_in_order;
use super::uncertainty::Uncertainty;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::Engine;
use crate::load_path::{Leaver, Onset, OnsetEvent, OnsetMargins, Parameter, Ramp};

/// An onset of sliding with its spread.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct RobustOnset<const C: usize> {
    /// The onset of the grasp as it is given.
    pub onset: Onset<C>,
    /// How far it spreads, to first order. `None` where nothing leaves, where the onset has no gradient
    /// ([`Sensitivity::onset_gradients`](crate::ask::Sensitivity::onset_gradients)), and where nothing resists from the onset on.
    pub spread: Option<OnsetSpread>,
}

/// How far an onset spreads where the data are not known exactly, to first order.
///
/// That holds where a few σ of each datum change which contact leaves first in no other way than the gradients do. Contacts that leave
/// little later do not count; [`Grasp::onset_of_samples`](crate::ask::Grasp::onset_of_samples) has them. Not a number where a datum leaves no equilibrium when it is off, see
/// [`GeometryGradient`](crate::load_path::GeometryGradient).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OnsetSpread {
    /// The onset of the data as given: a load factor, or an angle in rad.
    pub factor: f64,
    /// Everything that leaves there.
    pub leaving: Vec<LeaverSpread>,
    /// Mean of the onset: below `factor` where two leave together. `None` where more than two do.
    pub mean: Option<f64>,
    /// Its standard deviation, `None` where more than two leave together.
    pub deviation: Option<f64>,
}

/// How far the factor spreads at which one contact leaves, or one drive of a hand.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LeaverSpread {
    /// What leaves.
    pub leaving: Leaver,
    /// Standard deviation of the factor at which it does.
    pub deviation: f64,
}

impl OnsetSpread {
    /// The factor with so many standard deviations in reserve: `τ - number · |g_j|`, the least over what leaves.
    ///
    /// One leaver keeps sticking there with probability Φ(number), 0.977 for two and 0.99865 for three; of several all do at least with
    /// one less the sum of what each fails with.
    #[must_use]
    pub fn held_with(&self, number: f64) -> f64 {
        let of_one = |spread: &LeaverSpread| self.factor - number * spread.deviation;
        // Not a number wherever one is.
        let lesser = |least: f64, x: f64| if x.is_nan() || x < least { x } else { least };
        self.leaving.iter().map(of_one).fold(self.factor, lesser)
    }
}

impl<D: Size, const C: usize> Engine<D, C> {
    /// [`Grasp::robust_onset`](crate::ask::Grasp::robust_onset).
    pub(crate) fn robust_onset(
        &self,
        ramp: &Ramp<C>,
        uncertainty: &Uncertainty,
        settings: &Settings,
    ) -> Result<RobustOnset<C>, Error> {
        let onset = self.onset(ramp, settings)?;
        let spread = match onset.event() {
            Some(event) => self.onset_spread(event, uncertainty)?,
            None => None,
        };
        Ok(RobustOnset { onset, spread })
    }

    /// [`Grasp::robust_onset_each`](crate::ask::Grasp::robust_onset_each).
    pub(crate) fn robust_onset_each(
        &self,
        ramps: &[Ramp<C>],
        uncertainty: &Uncertainty,
        settings: &Settings,
    ) -> Vec<Result<RobustOnset<C>, Error>> {
        map_in_order(ramps, |ramp| self.robust_onset(ramp, uncertainty, settings))
    }

    /// [`Sensitivity::onset_spread`](crate::ask::Sensitivity::onset_spread).
    pub(crate) fn onset_spread(
        &self,
        event: &OnsetEvent<C>,
        uncertainty: &Uncertainty,
    ) -> Result<Option<OnsetSpread>, Error> {
        if uncertainty.position != 0.0 {
            self.refuse_hands("onset_spread with uncertain positions")?;
        }
        let Some(margins) = OnsetMargins::new(self, event) else { return Ok(None) };
        let moves = self.moves(&margins, event, uncertainty);
        let norm = |of: &dyn Fn(&Vec<f64>) -> f64| moves.iter().map(|g| of(g).powi(2)).sum::<f64>().sqrt();
        let leaving: Vec<_> = margins
            .leavers()
            .enumerate()
            .map(|(j, leaving)| LeaverSpread { leaving, deviation: norm(&|g| g[j]) })
            .collect();
        let (mean, deviation) = match &leaving[..] {
            [one] => (Some(event.factor), Some(one.deviation)),
            [one, other] => {
                let apart = norm(&|g| g[0] - g[1]).powi(2) / TAU;
                let variance = 0.5 * (one.deviation.powi(2) + other.deviation.powi(2)) - apart;
                // A difference that is zero where neither moves.
                let variance = if variance < 0.0 { 0.0 } else { variance };
                (Some(event.factor - apart.sqrt()), Some(variance.sqrt()))
            }
            _ => (None, None),
        };
        Ok(Some(OnsetSpread { factor: event.factor, leaving, mean, deviation }))
    }

    /// By how much one σ of each independent datum moves the factors of everything that leaves.
    fn moves(
        &self,
        margins: &OnsetMargins<D, C>,
        event: &OnsetEvent<C>,
        uncertainty: &Uncertainty,
    ) -> Vec<Vec<f64>> {
        let leavers = margins.leavers().count();
        let mut moves = Vec::new();
        // What is proportional to one z: data and what one z does to them.
        let mut add = |together: &[(Parameter, f64)]| {
            let mut sum = vec![0.0; leavers];
            for (parameter, times) in together {
                let by = margins.by(*parameter).unwrap_or_else(|| vec![f64::NAN; leavers]);
                // What is infinite or has no effect stays what it is.
                sum.iter_mut().zip(by).filter(|(_, by)| *by != 0.0).for_each(|(sum, by)| *sum += times * by);
            }
            moves.push(sum);
        };
        let Uncertainty { friction, stiffness, squeeze, position, normal, load, .. } = *uncertainty;
        for (contact, data) in self.contacts().iter().enumerate() {
            if friction != 0.0 && data.friction_coefficient().is_finite() {
                add(&[(Parameter::Friction { contact }, friction * data.friction_coefficient())]);
            }
            if stiffness != 0.0 {
                let k = data.series_stiffness_of_axes();
                let along = |axis: usize| (Parameter::Stiffness { contact, axis }, stiffness * k[axis]);
                add(&(0..C).map(along).collect::<Vec<_>>());
            }
            if squeeze != 0.0 {
                add(&[(Parameter::Command { contact, axis: 0 }, squeeze * data.commanded()[0])]);
            }
            if position != 0.0 {
                (0..C).for_each(|axis| add(&[(Parameter::Point { contact, axis }, position)]));
            }
            if normal != 0.0 {
                (1..C).for_each(|axis| add(&[(Parameter::Normal { contact, axis }, normal)]));
            }
        }
        if stiffness != 0.0 {
            for joint in 0..self.joint_commands().len() {
                let Some((_, drive)) = self.drives_of(joint).next() else { continue };
                add(&[(Parameter::JointStiffness { joint }, stiffness * drive.stiffness_of_owner())]);
            }
        }
        if load != 0.0 {
            let by = margins.by_load(&event.load).unwrap_or_else(|| vec![f64::NAN; leavers]);
            moves.push(by.into_iter().map(|by| load * by).collect());
        }
        moves
    }
}
