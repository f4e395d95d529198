//! A grasp with what is asked of it, in the plane or in space.

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};

use super::answer::Answer;
use super::fields::{found, given};
use super::finger::Finger;
use super::object;
use super::place::{Place, Places};
use super::question::{Commands, Goal, Leg, Question, RampAsked};
use crate::equilibrium::Settings;
use crate::error::{ContactLabel, Error};
use crate::grasp::Grasp;
use crate::load_path::{self, Ramp};

/// Contacts, questions and settings: `D` degrees of freedom and `C` axes a contact, 3 and 2 in the
/// plane, 6 and 3 in space.
///
/// ```
/// use grasp_lcp::planar::{Contact, Wrench};
/// use grasp_lcp::scene::{Answer, OnsetAnswer, Question, RampAsked, Setup, SolveAnswer};
///
/// // Two jaws press with 1000 N/m · 0.01 m = 10 N each; μ = 0.5, so that they hold 10 N.
/// let jaw = |side: f64| {
///     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
/// };
/// let down = Wrench::force([0.0, -1.0]);
/// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()])
///     .ask(Question::Solve { load: down * 4.0 })
///     .ask(Question::Onset(RampAsked { base: Wrench::ZERO, direction: down, command_change: None }));
///
/// let [Answer::Solve(SolveAnswer::Equilibrium(state)), Answer::Onset(OnsetAnswer::At(onset))] = &setup.answers()?[..] else {
///     panic!("it holds 4 N, and slides at some load")
/// };
/// assert!((state.contacts[0].force[0] - 10.0).abs() < 1e-13);
/// assert!((onset.factor - 10.0).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Setup<const D: usize, const C: usize> {
    /// At least one; without any [`Setup::grasp`] is an error.
    pub contacts: Vec<Finger<C>>,
    /// Corners of the object in order, m. They are only drawn, by the caller.
    #[serde(with = "found", skip_serializing_if = "Vec::is_empty")]
    pub outline: Vec<SVector<f64, C>>,
    /// Answered in this order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<Question<D, C>>,
    /// For all questions. Where they are for the polygon, so are onsets
    /// ([`Grasp::onset_with`]).
    #[serde(skip_serializing_if = "is_default")]
    pub settings: Settings,
}

fn is_default(settings: &Settings) -> bool {
    *settings == Settings::default()
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Written<const D: usize, const C: usize> {
    contacts: Vec<Finger<C>>,
    #[serde(default, with = "given")]
    outline: Vec<SVector<f64, C>>,
    #[serde(default)]
    questions: Vec<Question<D, C>>,
    #[serde(default)]
    settings: Settings,
}

impl<'de, const D: usize, const C: usize> Deserialize<'de> for Setup<D, C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a setup", |Written { contacts, outline, questions, settings }| {
            if contacts.is_empty() {
                return Err(Error::EmptyGrasp.to_string());
            }
            let setup = Self { contacts, outline, questions, settings };
            for (index, question) in setup.questions.iter().enumerate() {
                setup.check(question).map_err(|error| format!("question {index}: {error}"))?;
            }
            Ok(setup)
        })
    }
}

impl<const D: usize, const C: usize> From<&Grasp<D, C>> for Setup<D, C> {
    /// Every contact as a point; nothing is asked yet.
    fn from(grasp: &Grasp<D, C>) -> Self {
        Self::new(grasp.contacts().iter().cloned().map(Finger::from))
    }
}

impl<const D: usize, const C: usize> Setup<D, C> {
    /// Contacts of which nothing is asked yet, without an outline, with default settings. A
    /// [`Contact`](crate::grasp::Contact) is turned `into` a [`Finger`].
    pub fn new(contacts: impl IntoIterator<Item = Finger<C>>) -> Self {
        Self {
            contacts: contacts.into_iter().collect(),
            outline: Vec::new(),
            questions: Vec::new(),
            settings: Settings::default(),
        }
    }

    /// This setup with one more question.
    #[must_use]
    pub fn ask(mut self, question: Question<D, C>) -> Self {
        self.questions.push(question);
        self
    }

    /// This setup with other settings.
    #[must_use]
    pub fn with_settings(mut self, settings: Settings) -> Self {
        self.settings = settings;
        self
    }

    /// The grasp: soft fingertips are spread, so that it may have more contacts than the scene.
    ///
    /// # Errors
    /// As for [`Grasp::new`] and [`SoftFingertip`](crate::grasp::SoftFingertip), with the index
    /// that the contact has in the scene.
    pub fn grasp(&self) -> Result<Grasp<D, C>, Error> {
        let mut points = Vec::with_capacity(self.contacts.len());
        let mut of = Vec::with_capacity(self.contacts.len());
        for (index, finger) in self.contacts.iter().enumerate() {
            points.extend(finger.points(index)?);
            of.resize(points.len(), index);
        }
        Grasp::new(points).map_err(|error| match error {
            Error::Contact { contact: ContactLabel { index, name }, field, value, allowed } => {
                let contact = ContactLabel { index: of[index], name };
                Error::Contact { contact, field, value, allowed }
            }
            other => other,
        })
    }

    /// The ramp of a question as the grasp has it: with command changes for every point of a soft
    /// fingertip.
    ///
    /// # Errors
    /// [`Error::Size`] if the command changes are not one for each contact of the scene.
    pub fn ramp(&self, asked: &RampAsked<D, C>) -> Result<Ramp<D, C>, Error> {
        let ramp = Ramp::load(asked.base, asked.direction);
        Ok(match &asked.command_change {
            Some(change) => ramp.with_commands(self.spread(change, "command changes")?),
            None => ramp,
        })
    }

    /// The legs of a load program as the grasp has them: with commands for every point of a soft
    /// fingertip.
    ///
    /// # Errors
    /// [`Error::Size`] if the commands of a leg are not one for each contact of the scene.
    pub fn legs(&self, legs: &[Leg<D, C>]) -> Result<Vec<load_path::Leg<D, C>>, Error> {
        legs.iter().map(|leg| self.leg(leg)).collect()
    }

    fn leg(&self, leg: &Leg<D, C>) -> Result<load_path::Leg<D, C>, Error> {
        let mut out = load_path::Leg::load_by(crate::grasp::Wrench::ZERO);
        match &leg.load {
            None => {}
            Some(Goal::By(change)) => out = out.and_load_by(*change),
            Some(Goal::To(load)) => out = out.and_load_to(*load),
        }
        Ok(match &leg.commands {
            None => out,
            Some(Goal::By(change)) => out.and_commands_by(self.spread(change, "commands of a leg")?),
            Some(Goal::To(commands)) => out.and_commands_to(self.spread(commands, "commands of a leg")?),
        })
    }

    /// Whether the lists of a question that have one entry a contact are as long as that.
    fn check(&self, question: &Question<D, C>) -> Result<(), Error> {
        match question {
            Question::Solve { .. } => Ok(()),
            Question::Onset(asked) => self.ramp(asked).map(drop),
            Question::Follow { legs, .. } => self.legs(legs).map(drop),
        }
    }

    /// Commands of every point from those of the contacts.
    fn spread(&self, commands: &Commands<C>, what: &'static str) -> Result<Vec<SVector<f64, C>>, Error> {
        let (given, expected) = (commands.0.len(), self.contacts.len());
        if given != expected {
            return Err(Error::Size { what, given, expected });
        }
        let mut all = Vec::with_capacity(expected);
        for (finger, command) in self.contacts.iter().zip(&commands.0) {
            all.resize(all.len() + finger.count()?, *command);
        }
        Ok(all)
    }

    /// Where the contacts of the grasp stand in the scene.
    fn places(&self) -> Result<Places, Error> {
        let mut places = Vec::new();
        for (contact, finger) in self.contacts.iter().enumerate() {
            let place = |point| Place { contact, point, name: finger.contact.name.clone() };
            match finger.soft {
                None => places.push(place(None)),
                Some(_) => places.extend((0..finger.count()?).map(Some).map(place)),
            }
        }
        Ok(Places(places))
    }

    /// The answer to every question, in order.
    ///
    /// # Errors
    /// As for [`Self::grasp`], [`Self::ramp`], [`Self::legs`] and the methods of [`Grasp`] that
    /// answer: a malformed question is an error, "no equilibrium" is an answer.
    pub fn answers(&self) -> Result<Vec<Answer<D, C>>, Error> {
        let (grasp, places) = (self.grasp()?, self.places()?);
        self.questions.iter().map(|question| self.answer(&grasp, &places, question)).collect()
    }

    fn answer(
        &self,
        grasp: &Grasp<D, C>,
        places: &Places,
        question: &Question<D, C>,
    ) -> Result<Answer<D, C>, Error> {
        let settings = &self.settings;
        Ok(match question {
            Question::Solve { load } => {
                Answer::Solve(places.solved(grasp, &grasp.solve_with(load, settings)?))
            }
            Question::Onset(asked) => {
                let ramp = self.ramp(asked)?;
                let onset = grasp.onset_with(&ramp, settings)?;
                Answer::Onset(places.onset(grasp, settings, &onset))
            }
            Question::Follow { start, legs } => {
                let mut path = grasp.follow_with(start, &self.legs(legs)?, settings)?;
                let events = path.run();
                Answer::Follow(places.path(&path, &events))
            }
        })
    }
}
