//! Answers to "at which load does the first contact stop sticking?", and at which angle of a load that turns.

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use crate::ask::Grasp;
use crate::equilibrium::{Doubt, Equilibrium, NoEquilibrium, Undecided, WorkDone};
use crate::grasp::Wrench;
use crate::load_path::{
    self as path, Beyond, Change, ContactChange, Departure, Doing, EdgeOf, Leaving, PartChange, Touch,
    WholeChange, whole_changes,
};
use crate::serial::AsComputed;

/// When the first contact stops sticking, at a [`Factor`] or an [`Angle`]; see [`path::Onset`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum OnsetAnswer<const C: usize, At = Factor> {
    /// There.
    At(Box<OnsetAt<C, At>>),
    /// However far the load goes along this direction, everything keeps sticking; of a turn, up to its last angle.
    Never,
    /// Where the load begins something slides already.
    AlreadySliding {
        /// The equilibrium there.
        state: Box<Equilibrium<C>>,
    },
    /// No equilibrium exists where the load begins.
    NoBase(NoEquilibrium<C>),
    /// No contact stops sticking, but from here on nothing resists the load's direction.
    GivesWay {
        /// Up to where the grasp holds.
        #[serde(flatten)]
        at: At,
        /// Why it does not hold beyond.
        reason: NoEquilibrium<C>,
    },
    /// Nothing can be said about the equilibrium where the load begins.
    Undecided(Undecided),
}

/// Where an onset is while a load grows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Factor {
    /// Load factor τ, no unit.
    #[serde(with = "AsComputed::<f64>")]
    pub factor: f64,
}

/// Where an onset is while a load turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Angle {
    /// How far the load has turned, rad.
    #[serde(rename = "angle_rad", with = "AsComputed::<f64>")]
    pub angle: f64,
}

/// The first contact stops sticking; see [`path::OnsetEvent`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct OnsetAt<const C: usize, At = Factor> {
    /// Where.
    #[serde(flatten)]
    pub at: At,
    /// The load there.
    pub load: Wrench<C>,
    /// Which contacts leave, all at once.
    pub leaving: Vec<Leaving<C>>,
    /// Which joints and tendons give way there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<PartChange>,
    /// What comes next; rates are for one unit of the factor, or one radian.
    pub beyond: Beyond<C>,
    /// The equilibrium there.
    pub state: Equilibrium<C>,
}

impl<const C: usize, At> OnsetAt<C, At> {
    /// Who stops sticking, points of one soft fingertip together.
    #[must_use]
    pub fn whole_changes(&self) -> Vec<WholeChange<C>> {
        let change = |leaving: &Leaving<C>| {
            let what = match leaving.how {
                Departure::Slides { direction } => Change::Slides { direction },
                Departure::Opens => Change::Opens,
                Departure::WouldPull => return None,
            };
            Some(ContactChange { contact: leaving.contact.clone(), what })
        };
        let mut all = whole_changes(&self.state, &self.leaving.iter().filter_map(change).collect::<Vec<_>>());
        for leaving in self.leaving.iter().filter(|leaving| leaving.how == Departure::WouldPull) {
            let contact = leaving.contact.whole();
            if all.iter().all(|told| told.contact != contact || told.what != Doing::WouldPull) {
                all.push(WholeChange { contact, what: Doing::WouldPull });
            }
        }
        all
    }
}

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
/// let angle = answers[0]["onset_of_turn"]["angle_rad"].as_f64().unwrap();
/// assert!((2.0 * angle.sin() - 0.125 * (10.0 - 2.0 * angle.cos())).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TurnAnswer<const C: usize> {
    /// When the first contact stops sticking.
    #[serde(flatten)]
    pub onset: OnsetAnswer<C, Angle>,
    /// Where contacts and drives come as near to their edge as rounding without crossing it, up to the onset.
    pub touches: Vec<Touch>,
}

impl SceneNames {
    pub(super) fn onset<const C: usize, At>(
        &self,
        grasp: &Grasp<C>,
        onset: &path::Onset<C>,
        at: impl Fn(f64) -> At,
    ) -> OnsetAnswer<C, At> {
        let undecided = |doubt| OnsetAnswer::Undecided(Undecided { doubt, work: WorkDone::default() });
        match onset {
            path::Onset::At(event) => {
                // Both are there: the event is one of this grasp.
                let (Some(beyond), Some(state)) = (grasp.beyond(event), grasp.state_at_onset(event)) else {
                    return undecided(Doubt::Inaccurate);
                };
                let (load, drives, state) = (event.load, event.drives.clone(), self.equilibrium(state));
                let mut leaving = event.leaving.clone();
                for leaving in &mut leaving {
                    self.name(&mut leaving.contact);
                }
                let at = at(event.factor);
                OnsetAnswer::At(Box::new(OnsetAt { at, load, leaving, drives, beyond, state }))
            }
            path::Onset::Never => OnsetAnswer::Never,
            path::Onset::AlreadySliding(state) => {
                OnsetAnswer::AlreadySliding { state: Box::new(self.equilibrium(state.as_ref().clone())) }
            }
            path::Onset::NoBase(none) => OnsetAnswer::NoBase(none.clone()),
            path::Onset::GivesWay { factor, reason } => {
                OnsetAnswer::GivesWay { at: at(*factor), reason: reason.clone() }
            }
            path::Onset::Undecided(why) => undecided(why.doubt),
        }
    }

    pub(super) fn onset_of_turn<const C: usize>(
        &self,
        grasp: &Grasp<C>,
        found: &path::TurnOnset<C>,
    ) -> TurnAnswer<C> {
        let mut touches = found.touches.clone();
        for touch in &mut touches {
            if let EdgeOf::Contact(contact) = &mut touch.of {
                self.name(contact);
            }
        }
        TurnAnswer { onset: self.onset(grasp, &found.onset, |angle| Angle { angle }), touches }
    }
}
