//! A tendon, a linkage or a differential over several joints.

use alloc::sync::Arc;

use super::joint::Limit;
use crate::prelude::*;

/// A tendon over joints of a hand, with the spring and the pull of its motor. It pulls and never pushes, unless said otherwise.
///
/// It shortens by `r·φ`, its tension is `k (x - r·φ)` while that is positive, and on joint j it exerts r_j times its tension. With a tension that is given
/// and no stiffness it is a differential: equal to what the motor pulls with, whatever the joints do.
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
    /// along φ. Joints at the end of the list that it does not reach may be left out.
    pub fn new(arms: impl IntoIterator<Item = f64>) -> Self {
        let arms = arms.into_iter().collect();
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

    /// A tension that is there whatever the joints do, N, on top of that of its spring if it has one.
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

    /// A rod or a gear in place of a tendon: it pushes as well.
    #[must_use]
    pub fn pushes(mut self) -> Self {
        self.pushes = true;
        self
    }
}
