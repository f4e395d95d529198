//! Questions about a scene: equilibrium, first slip under a growing or turning load, load path, and others.

use std::collections::BTreeMap;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::identify_asked::IdentifyAsked;
use super::improve_asked::ImproveAsked;
use super::need_asked::NeedAsked;
use super::object;
use super::shake_asked::{ShakeAsked, ShakedownAsked};
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::serial::AsGiven;
use crate::words::printable;

/// One question, `{"hold": …}`, `{"need": …}`, `{"improve": …}`, `{"solve": …}`, `{"onset": …}`, `{"onset_of_turn": …}`, `{"follow": …}`, `{"shake": …}`, `{"shakedown": …}` or `{"identify": …}`.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Self", rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Question<const C: usize> {
    /// Does the grasp hold the load, and what happens as the load is put on? See [`Grasp::hold`](crate::ask::Grasp::hold).
    Hold {
        /// The load that acts before and stays; zero if left out.
        #[serde(default = "no_load::<C>")]
        base: Wrench<C>,
        /// The load that grows from zero beside it.
        load: Wrench<C>,
        /// With several bodies: loads on other bodies, by name, that grow with the load; then without a base.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        together_with: BTreeMap<String, Wrench<C>>,
    },
    /// How much of a quantity does the grasp need? See [`Grasp::need`](crate::ask::Grasp::need).
    Need(Box<NeedAsked<C>>),
    /// Where should the fingers be? See [`Improve`](crate::improve::Improve).
    Improve(Box<ImproveAsked<C>>),
    /// The equilibrium under a load; see [`Grasp::solve`](crate::ask::Grasp::solve).
    Solve {
        /// The load; zero if left out.
        #[serde(default = "no_load::<C>")]
        load: Wrench<C>,
        /// With several bodies: loads on other bodies, by name.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        together_with: BTreeMap<String, Wrench<C>>,
    },
    /// The onset of sliding along a ramp; see [`Grasp::onset`](crate::ask::Grasp::onset).
    Onset(RampAsked<C>),
    /// The onset of sliding while a load turns; see [`Grasp::onset_of_turn`](crate::ask::Grasp::onset_of_turn).
    OnsetOfTurn(Turn<C>),
    /// The load path of a program; see [`Grasp::follow`](crate::ask::Grasp::follow) and
    /// [`Grasp::follow_in_steps`](crate::ask::Grasp::follow_in_steps).
    Follow {
        /// The load at the start; zero if left out.
        #[serde(default = "no_load::<C>")]
        start: Wrench<C>,
        /// The legs of the load program.
        legs: Vec<LegAsked<C>>,
        /// The error of forces that each leg may add, over the largest force, from 1e-9 to 1: the path is then followed in steps, for hundreds of
        /// contacts and more. Every event is found if left out.
        #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
        in_steps: Option<f64>,
    },
    /// Does the grasp survive a repeated load? See [`Grasp::shake`](crate::ask::Grasp::shake).
    Shake(Box<ShakeAsked<C>>),
    /// Does the grasp survive loads that repeat in any order? See [`Statics::shakedown`](crate::ask::Statics::shakedown).
    Shakedown(Box<ShakedownAsked<C>>),
    /// Which friction, loads of supports, squeeze or stiffness follow from observed slips? See [`Identify`](crate::identify::Identify).
    Identify(Box<IdentifyAsked<C>>),
}

/// The expected form of a question, in the error for a value that is no object, such as `"onset"` alone.
const QUESTION_FORM: &str = "a question with what it needs, such as {\"hold\": {\"load\": {\"force\": [0, -1]}}}, with three numbers in space";

/// A question that is read from an object; a name alone is refused with [`QUESTION_FORM`].
struct Named<const C: usize>(Question<C>);

impl<'de, const C: usize> Deserialize<'de> for Named<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        Question::deserialize(deserializer).map(Self)
    }
}

impl<'de, const C: usize> Deserialize<'de> for Question<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, QUESTION_FORM, |Named(question)| Ok(question))
    }
}

impl<const C: usize> Serialize for Question<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Question::serialize(self, serializer)
    }
}

/// A ramp: the load is `base + τ direction` at the factor τ, and commands change by τ times their change; see [`Ramp`](crate::load_path::Ramp).
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RampAsked<const C: usize> {
    /// The load at factor 0; zero if left out.
    #[serde(default = "no_load::<C>")]
    pub base: Wrench<C>,
    /// The change of the load per unit of the factor; zero if left out.
    #[serde(default = "no_load::<C>")]
    pub direction: Wrench<C>,
    /// The change of the finger commands per unit of the factor, one row for each contact, m; zero if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub command_change: Option<Commands<C>>,
    /// The change of a hand's commands per unit of the factor, one for each joint and then each tendon, rad or m; zero if left out.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    pub joint_change: Option<Vec<f64>>,
    /// With several bodies: loads on other bodies, by name, that grow with the direction; then without a base.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub together_with: BTreeMap<String, Wrench<C>>,
}

impl<const C: usize> Question<C> {
    /// The equilibrium under a load.
    #[must_use]
    pub fn solve(load: Wrench<C>) -> Self {
        Self::Solve { load, together_with: BTreeMap::new() }
    }
}

impl<const C: usize> RampAsked<C> {
    /// The ramp from zero load along a direction, with constant commands.
    #[must_use]
    pub fn along(direction: Wrench<C>) -> Self {
        Self {
            base: Wrench::ZERO,
            direction,
            command_change: None,
            joint_change: None,
            together_with: BTreeMap::new(),
        }
    }
}

pub(super) fn no_load<const C: usize>() -> Wrench<C> {
    Wrench::ZERO
}

/// Finger commands, or changes of commands, m: one row for each contact of the scene in its contact frame, normal component first. All points of a
/// soft fingertip have the row of their contact. Any other number of rows is an error when the question is read or answered.
///
/// ```
/// use grasp_lcp::scene::Commands;
///
/// let squeeze: Commands<2> = [[0.002, 0.0]; 3].into_iter().collect();
/// assert_eq!(squeeze.0[2].as_slice(), [0.002, 0.0]);
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(transparent)]
pub struct Commands<const C: usize>(
    #[serde(with = "AsGiven::<Vec<SVector<f64, C>>>")] pub Vec<SVector<f64, C>>,
);

impl<U: Into<[f64; C]>, const C: usize> FromIterator<U> for Commands<C> {
    fn from_iter<I: IntoIterator<Item = U>>(commands: I) -> Self {
        Self(commands.into_iter().map(|u| SVector::from(u.into())).collect())
    }
}

/// The target of a load or of commands along a leg, reached in a straight line.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal<T> {
    /// A change from the value at the beginning of the leg.
    By(T),
    /// The value at the end of the leg.
    To(T),
}

/// The change of the load along a leg.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadGoal<const C: usize> {
    /// The load changes in a straight line.
    Straight(Goal<Wrench<C>>),
    /// The load changes as that of the turn does, see [`crate::load_path::Leg::turn`].
    Turn(Turn<C>),
}

/// One leg of a load program, see [`crate::load_path::Leg`]: `load_by` or `load_to`, `commands_by` or `commands_to`, `joints_by` or `joints_to`,
/// `torques_by` or `torques_to`, or one of each pair; or a `turn` alone. Quantities without a field stay constant. With several bodies,
/// `body_loads_by` and `body_loads_to` have loads by name.
///
/// ```
/// use grasp_lcp::planar::{Turn, Wrench};
/// use grasp_lcp::scene::{Commands, Goal, LegAsked};
///
/// let grip = Commands(vec![[0.002, 0.0].into(); 2]);
/// let leg: LegAsked<2> = LegAsked::new(Some(Goal::To(Wrench::force([0.0, -1.0]))), Some(Goal::By(grip)));
/// let written = r#"{"load_to": {"force": [0, -1]}, "commands_by": [[0.002, 0], [0.002, 0]]}"#;
/// assert_eq!(serde_json::from_str::<LegAsked<2>>(written)?, leg);
///
/// let tilted: LegAsked<2> = serde_json::from_str(r#"{"turn": {"weight": [0, -2], "angle_deg": 90}}"#)?;
/// assert_eq!(tilted, LegAsked::turn(Turn::tilting([0.0, -2.0], [0.0, 0.0]).up_to(std::f64::consts::FRAC_PI_2)));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LegAsked<const C: usize> {
    /// The change of the load; `None` if it is constant.
    pub load: Option<LoadGoal<C>>,
    /// The change of the finger commands; `None` if they are constant.
    pub commands: Option<Goal<Commands<C>>>,
    /// The change of a hand's commands, one for each joint and then each tendon, rad or m; `None` if they are constant.
    pub joints: Option<Goal<Vec<f64>>>,
    /// The change of the torques that hold the joints of a hand; `None` if they are constant. One for each joint, N m or N; slides of contacts that
    /// are held by a force come last.
    pub torques: Option<Goal<Vec<f64>>>,
    /// The changes of loads on single bodies, by name.
    pub body_loads: BTreeMap<String, Goal<Wrench<C>>>,
}

impl<const C: usize> LegAsked<C> {
    /// A leg with a change of the load, of the commands, or of both.
    #[must_use]
    pub fn new(load: Option<Goal<Wrench<C>>>, commands: Option<Goal<Commands<C>>>) -> Self {
        let load = load.map(LoadGoal::Straight);
        Self { load, commands, joints: None, torques: None, body_loads: BTreeMap::new() }
    }

    /// A leg along which the load changes as a turn does; all commands stay.
    #[must_use]
    pub fn turn(turn: Turn<C>) -> Self {
        let load = Some(LoadGoal::Turn(turn));
        Self { load, commands: None, joints: None, torques: None, body_loads: BTreeMap::new() }
    }

    /// This leg with commands of a hand.
    #[must_use]
    pub fn with_joints(self, joints: Goal<Vec<f64>>) -> Self {
        Self { joints: Some(joints), ..self }
    }

    /// This leg with torques that hold the joints of a hand.
    #[must_use]
    pub fn with_torques(self, torques: Goal<Vec<f64>>) -> Self {
        Self { torques: Some(torques), ..self }
    }

    /// This leg with a change of the load on one body.
    #[must_use]
    pub fn with_body_load(mut self, body: impl Into<String>, load: Goal<Wrench<C>>) -> Self {
        self.body_loads.insert(body.into(), load);
        self
    }
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, bound = "")]
struct WrittenLeg<const C: usize> {
    /// The change of the load along the leg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    load_by: Option<Wrench<C>>,
    /// The load at the end of the leg, instead of `load_by`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    load_to: Option<Wrench<C>>,
    /// The change of the finger commands along the leg: one row for each contact, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    commands_by: Option<Commands<C>>,
    /// The finger commands at the end of the leg, instead of `commands_by`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    commands_to: Option<Commands<C>>,
    /// The change of the commands of joints and then tendons along the leg, rad or m.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    joints_by: Option<Vec<f64>>,
    /// The commands of joints and then tendons at the end of the leg, instead of `joints_by`.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    joints_to: Option<Vec<f64>>,
    /// The change along the leg of the torques that hold joints, N m or N: one for each joint; slides of contacts that are held by a force come last.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    torques_by: Option<Vec<f64>>,
    /// The torques that hold joints at the end of the leg, instead of `torques_by`.
    #[serde(default, with = "AsGiven::<Option<Vec<f64>>>", skip_serializing_if = "Option::is_none")]
    torques_to: Option<Vec<f64>>,
    /// The change of the loads of bodies along the leg, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    body_loads_by: BTreeMap<String, Wrench<C>>,
    /// The loads of bodies at the end of the leg, by name. A body is in at most one of the two lists.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    body_loads_to: BTreeMap<String, Wrench<C>>,
    /// The turn of the load along the leg, instead of all other fields.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    turn: Option<Turn<C>>,
}

impl<const C: usize> LegAsked<C> {
    /// The change of the load, or its final value, if the load changes in a straight line.
    pub(super) fn straight_load(&self) -> Option<Wrench<C>> {
        match self.load {
            Some(LoadGoal::Straight(Goal::By(load) | Goal::To(load))) => Some(load),
            _ => None,
        }
    }
}

/// The goal by one of two fields; giving both is an error.
fn goal<T>(by: Option<T>, to: Option<T>, names: [&str; 2]) -> Result<Option<Goal<T>>, String> {
    match (by, to) {
        (None, None) => Ok(None),
        (Some(by), None) => Ok(Some(Goal::By(by))),
        (None, Some(to)) => Ok(Some(Goal::To(to))),
        (Some(_), Some(_)) => Err(format!("{} and {}: a leg has one of them", names[0], names[1])),
    }
}

fn split<T: Clone>(goal: Option<&Goal<T>>) -> (Option<T>, Option<T>) {
    match goal {
        None => (None, None),
        Some(Goal::By(by)) => (Some(by.clone()), None),
        Some(Goal::To(to)) => (None, Some(to.clone())),
    }
}

impl<const C: usize> WrittenLeg<C> {
    /// The change of the load; giving it in two ways is an error.
    fn load(&self) -> Result<Option<LoadGoal<C>>, String> {
        let straight = goal(self.load_by, self.load_to, ["load_by", "load_to"])?;
        let Some(turn) = self.turn else { return Ok(straight.map(LoadGoal::Straight)) };
        let straight = straight.map(|goal| if matches!(goal, Goal::By(_)) { "load_by" } else { "load_to" });
        straight.map_or(Ok(Some(LoadGoal::Turn(turn))), |name| {
            Err(format!("{name} and turn: a leg has one of them"))
        })
    }

    /// The changes of the loads of bodies; giving one in two ways is an error.
    fn body_loads(&self) -> Result<BTreeMap<String, Goal<Wrench<C>>>, String> {
        if let Some(name) = self.body_loads_by.keys().find(|name| self.body_loads_to.contains_key(*name)) {
            return Err(format!("body_loads_by and body_loads_to: {} is in both", printable(name)));
        }
        let mut loads = BTreeMap::new();
        for (name, change) in &self.body_loads_by {
            loads.insert(name.clone(), Goal::By(*change));
        }
        for (name, load) in &self.body_loads_to {
            loads.insert(name.clone(), Goal::To(*load));
        }
        Ok(loads)
    }
}

impl<const C: usize> Serialize for LegAsked<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (straight, turn) = match &self.load {
            None => (None, None),
            Some(LoadGoal::Straight(goal)) => (Some(goal), None),
            Some(LoadGoal::Turn(turn)) => (None, Some(*turn)),
        };
        let (load_by, load_to) = split(straight);
        let (commands_by, commands_to) = split(self.commands.as_ref());
        let (joints_by, joints_to) = split(self.joints.as_ref());
        let (torques_by, torques_to) = split(self.torques.as_ref());
        let [mut body_loads_by, mut body_loads_to] = [BTreeMap::new(), BTreeMap::new()];
        for (name, goal) in &self.body_loads {
            match goal {
                Goal::By(change) => body_loads_by.insert(name.clone(), *change),
                Goal::To(load) => body_loads_to.insert(name.clone(), *load),
            };
        }
        WrittenLeg {
            load_by,
            load_to,
            commands_by,
            commands_to,
            joints_by,
            joints_to,
            torques_by,
            torques_to,
            body_loads_by,
            body_loads_to,
            turn,
        }
        .serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for LegAsked<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a leg", |written: WrittenLeg<C>| {
            let load = written.load()?;
            let body_loads = written.body_loads()?;
            let WrittenLeg {
                commands_by,
                commands_to,
                joints_by,
                joints_to,
                torques_by,
                torques_to,
                turn,
                ..
            } = written;
            let commands = goal(commands_by, commands_to, ["commands_by", "commands_to"])?;
            let joints = goal(joints_by, joints_to, ["joints_by", "joints_to"])?;
            let torques = goal(torques_by, torques_to, ["torques_by", "torques_to"])?;
            if turn.is_some() && (commands.is_some() || joints.is_some() || torques.is_some()) {
                return Err(Error::CommandsWhileTurning.to_string());
            }
            Ok(Self { load, commands, joints, torques, body_loads })
        })
    }
}

#[cfg(feature = "schema")]
schema_as_written!("Leg", LegAsked<C>, WrittenLeg<C>, C);
