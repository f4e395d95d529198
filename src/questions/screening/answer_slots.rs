//! The storage of the answers of screening to one question for the grasps of one block. Screening computes, for many grasps, the load factor of first
//! slip, at which the first contact ceases to stick. A block holds as many grasps as a SIMD vector has numbers (lanes). A pull is a load that grows
//! from a base load.

use super::lanes::Packed;

/// The storage of the answers for all grasps of one block to one question, such as the load factor of first slip under one pull. The numbers of a
/// grasp are at one index, its lane, in every vector of numbers.
pub(crate) struct AnswerSlots<'a, T, X: Packed> {
    /// The answers to all questions for the grasps of the block, ordered by grasp, then by question.
    answers: &'a mut [T],
    /// For each lane (entry of a vector, which belongs to one grasp), true if the method in use computes the contact forces of this grasp: from
    /// forces along lines between contacts or from the motion of the object ([`Method`](super::method::Method)). Answers of other lanes are not
    /// stored.
    is_method_of_lane: X::Each<bool>,
    question: usize,
    questions: usize,
    /// How many numbers or structures of type `T` answer one question for one grasp.
    each: usize,
}

impl<'a, T: Copy, X: Packed> AnswerSlots<'a, T, X> {
    /// The storage of the answers of a block to the question with the index `question`, from 0, of `questions` questions, with `each` entries per
    /// grasp.
    #[inline(always)]
    pub(super) fn new(
        answers: &'a mut [T],
        is_method_of_lane: X::Each<bool>,
        [question, questions]: [usize; 2],
        each: usize,
    ) -> Self {
        Self { answers, is_method_of_lane, question, questions, each }
    }

    /// The storage of the answer of the grasp in this `lane`, i.e. at this index of the vectors. `None` if the forces of this grasp are found by
    /// another method, or if the lane is unused because the last block is not full.
    #[inline(always)]
    pub(super) fn slot(&mut self, lane: usize) -> Option<&mut [T]> {
        let first = (lane * self.questions + self.question) * self.each;
        if self.is_method_of_lane.as_ref()[lane] {
            self.answers.get_mut(first..first + self.each)
        } else {
            None
        }
    }

    /// Stores the answer of each lane in the first entry for its grasp. Lanes are skipped if they are unused, or if another method finds the forces
    /// of their grasp.
    #[inline(always)]
    pub(super) fn each(&mut self, answers: X::Each<T>) {
        for (lane, &answer) in answers.as_ref().iter().enumerate() {
            if let Some(slot) = self.slot(lane) {
                slot[0] = answer;
            }
        }
    }
}
