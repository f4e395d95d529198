//! Slips that were seen, as a scene tells of them, and what is sought from them.

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::held::said;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::identify::{Ending, Identified, Identify, Slip, SlipKind, Unknown, UnknownKind};
use crate::load_path::Turn;
use crate::serial::AsGiven;
use crate::words::Words;

/// Friction, loads of supports, squeeze or stiffness from slips that were seen. See [`Identify`].
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
    /// What is sought.
    pub unknowns: Vec<UnknownAsked>,
    /// What was seen.
    pub slips: Vec<SlipAsked<C>>,
    /// Other places of the contacts of the scene, which slips were seen with: layout 1, and so on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layouts: Vec<ContactPoints<C>>,
    /// Sums of unknowns that are known from elsewhere.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<KnownSum>,
    /// Slips that are off by more standard deviations than this count less; 2 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub outliers: Option<f64>,
    /// At most so many steps of the search; 100 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub iterations: Option<usize>,
}

/// A number that is sought, one for all contacts that are meant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct UnknownAsked {
    /// What kind of number.
    pub quantity: UnknownKind,
    /// The contacts, from 0; all if left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<usize>,
    /// The layout that it is of, 0 for the scene as it is; all if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<usize>,
    /// What answers call it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Where the search begins; at what the scene says if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<f64>,
}

/// A slip that was seen under a load, or at the angle of a turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SlipAsked<const C: usize> {
    /// Which slip: gross unless said otherwise.
    #[serde(default)]
    pub slip: SlipKind,
    /// The load under which it was seen, grown from nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Wrench<C>>,
    /// In place of a load a turn up to the angle at which it was seen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Turn<C>>,
    /// What acted besides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<Wrench<C>>,
    /// How many times the squeeze of the scene; 1 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub squeeze: Option<f64>,
    /// Which layout; the scene as it is if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<usize>,
    /// Standard deviation of load or angle, as a part of it: of every slip, or of none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scatter: Option<f64>,
    /// A number that slips have in common that may share errors, of one direction or one specimen: of every slip, or of none.
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

/// What the sum of some unknowns is known to be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct KnownSum {
    /// The unknowns, from 0.
    pub unknowns: Vec<usize>,
    /// Their sum.
    pub value: f64,
    /// Its standard deviation, as a part of it.
    pub scatter: f64,
}

/// What slips tell; see [`Identified`].
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
    /// One number of this kind for all contacts.
    #[must_use]
    pub fn of(quantity: UnknownKind) -> Self {
        Self { quantity, contacts: Vec::new(), layout: None, name: None, start: None }
    }
}

impl KnownSum {
    /// The sum of these unknowns, with its standard deviation as a part of it.
    #[must_use]
    pub fn new(unknowns: impl IntoIterator<Item = usize>, value: f64, scatter: f64) -> Self {
        Self { unknowns: unknowns.into_iter().collect(), value, scatter }
    }
}

impl<const C: usize> SlipAsked<C> {
    /// Gross slip under a load that has grown from nothing.
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
    /// These numbers from these slips.
    #[must_use]
    pub fn new(unknowns: Vec<UnknownAsked>, slips: Vec<SlipAsked<C>>) -> Self {
        Self { unknowns, slips, layouts: Vec::new(), known: Vec::new(), outliers: None, iterations: None }
    }

    /// What acts before the load of the first slip that nothing but the grasp's own squeeze acts before, else that of the first.
    pub(super) fn at_rest(&self) -> Wrench<C> {
        let acts = |slip: &SlipAsked<C>| {
            slip.base.unwrap_or(Wrench::ZERO) + slip.turn.map_or(Wrench::ZERO, |turn| turn.load_at(0.0))
        };
        let mut all = self.slips.iter().map(acts);
        let carried = self.unknowns.iter().any(|unknown| unknown.quantity == UnknownKind::Carried);
        let first = all.next().unwrap_or(Wrench::ZERO);
        if carried || all.all(|acts| acts != Wrench::ZERO) { first } else { Wrench::ZERO }
    }
}

impl<const C: usize> Setup<C> {
    /// The question as the grasp has it, without its layouts. An unknown of a soft fingertip is that of all its points.
    fn sought(&self, asked: &IdentifyAsked<C>) -> Result<Identify<C>, Error> {
        let unknown = |given: &UnknownAsked| {
            let mut unknown = match given.quantity {
                UnknownKind::Friction => Unknown::friction(),
                UnknownKind::Carried => Unknown::carried(),
                UnknownKind::Squeeze => Unknown::squeeze(),
                UnknownKind::Stiffness => Unknown::stiffness(),
            };
            if !given.contacts.is_empty() {
                let points = given.contacts.iter().map(|contact| self.points_of(*contact));
                unknown = unknown.of_contacts(points.collect::<Result<Vec<_>, _>>()?.concat());
            }
            let unknown = given.layout.into_iter().fold(unknown, Unknown::in_layout);
            let unknown = given.name.iter().fold(unknown, Unknown::named);
            Ok(given.start.into_iter().fold(unknown, Unknown::starting_at))
        };
        let unknowns = asked.unknowns.iter().map(unknown).collect::<Result<Vec<_>, Error>>()?;
        let slips = asked.slips.iter().map(SlipAsked::as_seen).collect::<Result<Vec<_>, Error>>()?;
        let mut sought = Identify::new(unknowns, slips);
        for known in &asked.known {
            sought = sought.knowing(known.unknowns.iter().copied(), known.value, known.scatter);
        }
        let sought = asked.outliers.into_iter().fold(sought, Identify::with_outliers_beyond);
        Ok(asked.iterations.into_iter().fold(sought, Identify::with_iterations))
    }

    /// Refuses what can be told from the question alone.
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

    /// The question as the grasp has it.
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
        let layouts = asked.layouts.iter().map(moved).collect::<Result<Vec<_>, _>>()?;
        Ok(self.sought(asked)?.and_layouts(layouts))
    }
}

/// The name of how a search ended, in the words of the format.
pub(super) fn ended(ending: &Ending) -> &'static str {
    match ending {
        Ending::Converged => "converged",
        Ending::NotConverged { .. } => "not_converged",
        Ending::NotPredicted { .. } => "not_predicted",
    }
}
