//! The load on a grasp in screening.

use super::first_exit::judge;
use super::first_slip::SlipCode;
use super::question::{Scenes, ScreeningQuestion};
use super::screened::Screened;
use crate::error::Error;
use crate::grasp::Wrench;

/// The load on a grasp in screening: where it begins, and the direction in which it grows from
/// there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull<const C: usize> {
    pub(super) base: Wrench<C>,
    pub(super) direction: Wrench<C>,
    /// Whether the base load is any.
    pub(super) loaded: bool,
}

impl<const C: usize> Pull<C> {
    /// The load on the object `base + factor · direction`, factor >= 0: forces in N, moments in N m
    /// about the origin of the coordinates of each grasp. The factor has no unit, and no length is
    /// asked of the direction.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of either is not finite or larger than 1e50.
    pub fn new(base: &Wrench<C>, direction: &Wrench<C>) -> Result<Self, Error> {
        base.check("base load")?;
        direction.check("load direction")?;
        Ok(Self { base: *base, direction: *direction, loaded: *base != Wrench::ZERO })
    }
}

impl<const D: usize, const C: usize> ScreeningQuestion<D, C> for Pull<C> {
    type Answer = Screened;
    const UNKNOWN: Screened = Screened(SlipCode::UNKNOWN);

    #[inline(always)]
    fn ask<const N: usize, const L: usize>(&self, scenes: Scenes<'_, D, C, N, L>) -> [Screened; L] {
        let rates = scenes.under(&self.direction);
        if !self.loaded {
            return judge(&scenes.block.friction, scenes.squeezed, &rates);
        }
        judge(&scenes.block.friction, &scenes.squeezed_under(&self.base), &rates)
    }
}
