//! A tendon, a linkage or a differential over several joints.

use crate::numerics::IntoList;
use alloc::sync::Arc;

use super::joint::Limit;
use crate::prelude::*;

/// A tendon over joints of a hand, with the spring and the pull of its motor. It only pulls, unless [`Self::pushes`] is set.
///
/// It shortens by `r·φ`. Its tension is `k (x - r·φ)` while that is positive, and it exerts r_j times its tension on joint j. With a given tension
/// and no stiffness it is a differential: the tension is that of the motor, at any joint positions.
#[derive(Debug, Clone, PartialEq)]
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
    /// A tendon with these arms over the joints of the hand, finger by finger: m (1 for a prismatic joint), positive where a pull moves the joint
    /// along φ. Arms of the last joints may be omitted if the tendon does not reach them.
    pub fn new(arms: impl IntoIterator<Item = f64>) -> Self {
        let arms = arms.into_iter().list();
        Self { name: None, arms, stiffness: 0.0, pull: 0.0, tension: 0.0, limit: None, pushes: false }
    }

    /// A name for messages and tables.
    #[must_use]
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into().into());
        self
    }

    /// Stiffness of tendon and motor in series, N/m.
    #[must_use]
    pub fn stiffness(mut self, stiffness: f64) -> Self {
        self.stiffness = stiffness;
        self
    }

    /// How far the motor has pulled, x in m: the command of the tendon.
    #[must_use]
    pub fn pull(mut self, x: f64) -> Self {
        self.pull = x;
        self
    }

    /// A constant tension, N, in addition to that of its spring, if it has one.
    #[must_use]
    pub fn tension(mut self, tension: f64) -> Self {
        self.tension = tension;
        self
    }

    /// A bound on the tension of its spring.
    #[must_use]
    pub fn limit(mut self, limit: Limit) -> Self {
        self.limit = Some(limit);
        self
    }

    /// A rod or a gear in place of a tendon: it also pushes.
    #[must_use]
    pub fn pushes(mut self) -> Self {
        self.pushes = true;
        self
    }
}
