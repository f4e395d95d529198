//! Translates the questions of a scene into calls of methods of the scene's [`Grasp`], and answers them. A setup is a grasp with its questions, in
//! the plane or in space. A command is the displacement that a finger, joint or tendon would make without the object.

use super::answer::Answer;
use super::labels::SceneNames;
use super::onset::Factor;
use super::question::Question;
use super::sentence_answers::{IdentifyAnswer, ImproveAnswer, NeedAnswer, ShakedownAnswer};
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::{Error, check_contact};
use crate::grasp::{Wrench, inside, outside};
use crate::identify::{Identify, LAYOUTS_OF_HANDS};
use crate::improve::Improve;
use crate::load_path::{self, Leg};
use crate::numerics::tried;
use crate::words::Words;

impl<const C: usize> Setup<C> {
    /// Refuses a question with a list of the wrong length, such as one command for each contact, or for each joint and tendon, of this setup. Refuses
    /// a question in which neither a load nor a command changes.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup, or with the fault of the question.
    pub fn check(&self, question: &Question<C>) -> Result<(), Error> {
        inside(self).check_question(&inside(question))
    }

    /// The answer to every question, in order.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question. That no equilibrium exists is an answer.
    pub fn answers(&self) -> Result<Vec<Answer<C>>, Error> {
        self.answers_in(Words::default())
    }

    /// The answer to every question, in order. `words` is the form of the numbers in sentences.
    ///
    /// # Errors
    /// An [`Error`] for a malformed setup or question. That no equilibrium exists is an answer.
    pub fn answers_in(&self, words: Words) -> Result<Vec<Answer<C>>, Error> {
        inside(self).answered(words).map(outside)
    }
}

impl Setup<3> {
    /// The question `improve` with the surfaces along which contacts may move. A scene states each surface at its contact, not in the question.
    pub(super) fn with_surfaces(&self, grasp: &Grasp<3>, asked: &Improve<3>) -> Improve<3> {
        let mut question = asked.clone();
        for (entry, contact) in self.entries().zip(grasp.engine.wholes().iter()) {
            if let Some(surface) = &entry.surface {
                question = question.along(contact.range.start, surface.clone());
            }
        }
        question
    }

    /// Checks a question, in the plane or in space. Refuses lists of the wrong length, and a question in which neither a load nor a command changes.
    /// Vectors have three components; in the plane the third is zero.
    pub(super) fn check_question(&self, question: &Question<3>) -> Result<(), Error> {
        self.check_growing(question)?;
        match &*self.meant(question)? {
            Question::Hold { .. }
            | Question::Solve { .. }
            | Question::Compare { .. }
            | Question::OnsetOfTurn(_) => Ok(()),
            Question::Need(asked) => {
                let is_loaded = self.bodies.iter().any(|body| body.load != Wrench::ZERO);
                asked.check(self.space, self.entries().count())?;
                asked.check_acts(is_loaded || self.gravity.is_some())
            }
            Question::Improve(asked) => asked.given_loads().map(drop),
            Question::Onset { .. } => question.ramp()?.check_changes(self.lengths()),
            Question::Follow { legs, in_steps, .. } => {
                in_steps.map_or(Ok(()), |error| load_path::check_leg_error("in_steps", error))?;
                self.check_legs(legs)
            }
            Question::Shake { legs, .. } => question.legs().and_then(|_| self.check_legs(legs)),
            Question::Shakedown { loads, .. } => match loads[..] {
                [] => Err(Error::Question {
                    question: "shakedown",
                    field: "loads",
                    fault: "are missing, must be given",
                }),
                _ => Ok(()),
            },
            Question::Identify(asked) => self.check_identify(asked),
        }
    }

    /// Refuses faults of a question `identify` that can be found without building a grasp for each of its layouts, i.e. the other arrangements of
    /// contact points in which slips were observed.
    pub(super) fn check_identify(&self, asked: &Identify<3>) -> Result<(), Error> {
        if !asked.layouts.is_empty() && (self.is_held_by_a_hand() || !self.bodies.is_empty()) {
            return Err(LAYOUTS_OF_HANDS);
        }
        let expected = self.entries().count();
        for points in &asked.layouts {
            let given = points.len();
            if given != expected {
                return Err(Error::Size { what: "points of a layout", given, expected });
            }
        }
        for contact in asked.unknowns.iter().flat_map(|unknown| &unknown.contacts).flatten() {
            check_contact(*contact, expected)?;
        }
        asked.check_numbers(self.space, 1 + asked.layouts.len())
    }

    fn check_legs(&self, legs: &[Leg<3>]) -> Result<(), Error> {
        for leg in legs {
            leg.check_lengths(self.lengths())?;
            leg.loaded_bodies().try_for_each(|name| self.has_body(name))?;
        }
        Ok(())
    }

    /// Numbers of contacts, of joints and tendons together, and of joints. A contact that a constant force presses counts as one more joint: the
    /// slide along which the force moves it.
    fn lengths(&self) -> [usize; 3] {
        let slides = self.entries().filter(|entry| entry.contact.force.is_some()).count();
        let joints = self.fingers.iter().map(|finger| finger.joints.len()).sum::<usize>() + slides;
        [self.entries().count(), joints + self.tendons.len(), joints]
    }

    /// The answers to all questions, in order, in the plane or in space; `words` is the form of the numbers in sentences. Vectors have three
    /// components; in the plane the third is zero.
    pub(crate) fn answered(&self, words: Words) -> Result<Vec<Answer<3>>, Error> {
        let grasp = self.grasp_checked()?;
        tried(&self.questions, &|question| self.answer_in(&grasp, question, words))
    }

    /// The answer to one question; `words` is the form of the numbers in sentences. `grasp` is the setup's [grasp](Self::grasp). The same grasp
    /// serves all questions, because it keeps the factorised equations for the case in which all contacts stick.
    ///
    /// # Errors
    /// An [`Error`] for a malformed question. That no equilibrium exists is an answer.
    pub fn answer_in(
        &self,
        grasp: &Grasp<3>,
        question: &Question<3>,
        words: Words,
    ) -> Result<Answer<3>, Error> {
        self.check_question(question)?;
        let words = words.in_space(self.space);
        let grasp = &self.grasp_of(grasp, question)?;
        let labels = SceneNames(grasp);
        Ok(match &*self.meant(question)? {
            Question::Hold { .. } => Answer::Hold(labels.verdict(grasp.hold(question.ramp()?)?, words)),
            Question::Need(asked) => {
                let needed = grasp.need(&asked.as_ref().clone().with_words(words))?;
                Answer::Need(NeedAnswer::of(needed, words))
            }
            Question::Improve(asked) => {
                Answer::Improve(ImproveAnswer::of(grasp.improve(&self.with_surfaces(grasp, asked))?, words))
            }
            Question::Solve { load, .. } => Answer::Solve(labels.solve(load, grasp.solve(load)?, words)?),
            Question::Compare { base, load } => Answer::Compare(labels.compared(base, load, words)?),
            Question::Onset { .. } => {
                let onset = grasp.onset(&question.ramp()?)?;
                Answer::Onset(labels.onset(&onset, |factor| Factor { factor }))
            }
            Question::OnsetOfTurn(turn) => {
                let found = grasp.onset_of_turn(turn)?;
                Answer::OnsetOfTurn(labels.onset_of_turn(&found))
            }
            Question::Follow { start, legs, in_steps: None } => {
                let mut path = grasp.follow(start, legs)?;
                let events = path.run();
                Answer::Follow(labels.path(&path, events))
            }
            Question::Follow { start, legs, in_steps: Some(error) } => {
                let mut path = grasp.follow_in_steps(start, legs, *error)?;
                let steps = path.run();
                Answer::Follow(labels.path_in_steps(&path, steps))
            }
            Question::Shake { base, .. } => {
                Answer::Shake(labels.shaken(grasp.shake(base, &question.legs()?)?, words))
            }
            Question::Shakedown { base, loads } => {
                Answer::Shakedown(ShakedownAnswer::of(grasp.statics().shakedown(base, loads)?, words))
            }
            Question::Identify(asked) => Answer::Identify(IdentifyAnswer::of(grasp.identify(asked)?, words)),
        })
    }
}
