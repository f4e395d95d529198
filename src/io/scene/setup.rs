//! A grasp with its questions, in the plane or in space. A hand has fingers with joints. A soft fingertip is a contact that is spread over a patch of
//! points. The onset is the load factor of first slip, the event at which the first contact ceases to stick.

use crate::numerics::IntoList;
use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::body::BodySetup;
use super::finger::FingerSetup;
use super::fingertip::Fingertip;
use super::link::LinkSetup;
use super::question::Question;
use crate::ask::Grasp;
use crate::equilibrium::Settings;
use crate::error::{ContactLabel, Error};
use crate::grasp::{self, Bodies, Hand, Space, Tendon, inside, outside};
use crate::serial::{AsGiven, in_text_of, object, space_of_text};
use crate::words::Words;

/// A grasp with its questions and settings. `C` is the number of axes of a contact: 2 in the plane, where the object has 3 degrees of freedom, 3 in
/// space, where it has 6.
///
/// ```
/// use grasp_lcp::planar::{Contact, Wrench};
/// use grasp_lcp::equilibrium::Outcome;
/// use grasp_lcp::scene::{Answer, OnsetAnswer, Question, Setup, SolveAnswer};
///
/// // Two jaws press with 1000 N/m · 0.01 m = 10 N each; μ = 0.5, so that they hold 10 N.
/// let jaw = |side: f64| {
///     Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0])
/// };
/// let down = Wrench::force([0.0, -1.0]);
/// let setup = Setup::new([jaw(-1.0).into(), jaw(1.0).into()])
///     .ask(Question::solve(down * 4.0))
///     .ask(Question::onset(down));
///
/// let [Answer::Solve(SolveAnswer { outcome: Outcome::Equilibrium(state), .. }), Answer::Onset(OnsetAnswer::At(onset))] = &setup.answers()?[..] else {
///     panic!("it holds 4 N, and slides at some load")
/// };
/// assert!((state.contacts[0].force[0] - 10.0).abs() < 1e-13);
/// assert!((onset.at.factor - 10.0).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(extend("required" = [])))]
#[serde(remote = "Self", deny_unknown_fields)]
#[non_exhaustive]
#[must_use]
pub struct Setup<const C: usize> {
    /// Whether the setup is in the plane or in space. The number of vector components does not tell: inside the crate planar vectors have three, too.
    #[serde(skip, default = "space_of_text::<C>")]
    pub(crate) space: Space,
    /// Contacts whose fingers have no joints. [`Setup::grasp`] returns an error if neither this list nor a finger has a contact.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<Fingertip<C>>,
    /// Fingers with joints; their contacts are numbered after those in `contacts`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fingers: Vec<FingerSetup<C>>,
    /// Tendons over the joints of all fingers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tendons: Vec<Tendon>,
    /// Several bodies; contacts then name the bodies that they touch. Empty for one object.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<BodySetup<C>>,
    /// Links between bodies, or between a body and the ground; one object may be linked to the ground.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<LinkSetup<C>>,
    /// Acceleration of gravity on the masses of bodies, m/s², in addition to the loads of questions.
    #[serde(default, with = "AsGiven::<Option<SVector<f64, C>>>", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub gravity: Option<SVector<f64, C>>,
    /// The body on which the loads of questions act; the first body if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loaded: Option<String>,
    /// Whether loads of questions act on all bodies, on each in proportion to its mass.
    #[serde(default, skip_serializing_if = "is_false")]
    pub shared_by_mass: bool,
    /// Corners of the object in order, m; used only to draw pictures.
    #[serde(default, with = "AsGiven::<Vec<SVector<f64, C>>>", skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub outline: Vec<SVector<f64, C>>,
    /// The grasped part as a mesh; contacts touch it.
    #[cfg(feature = "mesh")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<super::part::PartSetup>,
    /// The robot that holds the object; contacts are on its links.
    #[cfg(feature = "urdf")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robot: Option<super::robot::RobotSetup<C>>,
    /// The questions, in the order of their answers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub questions: Vec<Question<C>>,
    /// The settings for all questions. With the polygonal cone, the onset is the load factor at which a contact force reaches a facet
    /// ([`Grasp::onset`]).
    #[serde(default, skip_serializing_if = "is_default")]
    pub settings: Settings,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_false(said: &bool) -> bool {
    !said
}

fn is_default(settings: &Settings) -> bool {
    *settings == Settings::default()
}

/// A setup as read from text, field by field. Its parts and questions are not yet checked.
struct Fields(Setup<3>);

impl<'de> Deserialize<'de> for Fields {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        Setup::deserialize(deserializer).map(Self)
    }
}

impl<const C: usize> Serialize for Setup<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let setup = inside(self);
        in_text_of(setup.space, || Setup::serialize(&*setup, serializer))
    }
}

impl<'de, const C: usize> Deserialize<'de> for Setup<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        read_in(Space::of::<C>(), deserializer).map(outside)
    }
}

/// A planar setup that is read from a text with vectors of two components, and stored with three.
pub(super) struct PlanarSetup(pub(super) Setup<3>);

impl<'de> Deserialize<'de> for PlanarSetup {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        read_in(Space::Planar, deserializer).map(Self)
    }
}

fn read_in<'de, S: Deserializer<'de>>(space: Space, deserializer: S) -> Result<Setup<3>, S::Error> {
    in_text_of(space, || object::read(deserializer, "a setup", |Fields(setup)| setup.checked()))
}

impl<const C: usize> From<&Grasp<C>> for Setup<C> {
    /// The setup of a grasp: every contact is a point contact, and there are no questions.
    fn from(grasp: &Grasp<C>) -> Self {
        let contacts = grasp.contacts().iter().cloned().map(Fingertip::from);
        Self { space: grasp.space(), ..Self::new(contacts) }
    }
}

impl<const C: usize> Setup<C> {
    /// A setup without questions and outline, with default settings. A [`Contact`](crate::grasp::Contact) is converted to a [`Fingertip`] by `into`.
    pub fn new(contacts: impl IntoIterator<Item = Fingertip<C>>) -> Self {
        Self {
            space: Space::of::<C>(),
            contacts: contacts.into_iter().list(),
            fingers: Vec::new(),
            tendons: Vec::new(),
            bodies: Vec::new(),
            links: Vec::new(),
            gravity: None,
            loaded: None,
            shared_by_mass: false,
            outline: Vec::new(),
            #[cfg(feature = "mesh")]
            part: None,
            #[cfg(feature = "urdf")]
            robot: None,
            questions: Vec::new(),
            settings: Settings::default(),
        }
    }

    setters! {
        /// This setup with one more finger.
        pub fn finger(mut self, finger: FingerSetup<C>) { self.fingers.push(finger); }

        /// This setup with one more tendon over the joints of its fingers.
        pub fn tendon(mut self, tendon: Tendon) { self.tendons.push(tendon); }

        /// This setup with one more question.
        pub fn ask(mut self, question: Question<C>) { self.questions.push(question); }

        /// This setup with other settings for its questions.
        pub fn with_settings(mut self, settings: Settings) { self.settings = settings; }
    }

    /// All contacts: first [`Self::contacts`], then the contacts of fingers. The index of an entry is the index of the contact in questions and
    /// answers.
    pub fn entries(&self) -> impl Iterator<Item = &Fingertip<C>> {
        let mut all: Vec<&Fingertip<C>> = self.contacts.iter().list();
        for finger in &self.fingers {
            all.extend(&finger.contacts);
        }
        all.into_iter()
    }

    /// Whether there are fingers with joints, tendons, or contacts that are pressed with a constant force. The grasp is then made by a [`Hand`], see
    /// [`Self::hand`].
    #[must_use]
    pub fn is_held_by_a_hand(&self) -> bool {
        let by_force = self.contacts.iter().any(|entry| entry.contact.force.is_some());
        by_force || !self.fingers.is_empty() || !self.tendons.is_empty()
    }

    /// The grasp with the settings of the setup. It may have more contacts than the scene, since soft fingertips become several contacts.
    ///
    /// # Errors
    /// An [`Error`] for the first part that is missing or out of range, for example [`Error::EmptyGrasp`], [`Error::Contact`], [`Error::Fingertip`]
    /// or [`Error::Hand`]. It names a contact by the index that the contact has in the scene.
    pub fn grasp(&self) -> Result<Grasp<C>, Error> {
        inside(self).grasp_checked().map(outside)
    }

    /// The hand that holds the object. Its fingers without joints, one for each contact, come first.
    ///
    /// # Errors
    /// [`Error::Contact`], [`Error::Fingertip`] and [`Error::Hand`] for parts that cannot be built.
    pub fn hand(&self) -> Result<Hand<C>, Error> {
        inside(self).whole_hand().map(outside)
    }
}

impl Setup<3> {
    /// The number of axes of contacts: 2 in the plane, also if vectors have three components, and 3 in space.
    #[must_use]
    pub fn axes(&self) -> usize {
        self.space.axes()
    }

    /// The format `words` of numbers, adapted to this setup, whose vectors have three components. In the plane the third component is not written.
    pub fn words(&self, words: Words) -> Words {
        words.in_space(self.space)
    }

    /// Returns this setup, or an error if one of its parts or questions is malformed.
    fn checked(self) -> Result<Self, String> {
        self.check_bodies()?;
        #[cfg(feature = "urdf")]
        if self.robot.is_some() {
            // The robot's contacts are unknown until its file is read; questions are therefore checked when they are answered.
            return self.check_robot().map(|()| self);
        }
        if self.entries().next().is_none() && self.links.is_empty() {
            return Err(Error::EmptyGrasp.to_string());
        }
        #[cfg(feature = "mesh")]
        let (setup, has_points) = self.with_part_of_arrays()?;
        #[cfg(not(feature = "mesh"))]
        let (setup, has_points) = (self, true);
        if has_points && (setup.is_held_by_a_hand() || !setup.bodies.is_empty()) {
            // Whether joints fit the contacts that they move is checked only when a grasp is built; therefore a grasp is built here.
            setup.grasp_checked().map(drop).map_err(|error| error.to_string())?;
        }
        for (index, question) in setup.questions.iter().enumerate() {
            setup.check_question(question).map_err(|error| format!("questions[{index}]: {error}"))?;
        }
        Ok(setup)
    }

    /// Number of point contacts of the grasp: soft fingertips and links count with all their points.
    #[cfg(feature = "json")]
    pub(crate) fn all_points(&self) -> Result<usize, Error> {
        let points = self.entries().map(Fingertip::count).sum::<Result<usize, _>>()?;
        Ok(points + self.points_of_links()?.len())
    }

    /// The grasp with the settings of the setup, in the plane or in space. Vectors have three components; in the plane the third is zero.
    pub(super) fn grasp_checked(&self) -> Result<Grasp<3>, Error> {
        let grasp = if !self.bodies.is_empty() {
            self.several_bodies()?.grasp()
        } else if self.is_held_by_a_hand() {
            self.whole_hand()?.grasp()
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

    /// The hand that holds the object, in the plane or in space. Vectors have three components; in the plane the third is zero.
    fn whole_hand(&self) -> Result<Hand<3>, Error> {
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

    /// The bodies, with the hand that holds the bodies.
    fn several_bodies(&self) -> Result<Bodies<3>, Error> {
        let mut bodies = Bodies::new(self.bodies.iter().map(BodySetup::body)).held_by(self.whole_hand()?);
        if let Some(gravity) = self.gravity {
            bodies = bodies.gravity(gravity);
        }
        if let Some(loaded) = &self.loaded {
            bodies = bodies.loaded(loaded);
        }
        Ok(if self.shared_by_mass { bodies.shared_by_mass() } else { bodies })
    }

    /// Refuses fields about bodies in a scene without bodies. In a scene with bodies it refuses a load that is both shared by mass and on one body.
    /// There it also refuses an outline of the scene itself, since each body has an outline of its own.
    fn check_bodies(&self) -> Result<(), String> {
        let said = [
            ("gravity", self.gravity.is_some()),
            ("loaded", self.loaded.is_some()),
            ("shared_by_mass", self.shared_by_mass),
        ];
        if let Some((field, _)) = said.iter().find(|(_, said)| *said && self.bodies.is_empty()) {
            let payload = if *field == "gravity" {
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

    /// Replaces the contact index in an error of the grasp by the index in the scene, in which all points of a soft fingertip are one contact.
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
