//! A question to the scenes of a block.

use super::block::{Block, Parted};
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Lanes;
use super::prepared::Prepared;
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::grasp::Wrench;

/// Scenes side by side, made ready: only borrowed, for they are too large to be moved for every block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scenes<'a, const D: usize, const C: usize, const N: usize, const L: usize> {
    pub(super) block: &'a Block<C, N, L>,
    pub(super) parted: &'a Parted<N, L>,
    pub(super) ready: &'a Prepared<D, C, N, L>,
    /// Forces that the commands alone bring about, clearances included.
    pub(super) squeezed: &'a Forces<C, N, L>,
}

/// What is asked of every scene alike.
pub(crate) trait ScreeningQuestion<const D: usize, const C: usize>: Sync {
    type Answer: Copy + Send;
    /// Before it is asked.
    const UNKNOWN: Self::Answer;
    /// Must be inlined for the caller's vectors to be used.
    fn ask<const N: usize, const L: usize>(&self, scenes: Scenes<'_, D, C, N, L>) -> [Self::Answer; L];
}

impl<const D: usize, const C: usize, const N: usize, const L: usize> Scenes<'_, D, C, N, L> {
    /// The forces that a load alone brings about.
    #[inline(always)]
    pub(super) fn under(&self, load: &Wrench<C>) -> Forces<C, N, L> {
        self.ready.under(self.block, load)
    }

    /// The forces of the commands and a load together.
    #[inline(always)]
    pub(super) fn squeezed_under(&self, load: &Wrench<C>) -> Forces<C, N, L> {
        self.squeezed.with(&self.under(load), ON_THE_EDGE / ROUNDING)
    }

    /// Forces that the commands alone bring about, and those of the clearances, with the rounding of
    /// loads.
    #[inline(always)]
    pub(super) fn apart(&self) -> [Forces<C, N, L>; 2] {
        let mut largest = Lanes::ZERO;
        let mut overlaps = [Lanes::ZERO; N];
        for i in 0..N {
            largest = largest.max(self.parted.clearance[i].abs());
            overlaps[i] = -self.parted.clearance[i];
        }
        // Without clearances they are known, to the last bit.
        let mut apart = [*self.squeezed, Forces::none()];
        if largest.0 != [0.0; L] {
            let squeeze = |pressed, sheared| self.ready.squeezed_by(self.block, (pressed, sheared));
            apart[0] = squeeze(&self.parted.commanded, &self.block.sheared);
            apart[1] = squeeze(&overlaps, &[[Lanes::ZERO; N]; C]);
            // Springs do not work on what stretches none of them: where their forces cancel it is rounding.
            apart[1].free = Lanes::ZERO;
        }
        for forces in &mut apart {
            for i in 0..N {
                forces.rounding[i] = Lanes::all(ROUNDING / ON_THE_EDGE) * forces.rounding[i];
            }
        }
        apart
    }
}
