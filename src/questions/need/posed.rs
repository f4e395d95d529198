//! The question for an amount as its search poses it: checked, with one value of each datum.

use super::answer::{PressedBy, Quantity, check_part};
use super::question::Demand;
use crate::ask::Grasp;
use crate::error::{Error, is_moderate};
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::prelude::*;
use crate::squeeze::Loads;
use crate::words::Words;

/// A [`Need`](super::Need) after its check.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Posed<const C: usize> {
    pub(super) sought: Sought<C>,
    /// The loads; for an arm that at displacement 0, for an angle the whole turn.
    pub(super) loads: Loads<C>,
    /// The load at rest; constant unless its own multiple is sought.
    pub(super) base: Wrench<C>,
    pub(super) demand: Demand,
    /// Deviations from the data that the safe amount covers.
    pub(super) safety: Safety,
    /// Number of amounts tried around the bound.
    pub(super) scan: usize,
    /// Digits of numbers in the sentences for other amounts.
    pub(super) words: Words,
}

/// The sought quantity with the data of its own.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Sought<const C: usize> {
    Squeeze,
    /// Points of the contacts; `None` for all with friction.
    Friction {
        contacts: Option<Vec<usize>>,
    },
    Load,
    Arm {
        at: Wrench<C>,
        per_metre: Wrench<C>,
    },
    Angle {
        turn: Turn<C>,
    },
    /// The force of the part `of`, or the load at rest if that is `None`.
    Force {
        of: Option<String>,
    },
}

/// Deviations from the data to the worse, for a safe amount.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Safety {
    /// Relative reductions of friction and of the squeeze, from 0 to less than 1.
    pub(super) lower: [f64; 2],
    /// Factor on the loads.
    pub(super) load: f64,
}

impl Safety {
    /// No deviation.
    pub(super) const NONE: Self = Self { lower: [0.0; 2], load: 1.0 };
}

impl<const C: usize> Posed<C> {
    /// Refuses numbers out of range, and loads that do not suit the demand, whatever the grasp.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.base.check("base load")?;
        check_part("part by which friction is less", self.safety.lower[0])?;
        check_part("part by which the squeeze is less", self.safety.lower[1])?;
        if !(self.safety.load > 0.0 && is_moderate(self.safety.load)) {
            let (what, allowed) = ("factor of safety", "more than 0 and at most 1e50");
            return Err(Error::Argument { what, value: self.safety.load, allowed });
        }
        if let (true, Loads::AnyForce { .. }) = (self.demand.repeats(), &self.loads) {
            let fault = "is one of loads that repeat, must be another for a force of any direction";
            return Err(Error::Question { question: "need", field: "demand", fault });
        }
        if let Sought::Force { of: None } = self.sought
            && self.base == Wrench::ZERO
        {
            let fault =
                "is missing, must be the load at rest whose force is sought, or `of` the part whose force is";
            return Err(Error::Question { question: "need", field: "base", fault });
        }
        self.loads.check_size()
    }

    /// The question as this grasp answers it. Friction of a soft fingertip is that of all its points. Where no command presses, a force is sought in
    /// place of a squeeze: the load of the only loaded body, or the load at rest where no body is loaded.
    pub(super) fn on(mut self, grasp: &Grasp<C>) -> Result<Self, Error> {
        match &mut self.sought {
            Sought::Friction { contacts: Some(contacts) } => *contacts = grasp.points_of(contacts)?,
            Sought::Squeeze if !grasp.is_squeezed() => {
                let bodies = grasp.loaded_bodies();
                let is_at_rest = bodies.is_empty() && self.base != Wrench::ZERO;
                if bodies.len() == 1 || is_at_rest {
                    self.sought = Sought::Force { of: bodies.into_iter().next() };
                }
            }
            _ => {}
        }
        Ok(self)
    }

    /// The size of the force whose multiple is sought, N; `None` unless the loads are one single force.
    pub(super) fn force_of_load(&self) -> Option<f64> {
        match (&self.sought, &self.loads) {
            (Sought::Load, Loads::Each(list)) if list.len() == 1 => {
                list[0].measure().filter(|(_, unit)| *unit == "N").map(|(size, _)| size)
            }
            _ => None,
        }
    }

    /// The part whose force is sought, with its size; `None` for other quantities.
    pub(super) fn pressed_by(&self, grasp: &Grasp<C>) -> Result<Option<PressedBy>, Error> {
        let Sought::Force { of } = &self.sought else { return Ok(None) };
        let (part, is_body, size) = match of {
            Some(part) => {
                let pressing = grasp.scaled(part, 1.0)?.0;
                (Some(pressing.name), pressing.is_body, pressing.size)
            }
            None => (None, false, self.base.measure()),
        };
        let (size, unit) =
            size.filter(|(size, _)| *size > 0.0).map(|(size, unit)| (size, unit.to_owned())).unzip();
        Ok(Some(PressedBy { part, is_body, size, unit }))
    }

    pub(super) fn quantity(&self) -> Quantity {
        match self.sought {
            Sought::Squeeze => Quantity::Squeeze,
            Sought::Friction { .. } => Quantity::Friction,
            Sought::Load => Quantity::Load,
            Sought::Arm { .. } => Quantity::Arm,
            Sought::Angle { .. } => Quantity::Angle,
            Sought::Force { .. } => Quantity::Force,
        }
    }
}
