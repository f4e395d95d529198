//! A load that grows from a base load, as a question of screening, which answers it for many grasps at once: at which load factor does the first
//! contact cease to stick?

use super::answer_slots::AnswerSlots;
use super::first_exit::judge;
use super::first_slip::SlipCode;
use super::lanes::Packed;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened::Screened;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::numerics::Vectors;

/// A load on the object of every screened grasp that grows from a base load in a fixed direction: `base + factor · direction`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull<const C: usize> {
    pub(super) base: Wrench<C>,
    pub(super) direction: Wrench<C>,
    /// Whether the base load is not zero.
    pub(super) loaded: bool,
}

impl<const C: usize> Pull<C> {
    /// The load on the object `base + factor · direction`, factor >= 0: forces in N, moments in N m about the origin of the coordinates of each
    /// grasp. The factor has no unit, and the direction may have any length.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the base load or of the direction is not finite or larger than 1e50.
    pub fn new(base: &Wrench<C>, direction: &Wrench<C>) -> Result<Self, Error> {
        base.check("base load")?;
        direction.check("load direction")?;
        Ok(Self { base: *base, direction: *direction, loaded: *base != Wrench::ZERO })
    }
}

impl<const C: usize> ScreeningQuestion<C> for Pull<C> {
    type Answer = Screened;
    const UNKNOWN: Screened = Screened(SlipCode::UNKNOWN);

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [rates, base, _]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, Screened, X>,
    ) {
        prepared.under(&self.direction, rates);
        let mut start = prepared.squeezed;
        if self.loaded {
            prepared.squeezed_under(&self.base, base);
            start = base;
        }
        slots.each(judge(prepared.vectors, &prepared.block, start, rates));
    }
}
