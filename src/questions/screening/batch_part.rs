//! Answers the questions of screening, such as the load factor at which the first contact ceases to stick, for consecutive grasps of a batch, on one
//! thread. A block holds as many grasps as a SIMD vector has numbers (lanes).

use super::answer_slots::AnswerSlots;
use super::block::{Block, Layout, MOST_POINTS, MOST_SCREENED};
use super::finger::Force;
use super::forces::{AnyForces, Forces};
use super::lanes::{LANES, Lanes};
use super::method::Method;
use super::question::{PreparedBlock, ScreeningQuestion};
use super::springs::StickingSprings;
use crate::numerics::{Each, OnVectors, Vectors, on_the_widest};
use crate::prelude::*;

/// The forces at contacts, with room for as many contacts as a grasp of a batch may have.
type WideForces<const C: usize> = Forces<C, Lanes, [Force<C, Lanes>; MOST_POINTS]>;

/// Consecutive grasps of a batch for one thread, the questions about these grasps, and the storage of the answers.
pub(super) struct BatchPart<'a, const C: usize, Q: ScreeningQuestion<C>> {
    pub(super) contacts: usize,
    /// Bit i is set if contact point i is the last point of its finger. A soft fingertip has several points, any other contact has one.
    pub(super) ends: u64,
    /// Index in the batch of the first of these grasps.
    pub(super) first: usize,
    /// The data of all blocks of grasps one after the other, each laid out as in [`Block`].
    pub(super) numbers: &'a [Lanes],
    pub(super) commands_and_clearances: &'a [Lanes],
    pub(super) questions: &'a [Q],
    /// The storage of the answers about these grasps, ordered by grasp, then by question.
    pub(super) answers: &'a mut [Q::Answer],
}

/// Answers all questions about the grasps of one part of a batch, with the widest vector instructions of the processor.
pub(super) fn screen<const C: usize, Q: ScreeningQuestion<C>>(part: BatchPart<'_, C, Q>) {
    on_the_widest(part);
}

impl<const C: usize, Q: ScreeningQuestion<C>> OnVectors for BatchPart<'_, C, Q> {
    type Output = ();
    #[inline(always)]
    fn on<V: Vectors>(self, vectors: V) {
        if self.contacts <= MOST_SCREENED {
            let [mut a, mut b, mut c, mut d] = [Forces::<C, Lanes>::none(); 4];
            self.screen(vectors, [&mut a, &mut b, &mut c, &mut d]);
        } else {
            // The forces of up to 64 points are on the heap. If they were on the stack, they would enlarge the frame for all batches, also those of
            // few contacts.
            let mut rooms = Vec::new();
            rooms.resize(4, WideForces::<C>::none());
            if let [a, b, c, d] = &mut rooms[..] {
                self.screen(vectors, [a, b, c, d]);
            }
        }
    }
}

impl<const C: usize, Q: ScreeningQuestion<C>> BatchPart<'_, C, Q> {
    /// Answers the questions block by block. The four arrays are scratch buffers: contact forces that are computed for one block and overwritten for
    /// the next.
    #[inline(always)]
    fn screen<V: Vectors>(self, vectors: V, [squeezed, a, b, c]: [&mut AnyForces<C, Lanes>; 4]) {
        let (contacts, ends) = (self.contacts, self.ends);
        let numbers = self.numbers.chunks_exact(Layout::<C>::numbers(contacts));
        let blocks = numbers.zip(self.commands_and_clearances.chunks_exact(2 * contacts));
        let of_block = LANES * self.questions.len() * Q::answers(contacts);
        let mut methods = [Method::Edges, Method::Motions].each(StickingSprings::none);
        let all = blocks.zip(self.answers.chunks_mut(of_block)).enumerate();
        for (k, ((numbers, commands_and_clearances), answers)) in all {
            let block = Block { contacts, ends, numbers, commands_and_clearances };
            let first = self.first + k * LANES;
            for ready in &mut methods {
                let is_method_of_lane = ready.method().of(&block);
                if is_method_of_lane == [false; LANES] {
                    continue;
                }
                ready.prepare(vectors, &block);
                ready.squeeze(vectors, &block, None, squeezed);
                let prepared = PreparedBlock { vectors, block, ready, first, squeezed };
                for (k, question) in self.questions.iter().enumerate() {
                    let place = [k, self.questions.len()];
                    let mut slots = AnswerSlots::new(answers, is_method_of_lane, place, Q::answers(contacts));
                    question.ask(&prepared, [&mut *a, &mut *b, &mut *c], &mut slots);
                }
            }
        }
    }
}
