//! Answers to "what is the equilibrium under this load?"

use serde::{Deserialize, Serialize};

use super::drive::{JointTold, TendonTold};
use super::place::{Places, Touch};
use crate::ask::Grasp;
use crate::contact::PolygonCone;
use crate::equilibrium::{self as state, Doubt, NoEquilibrium, Outcome, Rung};
use crate::grasp::{Motion, Twist, Wrench};
use crate::serial::AsComputed;

/// How a question for an equilibrium ends; see [`Outcome`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum SolveAnswer<const C: usize> {
    /// The grasp holds.
    Equilibrium(Box<Equilibrium<C>>),
    /// No equilibrium exists under this load.
    NoEquilibrium(Proof<C>),
    /// None was found and none was ruled out.
    Undecided {
        /// Why.
        doubt: Doubt,
    },
}

/// Why no equilibrium exists, and how that is known; see [`state::Proof`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "proof", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Proof<const C: usize> {
    /// No contact resists this unit motion in any state, and the load works on it.
    FreeMotion {
        /// The motion.
        motion: Motion<C>,
        /// Work of the load on it, positive, J.
        #[serde(with = "AsComputed::<f64>")]
        work: f64,
    },
    /// No admissible contact force works against this unit motion, and the load drives it.
    SeparatingMotion {
        /// The motion.
        motion: Motion<C>,
        /// Work of the load on it, positive, J.
        #[serde(with = "AsComputed::<f64>")]
        work: f64,
    },
    /// Every combination of contact states was tried; each violates a condition clearly.
    EveryStateTried {
        /// How many combinations.
        combinations: usize,
    },
    /// On the round cone every case of contact states and directions of friction contradicts itself.
    EveryCaseContradicted {
        /// How many cases.
        cases: usize,
        /// By this factor an equilibrium that rounding has hidden would have to exceed the data.
        escape: f64,
    },
}

/// An equilibrium; see [`state::Equilibrium`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Equilibrium<const C: usize> {
    /// The load it balances.
    pub load: Wrench<C>,
    /// Motion of the object: translation of the origin (m) and rotation (rad).
    pub twist: Twist<C>,
    /// Contact by contact, in the order of the scene; a soft fingertip point by point.
    pub contacts: Vec<Touch<C>>,
    /// Joint by joint, finger by finger.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<JointTold>,
    /// Tendon by tendon.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tendons: Vec<TendonTold>,
    /// How well it satisfies the conditions, recomputed from the question.
    pub residuals: Residuals,
    /// How far it is from the exact answer: of the answer to `solve`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// The friction cone it is for.
    pub cone: Cone,
    /// By which rule it was found; there may be others.
    pub rule: Rung,
    /// Energy stored in the springs, J.
    #[serde(with = "AsComputed::<f64>")]
    pub stored_energy: f64,
    /// Unit motions that no contact resists, m and rad: the twist is known up to them. What counts
    /// as one unit says [`state::Equilibrium::free_motions`].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free_motions: Vec<Motion<C>>,
    /// Unit motions along which the object stays in equilibrium while its forces change.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub neutral_motions: Vec<Motion<C>>,
    /// The largest change of a contact force, N, from the answer of the polygon that the search
    /// started from, if it did.
    #[serde(default, with = "AsComputed::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    pub change_from_polygon: Option<f64>,
    /// Pivots of Lemke's method.
    pub pivots: usize,
}

/// The friction cone that an equilibrium is for; see [`state::Cone`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Cone {
    /// In the plane, where nothing is approximated.
    Planar,
    /// A polygon in place of the round cone.
    Polygon(PolygonCone),
    /// The round cone in space.
    Round,
}

/// Relative residuals, zero in exact arithmetic; see [`state::Residuals`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Residuals {
    /// Of the balance of forces and moments.
    #[serde(with = "AsComputed::<f64>")]
    pub equilibrium: f64,
    /// Of the contact springs.
    #[serde(with = "AsComputed::<f64>")]
    pub springs: f64,
    /// Of the friction cone.
    #[serde(with = "AsComputed::<f64>")]
    pub cone: f64,
    /// Penetration.
    #[serde(with = "AsComputed::<f64>")]
    pub gap: f64,
    /// Of the products that must vanish.
    #[serde(with = "AsComputed::<f64>")]
    pub complementarity: f64,
}

impl From<state::Residuals> for Residuals {
    fn from(r: state::Residuals) -> Self {
        Self {
            equilibrium: r.equilibrium,
            springs: r.springs,
            cone: r.cone,
            gap: r.gap,
            complementarity: r.complementarity,
        }
    }
}

/// How far an equilibrium is from the exact one; see [`state::Accuracy`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Accuracy {
    /// Estimated error of the contact forces, N.
    #[serde(with = "AsComputed::<f64>")]
    pub force: f64,
    /// Estimated error of the displacements at the contacts, m.
    #[serde(with = "AsComputed::<f64>")]
    pub displacement: f64,
    /// Relative change of the forces by a relative change of the data.
    #[serde(with = "AsComputed::<f64>")]
    pub condition: f64,
}

impl From<state::Accuracy> for Accuracy {
    fn from(a: state::Accuracy) -> Self {
        Self { force: a.force, displacement: a.displacement, condition: a.condition }
    }
}

impl Places {
    /// An outcome with all that is known of an equilibrium.
    pub(super) fn solved<const C: usize>(&self, grasp: &Grasp<C>, outcome: &Outcome<C>) -> SolveAnswer<C> {
        match outcome {
            Outcome::Equilibrium(state) => SolveAnswer::Equilibrium(Box::new(self.measured(grasp, state))),
            _ => self.outcome(outcome),
        }
    }

    pub(super) fn outcome<const C: usize>(&self, outcome: &Outcome<C>) -> SolveAnswer<C> {
        match outcome {
            Outcome::Equilibrium(state) => SolveAnswer::Equilibrium(Box::new(self.equilibrium(state))),
            Outcome::NoEquilibrium(none) => SolveAnswer::NoEquilibrium(proof(none)),
            Outcome::Undecided(undecided) => SolveAnswer::Undecided { doubt: undecided.doubt },
        }
    }

    /// An equilibrium with its accuracy, and with the states that are told from their neighbours.
    fn measured<const C: usize>(&self, grasp: &Grasp<C>, state: &state::Equilibrium<C>) -> Equilibrium<C> {
        let mut told = self.equilibrium(state);
        told.accuracy = grasp.accuracy(state).map(Accuracy::from);
        for (touch, distinct) in told.contacts.iter_mut().zip(grasp.distinct(state).into_iter().flatten()) {
            touch.distinct = Some(distinct);
        }
        told
    }

    pub(super) fn equilibrium<const C: usize>(&self, state: &state::Equilibrium<C>) -> Equilibrium<C> {
        Equilibrium {
            load: state.load,
            twist: state.twist,
            contacts: state.contacts.iter().enumerate().map(|(i, c)| self.touch(i, c)).collect(),
            joints: self.joints(&state.joints),
            tendons: self.tendons(&state.tendons),
            residuals: state.residuals.into(),
            accuracy: None,
            cone: match state.cone {
                state::Cone::Planar => Cone::Planar,
                state::Cone::Polygon(polygon) => Cone::Polygon(polygon),
                state::Cone::Round => Cone::Round,
            },
            rule: state.rule,
            stored_energy: state.stored_energy,
            free_motions: state.free_motions.clone(),
            neutral_motions: state.neutral_motions.clone(),
            change_from_polygon: state.change_from_polygon,
            pivots: state.work.pivots,
        }
    }
}

/// Why no equilibrium exists, as it is written.
pub(super) fn proof<const C: usize>(none: &NoEquilibrium<C>) -> Proof<C> {
    match &none.proof {
        state::Proof::FreeMotion { motion, work } => {
            Proof::FreeMotion { motion: motion.clone(), work: *work }
        }
        state::Proof::SeparatingMotion { motion, work } => {
            Proof::SeparatingMotion { motion: motion.clone(), work: *work }
        }
        state::Proof::EveryStateTried { combinations } => {
            Proof::EveryStateTried { combinations: *combinations }
        }
        state::Proof::EveryCaseContradicted { cases, escape } => {
            Proof::EveryCaseContradicted { cases: *cases, escape: *escape }
        }
    }
}
