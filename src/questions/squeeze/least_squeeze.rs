//! The least factor on commands and vacuums with which all contacts touch and stick under every one of a set of loads. A command is the displacement
//! that a finger would make if there were no object.

use super::loads::Loads;
use super::parts::{Condition, ForceParts};
use crate::equilibrium::StickingResponse;
use crate::error::Error;
use crate::grasp::{Engine, Motion, Wrench};
use crate::search::Settings;

/// The answer to "by which factor must commands and vacuums be multiplied so that all contacts stick under these loads?"
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LeastSqueeze<const C: usize> {
    /// With the commands and vacuums of the grasp times this factor all contacts touch and stick under every load. With a smaller factor some contact
    /// does not stick under some load.
    #[non_exhaustive]
    Factor {
        /// The least factor, at least zero, exact up to rounding.
        factor: f64,
        /// The contact whose force is on the boundary of its friction cone at this factor, from 0, and the load that brings it there. `None` if the
        /// factor is zero, because all contacts then stick without commands and vacuums.
        binding: Option<(usize, Wrench<C>)>,
    },
    /// No factor makes all contacts stick. With the factor in the field `factor`, or any larger factor, the contact `contact` does not stick under
    /// the load `load`. With a smaller factor the sticking condition of another contact or load fails.
    #[non_exhaustive]
    NoFactor {
        /// The contact that does not stick, counted from 0.
        contact: usize,
        /// The load under which this contact does not stick.
        load: Wrench<C>,
        /// The least factor with which all sticking conditions hold that were added before the condition of this contact.
        factor: f64,
    },
    /// Nothing resists this motion, whatever the factor, and some load does work along it.
    GivesWay {
        /// The motion that nothing resists, scaled to unit length.
        motion: Motion<C>,
    },
    /// Rounding keeps the factor from rising further although a sticking condition is broken.
    Undecided,
}

impl Engine {
    pub(crate) fn least_squeeze(
        &self,
        loads: &Loads<3>,
        settings: &Settings,
    ) -> Result<LeastSqueeze<3>, Error> {
        self.refuse_hands("least_squeeze")?;
        loads.check(self)?;
        let parts = match ForceParts::of(StickingResponse::new(self, settings), loads) {
            Ok(parts) => parts,
            Err(motion) => return Ok(LeastSqueeze::GivesWay { motion }),
        };
        let (mut factor, mut binding) = (0.0, None);
        // Each round raises the factor until the condition that was broken holds. The factor converges quadratically, so that after this many rounds
        // only rounding could still change it.
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
