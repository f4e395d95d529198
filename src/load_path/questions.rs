//! Questions that designers ask of a load path.

use super::event::{Loss, PathEnd};
use super::leg::Leg;
use super::onset::Onset;
use super::ramp::Ramp;
use crate::error::{Error, is_moderate};
use crate::grasp::Grasp;
use crate::search::Settings;

/// Onset of sliding and limit load along one ramp, side by side; see [`Grasp::reserve`].
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Reserve<const D: usize, const C: usize> {
    /// When the first contact leaves rolling (on the same cone as the path: in space the round one unless the settings say otherwise).
    pub onset: Onset<D, C>,
    /// The largest load factor that the grasp holds on its path, if equilibrium was lost. `None` if it
    /// holds as far as was asked, and where nothing can be said: `completed` tells which.
    pub limit: Option<f64>,
    /// Whether the grasp holds as far as was asked.
    pub completed: bool,
    /// The factor up to which the path was followed, and the grasp holds: `limit` where that is known, what was asked for where it
    /// holds so far, and a lower bound of the limit where the path could not be followed further. `None` where it has no start.
    pub held_to: Option<f64>,
    /// Where and how equilibrium was lost: `limit` is its fraction times the factor asked for.
    pub loss: Option<Loss<D, C>>,
    /// Number of events before the path ended.
    pub events: usize,
}

/// The range of load factors in which nothing leaves rolling; see [`Grasp::rolling_range`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RollingRange {
    /// The least factor, at most 0; minus infinity if there is none.
    pub from: f64,
    /// The largest factor, at least 0; infinity if there is none.
    pub to: f64,
}

impl RollingRange {
    /// Whether a factor lies in the range, ends included.
    #[must_use]
    pub fn contains(&self, factor: f64) -> bool {
        (self.from..=self.to).contains(&factor)
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Onset and limit load along a ramp that is followed up to a load factor `most`, with slip memory. The reserve factor
    /// against losing the object is `limit`, that against sliding is the onset's factor.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let weight = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let reserve = grasp.reserve(&weight, 100.0)?;
    /// assert!((reserve.onset.factor().expect("slides") - 10.0).abs() < 1e-13);
    /// assert!((reserve.limit.expect("falls") - 10.0).abs() < 1e-12); // both slide at once, and nothing is left
    /// assert!(reserve.held_to == reserve.limit);
    ///
    /// let holds = grasp.reserve(&weight, 5.0)?;
    /// assert!(holds.completed && holds.limit.is_none() && holds.held_to == Some(5.0));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn reserve(&self, ramp: &Ramp<D, C>, most: f64) -> Result<Reserve<D, C>, Error> {
        self.reserve_with(ramp, most, &Settings::default())
    }

    /// [`Self::reserve`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::reserve`].
    pub fn reserve_with(
        &self,
        ramp: &Ramp<D, C>,
        most: f64,
        settings: &Settings,
    ) -> Result<Reserve<D, C>, Error> {
        if !(most > 0.0 && is_moderate(most)) {
            let allowed = "more than 0 and at most 1e50";
            return Err(Error::Argument { what: "most, the bound of the factor", value: most, allowed });
        }
        let onset = self.onset_with(ramp, settings)?;
        let leg = Leg::along(&ramp.times(most));
        let mut path = self.follow_with(&ramp.base, &[leg], settings)?;
        let events = path.run().len();
        let end = path.end();
        let loss = end.and_then(PathEnd::loss).cloned();
        let lost_at = loss.as_ref().map(|loss| loss.fraction);
        let completed = matches!(end, Some(PathEnd::Completed));
        let held_to = if completed { Some(1.0) } else { end.and_then(PathEnd::fraction) };
        let [limit, held_to] = [lost_at, held_to].map(|fraction| fraction.map(|fraction| fraction * most));
        Ok(Reserve { onset, limit, completed, held_to, loss, events })
    }

    /// The range of factors of a ramp, around 0, in which everything that touches rolls: for an affine choice of load or
    /// commands all the values that a planner may take without sliding. Two onsets, one each way. `None` where at 0 something slides, nothing
    /// holds, or neither is known.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let range = grasp.rolling_range(&ramp)?.expect("rolls without load");
    /// assert!((range.from - -10.0).abs() < 1e-13 && (range.to - 10.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn rolling_range(&self, ramp: &Ramp<D, C>) -> Result<Option<RollingRange>, Error> {
        self.rolling_range_with(ramp, &Settings::default())
    }

    /// [`Self::rolling_range`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::rolling_range`].
    pub fn rolling_range_with(
        &self,
        ramp: &Ramp<D, C>,
        settings: &Settings,
    ) -> Result<Option<RollingRange>, Error> {
        let back = ramp.times(-1.0);
        let (to, from) =
            (self.onset_with(ramp, settings)?.factor(), self.onset_with(&back, settings)?.factor());
        Ok(to.zip(from).map(|(to, from)| RollingRange { from: -from, to }))
    }
}
