//! Loads of several bodies that grow together with the load of a question.

use std::collections::BTreeMap;

use super::question::Question;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;

/// The load of a question and the loads that grow with it.
struct Growing<'q, const C: usize> {
    question: &'static str,
    /// The load that acts before.
    base: Wrench<C>,
    /// The load with which the others grow; `None` if the question has several loads or none.
    load: Option<Wrench<C>>,
    others: &'q BTreeMap<String, Wrench<C>>,
}

impl<'q, const C: usize> Growing<'q, C> {
    /// `None` if no other load grows in the question.
    fn of(asked: &'q Question<C>) -> Option<Self> {
        let (question, base, load, others) = match asked {
            Question::Hold { base, load, together_with } => ("hold", *base, Some(*load), together_with),
            Question::Solve { load, together_with } => ("solve", Wrench::ZERO, Some(*load), together_with),
            Question::Onset(asked) => ("onset", asked.base, Some(asked.direction), &asked.together_with),
            Question::Need(asked) => {
                ("need", asked.base.unwrap_or(Wrench::ZERO), asked.only_load(), &asked.together_with)
            }
            Question::Improve(_)
            | Question::OnsetOfTurn(_)
            | Question::Follow { .. }
            | Question::Shake(_)
            | Question::Shakedown(_)
            | Question::Identify(_) => {
                return None;
            }
        };
        (!others.is_empty()).then_some(Self { question, base, load, others })
    }
}

impl<const C: usize> Setup<C> {
    /// The grasp of a question, with the loads that grow together. If gravity turns, the grasp has none beside the turning load.
    ///
    /// # Errors
    /// [`Error::Question`] where nothing can grow together, and as for [`Grasp::growing_together`].
    pub fn grasp_of(&self, grasp: &Grasp<C>, question: &Question<C>) -> Result<Grasp<C>, Error> {
        self.check_growing(question)?;
        if let Some(tilted) = self.tilted_grasp(question)? {
            return Ok(tilted);
        }
        match Growing::of(question) {
            Some(Growing { load: Some(load), others, .. }) => {
                grasp.growing_together(&load, others.iter().map(|(name, load)| (name, *load)))
            }
            _ => Ok(grasp.clone()),
        }
    }

    /// Refuses loads that cannot grow together.
    pub(super) fn check_growing(&self, question: &Question<C>) -> Result<(), Error> {
        let Some(Growing { question, base, load, others }) = Growing::of(question) else { return Ok(()) };
        others.keys().try_for_each(|name| self.has_body(name))?;
        let refuse = |fault| Err(Error::Question { question, field: "together_with", fault });
        match load {
            None => refuse(
                "given, must be left out unless the amount is one of squeeze, friction or load, for one load",
            ),
            _ if base != Wrench::ZERO => {
                refuse("given, must be left out beside a base: what is always there is the `load` of a body")
            }
            Some(load) if load == Wrench::ZERO => {
                refuse("given, must be left out without a load to grow with")
            }
            Some(_) => Ok(()),
        }
    }

    /// Refuses the name of a loaded body that the scene does not have.
    pub(super) fn has_body(&self, name: &str) -> Result<(), Error> {
        if self.bodies.iter().any(|body| &*body.name == name) {
            return Ok(());
        }
        let fault = "is to be loaded, and is none of the scene".to_owned();
        Err(Error::Body { name: name.to_owned(), fault })
    }
}
