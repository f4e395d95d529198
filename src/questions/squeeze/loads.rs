//! The sets of loads under which all contacts of a grasp must stick.

use nalgebra::SVector;

use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::{Engine, Wrench};
use crate::load_path::Turn;
use crate::prelude::*;

/// The set of loads under which all contacts must stick, one load at a time.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Loads<const C: usize> {
    /// Each load of the list, N and N m, one at a time; a list without loads is an error.
    Each(Vec<Wrench<C>>),
    /// The constant load `base` plus a force of magnitude `size` in any direction.
    AnyForce {
        /// The constant load to which the force is added, N and N m.
        base: Wrench<C>,
        /// The magnitude of the force, N, at least zero.
        size: f64,
        /// The point at which the force acts, m, in the coordinates of the grasp.
        point: [f64; C],
    },
    /// A load that turns: each load from angle zero to the last angle of the turn, or through a full turn if no last angle is given.
    Turn(Turn<C>),
}

impl Loads<3> {
    /// Returns an error for an empty list of loads, a force of magnitude below zero, and loads, points or magnitudes that are not finite or beyond
    /// 1e50.
    pub(super) fn check(&self, grasp: &Engine) -> Result<(), Error> {
        self.check_size()?;
        match self {
            Self::Each(list) => list.iter().try_for_each(|load| grasp.load_alone(load, "load").map(drop)),
            Self::AnyForce { base, point, .. } => {
                grasp.load_alone(base, "base load")?;
                check_point(point)
            }
            Self::Turn(turn) => turn.check_in(grasp.space()),
        }
    }
}

impl<const C: usize> Loads<C> {
    /// Returns an error for an empty list of loads, and for a force whose magnitude is below zero, beyond 1e50 or NaN.
    pub(crate) fn check_size(&self) -> Result<(), Error> {
        match self {
            Self::Each(list) if list.is_empty() => {
                Err(Error::Argument { what: "number of loads", value: 0.0, allowed: "at least 1" })
            }
            Self::AnyForce { size, .. } if !(*size >= 0.0 && is_moderate(*size)) => {
                let allowed = "zero, or more and at most 1e50";
                Err(Error::Argument { what: "size of the force", value: *size, allowed })
            }
            _ => Ok(()),
        }
    }
}

/// [`Loads`] written as the fields of a question in a scene file: `load`, `loads` and `turn`, or `any_force`. The force `any_force` acts at the point
/// `at` in addition to the constant `load`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LoadFields<const C: usize> {
    pub(crate) load: Option<Wrench<C>>,
    pub(crate) loads: Vec<Wrench<C>>,
    pub(crate) any_force: Option<f64>,
    pub(crate) at: Option<SVector<f64, C>>,
    pub(crate) turn: Option<Turn<C>>,
}

impl<const C: usize> From<Loads<C>> for LoadFields<C> {
    fn from(given: Loads<C>) -> Self {
        let mut fields = Self { load: None, loads: Vec::new(), any_force: None, at: None, turn: None };
        match given {
            Loads::Each(list) if list.len() == 1 => fields.load = Some(list[0]),
            Loads::Each(list) => fields.loads = list,
            Loads::AnyForce { base, size, point } => {
                fields.load = Some(base).filter(|base| *base != Wrench::ZERO);
                (fields.any_force, fields.at) = (Some(size), Some(point.into()));
            }
            Loads::Turn(turn) => fields.turn = Some(turn),
        }
        fields
    }
}

impl<const C: usize> Loads<C> {
    /// The [`Loads`] given by the fields of a question: exactly one of `load`, `loads` and `any_force`. Together with `any_force`, `load` may be
    /// given as the constant load.
    ///
    /// # Errors
    /// [`Error::Question`] with a field that is missing, or that excludes another given field.
    pub(crate) fn of_fields(
        question: &'static str,
        (load, loads): (Option<Wrench<C>>, &[Wrench<C>]),
        (any_force, at): (Option<f64>, Option<SVector<f64, C>>),
    ) -> Result<Self, Error> {
        let wrong = |field, fault| Err(Error::Question { question, field, fault });
        if at.is_some() && any_force.is_none() {
            return wrong("at", "is given, must be left out unless there is any_force (a load has its own)");
        }
        let (base, point) = (load.unwrap_or(Wrench::ZERO), at.map_or([0.0; C], Into::into));
        match (load, loads, any_force) {
            (Some(load), [], None) => Ok(load.into()),
            (None, [_, ..], None) => Ok(Self::Each(loads.to_vec())),
            (_, [], Some(size)) => Ok(Self::AnyForce { base, size, point }),
            (None, [], None) => wrong("load", "is missing, must be one of load, loads and any_force"),
            _ => wrong("load", "is given twice, must be one of load, loads and any_force"),
        }
    }
}

/// A single load becomes a list of one load.
impl<const C: usize> From<Wrench<C>> for Loads<C> {
    fn from(load: Wrench<C>) -> Self {
        Self::Each(vec![load])
    }
}

/// A list of loads, which act one at a time.
impl<const C: usize> From<Vec<Wrench<C>>> for Loads<C> {
    fn from(loads: Vec<Wrench<C>>) -> Self {
        Self::Each(loads)
    }
}

/// Returns an error for a point with a coordinate that is not finite or beyond 1e50.
pub(super) fn check_point(point: &[f64; 3]) -> Result<(), Error> {
    match point.iter().find(|x| !is_moderate(**x)) {
        Some(&value) => Err(Error::Argument { what: "point of the force", value, allowed: MODERATE }),
        None => Ok(()),
    }
}
