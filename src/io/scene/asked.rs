//! Translates the questions of a scene for its grasp, and answers them.

use std::sync::Arc;

use nalgebra::SVector;

use super::answer::Answer;
use super::held::NeedAnswer;
use super::identify_asked::IdentifyAnswer;
use super::improve_asked::ImproveAnswer;
use super::labels::SceneNames;
use super::onset::Factor;
use super::question::{Commands, Goal, LegAsked, LoadGoal, Question, RampAsked};
use super::setup::Setup;
use super::shake_asked::ShakedownAnswer;
use crate::ask::Grasp;
use crate::error::{ContactLabel, Error};
use crate::grasp::Wrench;
use crate::load_path::{self, Ramp};
use crate::numerics::tried;
use crate::words::Words;

impl<const C: usize> Setup<C> {
    /// The ramp of a question for the grasp. Every point of a soft fingertip has the command change of its contact.
    ///
    /// # Errors
    /// [`Error::Size`] unless there is one command change for each contact of the scene.
    /// [`Error::JointCommands`] unless there is one for each joint and each tendon. [`Error::NothingChanges`] if all of the ramp is zero.
    pub fn ramp(&self, asked: &RampAsked<C>) -> Result<Ramp<C>, Error> {
        let mut ramp = Ramp::load(asked.base, asked.direction);
        if let Some(change) = &asked.command_change {
            ramp = ramp.with_commands(self.spread(change, "command changes")?);
        }
        if let Some(change) = &asked.joint_change {
            ramp = ramp.with_joint_commands(self.of_joints(change, "changes of joint commands")?);
        }
        if ramp.stands_still() { Err(Error::NothingChanges) } else { Ok(ramp) }
    }

    /// The legs of a load program for the grasp. Every point of a soft fingertip has the command of its contact.
    ///
    /// # Errors
    /// [`Error::Size`] unless a leg has one command for each contact of the scene.
    /// [`Error::JointCommands`] unless it has one for each joint and each tendon.
    pub fn legs(&self, legs: &[LegAsked<C>]) -> Result<Vec<load_path::Leg<C>>, Error> {
        tried(legs, &|leg| self.leg(leg))
    }

    fn leg(&self, leg: &LegAsked<C>) -> Result<load_path::Leg<C>, Error> {
        let mut out = load_path::Leg::load_by(Wrench::ZERO);
        match &leg.load {
            None => {}
            Some(LoadGoal::Straight(Goal::By(change))) => out = out.and_load_by(*change),
            Some(LoadGoal::Straight(Goal::To(load))) => out = out.and_load_to(*load),
            Some(LoadGoal::Turn(turn)) => out = load_path::Leg::turn(turn),
        }
        match &leg.commands {
            None => {}
            Some(Goal::By(change)) => out = out.and_commands_by(self.spread(change, "commands of a leg")?),
            Some(Goal::To(commands)) => {
                out = out.and_commands_to(self.spread(commands, "commands of a leg")?);
            }
        }
        match &leg.joints {
            None => {}
            Some(Goal::By(change)) => {
                out = out.and_joints_by(self.of_joints(change, "joint commands of a leg")?);
            }
            Some(Goal::To(commands)) => {
                out = out.and_joints_to(self.of_joints(commands, "joint commands of a leg")?);
            }
        }
        match &leg.torques {
            None => {}
            Some(Goal::By(change)) => {
                out = out.and_torques_by(of_length(change, "torques of a leg", self.joints())?);
            }
            Some(Goal::To(torques)) => {
                out = out.and_torques_to(of_length(torques, "torques of a leg", self.joints())?);
            }
        }
        for (name, goal) in &leg.body_loads {
            self.has_body(name)?;
            out = match goal {
                Goal::By(change) => out.and_body_load_by(name, *change),
                Goal::To(load) => out.and_body_load_to(name, *load),
            };
        }
        Ok(out)
    }

    /// Checks that lists of a question with one entry for each contact have that length.
    pub(super) fn check(&self, question: &Question<C>) -> Result<(), Error> {
        self.check_growing(question)?;
        match &*self.meant(question)? {
            Question::Hold { .. } | Question::Solve { .. } | Question::OnsetOfTurn(_) => Ok(()),
            Question::Need(asked) => self.need(asked).map(drop),
            Question::Improve(asked) => self.improve(asked).map(drop),
            Question::Onset(asked) => self.ramp(asked).map(drop),
            Question::Follow { legs, in_steps, .. } => {
                in_steps.map_or(Ok(()), |error| load_path::check_leg_error("in_steps", error))?;
                self.legs(legs).map(drop)
            }
            Question::Shake(asked) => self.cycle(asked).map(drop),
            Question::Shakedown(asked) => asked.check(),
            Question::Identify(asked) => self.check_identify(asked),
        }
    }

    /// Commands of all points from those of the contacts.
    fn spread(&self, commands: &Commands<C>, what: &'static str) -> Result<Vec<SVector<f64, C>>, Error> {
        let (given, expected) = (commands.0.len(), self.entries().count());
        if given != expected {
            return Err(Error::Size { what, given, expected });
        }
        let mut all = Vec::with_capacity(expected);
        for (entry, command) in self.entries().zip(&commands.0) {
            all.resize(all.len() + entry.count()?, *command);
        }
        all.resize(all.len() + self.points_of_links()?.len(), SVector::zeros());
        Ok(all)
    }

    /// Commands of joints and tendons, if their number is right.
    fn of_joints(&self, commands: &[f64], what: &'static str) -> Result<Vec<f64>, Error> {
        of_length(commands, what, self.joints() + self.tendons.len())
    }

    /// Number of all joints, with the slides of contacts that are held by a force behind them.
    fn joints(&self) -> usize {
        let slides = self.entries().filter(|entry| entry.contact.force.is_some()).count();
        self.fingers.iter().map(|finger| finger.joints.len()).sum::<usize>() + slides
    }

    /// The scene's names of the contacts of its grasp.
    pub(super) fn labels(&self) -> Result<SceneNames, Error> {
        let mut labels = Vec::new();
        for (index, entry) in self.entries().enumerate() {
            let label = |point| ContactLabel { point, ..entry.contact.label(index) };
            if entry.is_spread() {
                labels.extend((0..entry.count()?).map(Some).map(label));
            } else {
                labels.push(label(None));
            }
        }
        let mut number = self.entries().count();
        for (k, point) in self.points_of_links()?.iter().enumerate() {
            number += usize::from(k > 0 && point.begins_a_whole());
            let name = point.whole_name().map(Arc::from);
            labels.push(ContactLabel { index: number, point: point.point_of_pad, name, link: point.link });
        }
        Ok(SceneNames(labels))
    }

    /// The answer to every question, in order.
    ///
    /// # Errors
    /// As for [`Self::grasp`], [`Self::ramp`], [`Self::legs`] and the methods of [`Grasp`] that
    /// answer: a malformed question is an error, "no equilibrium" is an answer.
    pub fn answers(&self) -> Result<Vec<Answer<C>>, Error> {
        self.answers_in(Words::default())
    }

    /// The answer to every question, in order, with this number of digits in its sentences.
    ///
    /// # Errors
    /// As for [`Self::answers`].
    pub fn answers_in(&self, words: Words) -> Result<Vec<Answer<C>>, Error> {
        let (grasp, labels) = (self.grasp()?, self.labels()?);
        tried(&self.questions, &|question| self.answer(&grasp, &labels, question, words))
    }

    fn answer(
        &self,
        grasp: &Grasp<C>,
        labels: &SceneNames,
        question: &Question<C>,
        words: Words,
    ) -> Result<Answer<C>, Error> {
        let grasp = &self.grasp_of(grasp, question)?;
        Ok(match &*self.meant(question)? {
            Question::Hold { base, load, .. } => {
                Answer::Hold(labels.verdict(grasp.hold(Ramp::load(*base, *load))?, words))
            }
            Question::Need(asked) => {
                let needed = grasp.need(&self.need(asked)?.told_in(words))?;
                Answer::Need(NeedAnswer::of(needed, words))
            }
            Question::Improve(asked) => {
                Answer::Improve(ImproveAnswer::of(self.improve(asked)?.answered_by(grasp)?, words))
            }
            Question::Solve { load, .. } => {
                Answer::Solve(labels.solve(grasp, load, grasp.solve(load)?, words)?)
            }
            Question::Onset(asked) => {
                let onset = grasp.onset(&self.ramp(asked)?)?;
                Answer::Onset(labels.onset(grasp, &onset, |factor| Factor { factor }))
            }
            Question::OnsetOfTurn(turn) => {
                let found = grasp.onset_of_turn(turn)?;
                Answer::OnsetOfTurn(labels.onset_of_turn(grasp, &found))
            }
            Question::Follow { start, legs, in_steps: None } => {
                let mut path = grasp.follow(start, &self.legs(legs)?)?;
                let events = path.run();
                Answer::Follow(labels.path(&path, events))
            }
            Question::Follow { start, legs, in_steps: Some(error) } => {
                let mut path = grasp.follow_in_steps(start, &self.legs(legs)?, *error)?;
                let steps = path.run();
                Answer::Follow(labels.path_in_steps(&path, steps))
            }
            Question::Shake(asked) => {
                Answer::Shake(labels.shaken(grasp.shake(&asked.base, &self.cycle(asked)?)?, words))
            }
            Question::Shakedown(asked) => Answer::Shakedown(ShakedownAnswer::of(asked.found(grasp)?, words)),
            Question::Identify(asked) => {
                Answer::Identify(IdentifyAnswer::of(self.identify(asked)?.answered_by(grasp)?, words))
            }
        })
    }
}

/// A list of numbers of joints, refused unless it has the expected length.
fn of_length(list: &[f64], what: &'static str, expected: usize) -> Result<Vec<f64>, Error> {
    let given = list.len();
    if given == expected { Ok(list.to_vec()) } else { Err(Error::JointCommands { what, given, expected }) }
}
