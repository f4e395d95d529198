//! A proof, case by case, that no equilibrium exists on the round cone.

use alloc::sync::Arc;

use crate::error::Error;
use crate::grasp::{Engine, Wrench, face_of_struct, same_on_both_sides};
use crate::proofs::{self, ProofStep};
use crate::search::{self, Settings};

/// A proof that no equilibrium exists on the round cone, which can be kept and checked.
///
/// Contact states are divided into cases: open or closed, sticking or sliding, friction between two angles. Each case is contradicted by a virtual
/// motion of the object and virtual contact forces that balance one another. In an equilibrium the total virtual work of this motion and these forces
/// is positive. But in the contact states of the case no contact can contribute positive work. [`Self::check`] recomputes both statements from the
/// numbers given for grasp and load, in closed form for every contact, and checks that no case is missing. The check does not depend on the search
/// that found the proof.
#[derive(Debug, Clone)]
pub struct Refutation<const C: usize> {
    steps: Arc<[ProofStep]>,
    cases: usize,
}

same_on_both_sides! { Arc<[ProofStep]> }

face_of_struct! {
    Refutation { steps, cases }
}

impl<const C: usize> Refutation<C> {
    /// Number of cases of the proof, including cases that were divided further.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.cases
    }
}

impl Engine {
    pub(crate) fn refutation(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<Option<Refutation<3>>, Error> {
        let problem = self.problem_under(load, &Settings { round: true, ..*settings })?;
        Ok(search::refute(&problem, settings).map(|(steps, cases)| Refutation { steps: steps.into(), cases }))
    }

    pub(crate) fn check_refutation(
        &self,
        proof: &Refutation<3>,
        load: &Wrench<3>,
    ) -> Result<Option<f64>, Error> {
        let problem = self.problem_under(load, &Settings::default())?;
        Ok(proofs::check(&problem, &proof.steps))
    }
}
