//! A tendon, a rod or a differential that acts on several joints.

use crate::numerics::IntoList;
use alloc::sync::Arc;

use super::joint::Limit;
use crate::prelude::*;

/// A tendon over joints of a hand, with its spring and the displacement of its motor. It only pulls, unless [`Self::pushes`] is set.
///
/// Joint displacements φ shorten the path of the tendon by `r·φ`, with the moment arms r. The tension is `k (x - r·φ)` while positive, and
/// exerts the torque r_j times the tension on joint j. A tendon with a constant tension and no stiffness is a differential: its tension does not
/// depend on the joint positions.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Tendon {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) arms: Vec<f64>,
    pub(crate) stiffness: f64,
    pub(crate) pull: f64,
    pub(crate) tension: f64,
    pub(crate) limit: Option<Limit>,
    pub(crate) pushes: bool,
}

impl Tendon {
    /// A tendon with these moment arms at the joints of the hand, finger by finger: m (1 for a prismatic joint), positive if a pull moves the
    /// joint along φ. Trailing arms may be omitted if the tendon does not reach the last joints.
    pub fn new(arms: impl IntoIterator<Item = f64>) -> Self {
        let arms = arms.into_iter().list();
        Self { name: None, arms, stiffness: 0.0, pull: 0.0, tension: 0.0, limit: None, pushes: false }
    }

    /// Sets the name for messages and tables.
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into().into());
        self
    }

    /// Sets the stiffness of tendon and motor in series, N/m.
    pub fn stiffness(mut self, stiffness: f64) -> Self {
        self.stiffness = stiffness;
        self
    }

    /// Sets the displacement x of the motor, m: the command of the tendon.
    pub fn pull(mut self, x: f64) -> Self {
        self.pull = x;
        self
    }

    /// Sets a constant tension, N, which acts in addition to the spring.
    pub fn tension(mut self, tension: f64) -> Self {
        self.tension = tension;
        self
    }

    /// Sets a bound on the tension of the spring.
    pub fn limit(mut self, limit: Limit) -> Self {
        self.limit = Some(limit);
        self
    }

    /// Makes the tendon a rod or a gear, which also pushes.
    pub fn pushes(mut self) -> Self {
        self.pushes = true;
        self
    }
}
