//! A [`Need`]: the sought quantity (squeeze, friction, load, arm, angle or force), the loads and the demand. A value of the quantity is an amount. It
//! is sufficient if the grasp meets the demand with it, for example holds the object. It is safe if it is sufficient also with less friction and
//! squeeze, or with larger loads. The squeeze is everything by which contacts press at rest without a load. At rest means before the loads of the
//! question act; the load at rest, if there is one, acts already.

use alloc::collections::BTreeMap;

use nalgebra::SVector;

use super::answer::Quantity;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsGiven;
use crate::squeeze::{LoadFields, Loads};
use crate::words::Words;

/// The condition that the grasp must meet with an amount, so that the amount is sufficient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Demand {
    /// The object is held; contacts may slide. The answer adds the amount with which nothing slides.
    #[default]
    Held,
    /// No contact slides or opens, and no drive exceeds its limit, while the load is applied.
    Sticks,
    /// The object comes to rest while the loads are applied and removed in turn, again and again; see [`Grasp::shake`](crate::ask::Grasp::shake).
    Rests,
    /// The object does not walk, that is, move on by the same amount in every cycle, while the loads are applied and removed in turn. Contacts may
    /// slide to and fro for ever.
    Stays,
}

impl Demand {
    /// Whether this demand is about loads that are applied and removed again and again.
    pub(super) fn repeats(self) -> bool {
        matches!(self, Self::Rests | Self::Stays)
    }
}

/// A question: the sought quantity, the loads, the demand and the deviations for the safe amount. [`Grasp::need`](crate::ask::Grasp::need) refuses
/// invalid values.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Need<const C: usize> {
    /// The sought quantity.
    pub(crate) quantity: Quantity,
    /// The demand that the amount has to meet: by default that the object is held. The answer then adds the amount with which nothing slides.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(super) demand: Demand,
    /// The load at rest; none if not given. It is constant, unless a force without `of` is sought: amounts then multiply the load at rest.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) base: Option<Wrench<C>>,
    /// The load that the grasp has to bear. If an arm is sought: the wrench of the force at the arm 0.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) load: Option<Wrench<C>>,
    /// Several loads that the grasp has to bear, one at a time.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub(super) loads: Vec<Wrench<C>>,
    /// Magnitude of a force of any direction, N, which acts at the point `at` in addition to `load`.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) any_force: Option<f64>,
    /// Point at which the force of any direction acts, m; the origin if not given.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub(super) at: Option<SVector<f64, C>>,
    /// A load that turns, in place of `load` and `loads`.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) turn: Option<Turn<C>>,
    /// For an arm: the change of the load per metre of displacement.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) per_metre: Option<Wrench<C>>,
    /// For friction: the index, from 0, of the contact whose coefficient is sought. If not given, one coefficient for all contacts is sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) contact: Option<usize>,
    /// For friction: indices of several contacts with one coefficient, instead of `contact`.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) contacts: Option<Vec<usize>>,
    /// For a force: the name of the part whose force is sought. This is the load of a body, or the command or force of a contact, link or joint. If
    /// not given, the load at rest, `base`, is sought.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) of: Option<String>,
    /// Loads on further bodies, by their names, which grow in proportion to `load`. If they are given, `base` must not be given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "BTreeMap::is_empty"))]
    pub(crate) together_with: BTreeMap<String, Wrench<C>>,
    /// For the safe amount: factor by which the loads are multiplied; 1 if not given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) safety: Option<f64>,
    /// For the safe amount: relative reduction of friction, from 0 to less than 1. The default is 0.1, or 0 if `safety` is given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) friction_less: Option<f64>,
    /// For the safe amount: relative reduction of the squeeze, from 0 to less than 1. The default is 0.05, or 0 if `safety` is given.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(super) squeeze_less: Option<f64>,
    /// Number of amounts that are tried on both sides of the least or greatest sufficient amount once this is found.
    #[cfg_attr(feature = "serde", serde(skip, default = "default_scan"))]
    pub(super) scan: usize,
    /// Format of numbers in the sentences about insufficient amounts.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) words: Words,
}

const fn default_scan() -> usize {
    6
}

impl<const C: usize> Need<C> {
    fn of(quantity: Quantity, loads: impl Into<Loads<C>>) -> Self {
        let LoadFields { load, loads, any_force, at, turn } = loads.into().into();
        Self {
            quantity,
            demand: Demand::default(),
            base: None,
            load,
            loads,
            any_force,
            at,
            turn,
            per_metre: None,
            contact: None,
            contacts: None,
            of: None,
            together_with: BTreeMap::new(),
            safety: None,
            friction_less: None,
            squeeze_less: None,
            scan: default_scan(),
            words: Words::default(),
        }
    }

    /// The least squeeze for these loads, as a multiple of the given squeeze.
    ///
    /// The squeeze consists of all commands of contacts, joints and tendons, and of the constant torques on joints; all are multiplied by the same
    /// number. [`Grasp::squeezed`](crate::ask::Grasp::squeezed) does this for a given number.
    #[doc(alias = "grip force")]
    #[doc(alias = "clamping force")]
    #[must_use]
    pub fn squeeze(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Quantity::Squeeze, loads)
    }

    /// The least coefficient of friction for these loads: the same μ for all contacts with friction, or for
    /// all contacts if none has friction. [Kinetic](crate::grasp::Contact::kinetic)
    /// coefficients keep their proportion to it.
    #[must_use]
    pub fn friction(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Quantity::Friction, loads)
    }

    /// The least coefficient of friction for these loads, one value for all the given contacts (indices from 0; a soft fingertip is one contact).
    /// Other contacts keep their coefficients.
    #[must_use]
    pub fn friction_of(contacts: impl IntoIterator<Item = usize>, loads: impl Into<Loads<C>>) -> Self {
        let contacts: Vec<_> = contacts.into_iter().collect();
        let (contact, contacts) =
            if contacts.len() == 1 { (Some(contacts[0]), None) } else { (None, Some(contacts)) };
        Self { contact, contacts, ..Self::friction(loads) }
    }

    /// The greatest multiple x of these loads with which the total load `base + x load` meets the demand; for a weight it gives the greatest mass.
    /// [`Self::on_top_of`] sets the load at rest, `base`.
    #[doc(alias = "payload")]
    #[must_use]
    pub fn load(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Quantity::Load, loads)
    }

    /// The greatest displacement x, m, of the point at which a force acts. The load is `at + x per_metre`: `at` is its wrench at x = 0 (N, N m),
    /// `per_metre` the change of that wrench per metre.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::Wrench;
    ///
    /// // How far out along x may 20 N hang?
    /// let [here, a_metre_on] = [0.0, 1.0].map(|x| Wrench::force_at([0.0, -20.0], [x, 0.0]));
    /// let arm = Need::arm(here, a_metre_on - here);
    /// # let _ = arm;
    /// ```
    #[doc(alias = "overhang")]
    #[doc(alias = "lever")]
    #[must_use]
    pub fn arm(at: Wrench<C>, per_metre: Wrench<C>) -> Self {
        Self { per_metre: Some(per_metre), ..Self::of(Quantity::Arm, at) }
    }

    /// The least force of the named part for these loads, as a multiple of its given force.
    ///
    /// The part may be a body, for example a lever or a screw: its force is the load on this body. For a contact, a cable or a joint it is the
    /// command or the constant force. All other parts keep their forces. If much larger multiples are insufficient again, the field `until` of
    /// [`Amount::Bound`](super::Amount::Bound) has the largest sufficient multiple.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
    ///
    /// // A screw drives the jaw of a vice with 500 N; the part is pulled across with 250 N, μ = 0.3 at both jaws.
    /// let jaw = |x: f64, way: f64| Contact::new([x, 0.0], [way, 0.0]).series_stiffness(1e7, 1e7).friction(0.3).on("part");
    /// let vice = Bodies::new([Body::new("part"), Body::new("jaw").load(Wrench::force([-500.0, 0.0]))])
    ///     .contacts([jaw(0.0, 1.0), jaw(0.06, -1.0).against("jaw")])
    ///     .links([Link::slide([0.08, 0.0], [1.0, 0.0], 0.03).to_ground("jaw")])
    ///     .grasp()?;
    /// let needed = vice.need(&Need::force("jaw", Wrench::force_at([0.0, 250.0], [0.03, 0.0])))?;
    /// assert!((needed.amount.bound().expect("some does") * 500.0 - 250.0 / 0.6).abs() < 1e-8);
    /// assert!(needed.to_string().starts_with("NEEDS 416.667 N on jaw so that it holds"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[doc(alias = "screw force", alias = "clamping force")]
    #[must_use]
    pub fn force(part: impl Into<String>, loads: impl Into<Loads<C>>) -> Self {
        Self { of: Some(part.into()), ..Self::of(Quantity::Force, loads) }
    }

    /// The least load at rest for these loads, as a multiple of the base load that [`Self::on_top_of`] sets, such as a weight that presses the object
    /// down.
    #[must_use]
    pub fn load_at_rest(loads: impl Into<Loads<C>>) -> Self {
        Self::of(Quantity::Force, loads)
    }

    /// The greatest angle by which a load may turn, rad, up to the last angle of the turn.
    #[doc(alias = "tilt")]
    #[must_use]
    pub fn angle(turn: Turn<C>) -> Self {
        Self::of(Quantity::Angle, Loads::Turn(turn))
    }

    /// This need with a load at rest (N, N m), which acts before the other loads and stays constant. For example, if the greatest push on an object
    /// is sought, the load at rest is its weight. Neither amounts nor factors of safety multiply it; only the amount of [`Self::load_at_rest`] does.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that hold 10 N carry 6 N. How much more along the same line?
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03), jaw(0.03)])?;
    /// let [weight, push] = [6.0, 1.0].map(|newtons| Wrench::force([0.0, -newtons]));
    /// let most = gripper.need(&Need::load(push).on_top_of(weight))?.amount.bound().expect("4 N");
    /// assert!((most - 4.0).abs() < 1e-11);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn on_top_of(mut self, base: Wrench<C>) -> Self {
        self.base = Some(base);
        self
    }

    /// This need with the demand that nothing slides, [`Demand::Sticks`].
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Of two jaws of unequal friction one slides before both do.
    /// let jaw = |x: f64, mu: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(mu).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, 0.4), jaw(0.03, 0.6)])?;
    /// let need = Need::squeeze(Wrench::force([0.0, -10.0])).if_lower_by(0.0, 0.0);
    /// let sticks = gripper.need(&need.to_stick())?.amount.bound().expect("some does");
    /// assert!((sticks - 5.0 / 4.0).abs() < 1e-11);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn to_stick(mut self) -> Self {
        self.demand = Demand::Sticks;
        self
    }

    /// This need with the demand that the object is held, [`Demand::Held`]: contacts may slide. The default.
    #[must_use]
    pub fn to_hold(mut self) -> Self {
        self.demand = Demand::Held;
        self
    }

    /// This need with the demand that the object comes to [rest](Demand::Rests) while the loads are applied and removed in turn, again and again.
    ///
    /// A load that turns goes to the end of its turn and back, or round and round in full turns. A force of any direction defines no order of loads
    /// and is refused.
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // A block of 10 N on two feet, pulled by 1.5 N and rocked by 3 N m to and fro: what one foot leaves the other has to hold.
    /// let foot = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(3e3, 1e3).friction(0.5);
    /// let block = Grasp::new([foot(-1.0), foot(1.0)])?;
    /// let rocked = [3.0, -3.0].map(|moment| Wrench::new([0.0, 0.0], moment));
    /// let need = Need::friction(rocked.to_vec()).on_top_of(Wrench::force([1.5, -10.0]));
    /// let least = |need: Need<2>| Ok::<_, grasp_lcp::Error>(block.need(&need)?.amount.bound().expect("some does"));
    /// assert!((least(need.clone().to_hold())? - 0.15).abs() < 1e-9);
    /// assert!((least(need.to_rest())? - 1.5 / (10.0 - 3.0)).abs() < 1e-9);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[doc(alias = "shakedown", alias = "vibration", alias = "cyclic load")]
    #[must_use]
    pub fn to_rest(mut self) -> Self {
        self.demand = Demand::Rests;
        self
    }

    /// This need with the demand that the object does not [walk](Demand::Stays) while the loads are applied and removed in turn, again and again.
    /// Contacts may slide to and fro for ever, so this demand is weaker than that of [`Self::to_rest`].
    #[must_use]
    pub fn to_stay(mut self) -> Self {
        self.demand = Demand::Stays;
        self
    }

    /// This need with a safe amount in the answer: the amount that is sufficient even if all coefficients of friction are lower by the fraction
    /// `friction`, and the squeeze by the fraction `squeeze`. Both fractions are from 0 to less than 1.
    ///
    /// Without this call the fractions are 0.1 and 0.05. If both are 0 and [`Self::with_safety`] does not enlarge the loads, the answer has no safe
    /// amount.
    #[must_use]
    pub fn if_lower_by(self, friction: f64, squeeze: f64) -> Self {
        self.if_friction_lower_by(friction).if_squeeze_lower_by(squeeze)
    }

    /// This need with a safe amount in the answer: the amount that is sufficient even if all coefficients of friction are lower by the fraction
    /// `part` (0.1 is 10 %), from 0 to less than 1. [`Self::if_lower_by`] lowers the squeeze, too.
    #[must_use]
    pub fn if_friction_lower_by(mut self, part: f64) -> Self {
        self.friction_less = Some(part);
        self
    }

    /// This need with a safe amount in the answer: the amount that is sufficient even if the squeeze is lower by the fraction `part` (0.1 is 10 %),
    /// from 0 to less than 1. [`Self::if_lower_by`] lowers the coefficients of friction, too.
    #[must_use]
    pub fn if_squeeze_lower_by(mut self, part: f64) -> Self {
        self.squeeze_less = Some(part);
        self
    }

    /// This need with a safe amount in the answer, for loads multiplied by `factor` in place of reduced friction and squeeze. After a later
    /// [`Self::if_lower_by`] the safe amount takes the larger loads and the reductions into account. The load at rest is not multiplied.
    #[doc(alias = "factor of safety")]
    #[must_use]
    pub fn with_safety(mut self, factor: f64) -> Self {
        (self.safety, self.friction_less, self.squeeze_less) = (Some(factor), None, None);
        self
    }

    /// This need with a load on another of several bodies. That load grows together with the single load of this need, see
    /// [`Grasp::growing_together`](crate::ask::Grasp::growing_together).
    #[must_use]
    pub fn together_with(mut self, body: impl Into<String>, load: Wrench<C>) -> Self {
        self.together_with.insert(body.into(), load);
        self
    }

    /// This need with the number format `words` in the sentences about insufficient amounts; by default numbers have 6 digits.
    #[must_use]
    pub fn with_words(mut self, words: Words) -> Self {
        self.words = words;
        self
    }

    /// This need with the number of amounts that are tried on both sides of the least or greatest sufficient amount once this is found; by default 6.
    /// They may show that amounts farther away are insufficient again, or sufficient again. With 0 no such amounts are tried.
    #[must_use]
    pub fn with_scan(mut self, amounts: usize) -> Self {
        self.scan = amounts;
        self
    }

    /// The load of the question, if it is given as a single load; or the constant load that acts together with a force of any direction.
    #[must_use]
    pub fn given_load(&self) -> Option<Wrench<C>> {
        self.load
    }

    /// The quantity that is sought.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// The load at rest, which acts before the other loads; zero if none was given.
    pub(crate) fn base(&self) -> Wrench<C> {
        self.base.unwrap_or(Wrench::ZERO)
    }
}
