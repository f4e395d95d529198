//! Screening of a part of a batch on one thread.

use super::block::{Block, Layout};
use super::forces::Forces;
use super::lanes::{LANES, Lanes};
use super::method::Method;
use super::question::{Scenes, ScreeningQuestion};
use super::springs::StickingSprings;
use super::told::Told;
use crate::numerics::{OnVectors, Vectors, on_the_widest};

/// Scenes, the questions about them, and the slots for their answers.
pub(super) struct Part<'a, const C: usize, Q: ScreeningQuestion<C>> {
    pub(super) contacts: usize,
    /// Laid out as in [`Block`], block after block.
    pub(super) numbers: &'a [Lanes],
    pub(super) parted: &'a [Lanes],
    pub(super) questions: &'a [Q],
    /// Ordered by scene, then by question.
    pub(super) answers: &'a mut [Q::Answer],
}

/// Answers the questions for a part.
pub(super) fn screen<const C: usize, Q: ScreeningQuestion<C>>(part: Part<'_, C, Q>) {
    on_the_widest(part);
}

impl<const C: usize, Q: ScreeningQuestion<C>> OnVectors for Part<'_, C, Q> {
    type Output = ();
    #[inline(always)]
    fn on<V: Vectors>(self, vectors: V) {
        let contacts = self.contacts;
        let numbers = self.numbers.chunks_exact(Layout::<C>::numbers(contacts));
        let blocks = numbers.zip(self.parted.chunks_exact(2 * contacts));
        let of_block = LANES * self.questions.len() * Q::answers(contacts);
        let mut methods =
            [Method::Edges, Method::Motions].map(|method| Answering::<V, C>::on(vectors, method));
        for ((numbers, parted), answers) in blocks.zip(self.answers.chunks_mut(of_block)) {
            for method in &mut methods {
                method.answer(&Block { contacts, numbers, parted }, self.questions, answers);
            }
        }
    }
}

/// The working memory of one method for a block of scenes.
struct Answering<V, const C: usize> {
    vectors: V,
    ready: StickingSprings<C, Lanes>,
    squeezed: Forces<C, Lanes>,
    room: [Forces<C, Lanes>; 3],
}

impl<V: Vectors, const C: usize> Answering<V, C> {
    fn on(vectors: V, method: Method) -> Self {
        let ready = StickingSprings::none(method);
        Self { vectors, ready, squeezed: Forces::none(), room: [Forces::none(); 3] }
    }

    /// Answers the questions for those scenes of a block that use this method.
    #[inline(always)]
    fn answer<Q: ScreeningQuestion<C>>(
        &mut self,
        block: &Block<'_, C, Lanes>,
        questions: &[Q],
        answers: &mut [Q::Answer],
    ) {
        let these = self.ready.method().of(block);
        if these == [false; LANES] {
            return;
        }
        let Self { vectors, ready, squeezed, room } = self;
        ready.prepare(*vectors, block);
        ready.squeeze(*vectors, block, None, squeezed);
        let scenes = Scenes { vectors: *vectors, block: *block, ready: &*ready, squeezed: &*squeezed };
        for (k, question) in questions.iter().enumerate() {
            let [a, b, c] = &mut *room;
            let mut told = Told::new(answers, these, [k, questions.len()], Q::answers(block.contacts));
            question.ask(&scenes, [a, b, c], &mut told);
        }
    }
}
