//! A tendon, a rod or a differential that acts on several joints.

use crate::numerics::IntoList;
use alloc::sync::Arc;

use super::joint::Limit;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::{AsGiven, is_absent, object::read_as_object};

/// A tendon over joints of a hand, with its spring and the displacement of its motor. It only pulls, unless it is a rod or a gear.
///
/// The motor pulls the tendon by the displacement x. Joint displacements φ shorten the path of the tendon by `r·φ`, with the moment arms r. With the
/// stiffness k the tension is `k (x - r·φ)`; a tendon that only pulls is slack where this is negative. The tension exerts the torque r_j times the
/// tension on joint j. A tendon with a constant tension and no stiffness is a differential: its tension does not depend on the joint positions.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(remote = "Self", deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[must_use]
pub struct Tendon {
    /// The name of the tendon in answers.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) name: Option<Arc<str>>,
    /// Moment arms, one for each joint of all fingers: m/rad for revolute joints, no unit for prismatic joints. A positive arm means that a pull
    /// moves the joint in its positive direction.
    #[cfg_attr(feature = "serde", serde(with = "AsGiven::<Vec<f64>>"))]
    pub(crate) arms: Vec<f64>,
    /// Stiffness of the tendon's spring (tendon and motor in series), N/m; without it only `tension` acts.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")
    )]
    pub(crate) stiffness: f64,
    /// Commanded displacement of the motor, m, which pulls if positive; 0 if left out.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")
    )]
    pub(crate) pull: f64,
    /// Constant tension in addition to the tension of the spring, N; 0 if left out.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "AsGiven::<f64>", skip_serializing_if = "is_absent")
    )]
    pub(crate) tension: f64,
    /// The largest tension of the spring, N; no limit if left out.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub(crate) limit: Option<Limit>,
    /// `true` for a rod or a gear, which pulls and pushes; `false` (default) for a tendon that goes slack instead of pushing.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "core::ops::Not::not"))]
    pub(crate) pushes: bool,
}

#[cfg(feature = "serde")]
read_as_object!("a tendon", Tendon);

impl Tendon {
    /// A tendon with these moment arms at the joints of the hand, finger by finger, in m (without unit at a prismatic joint). An arm is positive if a
    /// pull moves the joint in the direction of its positive displacement. The list has one arm for each joint, with 0 for a joint that the tendon
    /// does not reach.
    pub fn new(arms: impl IntoIterator<Item = f64>) -> Self {
        let arms = arms.into_iter().list();
        Self { name: None, arms, stiffness: 0.0, pull: 0.0, tension: 0.0, limit: None, pushes: false }
    }

    setters! {
        /// Sets the name for messages and tables.
        pub fn name(mut self, name: impl Into<String>) { self.name = Some(name.into().into()); }

        /// Sets the stiffness of tendon and motor in series, N/m.
        pub fn stiffness(mut self, stiffness: f64) { self.stiffness = stiffness; }

        /// Sets the displacement x of the motor, m: the command of the tendon.
        pub fn pull(mut self, x: f64) { self.pull = x; }

        /// Sets a constant tension, N, which acts in addition to the tension of the spring.
        pub fn tension(mut self, tension: f64) { self.tension = tension; }

        /// Sets a bound on the tension of the spring; a constant [tension](Self::tension) does not count.
        pub fn limit(mut self, limit: Limit) { self.limit = Some(limit); }

        /// Makes the tendon a rod or a gear, which also pushes.
        pub fn pushes(mut self) { self.pushes = true; }
    }
}
