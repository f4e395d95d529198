//! The elastic trial: the linear problem in which every contact that is not absent sticks.

use alloc::sync::Arc;

use super::piece::Piece;
use super::problem::Problem;
use crate::contact::State;

impl Problem<'_> {
    /// The linear problem in which every contact that is not absent sticks. In the static problem it depends on contacts and drives alone, not on
    /// load or commands, and is computed once for all questions.
    pub(crate) fn trial(&self) -> Arc<Piece> {
        let make = || Piece::new(self, &self.unjumped());
        match self.trial {
            // Only grasps with few contacts store these factors, which take memory: most repeated questions are about small grasps.
            Some(kept) if self.len() <= 256 => kept.get(make),
            _ => Arc::new(make()),
        }
    }

    /// The linear problem with these contact states. If everything sticks it is the elastic trial, which may be stored.
    pub(crate) fn piece(&self, states: &[State]) -> Arc<Piece> {
        let unjumped = || self.locals().zip(states).all(|(local, state)| local.unjumped() == *state);
        if self.trial.is_some() && unjumped() { self.trial() } else { Arc::new(Piece::new(self, states)) }
    }
}
