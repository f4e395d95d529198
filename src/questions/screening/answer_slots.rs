//! The places in memory where the kernels of screening store their answers.

use super::lanes::Packed;

/// The places for the answers to one question by all grasps of one block, which lie side by side in lanes.
pub(crate) struct AnswerSlots<'a, T, X: Packed> {
    /// All answers of the block, ordered by grasp, then by question.
    answers: &'a mut [T],
    /// For each lane, whether the grasp in it is answered by the present [`Method`](super::method::Method).
    these: X::Each<bool>,
    question: usize,
    questions: usize,
    /// The number of answers by one grasp to one question.
    each: usize,
}

impl<'a, T: Copy, X: Packed> AnswerSlots<'a, T, X> {
    /// The places for question number `question` of `questions`, to which each grasp gives `each` answers.
    #[inline(always)]
    pub(super) fn new(
        answers: &'a mut [T],
        these: X::Each<bool>,
        [question, questions]: [usize; 2],
        each: usize,
    ) -> Self {
        Self { answers, these, question, questions, each }
    }

    /// The places for the grasp in lane `scene`. `None` if another method answers it, or if the lane is unused because the last block is not full.
    #[inline(always)]
    pub(super) fn places(&mut self, scene: usize) -> Option<&mut [T]> {
        let first = (scene * self.questions + self.question) * self.each;
        if self.these.as_ref()[scene] { self.answers.get_mut(first..first + self.each) } else { None }
    }

    /// Stores one answer for the grasp in each lane.
    #[inline(always)]
    pub(super) fn each(&mut self, answers: X::Each<T>) {
        for (scene, &answer) in answers.as_ref().iter().enumerate() {
            if let Some(places) = self.places(scene) {
                places[0] = answer;
            }
        }
    }
}
