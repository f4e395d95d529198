//! Questions that designers ask of a load path.

use super::event::{Loss, PathEnd};
use super::leg::Leg;
use super::onset::Onset;
use super::ramp::Ramp;
use crate::error::{Error, is_moderate};
use crate::grasp::Engine;
use crate::numerics::Size;
use crate::search::Settings;

/// Onset of sliding and limit load along one ramp, side by side; see [`Grasp::reserve`](crate::ask::Grasp::reserve).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Reserve<const C: usize> {
    /// When the first contact stops sticking (on the same cone as the path: in space the round one unless the settings say otherwise).
    pub onset: Onset<C>,
    /// The largest load factor that the grasp holds on its path, if equilibrium was lost. `None` if it
    /// holds as far as was asked, and where nothing can be said: `completed` tells which.
    pub limit: Option<f64>,
    /// Whether the grasp holds as far as was asked.
    pub completed: bool,
    /// The factor up to which the path was followed, and the grasp holds: `limit` where that is known, what was asked for where it
    /// holds so far, and a lower bound of the limit where the path could not be followed further. `None` where it has no start.
    pub held_to: Option<f64>,
    /// Where and how equilibrium was lost: `limit` is its fraction times the factor asked for.
    pub loss: Option<Loss<C>>,
    /// Number of events before the path ended.
    pub events: usize,
}

/// The range of load factors in which nothing stops sticking; see [`Grasp::sticking_range`](crate::ask::Grasp::sticking_range).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct StickingRange {
    /// The least factor, at most 0; minus infinity if there is none.
    pub from: f64,
    /// The largest factor, at least 0; infinity if there is none.
    pub to: f64,
}

impl StickingRange {
    /// Whether a factor lies in the range, ends included.
    #[must_use]
    pub fn contains(&self, factor: f64) -> bool {
        (self.from..=self.to).contains(&factor)
    }
}

impl<D: Size, const C: usize> Engine<D, C> {
    /// [`Grasp::reserve`](crate::ask::Grasp::reserve).
    pub(crate) fn reserve(
        &self,
        ramp: &Ramp<C>,
        most: f64,
        settings: &Settings,
    ) -> Result<Reserve<C>, Error> {
        if !(most > 0.0 && is_moderate(most)) {
            let allowed = "more than 0 and at most 1e50";
            return Err(Error::Argument { what: "most, the bound of the factor", value: most, allowed });
        }
        let onset = self.onset(ramp, settings)?;
        let leg = Leg::along(&ramp.times(most));
        let mut path = self.follow(&ramp.base, &[leg], settings)?;
        let events = path.run().len();
        let end = path.end();
        let loss = end.and_then(PathEnd::loss).cloned();
        let lost_at = loss.as_ref().map(|loss| loss.fraction);
        let completed = matches!(end, Some(PathEnd::Completed));
        let held_to = if completed { Some(1.0) } else { end.and_then(PathEnd::fraction) };
        let [limit, held_to] = [lost_at, held_to].map(|fraction| fraction.map(|fraction| fraction * most));
        Ok(Reserve { onset, limit, completed, held_to, loss, events })
    }

    /// [`Grasp::sticking_range`](crate::ask::Grasp::sticking_range).
    pub(crate) fn sticking_range(
        &self,
        ramp: &Ramp<C>,
        settings: &Settings,
    ) -> Result<Option<StickingRange>, Error> {
        let back = ramp.times(-1.0);
        let (to, from) = (self.onset(ramp, settings)?.factor(), self.onset(&back, settings)?.factor());
        Ok(to.zip(from).map(|(to, from)| StickingRange { from: -from, to }))
    }
}
