//! Answers to "at which load does the first contact leave rolling?"

use nalgebra::SVector;
use serde::{Deserialize, Serialize};

use super::equilibrium::{Equilibrium, Proof};
use super::fields::found;
use super::place::{Doing, Place, Places};
use crate::equilibrium::{Doubt, Rung, Settings};
use crate::grasp::{Grasp, Twist, Wrench};
use crate::load_path as path;

/// When the first contact leaves rolling; see [`path::Onset`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum OnsetAnswer<const D: usize, const C: usize> {
    /// At a load factor.
    At(Box<Onset<D, C>>),
    /// However far the load goes along this direction, everything keeps rolling.
    Never,
    /// At factor 0 something slides already.
    AlreadySliding {
        /// The equilibrium there.
        state: Box<Equilibrium<D, C>>,
    },
    /// No equilibrium exists at factor 0.
    NoBase(Proof<D, C>),
    /// No contact leaves rolling, but from this factor on nothing resists the load's direction.
    GivesWay {
        /// The factor up to which the grasp holds.
        #[serde(with = "found")]
        factor: f64,
        /// Why it does not hold beyond.
        reason: Proof<D, C>,
    },
    /// Nothing can be said about the equilibrium at factor 0.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

/// The first contact leaves rolling; see [`path::OnsetEvent`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Onset<const D: usize, const C: usize> {
    /// Load factor τ, no unit.
    #[serde(with = "found")]
    pub factor: f64,
    /// The load there.
    pub load: Wrench<D, C>,
    /// Which contacts leave, all at once.
    pub leaving: Vec<Leaving<C>>,
    /// What comes next.
    pub beyond: Beyond<D, C>,
    /// The equilibrium there.
    pub state: Equilibrium<D, C>,
}

/// A contact that leaves rolling.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Leaving<const C: usize> {
    /// Which contact.
    #[serde(flatten)]
    pub place: Place,
    /// How it leaves.
    #[serde(flatten)]
    pub how: Departure<C>,
}

/// How a contact leaves rolling.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "how", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Departure<const C: usize> {
    /// It slides.
    Slides {
        /// Unit direction in which the finger slips over the body, coordinate axes.
        #[serde(with = "found")]
        direction: SVector<f64, C>,
    },
    /// It opens.
    Opens,
}

/// What comes after an onset or the end of a path; see [`path::Beyond`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "what", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Beyond<const D: usize, const C: usize> {
    /// The equilibrium goes on, with these rates per unit of load factor.
    Continues {
        /// What every contact does next, in the order of [`Equilibrium::contacts`].
        states: Vec<Doing<C>>,
        /// Rates of the contact forces in the contact frames, N, contact by contact.
        #[serde(with = "found")]
        force_rates: Vec<SVector<f64, C>>,
        /// Rate of the object's twist, m and rad.
        twist_rate: Twist<D, C>,
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
        reason: Proof<D, C>,
    },
    /// Nothing can be said.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

impl<const D: usize, const C: usize> From<&path::Beyond<D, C>> for Beyond<D, C> {
    fn from(beyond: &path::Beyond<D, C>) -> Self {
        match beyond {
            path::Beyond::Continues(next) => Self::Continues {
                states: next.states.iter().map(|state| (*state).into()).collect(),
                force_rates: next.force_rates.clone(),
                twist_rate: next.twist_rate,
                rule: next.rule,
            },
            path::Beyond::LimitLoad => Self::LimitLoad,
            path::Beyond::Snap => Self::Snap,
            path::Beyond::Ends(none) => Self::Ends { reason: none.into() },
            path::Beyond::Undecided(doubt) => Self::Undecided { doubt: *doubt },
        }
    }
}

impl Places {
    pub(super) fn onset<const D: usize, const C: usize>(
        &self,
        grasp: &Grasp<D, C>,
        settings: &Settings,
        onset: &path::Onset<D, C>,
    ) -> OnsetAnswer<D, C> {
        match onset {
            path::Onset::At(event) => {
                let (beyond, state) = (grasp.beyond_with(event, settings), grasp.state_at_onset(event));
                // Both are there: the event is one of this grasp.
                let (Some(beyond), Some(state)) = (beyond, state) else {
                    return OnsetAnswer::Undecided { doubt: Doubt::Inaccurate };
                };
                OnsetAnswer::At(Box::new(Onset {
                    factor: event.factor,
                    load: event.load,
                    leaving: event.leaving.iter().map(|leaving| self.leaving(leaving)).collect(),
                    beyond: (&beyond).into(),
                    state: self.equilibrium(&state),
                }))
            }
            path::Onset::Never => OnsetAnswer::Never,
            path::Onset::AlreadySliding(state) => {
                OnsetAnswer::AlreadySliding { state: Box::new(self.equilibrium(state)) }
            }
            path::Onset::NoBase(none) => OnsetAnswer::NoBase(none.into()),
            path::Onset::GivesWay { factor, reason } => {
                OnsetAnswer::GivesWay { factor: *factor, reason: reason.into() }
            }
            path::Onset::Undecided(undecided) => OnsetAnswer::Undecided { doubt: undecided.doubt },
        }
    }

    fn leaving<const C: usize>(&self, leaving: &path::Leaving<C>) -> Leaving<C> {
        Leaving {
            place: self.0[leaving.contact].clone(),
            how: match leaving.how {
                path::Departure::Slides { direction } => Departure::Slides { direction },
                path::Departure::Opens => Departure::Opens,
            },
        }
    }
}
