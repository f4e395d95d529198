//! What a scene says that is seldom meant: it is answered, with a word of warning.

use std::collections::BTreeMap;
use std::fmt;

use nalgebra::SVector;
use serde::Serialize;

use super::fingertip::Fingertip;
use super::link::LinkSetup;
use super::question::Question;
use super::setup::Setup;
use super::written::{Scene, Space};
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, Outcome};
use crate::error::Error;
use crate::grasp::{Hold, Wrench};
use crate::words::{Words, listed, printable};

/// Something that a scene says and hardly means.
///
/// ```
/// use grasp_lcp::planar::Contact;
/// use grasp_lcp::scene::{Setup, Warning};
///
/// let contact = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5);
/// let setup: Setup<2> = Setup::new([contact(-1.0).into(), contact(1.0).into()]);
/// assert_eq!(setup.warnings()?, [Warning::NothingPresses]);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "snake_case")]
#[non_exhaustive]
pub enum Warning {
    /// A question begins without load, and no command, clearance or drive presses a contact on.
    NothingPresses,
    /// At rest a contact that is `pressed_with` a force presses with another one: that force moves a spring, and the object gives way.
    PressesOtherwise {
        /// The contact of the scene, from 0.
        contact: usize,
        /// How messages call it.
        name: String,
        /// What it is pressed with, N.
        told: f64,
        /// What it presses with, N.
        force: f64,
    },
    /// Several contacts have one name, so that answers do not tell which is meant.
    SameName {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// The name.
        name: String,
    },
    /// Contacts have no stiffness, and answers depend on what was taken in its place.
    StiffnessLeftOut {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// How messages call them.
        names: Vec<String>,
        /// What was taken for all directions, N/m.
        stiffness: f64,
        /// The questions whose answers depend on it, from 0.
        questions: Vec<usize>,
    },
    /// The outline says that a normal points out of the object.
    PointsOut {
        /// The contact of the scene, from 0.
        contact: usize,
        /// How messages call it.
        name: String,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        match self {
            Self::NothingPresses => f.write_str(
                "no finger presses: every command is zero or missing, so that friction has nothing to act on; say `command` or `pressed_with`",
            ),
            Self::PressesOtherwise { name, told, force, .. } => write!(
                f,
                "{} presses with {} N at rest, not with {} N: `pressed_with` moves a spring, and the object gives way until forces agree",
                printable(name),
                words.number(*force),
                words.number(*told)
            ),
            Self::SameName { contacts, name } => {
                let numbers: Vec<_> = contacts.iter().map(|contact| format!("contact {contact}")).collect();
                write!(f, "{} are called {}: answers do not tell which is meant", listed(&numbers), printable(name))
            }
            Self::StiffnessLeftOut { names, stiffness, questions, .. } => {
                let have = if names.len() == 1 { "has" } else { "have" };
                let numbers: Vec<_> = questions.iter().map(|question| format!("question {question}")).collect();
                write!(
                    f,
                    "{} {have} no stiffness, and it is taken that each gives way by {} N/m in all directions: the answer to {} depends on it; say `stiffness`",
                    listed(&names.iter().map(|name| printable(name)).collect::<Vec<_>>()),
                    words.number(*stiffness),
                    listed(&numbers)
                )
            }
            Self::PointsOut { name, .. } => write!(
                f,
                "{}: its normal points out of the outline; normals point into the object, the way the finger pushes",
                printable(name)
            ),
        }
    }
}

impl Scene {
    /// What it says and hardly means.
    ///
    /// # Errors
    /// As for [`Setup::warnings`].
    pub fn warnings(&self) -> Result<Vec<Warning>, Error> {
        match &self.space {
            Space::Planar(setup) => setup.warnings(),
            Space::Spatial(setup) => setup.warnings(),
        }
    }
}

impl<const C: usize> Setup<C> {
    /// What it says and hardly means.
    ///
    /// # Errors
    /// As for [`Self::grasp`].
    pub fn warnings(&self) -> Result<Vec<Warning>, Error> {
        let mut warnings = Vec::new();
        let grasp = self.grasp()?;
        if self.begins_without_load() && !grasp.presses() {
            warnings.push(Warning::NothingPresses);
        }
        warnings.extend(self.presses_otherwise(&grasp)?);
        warnings.extend(self.same_names());
        warnings.extend(self.stiffness_left_out()?);
        warnings.extend(self.stiffness_of_links_left_out()?);
        for (contact, entry) in self.entries().enumerate() {
            let (point, normal) = (entry.contact.point(), entry.contact.normal);
            if points_out(self.outline_around(entry), &point, &normal) {
                warnings.push(Warning::PointsOut { contact, name: entry.contact.label_text(contact) });
            }
        }
        Ok(warnings)
    }
}

impl<const C: usize> Setup<C> {
    /// The outline of what a contact's normal points into.
    fn outline_around(&self, entry: &Fingertip<C>) -> &[SVector<f64, C>] {
        let Some(on) = &entry.contact.on else { return &self.outline };
        self.bodies.iter().find(|body| body.name == *on).map_or(&[], |body| &body.outline)
    }

    /// Contacts that press at rest with another force than they are pressed with.
    fn presses_otherwise(&self, grasp: &Grasp<C>) -> Result<Vec<Warning>, Error> {
        if self.entries().all(|entry| entry.contact.press.is_none()) {
            return Ok(Vec::new());
        }
        let Ok(Outcome::Equilibrium(state)) = grasp.solve(&Wrench::ZERO) else { return Ok(Vec::new()) };
        let mut warnings = Vec::new();
        let mut first = 0;
        for (contact, entry) in self.entries().enumerate() {
            let points = first..first + entry.count()?;
            first = points.end;
            let Some(told) = entry.contact.press else { continue };
            let force = state.contacts[points].iter().map(ContactAnswer::normal_force).sum::<f64>();
            if (force - told).abs() > OTHERWISE * told {
                let name = entry.contact.label_text(contact);
                warnings.push(Warning::PressesOtherwise { contact, name, told, force });
            }
        }
        Ok(warnings)
    }

    /// Names that more than one contact has.
    fn same_names(&self) -> Vec<Warning> {
        let mut named: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (contact, entry) in self.entries().enumerate() {
            if let Some(name) = entry.contact.name.as_deref() {
                named.entry(name).or_default().push(contact);
            }
        }
        let several = named.into_iter().filter(|(_, contacts)| contacts.len() > 1);
        several.map(|(name, contacts)| Warning::SameName { contacts, name: name.to_owned() }).collect()
    }

    /// Whether a question does, or none is asked yet.
    fn begins_without_load(&self) -> bool {
        let without = |question: &Question<C>| match question {
            Question::Hold { base, load, .. } => *base == Wrench::ZERO && !self.lies_on_a_contact(load),
            Question::Need(asked) => {
                asked.begins_without_load() && !asked.put_on().any(|load| self.lies_on_a_contact(load))
            }
            Question::Improve(asked) => asked.base.is_none(),
            Question::Solve { load, .. } => *load == Wrench::ZERO,
            Question::Onset(asked) => asked.base == Wrench::ZERO,
            Question::OnsetOfTurn(turn) => turn.load_at(0.0) == Wrench::ZERO,
            Question::Follow { start, .. } => *start == Wrench::ZERO,
            Question::Shake(asked) => asked.base == Wrench::ZERO,
            Question::Shakedown(asked) => asked.base == Wrench::ZERO,
            Question::Identify(asked) => asked.begins_without_load(),
        };
        self.questions.is_empty() || self.questions.iter().any(without)
    }
}

impl<const C: usize> Setup<C> {
    /// Whether a load presses a contact on by itself, as a weight does the table: it needs no finger for that.
    fn lies_on_a_contact(&self, load: &Wrench<C>) -> bool {
        let along = |normal: &SVector<f64, C>| {
            normal.iter().zip(load.components()).map(|(n, force)| n * force).sum::<f64>() / normal.norm()
        };
        let size = load.components()[..C].iter().map(|force| force * force).sum::<f64>().sqrt();
        let hangs = |link: &LinkSetup<C>| {
            link.link.contacts().is_ok_and(|points| {
                points
                    .iter()
                    .any(|point| point.hold != Hold::Unilateral || along(&point.normal) < -ALONG * size)
            })
        };
        self.entries().any(|entry| along(&entry.contact.normal) < -ALONG * size)
            || self.links.iter().any(hangs)
    }
}

/// Of a force that is said to press on a contact this part does.
const ALONG: f64 = 1e-6;

/// Forces that differ by less than this part are what was meant.
const OTHERWISE: f64 = 0.02;

/// A step from a contact into the object or out of it, in parts of the size of its outline.
const STEP: f64 = 1e-3;

/// Whether a step along the normal leads out of the outline and one against it leads in. In space the outline is no surface, and nothing is said.
fn points_out<const C: usize>(
    outline: &[SVector<f64, C>],
    point: &SVector<f64, C>,
    normal: &SVector<f64, C>,
) -> bool {
    if C != 2 || outline.len() < 3 {
        return false;
    }
    let size = outline.iter().map(|corner| (corner - outline[0]).norm()).fold(0.0, f64::max);
    let step = normal.normalize() * (STEP * size);
    is_inside(outline, &(point - step)) && !is_inside(outline, &(point + step))
}

/// Whether a ray along x from a point crosses a closed line an odd number of times.
fn is_inside<const C: usize>(outline: &[SVector<f64, C>], point: &SVector<f64, C>) -> bool {
    let sides = outline.iter().zip(outline.iter().cycle().skip(1));
    let crossed = sides.filter(|(a, b)| {
        let part = (point[1] - a[1]) / (b[1] - a[1]);
        (a[1] > point[1]) != (b[1] > point[1]) && point[0] < a[0] + part * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}
