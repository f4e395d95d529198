//! The places in memory where the kernels of screening store their answers.

use super::lanes::Packed;

/// The memory for the answers of all grasps of one block to one question, such as the onset under one load. Grasps lie side by side in the lanes of
/// vectors.
pub(crate) struct AnswerSlots<'a, T, X: Packed> {
    /// All answers of the block, ordered by grasp, then by question.
    answers: &'a mut [T],
    /// For each lane, whether the forces of the grasp in it are found by the present [`Method`](super::method::Method).
    these: X::Each<bool>,
    question: usize,
    questions: usize,
    /// The number of answers that one grasp has to one question.
    each: usize,
}

impl<'a, T: Copy, X: Packed> AnswerSlots<'a, T, X> {
    /// The memory for the answers to question number `question` of `questions`, `each` answers for a grasp.
    #[inline(always)]
    pub(super) fn new(
        answers: &'a mut [T],
        these: X::Each<bool>,
        [question, questions]: [usize; 2],
        each: usize,
    ) -> Self {
        Self { answers, these, question, questions, each }
    }

    /// The memory for the answers of the grasp in lane `scene`. `None` if the forces of this grasp are found by another method, or if the lane is
    /// unused because the last block is not full.
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
