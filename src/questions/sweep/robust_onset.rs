//! The onset of sliding of a grasp with uncertain data, to first order: no samples, a few linear solves.
//!
//! Close to the data the factor at which a contact leaves is linear in them, `τ_j = τ + g_j·z`. Here z is normally distributed (mean 0,
//! variance 1 each), and g_j the derivative by each datum times its σ. So the factor is normally distributed with the standard deviation `|g_j|`.
//! Where two contacts leave together, the onset is the lesser of two such factors (Clark, The greatest of a finite set of random variables, 1961):
//!
//! ```text
//! θ = |g_1 - g_2|:      mean = τ - θ / √(2π),      variance = (|g_1|² + |g_2|²) / 2 - θ² / (2π)
//! ```

use core::f64::consts::TAU;

use super::datum::UncertainDatum;
use super::off::ContactErrors;
use super::uncertainty::Uncertainty;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::{Engine, face_of_struct, same_on_both_sides};
use crate::load_path::{Leaver, Onset, OnsetEvent, OnsetMargins, Ramp};
use crate::numerics::{IntoList, moved, summed};
use crate::prelude::*;

/// An onset of sliding with its spread.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct RobustOnset<const C: usize> {
    /// The onset of the grasp with its data as given.
    pub onset: Onset<C>,
    /// The spread of the onset, to first order. `None` if no contact leaves, if the onset has no gradient
    /// ([`Sensitivity::onset_gradients`](crate::ask::Sensitivity::onset_gradients)), if nothing resists from the onset on, or if a
    /// force holds a contact whose squeeze is uncertain.
    pub spread: Option<OnsetSpread>,
}

/// The spread of an onset with uncertain data, to first order.
///
/// It is valid where a few σ of each datum change the first contact to leave only as the gradients predict. Contacts that leave
/// a little later do not count; [`Grasp::reserve`](crate::ask::Grasp::reserve) and
/// [`Grasp::onset_of_samples`](crate::ask::Grasp::onset_of_samples) include them. NaN where an error of a datum leaves no equilibrium, see
/// [`GeometryGradient`](crate::load_path::GeometryGradient).
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OnsetSpread {
    /// The onset of the data as given: a load factor, or an angle in rad.
    pub factor: f64,
    /// All contacts and drives that leave at the onset.
    pub leaving: Vec<LeaverSpread>,
    /// Mean of the onset: below `factor` where two leave together. `None` where more than two leave together.
    pub mean: Option<f64>,
    /// Standard deviation of the onset; `None` where more than two leave together.
    pub deviation: Option<f64>,
}

/// The spread of the load factor at which one contact leaves, or one drive of a hand.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LeaverSpread {
    /// The contact or drive that leaves.
    pub leaving: Leaver,
    /// Standard deviation of the load factor at which it leaves.
    pub deviation: f64,
}

same_on_both_sides! { OnsetSpread }

face_of_struct! {
    RobustOnset { onset, spread }
}

impl Engine {
    /// Implements [`Grasp::robust_onset`](crate::ask::Grasp::robust_onset).
    pub(crate) fn robust_onset(
        &self,
        ramp: &Ramp<3>,
        uncertainty: &Uncertainty,
        settings: &Settings,
    ) -> Result<RobustOnset<3>, Error> {
        let onset = self.onset(ramp, settings)?;
        let spread = match onset.event() {
            Some(event) => self.onset_spread(event, uncertainty)?,
            None => None,
        };
        Ok(RobustOnset { onset, spread })
    }

    /// Implements [`Sensitivity::onset_spread`](crate::ask::Sensitivity::onset_spread).
    pub(crate) fn onset_spread(
        &self,
        event: &OnsetEvent<3>,
        uncertainty: &Uncertainty,
    ) -> Result<Option<OnsetSpread>, Error> {
        if uncertainty.position != 0.0 {
            self.refuse_hands("onset_spread with uncertain positions")?;
        }
        // There are no derivatives by the force that holds a contact.
        if uncertainty.squeeze != 0.0 && self.contacts().iter().any(|contact| contact.force.is_some()) {
            return Ok(None);
        }
        let Some(margins) = OnsetMargins::new(self, event) else { return Ok(None) };
        let moves = self.moves(&margins, event, uncertainty);
        let norm = |of: &dyn Fn(&Vec<f64>) -> f64| summed(&moves, &|g| of(g).powi(2)).sqrt();
        let leaving: Vec<_> = margins
            .leavers()
            .into_iter()
            .enumerate()
            .map(|(j, leaving)| LeaverSpread { leaving, deviation: norm(&|g| g[j]) })
            .list();
        let (mean, deviation) = match &leaving[..] {
            [one] => (Some(event.factor), Some(one.deviation)),
            [one, other] => {
                let apart = norm(&|g| g[0] - g[1]).powi(2) / TAU;
                let variance = 0.5 * (one.deviation.powi(2) + other.deviation.powi(2)) - apart;
                // As a difference the variance may be negative by rounding where neither load factor depends on the data.
                let variance = if variance < 0.0 { 0.0 } else { variance };
                (Some(event.factor - apart.sqrt()), Some(variance.sqrt()))
            }
            _ => (None, None),
        };
        Ok(Some(OnsetSpread { factor: event.factor, leaving, mean, deviation }))
    }

    /// Changes of the factors of all leaving contacts and drives by one σ of each independent datum.
    fn moves(
        &self,
        margins: &OnsetMargins,
        event: &OnsetEvent<3>,
        uncertainty: &Uncertainty,
    ) -> Vec<Vec<f64>> {
        let leavers = margins.leavers().len();
        let unknown = || vec![f64::NAN; leavers];
        let Uncertainty { friction, load, .. } = *uncertainty;
        let mut data = self.data(uncertainty);
        let rubs = ContactErrors { friction, ..ContactErrors::default() };
        data.extend((0..self.wholes().len()).map(|contact| UncertainDatum::OfContact(contact, rubs)));
        let mut moves = Vec::with_capacity(data.len() + 1);
        for datum in data {
            let mut sum = vec![0.0; leavers];
            for (parameter, times) in datum.parameters(self) {
                let by = margins.by(parameter).unwrap_or_else(unknown);
                // Skips parameters without effect: their change may be infinite.
                sum.iter_mut().zip(by).filter(|(_, by)| *by != 0.0).for_each(|(sum, by)| *sum += times * by);
            }
            moves.push(sum);
        }
        if load != 0.0 {
            let by = margins.by_load(&event.load).unwrap_or_else(unknown);
            moves.push(moved(by, &|by| load * by));
        }
        moves
    }
}
