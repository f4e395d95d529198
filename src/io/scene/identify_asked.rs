//! Observed slips as a scene gives them, and the unknowns that are sought from them.

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::held::said;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::identify::{Ending, Identified, Identify, Slip, SlipKind, Unknown, UnknownKind};
use crate::load_path::Turn;
use crate::numerics::tried;
use crate::serial::AsGiven;
use crate::words::Words;

/// Friction, loads of supports, squeeze or stiffness from observed slips. See [`Identify`].
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
///         "questions": [{ "identify": {
///             "unknowns": [{ "quantity": "friction" }],
///             "slips": [{ "load": { "force": [0, -6.1] } }, { "load": { "force": [0, -5.8] } }, { "load": { "force": [0, -6.4] } }]
///         } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// let says = "friction 0.3048 ± 0.0087 (95 %: 0.2697 to 0.3444) from 3 slips, which scatter by 5.1 %";
/// assert_eq!(answers[0]["identify"]["says"], says);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct IdentifyAsked<const C: usize> {
    /// The unknowns.
    pub unknowns: Vec<UnknownAsked>,
    /// The observed slips.
    pub slips: Vec<SlipAsked<C>>,
    /// Other places of the scene's contacts at which slips were observed: layout 1, and so on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layouts: Vec<ContactPoints<C>>,
    /// Sums of unknowns that are known from elsewhere.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<KnownSum>,
    /// Slips that are off by more than this number of standard deviations count less; 2 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub outliers: Option<f64>,
    /// Largest number of steps of the search; 100 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub iterations: Option<usize>,
}

/// One unknown number, the same for all its contacts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct UnknownAsked {
    /// The kind of the unknown.
    pub quantity: UnknownKind,
    /// The contacts of the unknown, from 0; all if left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<usize>,
    /// The layout of the unknown, 0 for the scene itself; all if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<usize>,
    /// The name of the unknown in answers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Start of the search; the value of the scene if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<f64>,
}

/// A slip that was observed under a load, or at the angle of a turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SlipAsked<const C: usize> {
    /// First or gross slip; gross if left out.
    #[serde(default)]
    pub slip: SlipKind,
    /// The load at the slip, grown from zero.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Wrench<C>>,
    /// A turn up to the angle at the slip, instead of a load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Turn<C>>,
    /// The constant load beside it; zero if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<Wrench<C>>,
    /// Factor on the squeeze of the scene; 1 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub squeeze: Option<f64>,
    /// The layout in which the slip was observed; 0, the scene itself, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<usize>,
    /// Relative standard deviation of load or angle; for every slip, or for none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scatter: Option<f64>,
    /// A number that is the same for slips that may share an error, of one direction or one specimen; for every slip, or for none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<usize>,
}

/// Points of contact, m: one for each contact of the scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(transparent)]
pub struct ContactPoints<const C: usize>(
    #[serde(with = "AsGiven::<Vec<SVector<f64, C>>>")] pub Vec<SVector<f64, C>>,
);

/// A sum of unknowns that is known from elsewhere.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct KnownSum {
    /// The unknowns of the sum, from 0.
    pub unknowns: Vec<usize>,
    /// The value of the sum.
    pub value: f64,
    /// The relative standard deviation of the sum.
    pub scatter: f64,
}

/// The unknowns with their errors; see [`Identified`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct IdentifyAnswer {
    /// The answer in a sentence.
    pub says: String,
    /// The answer.
    #[serde(flatten)]
    pub identified: Identified,
}

impl IdentifyAnswer {
    pub(super) fn of(identified: Identified, words: Words) -> Self {
        Self { says: said(&identified, words), identified }
    }
}

fn wrong<T>(field: &'static str, fault: &'static str) -> Result<T, Error> {
    Err(Error::Question { question: "identify", field, fault })
}

impl UnknownAsked {
    /// One unknown of this kind for all contacts.
    #[must_use]
    pub fn of(quantity: UnknownKind) -> Self {
        Self { quantity, contacts: Vec::new(), layout: None, name: None, start: None }
    }
}

impl KnownSum {
    /// A known sum of these unknowns, with its relative standard deviation.
    #[must_use]
    pub fn new(unknowns: impl IntoIterator<Item = usize>, value: f64, scatter: f64) -> Self {
        Self { unknowns: unknowns.into_iter().collect(), value, scatter }
    }
}

impl<const C: usize> SlipAsked<C> {
    /// Gross slip under a load that has grown from zero.
    #[must_use]
    pub fn gross(load: Wrench<C>) -> Self {
        let (slip, load) = (SlipKind::Gross, Some(load));
        Self { slip, load, turn: None, base: None, squeeze: None, layout: None, scatter: None, group: None }
    }

    fn as_seen(&self) -> Result<Slip<C>, Error> {
        let slip = match (self.slip, self.load, self.turn) {
            (SlipKind::First, Some(load), None) => Slip::first(load),
            (SlipKind::Gross, Some(load), None) => Slip::gross(load),
            (SlipKind::First, None, Some(turn)) => Slip::first_on_turn(turn),
            (SlipKind::Gross, None, Some(turn)) => Slip::gross_on_turn(turn),
            (_, None, None) => {
                return wrong("slips", "have one without load and turn, each must have one of them");
            }
            (_, Some(_), Some(_)) => {
                return wrong("slips", "have one with load and turn, each must have one of them");
            }
        };
        let slip = slip
            .on_top_of(self.base.unwrap_or(Wrench::ZERO))
            .squeezed(self.squeeze.unwrap_or(1.0))
            .in_layout(self.layout.unwrap_or(0));
        let slip = self.scatter.into_iter().fold(slip, Slip::scattering_by);
        Ok(self.group.into_iter().fold(slip, Slip::in_group))
    }
}

impl<const C: usize> IdentifyAsked<C> {
    /// These unknowns from these slips.
    #[must_use]
    pub fn new(unknowns: Vec<UnknownAsked>, slips: Vec<SlipAsked<C>>) -> Self {
        Self { unknowns, slips, layouts: Vec::new(), known: Vec::new(), outliers: None, iterations: None }
    }

    /// Whether forces that contacts carry at rest are unknown, so that the scene need not state what presses.
    pub(super) fn seeks_carried(&self) -> bool {
        self.unknowns.iter().any(|unknown| unknown.quantity == UnknownKind::Carried)
    }

    /// The load before a slip's own load, for the check of contacts at rest: zero if some slip has none and no carried force is sought, else that of
    /// the first slip.
    pub(super) fn at_rest(&self) -> Wrench<C> {
        let acts = |slip: &SlipAsked<C>| {
            slip.base.unwrap_or(Wrench::ZERO) + slip.turn.map_or(Wrench::ZERO, |turn| turn.load_at(0.0))
        };
        let mut all = self.slips.iter().map(acts);
        let first = all.next().unwrap_or(Wrench::ZERO);
        if self.seeks_carried() || all.all(|acts| acts != Wrench::ZERO) { first } else { Wrench::ZERO }
    }
}

impl<const C: usize> Setup<C> {
    /// The question for the grasp, without its layouts. An unknown of a soft fingertip belongs to all its points.
    fn sought(&self, asked: &IdentifyAsked<C>) -> Result<Identify<C>, Error> {
        let unknown = |given: &UnknownAsked| {
            let mut unknown = match given.quantity {
                UnknownKind::Friction => Unknown::friction(),
                UnknownKind::Carried => Unknown::carried(),
                UnknownKind::Squeeze => Unknown::squeeze(),
                UnknownKind::Stiffness => Unknown::stiffness(),
            };
            if !given.contacts.is_empty() {
                let points = tried(&given.contacts, &|contact| self.points_of(*contact))?;
                unknown = unknown.of_contacts(points.concat());
            }
            if let Some(layout) = given.layout {
                unknown = unknown.in_layout(layout);
            }
            if let Some(name) = &given.name {
                unknown = unknown.named(name);
            }
            Ok(match given.start {
                Some(start) => unknown.starting_at(start),
                None => unknown,
            })
        };
        let unknowns = tried(&asked.unknowns, &unknown)?;
        let slips = tried(&asked.slips, &SlipAsked::as_seen)?;
        let mut sought = Identify::new(unknowns, slips);
        for known in &asked.known {
            sought = sought.knowing(known.unknowns.iter().copied(), known.value, known.scatter);
        }
        let sought = asked.outliers.into_iter().fold(sought, Identify::with_outliers_beyond);
        Ok(asked.iterations.into_iter().fold(sought, Identify::with_iterations))
    }

    /// Refuses faults that show without building the layouts.
    pub(super) fn check_identify(&self, asked: &IdentifyAsked<C>) -> Result<(), Error> {
        if !asked.layouts.is_empty() && (self.is_held_by_a_hand() || !self.bodies.is_empty()) {
            return wrong(
                "layouts",
                "are given, must be left out of a grasp with joints or of several bodies",
            );
        }
        for points in &asked.layouts {
            let (given, expected) = (points.0.len(), self.contacts.len());
            if given != expected {
                return Err(Error::Size { what: "points of a layout", given, expected });
            }
        }
        self.sought(asked)?.check_numbers(1 + asked.layouts.len())
    }

    /// The question for the grasp.
    ///
    /// # Errors
    /// [`Error::Question`] unless every slip has a load or a turn; [`Error::Size`] unless every layout has a point for each contact; as for
    /// [`Identify::answered_by`] and [`Self::grasp`].
    pub fn identify(&self, asked: &IdentifyAsked<C>) -> Result<Identify<C>, Error> {
        self.check_identify(asked)?;
        let moved = |points: &ContactPoints<C>| -> Result<Grasp<C>, Error> {
            let mut setup = self.clone();
            let contacts = setup.contacts.iter_mut().zip(&points.0);
            contacts.for_each(|(entry, point)| entry.contact.point = *point);
            setup.grasp()
        };
        let layouts = tried(&asked.layouts, &moved)?;
        Ok(self.sought(asked)?.and_layouts(layouts))
    }
}

/// The name of the search's end in the format.
pub(super) fn ended(ending: &Ending) -> &'static str {
    match ending {
        Ending::Converged => "converged",
        Ending::NotConverged { .. } => "not_converged",
        Ending::NotPredicted { .. } => "not_predicted",
    }
}
