//! A proof, case by case, that no equilibrium exists on the round cone.

use alloc::sync::Arc;
use core::any::Any;
use core::marker::PhantomData;

use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::prelude::*;
use crate::proofs::{self, ProofStep};
use crate::search::{self, Settings};

/// A proof that no equilibrium exists on the round cone, which can be kept and checked.
///
/// Behaviours of contacts are divided into cases: open or closed, sticking or sliding, friction between two angles. Each case is contradicted by a
/// virtual motion of the object and virtual forces of the contacts that balance one another. Together they do work on every equilibrium that no
/// contact can do in that case. [`Self::check`] repeats that from the data, in closed form for every contact, and checks that no case is left out; it
/// does not depend on how the proof was found.
#[derive(Debug, Clone)]
pub struct Refutation<const C: usize> {
    /// A list of [`ProofStep`]s in the grasp's number of coordinates.
    steps: Arc<dyn Any + Send + Sync>,
    cases: usize,
    axes: PhantomData<[(); C]>,
}

impl<const C: usize> Refutation<C> {
    /// Number of cases, including those that were divided further.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.cases
    }

    pub(crate) fn steps(&self) -> &(dyn Any + Send + Sync) {
        &*self.steps
    }
}

impl<const C: usize> Engine<C> {
    /// [`Grasp::refutation`](crate::ask::Grasp::refutation).
    pub(crate) fn refutation(
        &self,
        load: &Wrench<C>,
        settings: &Settings,
    ) -> Result<Option<Refutation<C>>, Error> {
        let problem = self.problem_under(load, &Settings { round: true, ..*settings })?;
        Ok(search::refute(&problem, settings).map(|(steps, cases)| Refutation {
            steps: Arc::new(steps),
            cases,
            axes: PhantomData,
        }))
    }

    /// [`Refutation::check`].
    pub(crate) fn check_refutation(
        &self,
        proof: &Refutation<C>,
        load: &Wrench<C>,
    ) -> Result<Option<f64>, Error> {
        let problem = self.problem_under(load, &Settings::default())?;
        // Steps in another number of coordinates belong to another grasp.
        let steps = proof.steps().downcast_ref::<Vec<ProofStep<C>>>();
        Ok(steps.and_then(|steps| proofs::check(&problem, steps)))
    }
}
