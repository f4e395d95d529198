//! Error bounds of commands and loads.

use crate::numerics::IntoList;
use nalgebra::SVector;

use crate::error::{Error, Field, is_moderate};
use crate::grasp::{Engine, Wrench};
use crate::prelude::*;

/// Error bounds of the commands and loads, which enter the forces of a sticking grasp linearly. Each number may be off by its bound to either side,
/// independently of the others. Numbers without bounds are exact.
///
/// ```
/// use grasp_lcp::planar::{Bounds, Wrench};
///
/// // Commands of two fingers to 0.1 mm, and a pull of up to 2 N along x and as much along y.
/// let bounds = Bounds::none().with_commands([[1e-4, 1e-4]; 2]).with_base(Wrench::force([2.0, 2.0]));
/// # let _ = bounds;
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds<const C: usize> {
    pub(super) commands: Option<Vec<SVector<f64, C>>>,
    pub(super) base: Wrench<C>,
    pub(super) direction: Wrench<C>,
}

impl<const C: usize> Bounds<C> {
    /// No error bounds: all commands and loads are exact.
    #[must_use]
    pub fn none() -> Self {
        Self { commands: None, base: Wrench::ZERO, direction: Wrench::ZERO }
    }

    /// Bounds of the errors of the finger commands: for each contact one bound per axis of its frame, m.
    #[must_use]
    pub fn with_commands(mut self, bounds: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        self.commands = Some(bounds.into_iter().map(|bound| SVector::from(bound.into())).list());
        self
    }

    /// Bounds of the errors of the base load's components, N and N m about the origin.
    #[must_use]
    pub fn with_base(mut self, bounds: Wrench<C>) -> Self {
        self.base = bounds;
        self
    }

    /// Bounds of the errors of the load direction's components, N and N m per unit of the load factor.
    #[must_use]
    pub fn with_direction(mut self, bounds: Wrench<C>) -> Self {
        self.direction = bounds;
        self
    }
}

impl Bounds<3> {
    /// An error for a bound below zero or beyond 1e50, and for a list of command bounds whose length is not the number of contacts.
    pub(super) fn check(&self, grasp: &Engine) -> Result<(), Error> {
        let allowed = "from 0 to 1e50";
        let is_bad = |x: &&f64| !(**x >= 0.0 && is_moderate(**x));
        for (bounds, what) in
            [(&self.base, "bound of the base load"), (&self.direction, "bound of the load direction")]
        {
            if let Some(&value) = bounds.components().iter().find(is_bad) {
                return Err(Error::Argument { what, value, allowed });
            }
        }
        let Some(commands) = &self.commands else { return Ok(()) };
        grasp.check_commands(commands, "bounds of the commands", Field::Command)?;
        match commands.iter().find_map(|bounds| bounds.iter().find(is_bad)) {
            Some(&value) => Err(Error::Argument { what: "bound of a command", value, allowed }),
            None => Ok(()),
        }
    }
}
