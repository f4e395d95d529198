//! Where answers go.

use super::lanes::Packed;

/// The places for the answers to one question by the scenes of a block.
pub(crate) struct Told<'a, T, X: Packed> {
    /// Scene by scene, for each question by question.
    answers: &'a mut [T],
    /// Scenes that are answered here.
    these: X::Each<bool>,
    question: usize,
    questions: usize,
    /// How many answers a question has.
    each: usize,
}

impl<'a, T: Copy, X: Packed> Told<'a, T, X> {
    /// The places for one question of so many, with so many answers each.
    #[inline(always)]
    pub(super) fn new(
        answers: &'a mut [T],
        these: X::Each<bool>,
        [question, questions]: [usize; 2],
        each: usize,
    ) -> Self {
        Self { answers, these, question, questions, each }
    }

    /// The answers of a scene; `None` if it goes another way, or a last block is not full.
    #[inline(always)]
    pub(super) fn places(&mut self, scene: usize) -> Option<&mut [T]> {
        let first = (scene * self.questions + self.question) * self.each;
        if self.these.as_ref()[scene] { self.answers.get_mut(first..first + self.each) } else { None }
    }

    /// One answer for each scene.
    #[inline(always)]
    pub(super) fn each(&mut self, answers: X::Each<T>) {
        for (scene, &answer) in answers.as_ref().iter().enumerate() {
            if let Some(places) = self.places(scene) {
                places[0] = answer;
            }
        }
    }
}
