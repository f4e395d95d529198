//! Screening of a part of a batch on one thread.

use super::answer_slots::AnswerSlots;
use super::block::{Block, Layout};
use super::forces::Forces;
use super::lanes::{LANES, Lanes};
use super::method::Method;
use super::question::{Scenes, ScreeningQuestion};
use super::springs::StickingSprings;
use crate::numerics::{OnVectors, Vectors, on_the_widest};

/// Scenes, the questions about them, and the slots for their answers.
pub(super) struct BatchPart<'a, const C: usize, Q: ScreeningQuestion<C>> {
    pub(super) contacts: usize,
    /// Laid out as in [`Block`], block after block.
    pub(super) numbers: &'a [Lanes],
    pub(super) parted: &'a [Lanes],
    pub(super) questions: &'a [Q],
    /// Ordered by scene, then by question.
    pub(super) answers: &'a mut [Q::Answer],
}

/// Answers the questions for a part.
pub(super) fn screen<const C: usize, Q: ScreeningQuestion<C>>(part: BatchPart<'_, C, Q>) {
    on_the_widest(part);
}

impl<const C: usize, Q: ScreeningQuestion<C>> OnVectors for BatchPart<'_, C, Q> {
    type Output = ();
    #[inline(always)]
    fn on<V: Vectors>(self, vectors: V) {
        let contacts = self.contacts;
        let numbers = self.numbers.chunks_exact(Layout::<C>::numbers(contacts));
        let blocks = numbers.zip(self.parted.chunks_exact(2 * contacts));
        let of_block = LANES * self.questions.len() * Q::answers(contacts);
        let mut methods = [Method::Edges, Method::Motions].map(StickingSprings::none);
        let (mut squeezed, mut room) = (Forces::none(), [Forces::none(); 3]);
        for ((numbers, parted), answers) in blocks.zip(self.answers.chunks_mut(of_block)) {
            let block = Block { contacts, numbers, parted };
            for ready in &mut methods {
                let these = ready.method().of(&block);
                if these == [false; LANES] {
                    continue;
                }
                ready.prepare(vectors, &block);
                ready.squeeze(vectors, &block, None, &mut squeezed);
                let scenes = Scenes { vectors, block, ready, squeezed: &squeezed };
                for (k, question) in self.questions.iter().enumerate() {
                    let place = [k, self.questions.len()];
                    let mut told = AnswerSlots::new(answers, these, place, Q::answers(contacts));
                    question.ask(&scenes, room.each_mut(), &mut told);
                }
            }
        }
    }
}
