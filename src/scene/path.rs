//! Answers to "what happens along this load program?"

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::drive::{DriveTurn, Part};
use super::equilibrium::{Equilibrium, SolveAnswer};
use super::onset::{Beyond, told_beyond};
use super::place::{Place, Places};
use crate::equilibrium::Doubt;
use crate::grasp::{Motion, Wrench};
use crate::load_path as path;
use crate::serial::AsComputed;

/// A load path that was followed to its end; see [`path::LoadPath`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PathAnswer<const C: usize> {
    /// How it ended.
    #[serde(flatten)]
    pub end: PathEnd<C>,
    /// What happened on the way, in order.
    pub events: Vec<Event<C>>,
    /// Of every leg that was entered, up to where the path was followed.
    pub energies: Vec<Energy>,
    /// Sum of the estimated errors of the steps along sliding arcs, each relative as in
    /// [`Settings::step_error`](crate::Settings::step_error); 0 where every piece is straight.
    #[serde(with = "AsComputed::<f64>")]
    pub step_error: f64,
}

/// How a load path ends; see [`path::PathEnd`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[allow(clippy::large_enum_variant)] // one is made for a question
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum PathEnd<const C: usize> {
    /// All legs were followed to their end.
    Completed {
        /// The equilibrium there; left out where rounding does not allow it to be written down, and
        /// where there was no way to go.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        state: Option<Box<Equilibrium<C>>>,
    },
    /// This equilibrium ends.
    Lost {
        /// Where and how.
        #[serde(flatten)]
        loss: Loss<C>,
        /// Whether another exists just beyond.
        beyond: Beyond<C>,
    },
    /// There is no equilibrium to start from.
    NoStart {
        /// What there is.
        start: Box<SolveAnswer<C>>,
    },
    /// The path could not be followed further; it holds up to there.
    Undecided {
        /// The leg, from 0.
        leg: usize,
        /// How much of the leg has been gone.
        #[serde(with = "AsComputed::<f64>")]
        fraction: f64,
        /// Why.
        doubt: Doubt,
    },
}

/// Where an equilibrium cannot be continued; see [`path::Loss`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Loss<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone.
    #[serde(with = "AsComputed::<f64>")]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// What ends the equilibrium.
    pub kind: path::LossKind,
    /// The contacts that stand on the edge of their cone there.
    pub contacts: Vec<Place>,
    /// The joints and tendons that have reached their limit there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<Part>,
    /// The unit motion with which the object leaves, if the states determine one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<Motion<C>>,
}

/// Something changes on a load path; see [`path::Event`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Event<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone, from 0 to 1.
    #[serde(with = "AsComputed::<f64>")]
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// What changes, contact by contact.
    pub changes: Vec<Change<C>>,
    /// Which joints and tendons change what they do.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<DriveTurn>,
    /// Unit motions that nothing resists from here on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free_motions: Vec<Motion<C>>,
    /// Other ways in which the path could go on; 0 if the continuation is unique, left out if that
    /// is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_continuations: Option<usize>,
    /// The equilibrium there. Its states are those before the event.
    pub state: Equilibrium<C>,
}

/// A contact that changes its state.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Change<const C: usize> {
    /// Which contact.
    #[serde(flatten)]
    pub place: Place,
    /// What it does from here on.
    #[serde(flatten)]
    pub what: Turn<C>,
}

/// What a contact does from an event on; see [`path::Change`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "what", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Turn<const C: usize> {
    /// A sticking contact starts to slide.
    Slides {
        /// Unit direction in which the finger slips over the body, coordinate axes.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
    /// A sliding contact sticks.
    Sticks,
    /// A sliding contact slides back.
    Reverses {
        /// Its new direction.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
    /// A sliding contact turns to another edge of its cone (space).
    Turns {
        /// Its new direction.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
    /// A closed contact opens.
    Opens,
    /// An open contact closes and sticks.
    Closes,
    /// An open contact closes and slides from the start.
    ClosesSliding {
        /// Unit direction in which the finger slips over the body, coordinate axes.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
}

impl<const C: usize> From<path::Change<C>> for Turn<C> {
    fn from(change: path::Change<C>) -> Self {
        match change {
            path::Change::Slides { direction } => Self::Slides { direction },
            path::Change::Sticks => Self::Sticks,
            path::Change::Reverses { direction } => Self::Reverses { direction },
            path::Change::Turns { direction } => Self::Turns { direction },
            path::Change::Opens => Self::Opens,
            path::Change::Closes => Self::Closes,
            path::Change::ClosesSliding { direction } => Self::ClosesSliding { direction },
        }
    }
}

/// Energies of one leg, J; see [`path::Energy`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Energy {
    /// Work of the load on the object, `∫ W·dq`.
    #[serde(with = "AsComputed::<f64>")]
    pub load_work: f64,
    /// Work of the fingers' drives, `Σ ∫ F·du_f`.
    #[serde(with = "AsComputed::<f64>")]
    pub finger_work: f64,
    /// Change of the energy stored in the springs.
    #[serde(with = "AsComputed::<f64>")]
    pub stored: f64,
    /// Heat from friction, `Σ ∫ F_t·ds`, never negative.
    #[serde(with = "AsComputed::<f64>")]
    pub dissipated: f64,
    /// What does not balance, over the sum of the sizes of all contributions: zero in exact
    /// arithmetic.
    #[serde(with = "AsComputed::<f64>")]
    pub residual: f64,
}

impl Places {
    /// A path that was followed to its end, and the events on the way.
    pub(super) fn path<const C: usize>(
        &self,
        path: &path::LoadPath<'_, C>,
        events: &[path::Event<C>],
    ) -> PathAnswer<C> {
        PathAnswer {
            end: self.end(path),
            events: events.iter().map(|event| self.event(event)).collect(),
            energies: path
                .energies()
                .iter()
                .map(|energy| Energy {
                    load_work: energy.load_work,
                    finger_work: energy.finger_work,
                    stored: energy.stored,
                    dissipated: energy.dissipated,
                    residual: energy.residual(),
                })
                .collect(),
            step_error: path.step_error(),
        }
    }

    fn end<const C: usize>(&self, path: &path::LoadPath<'_, C>) -> PathEnd<C> {
        match path.end() {
            Some(path::PathEnd::Completed) => {
                PathEnd::Completed { state: path.state().map(|state| Box::new(self.equilibrium(&state))) }
            }
            Some(path::PathEnd::Lost(loss)) => {
                let beyond = path.beyond().unwrap_or(path::Beyond::Undecided(Doubt::OnTheBoundary));
                PathEnd::Lost { loss: self.loss(loss), beyond: told_beyond(&beyond) }
            }
            Some(path::PathEnd::NoStart(outcome)) => {
                PathEnd::NoStart { start: Box::new(self.outcome(outcome)) }
            }
            Some(path::PathEnd::Undecided { leg, fraction, doubt }) => {
                PathEnd::Undecided { leg: *leg, fraction: *fraction, doubt: *doubt }
            }
            None => PathEnd::Undecided { leg: 0, fraction: 0.0, doubt: Doubt::OutOfSteps },
        }
    }

    fn loss<const C: usize>(&self, loss: &path::Loss<C>) -> Loss<C> {
        Loss {
            leg: loss.leg,
            fraction: loss.fraction,
            load: loss.load,
            kind: loss.kind,
            contacts: self.many(&loss.contacts),
            drives: loss.drives.iter().map(|part| self.part(*part)).collect(),
            motion: loss.motion.clone(),
        }
    }

    fn event<const C: usize>(&self, event: &path::Event<C>) -> Event<C> {
        let change = |(contact, change): &(usize, path::Change<C>)| Change {
            place: self.contacts[*contact].clone(),
            what: (*change).into(),
        };
        Event {
            leg: event.leg,
            fraction: event.fraction,
            load: event.load,
            changes: event.changes.iter().map(change).collect(),
            drives: self.turns(&event.drives),
            free_motions: event.free_motions.clone(),
            other_continuations: event.other_continuations,
            state: self.equilibrium(&event.state),
        }
    }
}
