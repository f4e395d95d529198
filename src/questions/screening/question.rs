//! A question about the scenes of a block.

use super::answer_slots::AnswerSlots;
use super::block::{Block, Commanded, MOST_SCREENED};
use super::forces::AnyForces;
use super::lanes::Packed;
use super::springs::StickingSprings;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::grasp::Wrench;
use crate::numerics::Vectors;

/// Prepared scenes, one in each lane. They are borrowed because they are too large to be moved for every block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scenes<'a, V, const C: usize, X: Packed> {
    pub(super) vectors: V,
    pub(super) block: Block<'a, C, X>,
    pub(super) ready: &'a StickingSprings<C, X>,
    /// Index of the scene in the first lane.
    pub(super) first: usize,
    /// Forces of the commands less the clearances, without load.
    pub(super) squeezed: &'a AnyForces<C, X>,
}

/// Working memory for the forces of a question, created once for all blocks.
pub(crate) type Room<'a, const C: usize, X> = [&'a mut AnyForces<C, X>; 3];

/// A question that every scene of a batch gets alike.
pub(crate) trait ScreeningQuestion<const C: usize>: Sync + Sized {
    type Answer: Copy + Send;
    /// The answer before the question has been asked.
    const UNKNOWN: Self::Answer;
    /// The number of answers of a scene with `contacts` contacts, stored side by side.
    fn answers(_contacts: usize) -> usize {
        1
    }
    /// Implementations must be inlined, or the caller's vector instructions would not be used.
    fn ask<V: Vectors, X: Packed>(
        &self,
        scenes: &Scenes<'_, V, C, X>,
        room: Room<'_, C, X>,
        told: &mut AnswerSlots<'_, Self::Answer, X>,
    );
}

impl<V: Vectors, const C: usize, X: Packed> Scenes<'_, V, C, X> {
    /// The forces of a load alone.
    #[inline(always)]
    pub(super) fn under(&self, load: &Wrench<C>, forces: &mut AnyForces<C, X>) {
        let mut lanes = [X::all(0.0); 6];
        for (lane, component) in lanes.iter_mut().zip(load.components()) {
            *lane = X::all(*component);
        }
        self.under_lanes(&lanes, forces);
    }

    /// The forces of a load alone, which may differ from scene to scene.
    #[inline(always)]
    pub(super) fn under_lanes(&self, load: &[X; 6], forces: &mut AnyForces<C, X>) {
        self.ready.load(self.vectors, &self.block, load, forces);
    }

    /// The forces of the commands and a load together.
    #[inline(always)]
    pub(super) fn squeezed_under(&self, load: &Wrench<C>, forces: &mut AnyForces<C, X>) {
        self.under(load, forces);
        forces.add_to(self.block.contacts, self.squeezed, ON_THE_EDGE / ZERO_SLACK);
    }

    /// The forces of the commands alone, and those of the clearances alone, both with the rounding of loads.
    #[inline(always)]
    pub(super) fn apart(&self, [commands, clearances]: [&mut AnyForces<C, X>; 2]) {
        let [commanded, clearance] = self.block.parted();
        let mut largest = X::all(0.0);
        let mut overlaps = [X::all(0.0); MOST_SCREENED];
        for (overlap, clearance) in overlaps.iter_mut().zip(clearance) {
            largest = largest.max(clearance.abs());
            *overlap = -*clearance;
        }
        // Without clearances the forces of the commands are those computed before, to the last bit.
        commands.copy_from(self.squeezed);
        clearances.clear();
        if !largest.is_all(0.0) {
            let contacts = self.block.contacts.min(MOST_SCREENED);
            let squeeze = |pressed, sheared, forces: &mut AnyForces<C, X>| {
                self.ready.squeeze(self.vectors, &self.block, Some(&Commanded { pressed, sheared }), forces);
            };
            squeeze(commanded, self.block.commands().sheared, commands);
            squeeze(&overlaps[..contacts], [&[X::all(0.0); MOST_SCREENED][..contacts]; C], clearances);
            // Clearances stretch springs alone and drive no free motion. Where their forces cancel, `free` would come from rounding.
            clearances.free = X::all(0.0);
        }
        for forces in [commands, clearances] {
            forces.scale_rounding(ZERO_SLACK / ON_THE_EDGE);
        }
    }
}
