//! The least factor of the commands with which all contacts stick under a set of loads.

use super::loads::Loads;
use super::parts::{Condition, Parts};
use crate::equilibrium::StickingResponse;
use crate::error::Error;
use crate::grasp::{Engine, Motion, Wrench};
use crate::search::Settings;

/// The answer to "how much squeeze do I need?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LeastSqueeze<const C: usize> {
    /// With the commands of the grasp times this factor all contacts touch and stick under every load; with a smaller factor some contact does not.
    #[non_exhaustive]
    Factor {
        /// At least zero, exact up to rounding.
        factor: f64,
        /// The contact on the edge of its cone at this factor, from 0, and the load under which it is; `None` if no squeeze is needed.
        binding: Option<(usize, Wrench<C>)>,
    },
    /// No factor suffices. With this factor, and with any larger one, the contact does not stick under this load. With a smaller factor the sticking
    /// condition of another contact or load fails.
    #[non_exhaustive]
    NoFactor {
        /// The contact, from 0.
        contact: usize,
        /// The load under which the contact does not stick.
        load: Wrench<C>,
        /// The least factor with which all other sticking conditions hold.
        factor: f64,
    },
    /// Some load works on this motion, which nothing resists at any squeeze.
    GivesWay {
        /// A unit motion of the object.
        motion: Motion<C>,
    },
    /// Rounding keeps the search from ending.
    Undecided,
}

impl Engine {
    /// Implements [`Grasp::least_squeeze`](crate::ask::Grasp::least_squeeze).
    pub(crate) fn least_squeeze(
        &self,
        loads: &Loads<3>,
        settings: &Settings,
    ) -> Result<LeastSqueeze<3>, Error> {
        self.refuse_hands("least_squeeze")?;
        loads.check(self)?;
        let parts = match Parts::of(StickingResponse::new(self, settings), loads) {
            Ok(parts) => parts,
            Err(motion) => return Ok(LeastSqueeze::GivesWay { motion }),
        };
        let (mut factor, mut binding) = (0.0, None);
        // Each round imposes one more sticking condition and so raises the factor, with quadratic convergence. Beyond this many rounds only rounding
        // could change the factor.
        for _ in 0..1000 {
            let Some((contact, Condition { row, value, load, .. })) = parts.broken(factor) else {
                return Ok(LeastSqueeze::Factor { factor, binding });
            };
            let gain = parts.gain(contact, &row);
            if gain <= 0.0 {
                return Ok(LeastSqueeze::NoFactor { contact, load, factor });
            }
            let next = factor - value / gain;
            if next.is_nan() || next <= factor {
                break;
            }
            (factor, binding) = (next, Some((contact, load)));
        }
        Ok(LeastSqueeze::Undecided)
    }
}
