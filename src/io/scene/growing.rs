//! Loads on several bodies that grow together with the load of a question, in proportion to it. The base load acts before that load grows.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::question::Question;
use super::setup::Setup;
use crate::ask::{Grasp, check_growing};
use crate::error::Error;
use crate::grasp::Wrench;

/// Name of a question, its base load, its growing load, and the loads on other bodies that grow in proportion to the growing load.
type GrowingLoads<'q> = (&'static str, Wrench<3>, Option<Wrench<3>>, &'q BTreeMap<String, Wrench<3>>);

/// The base load of a question, and its loads that grow in proportion to each other; `None` for a kind of question that has no such loads.
fn growing(asked: &Question<3>) -> Option<GrowingLoads<'_>> {
    match asked {
        Question::Hold { base, load, together_with } => Some(("hold", *base, Some(*load), together_with)),
        Question::Solve { load, together_with } => Some(("solve", Wrench::ZERO, Some(*load), together_with)),
        Question::Onset { base, direction, together_with, .. } => {
            Some(("onset", *base, Some(*direction), together_with))
        }
        Question::Need(asked) => Some(("need", asked.base(), asked.grows(), &asked.together_with)),
        _ => None,
    }
}

impl Setup<3> {
    /// The grasp for a question. It includes the loads on other bodies that grow in proportion to the question's load; for `need` it does not,
    /// because the question itself contains these loads. If gravity turns, the grasp has no gravity, since the turning load is the weight.
    ///
    /// # Errors
    /// [`Error::Question`] if the loads on other bodies cannot grow in proportion to the load; [`Error::Body`] for a body that the scene does not
    /// have; [`Error::Wrench`] if a component of a load is not finite.
    pub fn grasp_of(&self, grasp: &Grasp<3>, question: &Question<3>) -> Result<Grasp<3>, Error> {
        self.check_growing(question)?;
        if let Some(tilted) = self.tilted_grasp(question)? {
            return Ok(tilted.with(grasp.settings()));
        }
        match growing(question) {
            Some((name, base, load, others)) if !matches!(question, Question::Need(_)) => {
                grasp.growing(name, base, load, others).map(Cow::into_owned)
            }
            _ => Ok(grasp.clone()),
        }
    }

    /// Refuses loads on further bodies if they cannot grow in proportion to the load of the question, for example because that load is zero.
    pub(super) fn check_growing(&self, question: &Question<3>) -> Result<(), Error> {
        let Some((name, base, load, others)) = growing(question) else { return Ok(()) };
        others.keys().try_for_each(|name| self.has_body(name))?;
        check_growing(name, base, load, others)
    }

    /// Refuses a load on a body that the scene does not have; `name` is the name of the body.
    pub(super) fn has_body(&self, name: &str) -> Result<(), Error> {
        if self.bodies.iter().any(|body| &*body.name == name) {
            return Ok(());
        }
        let fault = "is to be loaded, and is none of the scene".to_owned();
        Err(Error::Body { name: name.to_owned(), fault })
    }
}
