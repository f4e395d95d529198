//! Answers about first slip, the event at which the first contact ceases to stick. They give the onset, i.e. the load factor of first slip, or the
//! angle of first slip under a turning load. A drive is the spring of a joint or tendon of a hand, with its force limit.

use crate::numerics::IntoList;
use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use crate::equilibrium::{Doubt, Equilibrium, NoEquilibrium, Undecided, WorkDone};
use crate::grasp::Wrench;
use crate::load_path::{
    self as path, Beyond, Change, ContactChange, DepartingContact, Departure, EdgeOf, EdgeTouch, PadChange,
    PartChange, WholeChange, whole_changes,
};
use crate::serial::AsComputed;

/// Whether and where first slip occurs, as a [`Factor`] or as an [`Angle`]; see [`path::Onset`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum OnsetAnswer<const C: usize, At = Factor> {
    /// The first contact stops sticking at this load factor or angle.
    At(Box<OnsetAt<C, At>>),
    /// All contacts keep sticking, however large the load grows, or up to the last angle of a turn.
    Never,
    /// A contact slides already at load factor or angle zero.
    AlreadySliding {
        /// The equilibrium at load factor or angle zero.
        state: Box<Equilibrium<C>>,
    },
    /// No equilibrium exists at load factor or angle zero.
    NoBase(NoEquilibrium<C>),
    /// No contact stops sticking, but beyond this load factor or angle no forces can balance the load.
    GivesWay {
        /// The load factor or angle up to which the grasp holds.
        #[serde(flatten)]
        at: At,
        /// The reason why no equilibrium exists beyond this load factor or angle.
        reason: NoEquilibrium<C>,
    },
    /// Whether an equilibrium exists at load factor or angle zero is undecided.
    Undecided(Undecided),
}

/// The load factor of first slip under a growing load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Factor {
    /// The load factor τ of first slip: the multiple of the growing load; it has no unit.
    #[serde(with = "AsComputed::<f64>")]
    pub factor: f64,
}

/// The angle of first slip under a turning load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Angle {
    /// The angle by which the load has turned, rad.
    #[serde(rename = "angle_rad", with = "AsComputed::<f64>")]
    pub angle: f64,
}

/// The event at which the first contact stops sticking; see [`path::OnsetEvent`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct OnsetAt<const C: usize, At = Factor> {
    /// The load factor or angle at first slip.
    #[serde(flatten)]
    pub at: At,
    /// The load at first slip.
    pub load: Wrench<C>,
    /// The contacts that stop sticking at this load, all at the same time.
    pub leaving: Vec<DepartingContact<C>>,
    /// The joints and tendons whose drives yield, hold again, slacken or tighten at this load.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<PartChange>,
    /// The behaviour just beyond first slip. Rates of change of forces and motions are per unit of the load factor, or per radian of the turn.
    pub beyond: Beyond<C>,
    /// The equilibrium at first slip.
    pub state: Equilibrium<C>,
}

impl<const C: usize, At> OnsetAt<C, At> {
    /// The contacts that stop sticking; all points of a soft fingertip count as one contact.
    #[must_use]
    pub fn whole_changes(&self) -> Vec<WholeChange<C>> {
        let change = |leaving: &DepartingContact<C>| {
            let what = match leaving.how {
                Departure::Slides { direction } => Change::Slides { direction },
                Departure::Opens => Change::Opens,
                Departure::WouldPull => return None,
            };
            Some(ContactChange { contact: leaving.contact.clone(), what })
        };
        let mut all = whole_changes(&self.state, &self.leaving.iter().filter_map(change).list());
        for leaving in self.leaving.iter().filter(|leaving| leaving.how == Departure::WouldPull) {
            let contact = leaving.contact.whole();
            if all.iter().all(|change| change.contact != contact || change.what != PadChange::WouldPull) {
                all.push(WholeChange { contact, what: PadChange::WouldPull });
            }
        }
        all
    }
}

/// First slip under a turning load, and the contacts and drives that touch the limit of their friction, torque or tension before;
/// see [`path::TurnOnset`].
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
    /// First slip as the load turns: the angle at which the first contact ceases to stick, or the reason why there is none.
    #[serde(flatten)]
    pub onset: OnsetAnswer<C, Angle>,
    /// Contacts and drives that before first slip reach the limit of their friction, torque or tension, up to rounding, without exceeding it.
    pub touches: Vec<EdgeTouch>,
    /// The fraction of the springs' resistance that geometric stiffness adds or takes away between the beginning of the turn and first slip, or the end
    /// of the turn; see [`Verdict::left_out`](crate::hold::Verdict::left_out).
    #[serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")]
    pub left_out: Option<f64>,
}

impl SceneNames<'_> {
    pub(super) fn onset<At>(&self, onset: &path::Onset<3>, at: impl Fn(f64) -> At) -> OnsetAnswer<3, At> {
        let undecided = |doubt| OnsetAnswer::Undecided(Undecided { doubt, work: WorkDone::default() });
        match onset {
            path::Onset::At(event) => {
                // The behaviour beyond the onset and the equilibrium at the onset both exist, since the event belongs to this grasp.
                let (Some(beyond), Some(state)) = (self.0.beyond(event), self.0.state_at_onset(event)) else {
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

    pub(super) fn onset_of_turn(&self, found: &path::TurnOnset<3>) -> TurnAnswer<3> {
        let mut touches = found.touches.clone();
        for touch in &mut touches {
            if let EdgeOf::Contact(contact) = &mut touch.of {
                self.name(contact);
            }
        }
        let state = |angle: f64| self.0.solve(found.turn.load_at(angle)).ok()?.equilibrium().cloned();
        let there = match &found.onset {
            path::Onset::At(event) => self.0.state_at_onset(event),
            path::Onset::Never => state(found.turn.angle()),
            _ => None,
        };
        let left_out = there.and_then(|there| self.0.engine.left_out_between(state(0.0).as_ref(), &there));
        TurnAnswer { onset: self.onset(&found.onset, |angle| Angle { angle }), touches, left_out }
    }
}
