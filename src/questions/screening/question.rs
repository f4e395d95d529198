//! A question of screening, and the block of grasps for which it is answered. An example is: at which load factor does the first contact cease to
//! stick? A block holds as many grasps as a SIMD vector has numbers (lanes). A command is the displacement that a finger would make if there were no
//! object. A clearance is the gap between finger and object before the command; it is negative if they overlap.

use super::answer_slots::AnswerSlots;
use super::block::{Block, Commanded, MOST_SCREENED};
use super::forces::AnyForces;
use super::lanes::Packed;
use super::springs::StickingSprings;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::grasp::Wrench;
use crate::numerics::Vectors;

/// The grasps of a block, one in each lane, with everything that does not depend on the question already computed: the springs' response to loads
/// (`ready`), and the contact forces under commands and clearances without a load (`squeezed`). Both are borrowed: they are large, and every question
/// reads them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PreparedBlock<'a, V, const C: usize, X: Packed> {
    pub(super) vectors: V,
    pub(super) block: Block<'a, C, X>,
    pub(super) ready: &'a StickingSprings<C, X>,
    /// Index in the batch of the grasp in the first lane.
    pub(super) first: usize,
    /// The contact forces that the commands, less the clearances, cause without a load.
    pub(super) squeezed: &'a AnyForces<C, X>,
}

/// Scratch buffers for three sets of contact forces that a question needs, created once for all blocks.
pub(crate) type WorkingForces<'a, const C: usize, X> = [&'a mut AnyForces<C, X>; 3];

/// A question of screening, such as the load factor of first slip under a load, which is answered for every grasp of a batch.
pub(crate) trait ScreeningQuestion<const C: usize>: Sync + Sized {
    type Answer: Copy + Send;
    /// The value that fills the storage of answers before they are computed.
    const UNKNOWN: Self::Answer;
    /// The number of entries of type `Answer` that answer the question for a grasp with `contacts` contacts; they are stored side by side.
    fn answers(_contacts: usize) -> usize {
        1
    }
    /// Answers the question for the grasps of a block; the answers are written to the last argument. Implementations must be inlined. If they were
    /// not, the vector instructions of the caller would not be used.
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        working: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, Self::Answer, X>,
    );
}

impl<V: Vectors, const C: usize, X: Packed> PreparedBlock<'_, V, C, X> {
    /// Computes the contact forces that a load alone causes; all grasps have the same load.
    #[inline(always)]
    pub(super) fn under(&self, load: &Wrench<C>, forces: &mut AnyForces<C, X>) {
        let mut lanes = [X::all(0.0); 6];
        for (lane, component) in lanes.iter_mut().zip(load.components()) {
            *lane = X::all(*component);
        }
        self.under_lanes(&lanes, forces);
    }

    /// Computes the contact forces that a load alone causes; each grasp has its own load.
    #[inline(always)]
    pub(super) fn under_lanes(&self, load: &[X; 6], forces: &mut AnyForces<C, X>) {
        self.ready.load(self.vectors, &self.block, load, forces);
    }

    /// Computes the contact forces that the commands, less the clearances, and a load cause together.
    #[inline(always)]
    pub(super) fn squeezed_under(&self, load: &Wrench<C>, forces: &mut AnyForces<C, X>) {
        self.under(load, forces);
        forces.add_to(self.block.contacts, self.squeezed, ON_THE_EDGE / ZERO_SLACK);
    }

    /// Computes the contact forces that the commands alone cause, and the contact forces that the clearances alone cause. The bound of the rounding
    /// error of each force is [`ZERO_SLACK`] (5e-14) times the sum of the magnitudes of its terms, which is also the bound for forces due to loads.
    /// Other methods give forces due to commands a wider bound, [`ON_THE_EDGE`] (1e-12) times this sum.
    #[inline(always)]
    pub(super) fn apart(&self, [commands, clearances]: [&mut AnyForces<C, X>; 2]) {
        let [commanded, clearance] = self.block.commands_and_clearances();
        let mut largest = X::all(0.0);
        let mut overlaps = [X::all(0.0); MOST_SCREENED];
        for (overlap, clearance) in overlaps.iter_mut().zip(clearance) {
            largest = largest.max(clearance.abs());
            *overlap = -*clearance;
        }
        // Without clearances the forces due to commands are copied from `squeezed`, the forces without a load. Thus both are equal to the last bit.
        commands.copy_from(self.squeezed);
        clearances.clear();
        if !largest.is_all(0.0) {
            let contacts = self.block.contacts.min(MOST_SCREENED);
            let squeeze = |pressed, sheared, forces: &mut AnyForces<C, X>| {
                self.ready.squeeze(self.vectors, &self.block, Some(&Commanded { pressed, sheared }), forces);
            };
            squeeze(commanded, self.block.commands().sheared, commands);
            squeeze(&overlaps[..contacts], [&[X::all(0.0); MOST_SCREENED][..contacts]; C], clearances);
            // `free` is positive if the load or spring forces do work along a motion that no contact resists. Clearances only stretch springs, whose
            // forces do no such work. Rounding of forces that cancel each other could make `free` positive, so it is set to zero.
            clearances.free = X::all(0.0);
        }
        for forces in [commands, clearances] {
            forces.scale_rounding(ZERO_SLACK / ON_THE_EDGE);
        }
    }
}
