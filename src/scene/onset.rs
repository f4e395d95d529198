//! Answers to "at which load does the first contact stop sticking?"

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::drive::DriveTurn;
use super::equilibrium::{Equilibrium, Proof, proof};
use super::place::{Doing, Place, Places};
use crate::ask::Grasp;
use crate::equilibrium::{Doubt, Rung};
use crate::grasp::{Motion, Wrench};
use crate::load_path as path;
use crate::serial::AsComputed;

/// When the first contact stops sticking; see [`path::Onset`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum OnsetAnswer<const C: usize> {
    /// At a load factor.
    At(Box<Onset<C>>),
    /// However far the load goes along this direction, everything keeps sticking.
    Never,
    /// At factor 0 something slides already.
    AlreadySliding {
        /// The equilibrium there.
        state: Box<Equilibrium<C>>,
    },
    /// No equilibrium exists at factor 0.
    NoBase(Proof<C>),
    /// No contact stops sticking, but from this factor on nothing resists the load's direction.
    GivesWay {
        /// The factor up to which the grasp holds.
        #[serde(with = "AsComputed::<f64>")]
        factor: f64,
        /// Why it does not hold beyond.
        reason: Proof<C>,
    },
    /// Nothing can be said about the equilibrium at factor 0.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

/// The first contact stops sticking; see [`path::OnsetEvent`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Onset<const C: usize> {
    /// Load factor τ, no unit.
    #[serde(with = "AsComputed::<f64>")]
    pub factor: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// Which contacts leave, all at once.
    pub leaving: Vec<Leaving<C>>,
    /// Which joints and tendons give way there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<DriveTurn>,
    /// What comes next.
    pub beyond: Beyond<C>,
    /// The equilibrium there.
    pub state: Equilibrium<C>,
}

/// A contact that stops sticking.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Leaving<const C: usize> {
    /// Which contact.
    #[serde(flatten)]
    pub place: Place,
    /// How it leaves.
    #[serde(flatten)]
    pub how: Departure<C>,
}

/// How a contact stops sticking.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "how", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Departure<const C: usize> {
    /// It slides.
    Slides {
        /// Unit direction in which the finger slips over the body, coordinate axes.
        #[serde(with = "AsComputed::<SVector<f64, C>>")]
        direction: SVector<f64, C>,
    },
    /// It opens.
    Opens,
}

/// What comes after an onset or the end of a path; see [`path::Beyond`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "what", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Beyond<const C: usize> {
    /// The equilibrium goes on, with these rates per unit of load factor.
    Continues {
        /// What every contact does next, in the order of [`Equilibrium::contacts`].
        states: Vec<Doing<C>>,
        /// Rates of the contact forces in the contact frames, N, contact by contact.
        #[serde(with = "AsComputed::<Vec<SVector<f64, C>>>")]
        force_rates: Vec<SVector<f64, C>>,
        /// Rate of the object's motion, m and rad, and of the joints'.
        twist_rate: Motion<C>,
        /// By which rule it was found.
        rule: Rung,
    },
    /// No equilibrium exists just beyond.
    LimitLoad,
    /// This equilibrium ends, others exist at slightly larger loads.
    Snap,
    /// This equilibrium ends; whether others exist is not known.
    Ends {
        /// Why.
        reason: Proof<C>,
    },
    /// Nothing can be said.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

impl Places {
    pub(super) fn onset<const C: usize>(&self, grasp: &Grasp<C>, onset: &path::Onset<C>) -> OnsetAnswer<C> {
        match onset {
            path::Onset::At(event) => {
                let (beyond, state) = (grasp.beyond(event), grasp.state_at_onset(event));
                // Both are there: the event is one of this grasp.
                let (Some(beyond), Some(state)) = (beyond, state) else {
                    return OnsetAnswer::Undecided { doubt: Doubt::Inaccurate };
                };
                OnsetAnswer::At(Box::new(Onset {
                    factor: event.factor,
                    load: event.load,
                    leaving: event.leaving.iter().map(|leaving| self.leaving(leaving)).collect(),
                    drives: self.turns(&event.drives),
                    beyond: told_beyond(&beyond),
                    state: self.equilibrium(&state),
                }))
            }
            path::Onset::Never => OnsetAnswer::Never,
            path::Onset::AlreadySliding(state) => {
                OnsetAnswer::AlreadySliding { state: Box::new(self.equilibrium(state)) }
            }
            path::Onset::NoBase(none) => OnsetAnswer::NoBase(proof(none)),
            path::Onset::GivesWay { factor, reason } => {
                OnsetAnswer::GivesWay { factor: *factor, reason: proof(reason) }
            }
            path::Onset::Undecided(undecided) => OnsetAnswer::Undecided { doubt: undecided.doubt },
        }
    }

    fn leaving<const C: usize>(&self, leaving: &path::Leaving<C>) -> Leaving<C> {
        Leaving {
            place: self.contacts[leaving.contact].clone(),
            how: match leaving.how {
                path::Departure::Slides { direction } => Departure::Slides { direction },
                path::Departure::Opens => Departure::Opens,
            },
        }
    }
}

/// What comes next, as it is written.
pub(super) fn told_beyond<const C: usize>(beyond: &path::Beyond<C>) -> Beyond<C> {
    match beyond {
        path::Beyond::Continues(next) => Beyond::Continues {
            states: next.states.iter().map(|state| (*state).into()).collect(),
            force_rates: next.force_rates.clone(),
            twist_rate: next.twist_rate.clone(),
            rule: next.rule,
        },
        path::Beyond::LimitLoad => Beyond::LimitLoad,
        path::Beyond::Snap => Beyond::Snap,
        path::Beyond::Ends(none) => Beyond::Ends { reason: proof(none) },
        path::Beyond::Undecided(doubt) => Beyond::Undecided { doubt: *doubt },
    }
}
