//! A [`Need`] after a check of its fields, with defaults for all fields that were not given. The load at rest acts before the other loads. An amount
//! (of squeeze, friction, load, arm, angle or force) is sufficient if the grasp meets the demand with it, for example holds the object. A safe amount
//! is sufficient also with less friction and squeeze, or with larger loads. The squeeze is everything by which contacts press at rest without a load.

use alloc::borrow::Cow;

use super::answer::{PressedBy, Quantity, check_part};
use super::question::{Demand, Need};
use crate::ask::Grasp;
#[cfg(feature = "serde")]
use crate::error::check_contact;
use crate::error::{Error, is_moderate};
use crate::grasp::{Contact, Wrench};
use crate::load_path::Turn;
use crate::numerics::{Each, Space, any_index, chosen, largest};
use crate::prelude::*;
use crate::squeeze::Loads;
use crate::words::Words;

impl<const C: usize> Need<C> {
    /// The loads of the question; `None` if it has none, or has several where only one is allowed.
    #[cfg(feature = "serde")]
    pub(crate) fn loads(&self) -> Option<Loads<C>> {
        match self.turn {
            Some(turn) => Some(Loads::Turn(turn)),
            None => Loads::of_fields("need", (self.load, &self.loads), (self.any_force, self.at)).ok(),
        }
    }

    /// The loads of the question that are given as wrenches: the single load and the list of loads.
    #[cfg(feature = "serde")]
    pub(crate) fn wrenches(&self) -> impl Iterator<Item = &Wrench<C>> {
        self.load.iter().chain(&self.loads)
    }

    /// The single load of the question; the loads of other bodies [grow](Self::together_with) in proportion to it. `None` if the question has no load
    /// or several, or if an arm or an angle is sought.
    pub(crate) fn grows(&self) -> Option<Wrench<C>> {
        let is_alone = self.loads.is_empty() && self.any_force.is_none() && self.turn.is_none();
        self.load.filter(|_| is_alone && !matches!(self.quantity, Quantity::Arm | Quantity::Angle))
    }

    /// The grasp in which loads of other bodies grow together with the load of the question.
    pub(super) fn growing<'g>(&self, grasp: &'g Grasp<C>) -> Result<Cow<'g, Grasp<C>>, Error> {
        grasp.growing("need", self.base(), self.grows(), &self.together_with)
    }
}

/// A [`Need`] after a check of its fields: the sought quantity, the loads, the demand and the reductions for the safe amount.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CheckedNeed {
    pub(super) sought: Sought,
    /// The loads. If an arm is sought, the load at the arm 0, i.e. at its given point of action; if an angle is sought, the load that turns.
    pub(super) loads: Loads<3>,
    /// The load at rest. It is constant unless its multiple is the sought quantity.
    pub(super) base: Wrench<3>,
    pub(super) demand: Demand,
    /// For the safe amount: the reductions of friction and squeeze and the factor on loads.
    pub(super) safety: SafetyDeviations,
    /// The search finds the least or the greatest sufficient amount. It then tries this number of further amounts on both sides of the amount found.
    pub(super) scan: usize,
    /// Units and digits of numbers in the sentences about insufficient amounts.
    pub(super) words: Words,
}

/// The sought quantity, and the data that belong to it alone.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Sought {
    Squeeze,
    /// The overlaps of contacts (negative clearances), as in a press fit. A factor on them is sought in place of the squeeze if no command presses.
    Overlaps,
    /// The contact points whose coefficient is sought; `None` for all contact points with friction.
    Friction {
        contacts: Option<Vec<usize>>,
    },
    Load,
    Arm {
        at: Wrench<3>,
        per_metre: Wrench<3>,
    },
    Angle {
        turn: Turn<3>,
    },
    /// A multiple of one force is sought. If `of` names a body, it is the load on this body; if `of` names a contact, link or joint, it is its
    /// command or constant force. If `of` is `None`, it is the load at rest.
    Force {
        of: Option<String>,
    },
}

/// Unfavourable deviations from the given friction, squeeze and loads, which the safe amount takes into account.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SafetyDeviations {
    /// Relative reductions of friction and of the squeeze, from 0 to less than 1.
    pub(super) lower: [f64; 2],
    /// Factor on the loads.
    pub(super) load: f64,
}

impl SafetyDeviations {
    /// No deviation from the given friction, squeeze and loads.
    pub(super) const NONE: Self = Self { lower: [0.0; 2], load: 1.0 };
}

impl CheckedNeed {
    /// Refuses numbers out of range, and loads that do not suit the demand. These checks do not depend on the grasp.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.base.check_in(self.words.space::<3>(), "base load")?;
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

    /// This need adapted to a grasp. The friction of a soft fingertip is set at all its points. If no contact has friction, the coefficient of all
    /// contacts is sought; contacts that are parts of links, such as guides, stay frictionless. If no command presses, a force is sought in place of
    /// a squeeze. This force is the load of the only loaded body, or the load at rest if no body is loaded and no contacts overlap.
    pub(super) fn on(mut self, grasp: &Grasp<3>) -> Result<Self, Error> {
        match &mut self.sought {
            Sought::Friction { contacts: Some(contacts) } => *contacts = grasp.points_of(contacts)?,
            Sought::Friction { contacts }
                if grasp.contacts().iter().all(|contact| contact.friction == 0.0) =>
            {
                let all = grasp.contacts();
                *contacts = Some(chosen(all.len(), &|i| all[*i].link.is_none()));
            }
            Sought::Squeeze if !grasp.is_squeezed() => {
                let bodies = grasp.loaded_bodies();
                let is_at_rest = bodies.is_empty() && self.base != Wrench::ZERO;
                if bodies.len() != 1 && grasp.overlaps() {
                    self.sought = Sought::Overlaps;
                } else if bodies.len() == 1 || is_at_rest {
                    self.sought = Sought::Force { of: bodies.into_iter().next() };
                }
            }
            _ => {}
        }
        Ok(self)
    }

    /// The magnitude of the force whose multiple is sought, N; `None` unless the loads are one single force.
    pub(super) fn force_of_load(&self) -> Option<f64> {
        match (&self.sought, &self.loads) {
            (Sought::Load, Loads::Each(list)) if list.len() == 1 => {
                list[0].measure().filter(|(_, unit)| *unit == "N").map(|(size, _)| size)
            }
            _ => None,
        }
    }

    /// The largest magnitude of a force of the question, N: of the load at rest, of the other loads, or of the force of any direction.
    pub(super) fn largest_force(&self) -> f64 {
        let force = |load: &Wrench<3>| load.force_part().norm();
        let of_loads = match &self.loads {
            Loads::Each(list) => largest(list, &force),
            Loads::AnyForce { base, size, .. } => force(base).max(*size),
            Loads::Turn(turn) => largest(&turn.parts(), &force),
        };
        of_loads.max(force(&self.base))
    }

    /// Whether the sought angle in the plane is an anticlockwise tilt of the grasp. In coordinates of the tilted grasp the load turns the other way.
    pub(super) fn tilts_anticlockwise(&self, space: Space) -> Option<bool> {
        let Sought::Angle { turn } = &self.sought else { return None };
        let [_, cosine, sine] = turn.parts().each(|part| part.force_part());
        let turns = cosine[0] * sine[1] - cosine[1] * sine[0];
        (space == Space::Planar && turns != 0.0).then_some(turns < 0.0)
    }

    /// Whether the sought load scales a force in any direction, too.
    pub(super) fn scales_any_force(&self) -> bool {
        self.quantity() == Quantity::Load && matches!(self.loads, Loads::AnyForce { .. })
    }

    /// Whether friction is sought, and a contact whose friction is sought has a kinetic coefficient that differs from its static one.
    pub(super) fn scales_kinetic(&self, all: &[Contact<3>]) -> bool {
        let Sought::Friction { contacts } = &self.sought else { return false };
        any_index(all.len(), &|i| {
            let is_meant = contacts.as_ref().is_none_or(|those| those.contains(&i));
            is_meant && all[i].kinetic_coefficient() != all[i].friction_coefficient()
        })
    }

    /// What exerts the sought force (a body, contact, link or joint, or the load at rest), with the given magnitude of that force. `None` if another
    /// quantity is sought.
    pub(super) fn pressed_by(&self, grasp: &Grasp<3>) -> Result<Option<PressedBy>, Error> {
        let Sought::Force { of } = &self.sought else { return Ok(None) };
        let (part, is_body, is_command, size) = match of {
            Some(part) => {
                let pressing = grasp.scaled(part, 1.0)?.0;
                (Some(pressing.name), pressing.is_body, pressing.is_command, pressing.size)
            }
            None => (None, false, false, self.base.measure()),
        };
        let (size, unit) =
            size.filter(|(size, _)| *size > 0.0).map(|(size, unit)| (size, unit.to_owned())).unzip();
        Ok(Some(PressedBy { part, is_body, is_command, size, unit }))
    }

    pub(super) fn quantity(&self) -> Quantity {
        match self.sought {
            Sought::Squeeze | Sought::Overlaps => Quantity::Squeeze,
            Sought::Friction { .. } => Quantity::Friction,
            Sought::Load => Quantity::Load,
            Sought::Arm { .. } => Quantity::Arm,
            Sought::Angle { .. } => Quantity::Angle,
            Sought::Force { .. } => Quantity::Force,
        }
    }
}

impl Need<3> {
    /// Refuses fields that are missing or belong to another quantity, numbers out of range, and contact indices that are not below `contacts`, the
    /// number of contacts.
    #[cfg(feature = "serde")]
    pub(crate) fn check(&self, space: Space, contacts: usize) -> Result<(), Error> {
        match self.posed(space)?.sought {
            Sought::Friction { contacts: Some(list) } => {
                list.iter().try_for_each(|contact| check_contact(*contact, contacts))
            }
            _ => Ok(()),
        }
    }

    /// This need after a check of its fields, with the loads and the sought quantity in the form that the search uses.
    pub(super) fn posed(&self, space: Space) -> Result<CheckedNeed, Error> {
        let of_its_own = [
            (
                self.per_metre.is_some(),
                Quantity::Arm,
                "per_metre",
                "is given, must be left out unless an arm is sought",
            ),
            (
                self.contact.is_some(),
                Quantity::Friction,
                "contact",
                "is given, must be left out unless friction is sought",
            ),
            (
                self.contacts.is_some(),
                Quantity::Friction,
                "contacts",
                "is given, must be left out unless friction is sought",
            ),
            (self.of.is_some(), Quantity::Force, "of", "is given, must be left out unless a force is sought"),
        ];
        for (given, of, field, fault) in of_its_own {
            if given && of != self.quantity {
                return Err(wrong(field, fault));
            }
        }
        if self.at.is_some() && self.any_force.is_none() {
            return Err(wrong(
                "at",
                "is given, must be left out unless there is any_force (a load has its own)",
            ));
        }
        // For each of the fields `load`, `loads`, `any_force` and `turn`: whether it is given although the search for an arm or angle does not use
        // it.
        let (has_list, any) = (!self.loads.is_empty(), self.any_force.is_some());
        let unused = match self.quantity {
            Quantity::Arm => [false, has_list, any, self.turn.is_some()],
            Quantity::Angle => [self.load.is_some(), has_list, any, false],
            _ => [false; 4],
        };
        if let Some(k) = unused.iter().position(|given| *given) {
            let field = ["load", "loads", "any_force", "turn"][k];
            return Err(wrong(
                field,
                "is given, must be left out: an arm has one `load`, an angle one `turn`",
            ));
        }
        let sought = match self.quantity {
            Quantity::Squeeze => Sought::Squeeze,
            Quantity::Load => Sought::Load,
            Quantity::Force => Sought::Force { of: self.of.clone() },
            Quantity::Friction => Sought::Friction { contacts: self.sought_contacts()? },
            Quantity::Arm => {
                let fault = "is missing, must be given where an arm is sought";
                let at = self.load.ok_or_else(|| wrong("load", fault))?;
                let fault = "is missing, must be what a metre adds to the load where an arm is sought";
                Sought::Arm { at, per_metre: self.per_metre.ok_or_else(|| wrong("per_metre", fault))? }
            }
            Quantity::Angle => {
                let fault = "is missing, must be given where an angle is sought";
                Sought::Angle { turn: self.turn.ok_or_else(|| wrong("turn", fault))? }
            }
        };
        let loads = match &sought {
            Sought::Arm { at, .. } => (*at).into(),
            Sought::Angle { turn } => Loads::Turn(*turn),
            _ => self.given_loads()?,
        };
        let [friction, squeeze] = if self.safety.is_some() { [0.0; 2] } else { [0.1, 0.05] };
        let lower = [self.friction_less.unwrap_or(friction), self.squeeze_less.unwrap_or(squeeze)];
        let safety = SafetyDeviations { lower, load: self.safety.unwrap_or(1.0) };
        let posed = CheckedNeed {
            sought,
            loads,
            base: self.base(),
            demand: self.demand,
            safety,
            scan: self.scan,
            words: self.words.in_space(space),
        };
        posed.check()?;
        let is_zero = |load: &Wrench<3>| *load == Wrench::ZERO;
        let has_no_load = matches!(&posed.loads, Loads::Each(list) if list.iter().all(is_zero));
        if safety.load != 1.0 && has_no_load {
            return Err(wrong("safety", NOTHING_TO_MULTIPLY));
        }
        if self.quantity == Quantity::Load && has_no_load && self.together_with.is_empty() {
            return Err(wrong("load", "is zero, must be a force or a moment whose multiple is sought"));
        }
        Ok(posed)
    }

    /// The contacts whose coefficient is sought; `None` for all contacts.
    fn sought_contacts(&self) -> Result<Option<Vec<usize>>, Error> {
        match (self.contact, &self.contacts) {
            (Some(_), Some(_)) => Err(wrong("contacts", "are given beside a contact, must be one of them")),
            (None, Some(list)) if list.is_empty() => {
                Err(Error::Argument { what: "number of contacts", value: 0.0, allowed: "at least 1" })
            }
            (contact, list) => Ok(contact.map(|contact| vec![contact]).or_else(|| list.clone())),
        }
    }

    /// The loads of the question; an error unless they are given in exactly one way. Without any load, the grasp has to hold the load at rest.
    fn given_loads(&self) -> Result<Loads<3>, Error> {
        let others = self.load.is_some() || !self.loads.is_empty() || self.any_force.is_some();
        match self.turn {
            Some(turn) if !others => Ok(Loads::Turn(turn)),
            Some(_) => Err(wrong("load", "is given twice, must be one of load, loads, any_force and turn")),
            None if others => Loads::of_fields("need", (self.load, &self.loads), (self.any_force, self.at)),
            None if self.quantity == Quantity::Load => Err(NO_LOAD),
            None => Ok(Wrench::ZERO.into()),
        }
    }

    /// Refuses a question without a load unless something acts at rest: the load at rest of the question, or loads and weights of bodies.
    pub(crate) fn check_acts(&self, is_loaded: bool) -> Result<(), Error> {
        let is_nothing = self.base() == Wrench::ZERO && !is_loaded;
        let has_no_load =
            self.load.is_none() && self.loads.is_empty() && self.any_force.is_none() && self.turn.is_none();
        if is_nothing && has_no_load { Err(NO_LOAD) } else { Ok(()) }
    }
}

/// The message of the error if a factor of safety is given but only a load at rest acts.
const NOTHING_TO_MULTIPLY: &str = "multiplies the load asked about, and none is given; the load at rest and the weights of bodies stay as they are";

/// The error of a question without a load if nothing acts at rest.
const NO_LOAD: Error = Error::Question {
    question: "need",
    field: "load",
    fault: "is missing, must be one of load, loads, any_force and turn",
};

fn wrong(field: &'static str, fault: &'static str) -> Error {
    Error::Question { question: "need", field, fault }
}
