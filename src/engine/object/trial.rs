//! The elastic trial: the linear problem in which every contact sticks, except those whose law says that they stay open. Drives of joints and tendons
//! are treated like contacts. A command is a prescribed displacement of a finger.

use alloc::sync::Arc;

use super::linear_problem::LinearProblem;
use super::problem::Problem;
use crate::contact::State;

impl Problem<'_> {
    /// The factorised linear problem in which every contact sticks, except contacts that their law keeps open (`Law::Absent`). In the static problem
    /// it depends on contacts and drives alone, not on load or commands. A grasp with at most 256 contacts and drives keeps it for later loads and
    /// commands.
    pub(crate) fn trial(&self) -> Arc<LinearProblem> {
        let make = || LinearProblem::new(self, &self.trial_states());
        match self.trial {
            // Only grasps with few contacts and drives keep these factors: the storage grows with the number of contacts, and searches are most often
            // repeated for small grasps.
            Some(kept) if self.len() <= 256 => kept.get(make),
            _ => Arc::new(make()),
        }
    }

    /// The factorised linear problem with these contact states. For the states of the elastic trial it is the linear problem of [`Self::trial`],
    /// which the grasp may have kept.
    pub(crate) fn linear_problem(&self, states: &[State]) -> Arc<LinearProblem> {
        let trial_states = || self.locals().zip(states).all(|(local, state)| local.trial_state() == *state);
        if self.trial.is_some() && trial_states() {
            self.trial()
        } else {
            Arc::new(LinearProblem::new(self, states))
        }
    }
}
