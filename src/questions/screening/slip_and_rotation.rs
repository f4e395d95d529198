//! First slip (the first contact stops sticking), and the rotation of the object up to the whole load, for a batch of grasps, each under its own
//! load. The base load acts at load factor 0. A block holds as many grasps as a SIMD vector has numbers (lanes).

use super::answer_slots::AnswerSlots;
use super::block::Layout;
use super::first_exit::judge;
use super::first_slip::SlipCode;
use super::forces::AnyForces;
use super::kernels::Kernels;
use super::lanes::{Packed, dot};
use super::moved::ObjectMotion;
use super::point_batch::PointBatch;
use super::pull::Pull;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened::Screened;
use super::springs::Cause;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::numerics::Vectors;
use crate::prelude::*;

/// The question for first slip and rotation of each grasp of a batch under its own load; `pulls` has one load for each grasp.
pub(crate) struct SlipAndRotation<const C: usize> {
    pub(crate) pulls: Vec<Pull<C>>,
    /// Whether the rotation of the object is to be computed, too.
    pub(crate) turns: bool,
}

/// First slip of one grasp as its load grows, and the rotation of its object computed as if every contact stuck.
#[derive(Clone, Copy)]
pub(crate) struct WhileSticking {
    pub(crate) first: Screened,
    /// The larger of the object's rotations under the base load and under the whole load (factor 1), rad. NaN if the position of the object is not
    /// determined, or if no rotation was computed.
    pub(crate) turn: f64,
}

impl<const C: usize> SlipAndRotation<C> {
    /// First slip and rotation of every grasp of a batch, on one thread. Empty if the number of loads is not the number of grasps.
    pub(crate) fn answers(self, batch: &PointBatch<C>) -> Vec<WhileSticking> {
        let mut answers = Vec::new();
        if self.pulls.len() != batch.len() {
            return answers;
        }
        batch.parts(&[self], batch.len(), &mut answers).for_each(Kernels::get().put_on);
        answers
    }

    /// One component of the load on the grasp in each lane of a block, whose first grasp has the index `first` in the batch. Lanes beyond the last
    /// grasp repeat the load of the last grasp.
    #[inline(always)]
    fn lanes<X: Packed>(&self, first: usize, component: impl Fn(&Pull<C>) -> f64) -> X {
        let last = self.pulls.len() - 1;
        X::of(X::each(|lane| component(&self.pulls[(first + lane).min(last)])))
    }
}

impl<const C: usize> ScreeningQuestion<C> for SlipAndRotation<C> {
    type Answer = WhileSticking;
    const UNKNOWN: WhileSticking = WhileSticking { first: Screened(SlipCode::UNKNOWN), turn: f64::NAN };

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [rates, base, _]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, WhileSticking, X>,
    ) {
        let zero = X::all(0.0);
        let [mut at_rest, mut more] = [[zero; 6]; 2];
        for k in 0..Layout::<C>::COORDINATES {
            at_rest[k] = self.lanes(prepared.first, |pull| pull.base.components()[k]);
            more[k] = self.lanes(prepared.first, |pull| pull.direction.components()[k]);
        }
        prepared.under_lanes(&more, rates);
        prepared.under_lanes(&at_rest, base);
        base.add_to(prepared.block.contacts, prepared.squeezed, ON_THE_EDGE / ZERO_SLACK);
        let first = judge(prepared.vectors, &prepared.block, base, rates);
        let mut turn = X::all(f64::NAN);
        if self.turns {
            let start = prepared.turned(&at_rest, base);
            base.add_to(prepared.block.contacts, rates, 1.0);
            for k in 0..Layout::<C>::COORDINATES {
                more[k] += at_rest[k];
            }
            // `max` ignores NaN. Adding zero times `start` makes `turn` NaN if `start` is NaN.
            turn = start.max(prepared.turned(&more, base)) + zero * start;
        }
        let first = first.as_ref();
        slots.each(X::each(|lane| WhileSticking { first: first[lane], turn: turn.lane(lane) }));
    }
}

impl<V: Vectors, const C: usize, X: Packed> PreparedBlock<'_, V, C, X> {
    /// The magnitude of the object's rotation under the commands and a load, rad, given the contact forces of both together. NaN if the position of
    /// the object is not determined.
    #[inline(always)]
    fn turned(&self, load: &[X; 6], forces: &AnyForces<C, X>) -> X {
        let mut moved = ObjectMotion::none();
        let cause = Cause { commands: self.block.commands(), load: *load };
        self.ready.turned(self.vectors, &self.block, &cause, forces, &mut moved);
        dot(&moved.turn, &moved.turn).sqrt()
    }
}
