//! Loads of several bodies that grow together with the load of a question.

use std::collections::BTreeMap;

use super::question::Question;
use super::setup::Setup;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;

/// What grows in a question.
struct Growing<'q, const C: usize> {
    question: &'static str,
    /// What is there besides.
    base: Wrench<C>,
    /// With which others grow; `None` where there is not one load alone.
    load: Option<Wrench<C>>,
    others: &'q BTreeMap<String, Wrench<C>>,
}

impl<'q, const C: usize> Growing<'q, C> {
    /// `None` where nothing grows with anything.
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
    /// The grasp of a question, with the loads that grow together in it; where gravity turns, without it beside the load.
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

    /// Refuses what cannot grow together.
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

    /// Refuses the name of a body that is to be loaded, and is none of the scene.
    pub(super) fn has_body(&self, name: &str) -> Result<(), Error> {
        if self.bodies.iter().any(|body| &*body.name == name) {
            return Ok(());
        }
        let fault = "is to be loaded, and is none of the scene".to_owned();
        Err(Error::Body { name: name.to_owned(), fault })
    }
}
