//! The unknowns, and the observed slips.

use super::answer::Identified;
use super::fit::fitted;
use super::model::Model;
use super::slip::Slip;
use super::spread::told;
use super::unknown::{Unknown, UnknownKind};
use crate::ask::Grasp;
use crate::error::Error;
use crate::numerics::mapped;
use crate::prelude::*;

/// Unknown numbers of a grasp, and the observed slips. The question is checked when it is answered.
#[derive(Debug, Clone)]
pub struct Identify<const C: usize> {
    pub(super) unknowns: Vec<Unknown>,
    pub(super) slips: Vec<Slip<C>>,
    /// Sums of unknowns that are known from elsewhere.
    pub(super) known: Vec<Known>,
    /// Grasps of other slips, beside the one that is asked.
    pub(super) others: Vec<Grasp<C>>,
    pub(super) outliers: f64,
    pub(super) iterations: usize,
}

/// A known number, or a known sum of several.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Known {
    pub(super) unknowns: Vec<usize>,
    pub(super) value: f64,
    pub(super) scatter: f64,
}

impl<const C: usize> Identify<C> {
    /// These unknowns from these slips.
    pub fn new(
        unknowns: impl IntoIterator<Item = Unknown>,
        slips: impl IntoIterator<Item = Slip<C>>,
    ) -> Self {
        Self {
            unknowns: unknowns.into_iter().collect(),
            slips: slips.into_iter().collect(),
            known: Vec::new(),
            others: Vec::new(),
            // One in twenty normally distributed residuals is beyond two standard deviations, and estimates
            // scatter by 1 % more than those of least squares.
            outliers: 2.0,
            // A longer search creeps along combinations that slips hardly determine.
            iterations: 100,
        }
    }

    /// Grasps of other layouts in which slips were observed, for instance the same contacts at other places. The grasp that is asked is layout 0.
    #[must_use]
    pub fn and_layouts(mut self, others: impl IntoIterator<Item = Grasp<C>>) -> Self {
        self.others.extend(others);
        self
    }

    /// A sum of unknowns, by their numbers from 0, that is known with a relative standard deviation. Examples are a weighed total load of all
    /// supports, or one unknown from another measurement.
    #[must_use]
    pub fn knowing(mut self, unknowns: impl IntoIterator<Item = usize>, value: f64, scatter: f64) -> Self {
        self.known.push(Known { unknowns: unknowns.into_iter().collect(), value, scatter });
        self
    }

    /// The number of standard deviations beyond which slips count less (default 2). The loss is Huber's: quadratic up to there, and linear beyond.
    /// Infinity gives least squares.
    #[doc(alias = "Huber")]
    #[must_use]
    pub fn with_outliers_beyond(mut self, deviations: f64) -> Self {
        self.outliers = deviations;
        self
    }

    /// The limit of steps of the search (default 100).
    #[must_use]
    pub fn with_iterations(mut self, most: usize) -> Self {
        self.iterations = most;
        self
    }

    /// The grasp with the estimates, such as a coefficient of friction or a squeeze. A number that the slips do not determine has its value at the
    /// start of the search, or one that fits the others.
    ///
    /// # Errors
    /// As for [`Self::answered_by`].
    pub fn grasp_with(&self, grasp: &Grasp<C>, found: &Identified) -> Result<Grasp<C>, Error> {
        let layouts = self.layouts(grasp);
        self.check(&layouts)?;
        let logs: Vec<_> = mapped(&found.estimates, &|estimate| estimate.value.ln());
        let model = Model { layouts: &layouts, asked: self };
        Ok(model.at(&logs)?.swap_remove(0).grasp)
    }

    /// The question with weights at rest in slips whose own load presses, unless carried forces are sought.
    fn with_weights_at_rest(&self, layouts: &[Grasp<C>]) -> Self {
        let mut asked = self.clone();
        let is_carried =
            |unknown: &Unknown, layout| unknown.kind == UnknownKind::Carried && unknown.is_in(layout);
        for slip in &mut asked.slips {
            if !self.unknowns.iter().any(|unknown| is_carried(unknown, slip.layout)) {
                *slip = slip.clone().with_weight_at_rest(&layouts[slip.layout]);
            }
        }
        asked
    }

    fn layouts(&self, grasp: &Grasp<C>) -> Vec<Grasp<C>> {
        core::iter::once(grasp).chain(&self.others).cloned().collect()
    }
}

impl<const C: usize> Identify<C> {
    /// The unknowns of this grasp by the slips. See [the room](crate::identify).
    ///
    /// ```
    /// use grasp_lcp::identify::{Identify, Slip, Unknown};
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that press with 10 N each; nobody knows their friction. Five times a load was hung on until it slid.
    /// let jaw = |x: f64, name| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
    /// let slid_at = [6.1, 5.8, 6.4, 6.0, 6.2].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])));
    /// let asked = Identify::new([Unknown::friction()], slid_at);
    /// let found = asked.answered_by(&gripper)?;
    /// assert_eq!(found.to_string(), "friction 0.3048 ± 0.0050 (95 %: 0.2913 to 0.3190) from 5 slips, which scatter by 3.8 %");
    ///
    /// // The load is 2 μ N. How hard must it press on, if friction is as low as the slips allow?
    /// let sure = asked.grasp_with(&gripper, &found)?;
    /// let needed = sure.need(&Need::squeeze(Wrench::force([0.0, -4.0])).if_lower_by(found.friction_less(), 0.0))?;
    /// assert!(needed.to_string().starts_with("NEEDS 6.56"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Identify`] with the slip or the unknown, field, value and allowed values; as for [`Grasp::hold`].
    #[doc(alias = "calibrate")]
    #[doc(alias = "estimate")]
    #[doc(alias = "fit")]
    pub fn answered_by(&self, grasp: &Grasp<C>) -> Result<Identified, Error> {
        let layouts = self.layouts(grasp);
        self.check(&layouts)?;
        let asked = &self.with_weights_at_rest(&layouts);
        let model = Model { layouts: &layouts, asked };
        let fit = fitted(&model)?;
        Ok(told(&model, &fit))
    }
}
