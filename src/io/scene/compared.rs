//! The answer to the question `compare` of a scene: the equilibrium beside the contact forces of least potential energy under the constraints of the
//! friction cones. The quadratic program for these forces is that of "Position Control for Multifingered Robot Hand" (see `paper-notes.md`). Once a
//! friction constraint binds, its solution is not an equilibrium. The base load acts before the load grows.

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use super::sentence_answers::text;
use crate::energy::Comparison;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Ramp;
use crate::serial::AsComputed;
use crate::words::Words;

/// The equilibrium under a load, compared with the minimum of energy; see [`Energy::compare`](crate::ask::Energy::compare).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CompareAnswer<const C: usize> {
    /// The answer in a sentence.
    pub says: String,
    /// Multiple of the load up to which the minimum of energy is the equilibrium, infinite if there is no such limit; see
    /// [`Energy::agreement`](crate::ask::Energy::agreement). Left out if minimum and equilibrium differ already under the base load, or if the
    /// multiple is not known.
    #[serde(default, with = "AsComputed::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    pub agrees_up_to: Option<f64>,
    /// The comparison under the base load plus the whole load.
    #[serde(flatten)]
    pub comparison: Comparison<C>,
}

impl SceneNames<'_> {
    /// The answer to `compare`: the equilibrium and the minimum of energy under `base + load`, and the multiple of `load` up to which both agree.
    pub(super) fn compared(
        &self,
        base: &Wrench<3>,
        load: &Wrench<3>,
        words: Words,
    ) -> Result<CompareAnswer<3>, Error> {
        let energy = self.0.energy();
        let mut comparison = energy.compare(*base + *load)?;
        let is_loaded = *load != Wrench::ZERO;
        let agrees_up_to =
            if is_loaded { energy.agreement(Ramp::load(*base, *load))?.factor() } else { None };
        let mut says = text(&comparison, words);
        if let Some(factor) = agrees_up_to.filter(|factor| factor.is_finite() && *factor > 0.0) {
            let amount = match load.measure() {
                Some((size, unit)) => format!("{} {unit}", words.number(size * factor)),
                None => format!("{} times the load", words.number(factor)),
            };
            says = format!("{says}. Both agree up to {amount}");
        }
        comparison.equilibrium = self.outcome(comparison.equilibrium);
        Ok(CompareAnswer { says, agrees_up_to, comparison: comparison.written() })
    }
}
