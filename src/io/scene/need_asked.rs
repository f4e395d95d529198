//! The question for an amount, as a scene states it.

use std::collections::BTreeMap;

use nalgebra::SVector;

use super::setup::Setup;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::need::{Demand, Need, Quantity};
use crate::serial::AsGiven;
use crate::squeeze::Loads;

/// The question how much of a quantity a grasp needs, for loads given in one of four ways: `load`, `loads`, `any_force` or `turn`.
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 },
///             { "name": "right", "point": [0.03, 0], "normal": [-1, 0], "series_stiffness": [1e3, 8e2], "friction": 0.5, "pressed_with": 10 }
///         ],
///         "questions": [{ "need": { "quantity": "squeeze", "load": { "force": [0, -12] }, "friction_less": 0 } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = answers[0]["need"]["says"].as_str().unwrap_or_default();
/// let needs = "NEEDS 12 N at left and right so that it holds and nothing slides, 12.6316 N if the squeeze is 5 % less. With less: SLIPS OUT at 12 N of 12 N";
/// assert!(says.starts_with(needs), "{says}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct NeedAsked<const C: usize> {
    /// The sought quantity.
    pub quantity: Quantity,
    /// The demand on it: by default that the object is held. Then the answer adds the amount with which nothing slides.
    #[serde(default)]
    pub demand: Demand,
    /// The load at rest; none if left out. It is constant, except where a force without `of` is sought: then amounts multiply it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<Wrench<C>>,
    /// One load. For an arm: the wrench of the force at displacement 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Wrench<C>>,
    /// Several loads, one at a time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Wrench<C>>,
    /// Size of a force of any direction, N, which acts at the point `at` beside `load`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub any_force: Option<f64>,
    /// Point at which the force of any direction acts, m; the origin if left out.
    #[serde(default, with = "AsGiven::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub at: Option<SVector<f64, C>>,
    /// A load that turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Turn<C>>,
    /// For an arm: the change of the load per metre of displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub per_metre: Option<Wrench<C>>,
    /// For friction: the index, from 0, of the contact whose coefficient is sought; that of all contacts if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<usize>,
    /// For a force: the name of the body whose load is sought, or of the contact, link or joint whose command or force is. The load at rest, `base`,
    /// if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<String>,
    /// Loads of further bodies, by name, which grow together with `load`; without `base` then.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub together_with: BTreeMap<String, Wrench<C>>,
    /// For the safe amount: factor on the loads; 1 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub safety: Option<f64>,
    /// For the safe amount: relative reduction of friction, from 0 to less than 1. The default is 0.1, or 0 if `safety` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction_less: Option<f64>,
    /// For the safe amount: relative reduction of the squeeze, from 0 to less than 1. The default is 0.05, or 0 if `safety` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub squeeze_less: Option<f64>,
}

fn wrong(field: &'static str, fault: &'static str) -> Error {
    Error::Question { question: "need", field, fault }
}

impl<const C: usize> NeedAsked<C> {
    /// The question for a quantity, still without loads.
    #[must_use]
    pub fn of(quantity: Quantity) -> Self {
        Self {
            quantity,
            demand: Demand::default(),
            base: None,
            load: None,
            loads: Vec::new(),
            any_force: None,
            at: None,
            turn: None,
            per_metre: None,
            contact: None,
            of: None,
            together_with: BTreeMap::new(),
            safety: None,
            friction_less: None,
            squeeze_less: None,
        }
    }

    /// The loads, or an error unless they are given in exactly one way.
    fn loads(&self) -> Result<Loads<C>, Error> {
        let others = self.load.is_some() || !self.loads.is_empty() || self.any_force.is_some();
        match self.turn {
            Some(turn) if !others => Ok(Loads::Turn(turn)),
            Some(_) => Err(wrong("load", "is given twice, must be one of load, loads, any_force and turn")),
            None if !others => {
                Err(wrong("load", "is missing, must be one of load, loads, any_force and turn"))
            }
            None => loads_given("need", (self.load, &self.loads), (self.any_force, self.at)),
        }
    }
}

/// The loads of a question given in exactly one way: one, several, or a force of any direction, which may have one constant load beside it.
pub(super) fn loads_given<const C: usize>(
    question: &'static str,
    (load, loads): (Option<Wrench<C>>, &[Wrench<C>]),
    (any_force, at): (Option<f64>, Option<SVector<f64, C>>),
) -> Result<Loads<C>, Error> {
    let wrong = |field, fault| Err(Error::Question { question, field, fault });
    if at.is_some() && any_force.is_none() {
        return wrong("at", "is given, must be left out unless there is any_force (a load has its own)");
    }
    let (base, point) = (load.unwrap_or(Wrench::ZERO), at.map_or([0.0; C], Into::into));
    match (load, loads, any_force) {
        (Some(load), [], None) => Ok(load.into()),
        (None, [_, ..], None) => Ok(Loads::Each(loads.to_vec())),
        (_, [], Some(size)) => Ok(Loads::AnyForce { base, size, point }),
        (None, [], None) => wrong("load", "is missing, must be one of load, loads and any_force"),
        _ => wrong("load", "is given twice, must be one of load, loads and any_force"),
    }
}

impl<const C: usize> NeedAsked<C> {
    /// The load, if it is the only one and the quantity is neither an arm nor an angle.
    pub(super) fn only_load(&self) -> Option<Wrench<C>> {
        let others = self.loads.is_empty() && self.any_force.is_none() && self.turn.is_none();
        let sought = !matches!(self.quantity, Quantity::Arm | Quantity::Angle);
        self.load.filter(|_| others && sought)
    }

    /// The loads given as wrenches in `load` and `loads`.
    pub(super) fn put_on(&self) -> impl Iterator<Item = &Wrench<C>> {
        self.load.iter().chain(&self.loads)
    }
}

impl<const C: usize> Setup<C> {
    /// The [`Need`] of a grasp for a question of its scene. The friction of a soft fingertip is that of all its points.
    ///
    /// # Errors
    /// [`Error::Question`] unless loads are given in exactly one way, an arm with `per_metre`, an angle with `turn`, and no field of another
    /// quantity. [`Error::Argument`] for the index of a contact that the scene does not have, and for numbers out of range.
    pub fn need(&self, asked: &NeedAsked<C>) -> Result<Need<C>, Error> {
        let of_its_own = [
            (
                asked.per_metre.is_some(),
                Quantity::Arm,
                "per_metre",
                "is given, must be left out unless an arm is sought",
            ),
            (
                asked.contact.is_some(),
                Quantity::Friction,
                "contact",
                "is given, must be left out unless friction is sought",
            ),
            (
                asked.of.is_some(),
                Quantity::Force,
                "of",
                "is given, must be left out unless a force is sought",
            ),
        ];
        if let Some((.., field, fault)) =
            of_its_own.iter().find(|(given, of, ..)| *given && *of != asked.quantity)
        {
            return Err(wrong(field, fault));
        }
        if asked.at.is_some() && asked.any_force.is_none() {
            return Err(wrong(
                "at",
                "is given, must be left out unless there is any_force (a load has its own)",
            ));
        }
        let need = match asked.quantity {
            Quantity::Squeeze => Need::squeeze(asked.loads()?),
            Quantity::Load => Need::load(asked.loads()?),
            Quantity::Force => match &asked.of {
                Some(part) => Need::force(part.as_str(), asked.loads()?),
                None => Need::load_at_rest(asked.loads()?),
            },
            Quantity::Friction => match asked.contact {
                None => Need::friction(asked.loads()?),
                Some(contact) => Need::friction_of(self.points_of(contact)?, asked.loads()?),
            },
            Quantity::Arm => {
                let load = asked
                    .load
                    .ok_or_else(|| wrong("load", "is missing, must be given where an arm is sought"))?;
                let missing = "is missing, must be what a metre adds to the load where an arm is sought";
                let per_metre = asked.per_metre.ok_or_else(|| wrong("per_metre", missing))?;
                Need::arm(load, per_metre)
            }
            Quantity::Angle => {
                let missing = "is missing, must be given where an angle is sought";
                Need::angle(asked.turn.ok_or_else(|| wrong("turn", missing))?)
            }
        };
        let need = need.on_top_of(asked.base.unwrap_or(Wrench::ZERO));
        // The same as those of [`Need`]: other ones would make scenes and calls disagree.
        let [friction, squeeze] = if asked.safety.is_some() { [0.0; 2] } else { [0.1, 0.05] };
        let need = need
            .with_safety(asked.safety.unwrap_or(1.0))
            .if_lower_by(asked.friction_less.unwrap_or(friction), asked.squeeze_less.unwrap_or(squeeze));
        let need = match asked.demand {
            Demand::Sticks => need.to_stick(),
            Demand::Held => need.to_hold(),
            Demand::Rests => need.to_rest(),
            Demand::Stays => need.to_stay(),
        };
        need.check()?;
        Ok(need)
    }

    /// Indices in the grasp of the points of a contact of the scene; a soft fingertip has several.
    pub(super) fn points_of(&self, contact: usize) -> Result<Vec<usize>, Error> {
        let mut first = 0;
        for (index, entry) in self.entries().enumerate() {
            let count = entry.count()?;
            if index == contact {
                return Ok((first..first + count).collect());
            }
            first += count;
        }
        let (what, allowed) = ("number of the contact", "less than the number of contacts");
        Err(Error::Argument { what, value: contact as f64, allowed })
    }
}
