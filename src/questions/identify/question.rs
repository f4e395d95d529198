//! The question which parameters of a grasp explain observed slip. A parameter is a number of the grasp that is sought, such as a coefficient of
//! friction. An observation is a load or an angle at which slip was observed. A layout is an arrangement of the contact points. A known sum is a sum
//! of parameters that is known from another measurement. A carried force is the normal force of a contact before the load of an observation grows.

use crate::numerics::{IntoList, mapped, tried};
use nalgebra::SVector;

use super::answer::Identified;
use super::assignments::assigned;
use super::fit::fitted;
use super::model::Model;
use super::slip::Slip;
use super::unknown::{Unknown, UnknownKind};
use crate::ask::Grasp;
use crate::error::Error;
#[cfg(feature = "serde")]
use crate::grasp::Wrench;
use crate::grasp::{inside, outside};
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsGiven;

/// The parameters of a grasp that are sought, and the observations from which they follow. Invalid values are refused when the question is asked.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(extend("required" = ["unknowns", "slips"]))
)]
#[must_use]
pub struct Identify<const C: usize> {
    /// The parameters of the grasp that are estimated from the observations.
    pub(crate) unknowns: Vec<Unknown>,
    /// The observations: loads or angles at which the grasp was observed to slip.
    pub(crate) slips: Vec<Slip<C>>,
    /// Contact points of other layouts in which slip was observed, m. A layout is one arrangement of the contact points. Layout 0 is that of the
    /// given grasp, layout 1 the first one in this list.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<Vec<Vec<SVector<f64, C>>>>", skip_serializing_if = "Vec::is_empty")
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub(crate) layouts: Vec<Vec<SVector<f64, C>>>,
    /// Sums of parameters that are known from other measurements.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub(super) known: Vec<KnownSum>,
    /// Observations with residuals of more than this number of standard deviations get less weight; 2 if not given.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub(super) outliers: Option<f64>,
    /// Upper limit of the number of steps of the search; 100 if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) iterations: Option<usize>,
    /// Grasps of other layouts in which slip was observed.
    #[cfg_attr(feature = "serde", serde(skip, default = "no_others"))]
    pub(super) others: OtherLayouts<C>,
}

/// The grasps of other layouts (arrangements of the contact points) in which slip was observed. Two such lists are equal if the contacts of all their
/// grasps are equal; joints and settings do not count.
#[derive(Debug, Clone)]
pub(super) struct OtherLayouts<const C: usize> {
    pub(super) grasps: Vec<Grasp<C>>,
}

impl<const C: usize> PartialEq for OtherLayouts<C> {
    fn eq(&self, other: &Self) -> bool {
        let contacts = |others: &Self| mapped(&others.grasps, &|grasp| grasp.contacts().to_vec());
        contacts(self) == contacts(other)
    }
}

#[cfg(feature = "serde")]
fn no_others<const C: usize>() -> OtherLayouts<C> {
    OtherLayouts { grasps: Vec::new() }
}

/// A sum of parameters that is known from another measurement.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct KnownSum {
    /// The indices of the parameters in the sum, from 0.
    pub(super) unknowns: Vec<usize>,
    /// The value of the sum, known from the other measurement.
    pub(super) value: f64,
    /// The relative standard deviation of the sum.
    pub(super) scatter: f64,
}

impl<const C: usize> Identify<C> {
    /// The question for estimates of the parameters `unknowns` from the observations `slips`.
    pub fn new(
        unknowns: impl IntoIterator<Item = Unknown>,
        slips: impl IntoIterator<Item = Slip<C>>,
    ) -> Self {
        Self {
            unknowns: unknowns.into_iter().list(),
            slips: slips.into_iter().list(),
            layouts: Vec::new(),
            known: Vec::new(),
            outliers: None,
            iterations: None,
            others: OtherLayouts { grasps: Vec::new() },
        }
    }

    setters! {
        /// Adds a layout in which slip was observed: the points of its contacts, m, one for each contact. The grasp for which the question is asked
        /// is layout 0, the first layout added is layout 1.
        pub fn with_points(mut self, points: impl IntoIterator<Item = impl Into<[f64; C]>>) {
            self.layouts.push(points.into_iter().map(|point| SVector::from(point.into())).list());
        }

        /// Adds layouts as grasps of their own, for instance with another squeeze. They are numbered after the layouts of [`Self::with_points`].
        pub fn and_layouts(mut self, others: impl IntoIterator<Item = Grasp<C>>) {
            self.others.grasps.extend(others);
        }

        /// Adds a sum of parameters, given by their indices `unknowns` from 0. Its value is known with the relative standard deviation `scatter`.
        /// Examples are the weighed total load of all supports, or one parameter from another measurement.
        pub fn knowing(mut self, unknowns: impl IntoIterator<Item = usize>, value: f64, scatter: f64) {
            self.known.push(KnownSum { unknowns: unknowns.into_iter().list(), value, scatter });
        }

        /// Sets the number of standard deviations beyond which observations get less weight (default 2). The loss is Huber's: quadratic up to this
        /// number, and linear beyond. Infinity gives least squares.
        #[doc(alias = "Huber")]
        pub fn with_outliers_beyond(mut self, deviations: f64) { self.outliers = Some(deviations); }

        /// Sets the upper limit of the number of steps of the search (default 100).
        pub fn with_iterations(mut self, most: usize) { self.iterations = Some(most); }
    }

    /// The grasp with the estimates `found` put in, such as a coefficient of friction or a squeeze. A parameter that the observations do not
    /// determine keeps its value at the start of the search, or gets a value that fits the observations equally well.
    ///
    /// # Errors
    /// The errors of [`Grasp::identify`].
    pub fn grasp_with(&self, grasp: &Grasp<C>, found: &Identified) -> Result<Grasp<C>, Error> {
        inside(self).fitted_grasp(&inside(grasp), found).map(outside)
    }

    /// Whether forces are sought that contacts carry before the load of an observation grows. The load that presses on the contacts then need not be
    /// given.
    #[cfg(feature = "serde")]
    pub(crate) fn seeks_carried(&self) -> bool {
        self.unknowns.iter().any(|unknown| unknown.kind == UnknownKind::Carried)
    }
}

impl Identify<3> {
    /// Puts the estimates `found` into `grasp`, in the engine's form, whose vectors have three components in the plane, too.
    fn fitted_grasp(&self, grasp: &Grasp<3>, found: &Identified) -> Result<Grasp<3>, Error> {
        let layouts = self.layouts(grasp)?;
        let asked = &self.of_points(&layouts)?;
        let logs: Vec<_> = mapped(&found.estimates, &|estimate| estimate.value.ln());
        let model = Model { layouts: &layouts, asked };
        Ok(model.at(&logs)?.swap_remove(0).grasp)
    }

    /// Searches for the parameters in the engine's form, whose vectors have three components in the plane, too.
    fn answered_by(&self, grasp: &Grasp<3>) -> Result<Identified, Error> {
        let layouts = self.layouts(grasp)?;
        let asked = &self.of_points(&layouts)?.with_weights_at_rest(&layouts);
        let model = Model { layouts: &layouts, asked };
        assigned(&model, fitted(&model)?)
    }

    /// Returns this question with the load of each observation [split in two](Slip::with_weight_at_rest) if nothing else presses on the contacts. The
    /// component that presses on them then acts from the start. An observation keeps its load if carried forces are sought in its layout.
    fn with_weights_at_rest(&self, layouts: &[Grasp<3>]) -> Self {
        let mut asked = self.clone();
        let is_carried =
            |unknown: &Unknown, layout| unknown.kind == UnknownKind::Carried && unknown.is_in(layout);
        for slip in &mut asked.slips {
            if !self.unknowns.iter().any(|unknown| is_carried(unknown, slip.layout())) {
                *slip = slip.clone().with_weight_at_rest(&layouts[slip.layout()]);
            }
        }
        asked
    }

    /// The number of standard deviations beyond which observations get less weight. With the default of two, one in twenty normally distributed
    /// residuals gets less weight, and standard errors are 1 % larger than with least squares.
    pub(super) fn outliers(&self) -> f64 {
        self.outliers.unwrap_or(2.0)
    }

    /// The upper limit of the number of steps of the search. The default of 100 is enough: a search that takes longer only changes combinations of
    /// parameters that the observations hardly determine.
    pub(super) fn iterations(&self) -> usize {
        self.iterations.unwrap_or(100)
    }

    /// The grasps of all layouts: the given grasp, copies of it with the contacts at other points, then the grasps that [`Self::and_layouts`] added.
    fn layouts(&self, grasp: &Grasp<3>) -> Result<Vec<Grasp<3>>, Error> {
        let mut all = vec![grasp.clone()];
        all.extend(tried(&self.layouts, &|points| grasp.moved_to(points))?);
        all.extend(self.others.grasps.iter().cloned());
        Ok(all)
    }

    /// Checks the values of this question. Returns the question with the contact points of soft fingertips in place of the fingertips. Each such
    /// point is a contact of its own in the engine.
    fn of_points(&self, layouts: &[Grasp<3>]) -> Result<Self, Error> {
        self.check_numbers(layouts[0].engine.space(), layouts.len())?;
        let mut asked = self.clone();
        for (k, unknown) in asked.unknowns.iter_mut().enumerate() {
            *unknown = unknown.of_points(k, layouts)?;
        }
        asked.check(layouts)?;
        Ok(asked)
    }

    /// A load that acts before any load grows. The code that reads scene files uses it to check whether anything presses on the contacts. If carried
    /// forces are sought, or if every observation has an initial load, it is the initial load of the first observation in the list. Otherwise it is
    /// zero.
    #[cfg(feature = "serde")]
    pub(crate) fn at_rest(&self) -> Wrench<3> {
        let mut all = self.slips.iter().map(Slip::at_rest);
        let first = all.next().unwrap_or(Wrench::ZERO);
        if self.seeks_carried() || all.all(|acts| acts != Wrench::ZERO) { first } else { Wrench::ZERO }
    }
}

impl Grasp<3> {
    /// Returns this grasp with its contacts at other points. Links between bodies (such as cables) get no point and stay in place. A soft fingertip
    /// moves as a whole, so that the mean of its points is the given point.
    fn moved_to(&self, points: &[SVector<f64, 3>]) -> Result<Self, Error> {
        if self.refuse_hands("identify").is_err() {
            return Err(LAYOUTS_OF_HANDS);
        }
        let parts = self.engine.wholes();
        let middles = parts.mean(&|i| self.contacts()[i].point);
        let (mut contacts, mut count) = (self.contacts().to_vec(), 0);
        for (part, middle) in parts.iter().zip(middles) {
            if part.label.link.is_none() {
                let point = points.get(count).copied().unwrap_or(middle);
                for contact in &mut contacts[part.range.clone()] {
                    // For a contact with a single point `contact.point - middle` is exactly zero, so that the contact gets the new point without
                    // rounding.
                    contact.point = point + (contact.point - middle);
                }
                count += 1;
            }
        }
        if points.len() != count {
            return Err(Error::Size { what: "points of a layout", given: points.len(), expected: count });
        }
        Ok(Self::new(contacts)?.with(self.settings()))
    }
}

/// The error of a question that gives layouts by contact points for a grasp with joints or several bodies, whose contacts cannot be moved one by one.
pub(crate) const LAYOUTS_OF_HANDS: Error = Error::Question {
    question: "identify",
    field: "layouts",
    fault: "are given, must be left out of a grasp with joints or of several bodies",
};

impl<const C: usize> Grasp<C> {
    /// The estimates of parameters of this grasp, such as friction, from observed slip. The module [`identify`](crate::identify) describes the
    /// method.
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
    /// let found = gripper.identify(&asked)?;
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
    /// [`Error::Identify`] with the observation or the parameter, the field, its value and the allowed values. Also the errors of [`Grasp::hold`].
    #[doc(alias = "calibrate")]
    #[doc(alias = "estimate")]
    #[doc(alias = "fit")]
    pub fn identify(&self, question: &Identify<C>) -> Result<Identified, Error> {
        inside(question).answered_by(&inside(self))
    }
}
