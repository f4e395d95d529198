//! The loads that a grasp must hold.

use crate::error::{Error, MODERATE, is_moderate};
use crate::grasp::{Engine, Wrench};
use crate::load_path::Turn;
use crate::prelude::*;

/// A set of loads.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Loads<const C: usize> {
    /// Each load of the list, one at a time.
    Each(Vec<Wrench<C>>),
    /// A constant load plus a force of any direction.
    AnyForce {
        /// The constant load, N and N m.
        base: Wrench<C>,
        /// The size of the force, N.
        size: f64,
        /// The point at which the force acts, m.
        point: [f64; C],
    },
    /// A load that turns, over a full turn or up to its last angle.
    Turn(Turn<C>),
}

impl Loads<3> {
    /// Refuses sets without a load, and loads that are not finite or beyond 1e50.
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
    /// Refuses sets without a load, and forces without a size.
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

/// One load.
impl<const C: usize> From<Wrench<C>> for Loads<C> {
    fn from(load: Wrench<C>) -> Self {
        Self::Each(vec![load])
    }
}

/// Each load of the list, one at a time.
impl<const C: usize> From<Vec<Wrench<C>>> for Loads<C> {
    fn from(loads: Vec<Wrench<C>>) -> Self {
        Self::Each(loads)
    }
}

/// Refuses a point that is not finite or beyond 1e50.
pub(super) fn check_point(point: &[f64; 3]) -> Result<(), Error> {
    match point.iter().find(|x| !is_moderate(**x)) {
        Some(&value) => Err(Error::Argument { what: "point of the force", value, allowed: MODERATE }),
        None => Ok(()),
    }
}
