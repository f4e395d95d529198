//! A question to the scenes of a block.

use super::block::{Block, Commanded, count};
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Packed;
use super::springs::StickingSprings;
use super::told::Told;
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::grasp::Wrench;
use crate::numerics::Vectors;

/// Scenes side by side, made ready: only borrowed, for they are too large to be moved for every block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scenes<'a, V, P, const C: usize, const M: usize, X: Packed> {
    pub(super) vectors: V,
    pub(super) block: Block<'a, C, X>,
    pub(super) ready: &'a P,
    /// Forces that the commands alone bring about, clearances included.
    pub(super) squeezed: &'a Forces<C, M, X>,
}

/// Room for the forces that a question asks for. It is made once for all blocks.
pub(crate) type Room<'a, const C: usize, const M: usize, X> = [&'a mut Forces<C, M, X>; 3];

/// What is asked of every scene alike.
pub(crate) trait ScreeningQuestion<const C: usize>: Sync + Sized {
    type Answer: Copy + Send;
    /// Before it is asked.
    const UNKNOWN: Self::Answer;
    /// How many of them a scene of so many contacts gets, side by side.
    fn answers(_contacts: usize) -> usize {
        1
    }
    /// Must be inlined for the caller's vectors to be used.
    fn ask<V: Vectors, P: StickingSprings<C, M, X>, const M: usize, X: Packed>(
        &self,
        scenes: &Scenes<'_, V, P, C, M, X>,
        room: Room<'_, C, M, X>,
        told: &mut Told<'_, Self::Answer, X>,
    );
}

impl<V: Vectors, P: StickingSprings<C, M, X>, const C: usize, const M: usize, X: Packed>
    Scenes<'_, V, P, C, M, X>
{
    /// The forces that a load alone brings about.
    #[inline(always)]
    pub(super) fn under(&self, load: &Wrench<C>, forces: &mut Forces<C, M, X>) {
        self.ready.load(self.vectors, &self.block, load.components(), forces);
    }

    /// The forces of the commands and a load together.
    #[inline(always)]
    pub(super) fn squeezed_under(&self, load: &Wrench<C>, forces: &mut Forces<C, M, X>) {
        self.under(load, forces);
        forces.add_to(self.block.contacts, self.squeezed, ON_THE_EDGE / ROUNDING);
    }

    /// Forces that the commands alone bring about, and those of the clearances, with the rounding of
    /// loads.
    #[inline(always)]
    pub(super) fn apart(&self, [commands, clearances]: [&mut Forces<C, M, X>; 2]) {
        let [commanded, clearance] = self.block.parted();
        let mut largest = X::all(0.0);
        let mut overlaps = [X::all(0.0); M];
        for (overlap, clearance) in overlaps.iter_mut().zip(clearance) {
            largest = largest.max(clearance.abs());
            *overlap = -*clearance;
        }
        // Without clearances they are known, to the last bit.
        *commands = *self.squeezed;
        *clearances = Forces::none();
        if !largest.is_all(0.0) {
            let contacts = count::<M, X>(self.block.contacts);
            let squeeze = |pressed, sheared, forces: &mut Forces<C, M, X>| {
                self.ready.squeeze(self.vectors, &self.block, Some(&Commanded { pressed, sheared }), forces);
            };
            squeeze(commanded, self.block.commands().sheared, commands);
            squeeze(&overlaps[..contacts], [&[X::all(0.0); M][..contacts]; C], clearances);
            // Springs do not work on what stretches none of them: where their forces cancel it is rounding.
            clearances.free = X::all(0.0);
        }
        for forces in [commands, clearances] {
            for rounding in &mut forces.rounding {
                *rounding = X::all(ROUNDING / ON_THE_EDGE) * *rounding;
            }
        }
    }
}
