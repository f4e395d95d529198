//! A grasp with what is asked of it, in the plane or in space.

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};

use super::body::BodySetup;
use super::finger::FingerSetup;
use super::fingertip::Fingertip;
use super::link::LinkSetup;
use super::object;
use super::question::Question;
use crate::ask::Grasp;
use crate::equilibrium::Settings;
use crate::error::{ContactLabel, Error};
use crate::grasp::{self, Bodies, Hand, Tendon};
use crate::serial::{AsComputed, AxisRow, Given};

/// Contacts, questions and settings: `D` degrees of freedom of the object and `C` axes a contact, 3 and 2 in
/// the plane, 6 and 3 in space.
///
/// ```
/// use grasp_lcp::planar::{Contact, Wrench};
/// use grasp_lcp::equilibrium::Outcome;
/// use grasp_lcp::scene::{Answer, OnsetAnswer, Question, RampAsked, Setup, SolveAnswer};
///
/// // Two jaws press with 1000 N/m · 0.01 m = 10 N each; μ = 0.5, so that they hold 10 N.
/// let jaw = |side: f64| {
///     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
/// };
/// let down = Wrench::force([0.0, -1.0]);
/// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()])
///     .ask(Question::solve(down * 4.0))
///     .ask(Question::Onset(RampAsked::along(down)));
///
/// let [Answer::Solve(SolveAnswer { outcome: Outcome::Equilibrium(state), .. }), Answer::Onset(OnsetAnswer::At(onset))] = &setup.answers()?[..] else {
///     panic!("it holds 4 N, and slides at some load")
/// };
/// assert!((state.contacts[0].force[0] - 10.0).abs() < 1e-13);
/// assert!((onset.at.factor - 10.0).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Setup<const C: usize> {
    /// Contacts whose fingers have no joints. With those of the fingers at least one; without any
    /// [`Setup::grasp`] is an error.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<Fingertip<C>>,
    /// Fingers with joints; their contacts are counted on behind those above.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fingers: Vec<FingerSetup<C>>,
    /// Tendons over the joints of all fingers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tendons: Vec<Tendon>,
    /// Of several bodies, each; contacts then say which ones they touch. None where there is one object.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<BodySetup<C>>,
    /// What joins bodies to each other and to the ground; one object may be joined to the ground.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<LinkSetup<C>>,
    /// Gravity on bodies, m/s², beside the loads of questions.
    #[serde(with = "AsComputed::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")]
    pub gravity: Option<SVector<f64, C>>,
    /// The body that loads of questions act on; the first if it is not said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loaded: Option<String>,
    /// Loads of questions act on all bodies, on each with the share of its mass.
    #[serde(skip_serializing_if = "is_false")]
    pub shared_by_mass: bool,
    /// Corners of the object in order, m. They are only drawn, by the caller.
    #[serde(with = "AsComputed::<Vec<SVector<f64, C>>>", skip_serializing_if = "Vec::is_empty")]
    pub outline: Vec<SVector<f64, C>>,
    /// Answered in this order.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<Question<C>>,
    /// For all questions. Where they are for the polygon, so are onsets
    /// ([`Grasp::onset`]).
    #[serde(skip_serializing_if = "is_default")]
    pub settings: Settings,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_false(said: &bool) -> bool {
    !said
}

fn is_default(settings: &Settings) -> bool {
    *settings == Settings::default()
}

#[derive(serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Written<const C: usize> {
    /// Contacts whose fingers have no joints.
    #[serde(default)]
    contacts: Vec<Fingertip<C>>,
    /// Fingers with joints; their contacts are counted on behind those above.
    #[serde(default)]
    fingers: Vec<FingerSetup<C>>,
    /// Tendons over the joints of all fingers.
    #[serde(default)]
    tendons: Vec<Tendon>,
    /// Of several bodies, each.
    #[serde(default)]
    bodies: Vec<BodySetup<C>>,
    /// What joins bodies to each other and to the ground.
    #[serde(default)]
    links: Vec<LinkSetup<C>>,
    /// Gravity on bodies, m/s².
    #[serde(default)]
    gravity: Option<AxisRow<Given, C>>,
    /// The body that loads of questions act on; the first if left out.
    #[serde(default)]
    loaded: Option<String>,
    /// Whether loads of questions act on all bodies, on each with the share of its mass.
    #[serde(default)]
    shared_by_mass: bool,
    /// Corners of the object in order, m; only drawn.
    #[serde(default)]
    outline: Vec<AxisRow<Given, C>>,
    /// What is asked, in order.
    #[serde(default)]
    questions: Vec<Question<C>>,
    /// For all questions.
    #[serde(default)]
    settings: Settings,
}

impl<'de, const C: usize> Deserialize<'de> for Setup<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a setup", |written: Written<C>| {
            let outline = written.outline.into_iter().map(|row| row.0).collect();
            let setup = Self {
                contacts: written.contacts,
                fingers: written.fingers,
                tendons: written.tendons,
                bodies: written.bodies,
                links: written.links,
                gravity: written.gravity.map(|row| row.0),
                loaded: written.loaded,
                shared_by_mass: written.shared_by_mass,
                outline,
                questions: written.questions,
                settings: written.settings,
            };
            setup.check_bodies()?;
            if setup.entries().next().is_none() && setup.links.is_empty() {
                return Err(Error::EmptyGrasp.to_string());
            }
            if setup.is_held_by_a_hand() || !setup.bodies.is_empty() {
                // Numbers of joints are judged together with what they move.
                setup.grasp().map(drop).map_err(|error| error.to_string())?;
            }
            for (index, question) in setup.questions.iter().enumerate() {
                setup.check(question).map_err(|error| format!("questions[{index}]: {error}"))?;
            }
            Ok(setup)
        })
    }
}

impl<const C: usize> From<&Grasp<C>> for Setup<C> {
    /// Every contact as a point; nothing is asked yet.
    fn from(grasp: &Grasp<C>) -> Self {
        Self::new(grasp.contacts().iter().cloned().map(Fingertip::from))
    }
}

impl<const C: usize> Setup<C> {
    /// Contacts of which nothing is asked yet, without an outline, with default settings. A
    /// [`Contact`](crate::grasp::Contact) is turned `into` a [`Fingertip`].
    pub fn new(contacts: impl IntoIterator<Item = Fingertip<C>>) -> Self {
        Self {
            contacts: contacts.into_iter().collect(),
            fingers: Vec::new(),
            tendons: Vec::new(),
            bodies: Vec::new(),
            links: Vec::new(),
            gravity: None,
            loaded: None,
            shared_by_mass: false,
            outline: Vec::new(),
            questions: Vec::new(),
            settings: Settings::default(),
        }
    }

    /// This setup with one more finger.
    #[must_use]
    pub fn finger(mut self, finger: FingerSetup<C>) -> Self {
        self.fingers.push(finger);
        self
    }

    /// This setup with one more tendon over the joints of its fingers.
    #[must_use]
    pub fn tendon(mut self, tendon: Tendon) -> Self {
        self.tendons.push(tendon);
        self
    }

    /// This setup with one more question.
    #[must_use]
    pub fn ask(mut self, question: Question<C>) -> Self {
        self.questions.push(question);
        self
    }

    /// This setup with other settings.
    #[must_use]
    pub fn with_settings(mut self, settings: Settings) -> Self {
        self.settings = settings;
        self
    }

    /// All contacts, those of the fingers behind the others: the index of an entry is that of the contact in questions and answers.
    pub fn entries(&self) -> impl Iterator<Item = &Fingertip<C>> {
        self.contacts.iter().chain(self.fingers.iter().flat_map(|finger| &finger.contacts))
    }

    /// Number of contacts that its grasp has: soft fingertips and links count as many as they have points.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for a patch that cannot be built.
    pub fn points(&self) -> Result<usize, Error> {
        let points = self.entries().map(Fingertip::count).sum::<Result<usize, _>>()?;
        Ok(points + self.points_of_links()?.len())
    }

    /// Whether there are fingers or tendons, or forces that hold contacts: the grasp is then that of a [`Hand`], see [`Self::hand`].
    #[must_use]
    pub fn is_held_by_a_hand(&self) -> bool {
        let by_force = self.contacts.iter().any(|entry| entry.contact.force.is_some());
        by_force || !self.fingers.is_empty() || !self.tendons.is_empty()
    }

    /// The grasp, asked with the settings of the setup. Soft fingertips are spread, so that it may have more contacts than the scene.
    ///
    /// # Errors
    /// As for [`Grasp::new`], [`Hand::grasp`] and [`SoftFingertip`](crate::grasp::SoftFingertip), with the index
    /// that the contact has in the scene.
    pub fn grasp(&self) -> Result<Grasp<C>, Error> {
        let grasp = if !self.bodies.is_empty() {
            self.several_bodies()?.grasp()
        } else if self.is_held_by_a_hand() {
            self.hand()?.grasp()
        } else {
            let mut points = Vec::with_capacity(self.contacts.len());
            for (index, entry) in self.contacts.iter().enumerate() {
                points.extend(entry.points(index)?);
            }
            points.extend(self.points_of_links()?);
            Grasp::new(points)
        };
        Ok(grasp.map_err(|error| self.in_the_scene(error))?.with(&self.settings))
    }

    /// The hand that holds the object: fingers that are nothing but a contact first.
    ///
    /// # Errors
    /// [`Error::Contact`], [`Error::Fingertip`] and [`Error::Hand`] for what cannot be built.
    pub fn hand(&self) -> Result<Hand<C>, Error> {
        let mut fingers = Vec::new();
        for (index, entry) in self.contacts.iter().enumerate() {
            fingers.extend(entry.points(index)?.into_iter().map(grasp::Finger::fixed));
        }
        let mut first = self.contacts.len();
        for finger in &self.fingers {
            fingers.push(finger.spread(first)?);
            first += finger.contacts.len();
        }
        fingers.extend(self.points_of_links()?.into_iter().map(grasp::Finger::fixed));
        Ok(self.tendons.iter().cloned().fold(Hand::new(fingers), Hand::tendon))
    }

    /// The bodies, and the hand that holds them.
    fn several_bodies(&self) -> Result<Bodies<C>, Error> {
        let mut bodies = Bodies::new(self.bodies.iter().map(BodySetup::body)).held_by(self.hand()?);
        if let Some(gravity) = self.gravity {
            bodies = bodies.gravity(gravity);
        }
        if let Some(loaded) = &self.loaded {
            bodies = bodies.loaded(loaded);
        }
        Ok(if self.shared_by_mass { bodies.shared_by_mass() } else { bodies })
    }

    /// Refuses what is said of bodies where there are none, and two ways to share a load.
    fn check_bodies(&self) -> Result<(), String> {
        let said = [("gravity", self.gravity.is_some()), ("loaded", self.loaded.is_some())];
        let mut said = said.into_iter().chain([("shared_by_mass", self.shared_by_mass)]);
        if let Some((field, _)) = said.find(|(_, said)| *said && self.bodies.is_empty()) {
            let payload = if field == "gravity" {
                "; of one object its weight is a load with a mass, {\"mass\": 2, \"at\": …}, which may have a `gravity`"
            } else {
                ""
            };
            return Err(format!("{field}: of a scene with bodies alone{payload}"));
        }
        if self.shared_by_mass && self.loaded.is_some() {
            return Err(
                "loaded and shared_by_mass: loads act on one body or on all, give one of them".to_owned()
            );
        }
        if !self.bodies.is_empty() && !self.outline.is_empty() {
            return Err("outline: of several bodies each has its own".to_owned());
        }
        Ok(())
    }

    /// The index of a contact in a message is that of the scene, whatever number of points come before it.
    fn in_the_scene(&self, error: Error) -> Error {
        let Error::Contact { contact: ContactLabel { index, name, link, .. }, field, value, allowed } = error
        else {
            return error;
        };
        let mut behind = 0;
        let entry = self.entries().position(|entry| {
            behind += entry.count().unwrap_or(1);
            index < behind
        });
        let contact = ContactLabel { index: entry.unwrap_or(index), point: None, name, link };
        Error::Contact { contact, field, value, allowed }
    }
}

#[cfg(feature = "schema")]
schema_as_written!("Setup", Setup<C>, Written<C>, C);
