//! Questions that designers ask of a load path.

use super::event::{Loss, PathEnd};
use super::leg::Leg;
use super::onset::Onset;
use super::ramp::Ramp;
use crate::equilibrium::Settings;
use crate::error::Error;
use crate::grasp::Grasp;

/// Onset of sliding and limit load along one ramp, side by side.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Reserve<const D: usize, const C: usize> {
    /// When the first contact leaves rolling (on the same cone as the path: in space the round one unless the settings say otherwise).
    pub onset: Onset<D, C>,
    /// The largest load factor that the grasp holds on its path, if the path was lost; the same number is
    /// `loss.fraction` times the factor asked for.
    pub limit: Option<f64>,
    /// Where and how equilibrium was lost.
    pub loss: Option<Loss<D>>,
    /// Events before the path ended.
    pub events: usize,
}

/// The range of load factors in which nothing leaves rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RollingRange {
    /// The least factor, minus infinity if there is none.
    pub from: f64,
    /// The largest factor, infinity if there is none.
    pub to: f64,
}

impl RollingRange {
    /// Whether a factor lies in the range.
    #[must_use]
    pub fn contains(&self, factor: f64) -> bool {
        (self.from..=self.to).contains(&factor)
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Onset and limit load along a ramp that is followed up to a load factor `most`, with slip memory. The reserve factor
    /// against losing the object is `limit`, that against sliding is the onset's factor.
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn reserve(&self, ramp: &Ramp<D, C>, most: f64, settings: &Settings) -> Result<Reserve<D, C>, Error> {
        let onset = if settings.is_round::<C>() {
            self.onset(ramp, settings)?
        } else {
            self.onset_on_polygon(ramp, settings)?
        };
        let mut leg = Leg::load_by(ramp.direction * most);
        if let Some(change) = &ramp.command_change {
            leg = leg.and_commands_by(change.iter().map(|a| a * most).collect::<Vec<_>>());
        }
        let mut path = self.follow_with(ramp.base, &[leg], settings)?;
        let events = path.run().len();
        let loss = path.end().and_then(PathEnd::loss).cloned();
        Ok(Reserve { onset, limit: loss.as_ref().map(|loss| loss.fraction * most), loss, events })
    }

    /// The range of factors of a ramp, around 0, in which everything that touches rolls: for an affine choice of load or
    /// commands all the values that a planner may take without sliding. `None` where something slides, or nothing holds, at 0.
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn rolling_range(
        &self,
        ramp: &Ramp<D, C>,
        settings: &Settings,
    ) -> Result<Option<RollingRange>, Error> {
        let back = Ramp {
            base: ramp.base,
            direction: -ramp.direction,
            command_change: ramp.command_change.as_ref().map(|change| change.iter().map(|a| -a).collect()),
        };
        let (to, from) = (self.onset(ramp, settings)?.factor(), self.onset(&back, settings)?.factor());
        Ok(to.zip(from).map(|(to, from)| RollingRange { from: -from, to }))
    }
}
