//! Answers to "at which angle does the first contact stop sticking while a load turns?"

use serde::{Deserialize, Serialize};

use super::drive::{DriveTurn, Part};
use super::equilibrium::{Equilibrium, Proof};
use super::onset::{Beyond, Leaving, Onset, OnsetAnswer};
use super::place::{Place, Places};
use crate::ask::Grasp;
use crate::equilibrium::Doubt;
use crate::grasp::Wrench;
use crate::load_path as path;
use crate::serial::AsComputed;

/// The onset of sliding while a load turns, and what comes near to one; see [`path::TurnOnset`].
///
/// A tray of 4 N between two palms that press with 10 N each, tilted from x to y until it slides:
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "contacts": [
///             { "point": [0, -0.01], "normal": [0, 1], "series_stiffness": [1e3, 8e2], "friction": 0.125, "pressed_with": 10 },
///             { "point": [0, 0.01], "normal": [0, -1], "series_stiffness": [1e3, 8e2], "friction": 0.125, "pressed_with": 10 }
///         ],
///         "questions": [{ "onset_of_turn": { "weight": [0, -4] } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// // Half of the weight a palm: the upper one carries F_n = 10 - 2 cos θ and F_t = 2 sin θ.
/// let angle = answers[0]["onset_of_turn"]["angle"].as_f64().unwrap();
/// assert!((2.0 * angle.sin() - 0.125 * (10.0 - 2.0 * angle.cos())).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TurnAnswer<const C: usize> {
    /// When the first contact stops sticking.
    #[serde(flatten)]
    pub onset: TurnOnset<C>,
    /// Where contacts and drives come as near to their edge as rounding without crossing it, up to the onset.
    pub touches: Vec<EdgeTouch>,
}

/// When the first contact stops sticking while a load turns; see [`path::Onset`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum TurnOnset<const C: usize> {
    /// At an angle.
    At(Box<TurnEvent<C>>),
    /// Everything keeps sticking up to the last angle.
    Never,
    /// At angle 0 something slides already.
    AlreadySliding {
        /// The equilibrium there.
        state: Box<Equilibrium<C>>,
    },
    /// No equilibrium exists at angle 0.
    NoBase(Proof<C>),
    /// No contact stops sticking, but from this angle on nothing resists the load.
    GivesWay {
        /// The angle up to which the grasp holds, rad.
        #[serde(with = "AsComputed::<f64>")]
        angle: f64,
        /// Why it does not hold beyond.
        reason: Proof<C>,
    },
    /// Nothing can be said about the equilibrium at angle 0.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

/// The first contact stops sticking while a load turns; see [`path::OnsetEvent`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TurnEvent<const C: usize> {
    /// How far the load has turned, rad.
    #[serde(with = "AsComputed::<f64>")]
    pub angle: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// Which contacts leave, all at once.
    pub leaving: Vec<Leaving<C>>,
    /// Which joints and tendons give way there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<DriveTurn>,
    /// What comes next; rates are for one radian.
    pub beyond: Beyond<C>,
    /// The equilibrium there.
    pub state: Equilibrium<C>,
}

/// An edge that is touched and not crossed while a load turns; see [`path::Touch`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EdgeTouch {
    /// What touches its edge.
    #[serde(flatten)]
    pub of: EdgeOf,
    /// Where, rad.
    #[serde(with = "AsComputed::<f64>")]
    pub angle: f64,
}

/// What has an edge to touch.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
#[non_exhaustive]
pub enum EdgeOf {
    /// A contact: its friction cone.
    Contact(Place),
    /// A joint or a tendon: its limit.
    Drive(Part),
}

impl<const C: usize> From<OnsetAnswer<C>> for TurnOnset<C> {
    /// The factor of an onset while a load turns is the angle.
    fn from(onset: OnsetAnswer<C>) -> Self {
        match onset {
            OnsetAnswer::At(onset) => {
                let Onset { factor, load, leaving, drives, beyond, state } = *onset;
                Self::At(Box::new(TurnEvent { angle: factor, load, leaving, drives, beyond, state }))
            }
            OnsetAnswer::Never => Self::Never,
            OnsetAnswer::AlreadySliding { state } => Self::AlreadySliding { state },
            OnsetAnswer::NoBase(proof) => Self::NoBase(proof),
            OnsetAnswer::GivesWay { factor, reason } => Self::GivesWay { angle: factor, reason },
            OnsetAnswer::Undecided { doubt } => Self::Undecided { doubt },
        }
    }
}

impl Places {
    pub(super) fn onset_of_turn<const C: usize>(
        &self,
        grasp: &Grasp<C>,
        found: &path::TurnOnset<C>,
    ) -> TurnAnswer<C> {
        TurnAnswer {
            onset: self.onset(grasp, &found.onset).into(),
            touches: found.touches.iter().map(|touch| self.edge_touch(touch)).collect(),
        }
    }

    /// A touch by what the scene knows it by.
    fn edge_touch(&self, touch: &path::Touch) -> EdgeTouch {
        let of = match touch.of {
            path::Leaver::Contact(contact) => EdgeOf::Contact(self.contacts[contact].clone()),
            path::Leaver::Drive(part) => EdgeOf::Drive(self.part(part)),
        };
        EdgeTouch { of, angle: touch.angle }
    }
}
