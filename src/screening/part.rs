//! Screening of a part of a batch on one thread.

use super::balance::RigidBody;
use super::block::{Block, Layout};
use super::forces::Forces;
use super::lanes::{LANES, Lanes};
use super::method::{is_a_pair, is_a_triangle};
use super::pair::Pair;
use super::question::{Scenes, ScreeningQuestion};
use super::springs::StickingSprings;
use super::told::Told;
use super::triangle::Triangle;
use crate::numerics::{Compiled, OnVectors, Vectors, on_the_widest};

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
        self.screen_on(vectors);
    }
}

impl<const C: usize, Q: ScreeningQuestion<C>> Part<'_, C, Q> {
    #[inline(always)]
    fn screen_on<V: Vectors>(self, vectors: V) {
        let contacts = self.contacts;
        let numbers = self.numbers.chunks_exact(Layout::<C>::numbers(contacts));
        let blocks = numbers.zip(self.parted.chunks_exact(2 * contacts));
        let of_block = LANES * self.questions.len() * Q::answers(contacts);
        let blocks = blocks.zip(self.answers.chunks_mut(of_block));
        let questions = self.questions;
        let mut edges = Answering::<_, Triangle<C, Lanes>, C>::on(vectors);
        let mut motions = Answering::<_, RigidBody<C, Lanes>, C>::on(vectors);
        for ((numbers, parted), answers) in blocks {
            let block = Block { contacts, numbers, parted };
            if const { C == 2 } && is_a_pair(&block) {
                answer_pairs(vectors, &block, questions, answers);
                continue;
            }
            if const { C == 3 } && is_a_triangle(&block) {
                edges.answer(&block, questions, answers);
            }
            motions.answer(&block, questions, answers);
        }
    }
}

/// Pairs have the shortest method, which is compiled as one function.
#[inline(never)]
fn answer_pairs<V: Vectors, const C: usize, Q: ScreeningQuestion<C>>(
    vectors: V,
    block: &Block<'_, C, Lanes>,
    questions: &[Q],
    answers: &mut [Q::Answer],
) {
    vectors.run(
        #[inline(always)]
        || {
            let block = Block { contacts: 2, ..*block };
            Answering::<_, Pair<Lanes>, C>::on(Compiled).answer(&block, questions, answers);
        },
    );
}

/// The working memory of one method for a block of scenes.
struct Answering<V, P, const C: usize> {
    vectors: V,
    ready: P,
    squeezed: Forces<C, Lanes>,
    room: [Forces<C, Lanes>; 3],
}

impl<V: Vectors, P: StickingSprings<C, Lanes>, const C: usize> Answering<V, P, C> {
    #[inline(always)]
    fn on(vectors: V) -> Self {
        Self { vectors, ready: P::none(), squeezed: Forces::none(), room: [Forces::none(); 3] }
    }

    /// Answers the questions for those scenes of a block that use this method.
    #[inline(always)]
    fn answer<Q: ScreeningQuestion<C>>(
        &mut self,
        block: &Block<'_, C, Lanes>,
        questions: &[Q],
        answers: &mut [Q::Answer],
    ) {
        let these = P::METHOD.of(block);
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
