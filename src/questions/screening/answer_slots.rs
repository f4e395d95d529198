//! The places where a kernel stores its answers.

use super::lanes::Packed;

/// The slots for the answers of the scenes of one block to one question.
pub(crate) struct AnswerSlots<'a, T, X: Packed> {
    /// Answers, ordered by scene, then by question.
    answers: &'a mut [T],
    /// Whether each scene is answered by the present method.
    these: X::Each<bool>,
    question: usize,
    questions: usize,
    /// The number of answers per scene and question.
    each: usize,
}

impl<'a, T: Copy, X: Packed> AnswerSlots<'a, T, X> {
    /// The slots of question number `question` of `questions`, with `each` answers per scene.
    #[inline(always)]
    pub(super) fn new(
        answers: &'a mut [T],
        these: X::Each<bool>,
        [question, questions]: [usize; 2],
        each: usize,
    ) -> Self {
        Self { answers, these, question, questions, each }
    }

    /// The slots of a scene. `None` if another method answers it, or if the lane is unused because the last block is not full.
    #[inline(always)]
    pub(super) fn places(&mut self, scene: usize) -> Option<&mut [T]> {
        let first = (scene * self.questions + self.question) * self.each;
        if self.these.as_ref()[scene] { self.answers.get_mut(first..first + self.each) } else { None }
    }

    /// Stores one answer for each scene.
    #[inline(always)]
    pub(super) fn each(&mut self, answers: X::Each<T>) {
        for (scene, &answer) in answers.as_ref().iter().enumerate() {
            if let Some(places) = self.places(scene) {
                places[0] = answer;
            }
        }
    }
}
