//! Questions about a scene: equilibrium, first slip under a growing or turning load, load path, and others. First slip is the event at which the
//! first contact ceases to stick; the onset is its load factor. The base load acts before the load of the question grows. A leg is a section of a
//! load program. A command is the displacement that a finger or joint would make without the object.

use std::collections::BTreeMap;

use crate::error::Error;
use crate::grasp::Wrench;
use crate::identify::Identify;
use crate::improve::Improve;
use crate::load_path::{Leg, Ramp, Turn};
use crate::need::Need;
use crate::serial::AsGiven;
use crate::serial::object::read_as_object;
use crate::squeeze::Loads;
use nalgebra::SVector;

/// One question, `{"hold": …}`, `{"need": …}`, `{"improve": …}`, `{"solve": …}`, `{"compare": …}`, `{"onset": …}`, `{"onset_of_turn": …}`, `{"follow": …}`, `{"shake": …}`, `{"shakedown": …}` or `{"identify": …}`.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Self", rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Question<const C: usize> {
    /// Does the grasp hold the load, and what happens while the load grows? See [`Grasp::hold`](crate::ask::Grasp::hold).
    Hold {
        /// The load that acts from the start and stays constant; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The load that grows from zero in addition to the base.
        load: Wrench<C>,
        /// With several bodies: loads on other bodies, by name, in proportion to the load. The base must then be left out.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        together_with: BTreeMap<String, Wrench<C>>,
    },
    /// Which amount of a quantity, such as squeeze or friction, does the grasp need? See [`Grasp::need`](crate::ask::Grasp::need).
    Need(Box<Need<C>>),
    /// At which places should the fingers touch? See [`Improve`].
    Improve(Box<Improve<C>>),
    /// The equilibrium under a load; see [`Grasp::solve`](crate::ask::Grasp::solve).
    Solve {
        /// The load; zero if left out.
        #[serde(default = "no_load::<C>")]
        load: Wrench<C>,
        /// With several bodies: loads on other bodies, by name.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        together_with: BTreeMap<String, Wrench<C>>,
    },
    /// Is the equilibrium under a load the minimum of energy, which the quadratic program of the paper computes? See
    /// [`Energy::compare`](crate::ask::Energy::compare).
    Compare {
        /// The load that acts from the start and stays constant; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The load that grows from zero in addition to the base.
        load: Wrench<C>,
    },
    /// The onset of sliding under a load that grows linearly: the load is `base + τ direction` at the load factor τ, and commands change by τ times
    /// their change. See [`Grasp::onset`](crate::ask::Grasp::onset).
    Onset {
        /// The load at load factor 0; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The change of the load per unit of the load factor; zero if left out.
        #[serde(default = "no_load::<C>")]
        direction: Wrench<C>,
        /// The change of the finger commands per unit of the load factor, one row for each contact, m; zero if left out.
        #[serde(
            default,
            with = "AsGiven::<Option<Vec<SVector<f64, C>>>>",
            skip_serializing_if = "Option::is_none"
        )]
        #[cfg_attr(feature = "schema", schemars(!default))]
        command_change: Option<Vec<SVector<f64, C>>>,
        /// The change of a hand's commands per unit of the load factor, one for each joint and then each tendon, rad or m; zero if left out.
        #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
        joint_change: Option<Vec<f64>>,
        /// With several bodies: loads on other bodies, by name, in proportion to the load factor. The base must then be left out.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        together_with: BTreeMap<String, Wrench<C>>,
    },
    /// The onset of sliding while a load turns; see [`Grasp::onset_of_turn`](crate::ask::Grasp::onset_of_turn).
    OnsetOfTurn(Turn<C>),
    /// The load path of a load program; see [`Grasp::follow`](crate::ask::Grasp::follow) and
    /// [`Grasp::follow_in_steps`](crate::ask::Grasp::follow_in_steps).
    Follow {
        /// The load at the start; zero if left out.
        #[serde(default = "no_load::<C>")]
        start: Wrench<C>,
        /// The legs of the load program.
        legs: Vec<Leg<C>>,
        /// Error that each leg may add to forces, relative to the largest force, from 1e-9 to 1. The path is then followed in steps, which suits
        /// hundreds of contacts. If left out, every change of the state of a contact is found.
        #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
        in_steps: Option<f64>,
    },
    /// Does the grasp survive a repeated load? See [`Grasp::shake`](crate::ask::Grasp::shake).
    Shake {
        /// The constant load, which acts alone at the beginning and the end of every cycle; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The loads in addition to the base, each applied and removed, one after the other.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        loads: Vec<Wrench<C>>,
        /// The legs of a cycle, instead of loads; loads and commands at the end of the cycle must equal those at its beginning.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        legs: Vec<Leg<C>>,
    },
    /// Does the grasp survive loads that repeat in any order? See [`Statics::shakedown`](crate::ask::Statics::shakedown).
    Shakedown {
        /// The constant load, to which the repeated loads are added; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The loads in addition to the base. Their order is arbitrary, and so is the path between them within their convex hull.
        loads: Vec<Wrench<C>>,
    },
    /// Which friction, loads of supports, squeeze or stiffness follow from observed slips? See [`Identify`].
    Identify(Box<Identify<C>>),
}

/// The form of a question in JSON. A value that is no JSON object, such as the string `"onset"`, is refused with this text.
const QUESTION_FORM: &str = "a question with what it needs, such as {\"hold\": {\"load\": {\"force\": [0, -1]}}}, with three numbers in space";

read_as_object!(QUESTION_FORM, Question, C);

impl<const C: usize> Question<C> {
    /// The base load, the growing loads, and the loads on other bodies that grow in proportion; for the questions `hold`, `solve` and `need`. `None`
    /// for other questions, and for a `need` without a growing load.
    #[must_use]
    pub fn loads(&self) -> Option<(Wrench<C>, Loads<C>, &BTreeMap<String, Wrench<C>>)> {
        match self {
            Self::Hold { base, load, together_with } => Some((*base, (*load).into(), together_with)),
            Self::Solve { load, together_with } => Some((Wrench::ZERO, (*load).into(), together_with)),
            Self::Need(asked) => asked.loads().map(|loads| (asked.base(), loads, &asked.together_with)),
            _ => None,
        }
    }

    /// The constant load of this question (base load or load at the start), which acts before its other loads. `None` for `solve`, `onset_of_turn`
    /// and `identify`, which have none.
    #[must_use]
    pub fn base(&self) -> Option<Wrench<C>> {
        Some(match self {
            Self::Hold { base, .. }
            | Self::Compare { base, .. }
            | Self::Onset { base, .. }
            | Self::Shake { base, .. }
            | Self::Shakedown { base, .. } => *base,
            Self::Follow { start, .. } => *start,
            Self::Need(asked) => asked.base(),
            Self::Improve(asked) => asked.base(),
            Self::Solve { .. } | Self::OnsetOfTurn(_) | Self::Identify(_) => return None,
        })
    }

    /// The question for the equilibrium under a load.
    #[must_use]
    pub fn solve(load: Wrench<C>) -> Self {
        Self::Solve { load, together_with: BTreeMap::new() }
    }

    /// The question for the onset of sliding along a [`Ramp`], or under a load that grows from zero.
    pub fn onset(ramp: impl Into<Ramp<C>>) -> Self {
        let Ramp { base, direction, command_change, joint_change } = ramp.into();
        Self::Onset { base, direction, command_change, joint_change, together_with: BTreeMap::new() }
    }

    /// The base load and the growing load of [`Self::Hold`], [`Self::Compare`] and [`Self::Onset`]; for an onset also the changes of commands and
    /// joint commands. If the question has further growing loads, on single bodies (`together_with`), the ramp leaves them out.
    ///
    /// # Errors
    /// [`Error::Question`] for other questions, whose loads do not grow linearly.
    pub fn ramp(&self) -> Result<Ramp<C>, Error> {
        match self {
            Self::Hold { base, load, .. } | Self::Compare { base, load } => Ok(Ramp::load(*base, *load)),
            Self::Onset { base, direction, command_change, joint_change, .. } => Ok(Ramp {
                base: *base,
                direction: *direction,
                command_change: command_change.clone(),
                joint_change: joint_change.clone(),
            }),
            _ => Err(Error::Question {
                question: "ramp",
                field: "load",
                fault: "does not grow, must be that of hold, compare or onset",
            }),
        }
    }

    /// The legs of [`Self::Follow`], or of one cycle of [`Self::Shake`], which may be given as loads.
    ///
    /// # Errors
    /// [`Error::Question`] for a [`Self::Shake`] with both loads and legs or with neither, and for other questions.
    pub fn legs(&self) -> Result<Vec<Leg<C>>, Error> {
        let (loads, legs) = match self {
            Self::Follow { legs, .. } => return Ok(legs.clone()),
            Self::Shake { loads, legs, .. } => (&loads[..], &legs[..]),
            _ => (&[][..], &[][..]),
        };
        let wrong = |field, fault| Err(Error::Question { question: "shake", field, fault });
        match (loads, legs) {
            ([], []) => wrong("loads", "are missing, must be given, or legs in their place"),
            ([_, ..], [_, ..]) => wrong("legs", "are given beside loads, must be one of them"),
            _ => {
                let mut all = legs.to_vec();
                for load in loads {
                    all.extend(Leg::there_and_back(*load));
                }
                Ok(all)
            }
        }
    }
}

pub(super) fn no_load<const C: usize>() -> Wrench<C> {
    Wrench::ZERO
}
