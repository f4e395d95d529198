//! The trial of an amount (of squeeze, friction, load, arm or angle) under loads that are applied and removed again and again. The amount is
//! sufficient if the object comes to rest, i.e. nothing slides from some cycle on. With a weaker demand it is sufficient if the object does not walk,
//! i.e. move on by the same motion in every period. A leg is a section of the load program, a period one cycle or several cycles after which the
//! motion repeats itself. The load at rest acts before the loads that repeat. Motions are small within the limits up to which the linear theory is
//! trusted.

use core::f64::consts::TAU;

use super::loading::Loading;
use super::question::Demand;
use super::trial::{NOT_AT_REST, Trial};
use crate::error::Error;
use crate::grasp::{BodyMotion, Wrench};
use crate::hold::LossVerb;
use crate::load_path::Leg;
use crate::numerics::largest;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::prelude::*;
use crate::shake::{Repeats, Shaken};
use crate::squeeze::Loads;

impl Loading {
    /// Determines whether the amount is sufficient: while the loads are applied and removed in turn for ever, the object comes to rest
    /// ([`Demand::Rests`]), or does not walk ([`Demand::Stays`]).
    pub(super) fn again_and_again(&self, demand: Demand) -> Result<Trial, Error> {
        let Some((base, legs)) = self.cycle() else {
            return Ok(Trial::Unknown("a force of any direction comes in no order".to_owned()));
        };
        let shaken = self.grasp.shake(base, &legs)?;
        let sufficient = if demand == Demand::Rests { shaken.rests() } else { shaken.stays() };
        // If motions go beyond the limit of small motions, the computation proves neither that the object comes to rest nor that it does not walk.
        if let Some(far) = shaken.too_far.as_ref().filter(|_| sufficient == Some(true)) {
            let says = format!("{} in a cycle: {}", LossVerb::from(far), far.reason(self.words));
            return Ok(Trial::insufficient(says, carried(&shaken, legs.len())));
        }
        Ok(match sufficient {
            Some(true) => Trial::always(),
            Some(false) => Trial::insufficient(self.said(&shaken), carried(&shaken, legs.len())),
            None => Trial::Unknown(self.said(&shaken)),
        })
    }

    /// The load at rest and the legs of one cycle (sections of the load program). Each load is applied and removed. A load that turns is turned back,
    /// unless it ends where it began after full revolutions. `None` if the question asks about a force of any direction.
    fn cycle(&self) -> Option<(Wrench<3>, Vec<Leg<3>>)> {
        match &self.loads {
            Loads::Each(loads) => {
                let mut legs = Vec::new();
                for load in loads {
                    legs.extend(Leg::there_and_back(*load * self.times));
                }
                Some((self.base, legs))
            }
            Loads::Turn(turn) => {
                let there = self.multiplied_turn(turn);
                let round = there.angle() / TAU;
                let is_round = (round - round.round()).abs() <= SOLVED_ROUNDING && round > 0.5;
                let mut legs = vec![Leg::turn(&there)];
                if !is_round {
                    legs.push(Leg::turn(&there.back()));
                }
                Some((there.load_at(0.0), legs))
            }
            Loads::AnyForce { .. } => None,
        }
    }
}

/// For an insufficient amount, a number below 1 that guides the search for a sufficient amount. For a load that is applied only once, the search is
/// guided by the load factor up to which it is held; this number takes its place. It is larger if the object is lost later, or moves less in each
/// period.
fn carried(shaken: &Shaken<3>, legs: usize) -> f64 {
    // A loss of the object gives a number below one half; a walk and sliding to and fro give larger numbers. A search for larger numbers thus leads
    // from losses to walks, and from walks to rest.
    let held = 0.5;
    match &shaken.repeats {
        Repeats::NoRest { .. } => NOT_AT_REST,
        Repeats::Lost { cycle, leg, lost, .. } => {
            let gone = (cycle - 1) as f64 + (*leg as f64 + lost.factor) / legs as f64;
            held * gone / (1.0 + gone)
        }
        Repeats::Walks { by, .. } => {
            let part = |motion: &BodyMotion<3>| motion.speed() / motion.reach.max(f64::MIN_POSITIVE);
            held + (1.0 - held) / (2.0 + largest(by, &part))
        }
        _ => held + 0.5 * (1.0 - held),
    }
}
