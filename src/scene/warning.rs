//! What a scene says that is seldom meant: it is answered, with a word of warning.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use super::setup::Setup;
use super::written::{Scene, Space};
use crate::error::Error;
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
    /// At rest a spring or cable pulls with another force than its pretension, since what it pulls at gives way.
    PullsOtherwise {
        /// The link of the scene, from 0.
        link: usize,
        /// How messages call it.
        name: String,
        /// Its pretension, N.
        told: f64,
        /// What it pulls with, N.
        force: f64,
    },
    /// Friction is more than contacts have; perhaps it is given in percent.
    MuchFriction {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// How messages call them.
        names: Vec<String>,
        /// The coefficient of the first.
        friction: f64,
    },
    /// No contact has friction, and contacts do not hold the object against every load without.
    NoFriction,
    /// A length is too large; perhaps it is given in mm.
    ManyMetres {
        /// What it is, with a verb.
        what: String,
        /// How large it is, m.
        length: f64,
        /// How far contacts are apart, if that is what it is too large beside, m.
        #[serde(skip_serializing_if = "Option::is_none")]
        beside: Option<f64>,
    },
    /// All normals point the same way, so that contacts cannot press as they are told.
    SameSide {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// How messages call them.
        names: Vec<String>,
    },
    /// All normals point away from the middle of the contacts, as those of fingers in a hole.
    Outwards {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// How messages call them.
        names: Vec<String>,
    },
    /// A load is hundreds of times what contacts press with; perhaps its mass is given in g.
    HeavyLoad {
        /// Its force, N.
        force: f64,
        /// What contacts press with together, N.
        pressed: f64,
    },
    /// Two contacts are in one place, with parallel normals.
    OnePlace {
        /// The contacts of the scene, from 0.
        contacts: Vec<usize>,
        /// How messages call them.
        names: Vec<String>,
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
            Self::PullsOtherwise { name, told, force, .. } => write!(
                f,
                "{} pulls with {} N at rest, not with {} N: `pretension` is its pull before anything gives way; say `tension` for the pull once it is installed",
                printable(name),
                words.number(*force),
                words.number(*told)
            ),
            Self::MuchFriction { names, friction, .. } => write!(
                f,
                "friction {} at {}: coefficients are rarely above 1; in percent? Then it is {}",
                words.number(*friction),
                all(names),
                words.number(0.01 * friction)
            ),
            Self::NoFriction => f.write_str(
                "no contact has friction: nothing is held but what normals push against; say `friction`",
            ),
            Self::ManyMetres { what, length, beside } => {
                write!(f, "{} {} m", printable(what), words.number(*length))?;
                if let Some(size) = beside {
                    write!(f, ", and contacts are {} m apart", words.number(*size))?;
                }
                f.write_str(": lengths are in m; is this in mm?")
            }
            Self::SameSide { names, .. } => write!(
                f,
                "the normals of {} point the same way: contacts cannot press against each other; normals point into the object, the way the finger pushes",
                all(names)
            ),
            Self::Outwards { names, .. } => write!(
                f,
                "the normals of {} point away from the middle: so they do for fingers in a hole; else normals point into the object, the way the finger pushes",
                all(names)
            ),
            Self::HeavyLoad { force, pressed } => write!(
                f,
                "a load has {} N, and contacts press with {} N together: masses are in kg; is this in g?",
                words.number(*force),
                words.number(*pressed)
            ),
            Self::OnePlace { names, .. } => write!(
                f,
                "{} are in one place, with parallel normals: a finger that is there twice is twice as stiff",
                all(names)
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
                    all(names),
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

/// Names of contacts in a row.
fn all(names: &[String]) -> String {
    listed(&names.iter().map(|name| printable(name)).collect::<Vec<_>>())
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
        let grasp = self.grasp()?;
        let mut warnings = self.odd_contacts(&grasp)?;
        warnings.extend(self.odd_loads());
        if self.nothing_presses(&grasp)? {
            warnings.push(Warning::NothingPresses);
        }
        warnings.extend(self.otherwise_at_rest(&grasp)?);
        warnings.extend(self.same_names());
        warnings.extend(self.stiffness_left_out()?);
        warnings.extend(self.stiffness_of_links_left_out()?);
        Ok(warnings)
    }
}

impl<const C: usize> Setup<C> {
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
}
