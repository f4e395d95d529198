//! A finger with joints, and the contacts on its links.

use nalgebra::{DMatrix, SVector};
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::fingertip::{Fingertip, MovedBy};
use super::matrix::Rows;
use super::written_contact::LinkedContact;
use crate::error::Error;
use crate::grasp::{self, Joint, Space};
use crate::numerics::{IntoList, matrix_of, moved};
use crate::serial::{AsGiven, object};

/// A finger of a scene: joints in a row from the palm on, and contacts on its links; see [`grasp::Finger`].
///
/// ```
/// use grasp_lcp::planar::Contact;
/// use grasp_lcp::planar::hand::Joint;
/// use grasp_lcp::scene::{FingerSetup, Scene, Setup};
///
/// // Two jaws of 1000 N/m, told to close by 10 mm, with stiff pads.
/// let jaw = |side: f64| {
///     let slide = Joint::prismatic([-side, 0.0]).stiffness(1e3).command(0.01);
///     FingerSetup::new([slide]).contact(Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e5, 1e5).friction(0.5))
/// };
/// let scene = Scene::from(Setup::<2>::new([]).finger(jaw(-1.0)).finger(jaw(1.0)));
/// let written = serde_json::to_value(&scene)?;
/// assert_eq!(written["planar"]["fingers"][0]["joints"][0]["stiffness"], 1e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Two jaws of a gripper whose motors stall at 6 N:
///
/// ```
/// use grasp_lcp::scene::Scene;
///
/// let scene: Scene = serde_json::from_str(r#"{
///     "format": "grasp-lcp/1",
///     "planar": {
///         "fingers": [
///             {
///                 "joints": [{ "name": "left jaw", "prismatic": [1, 0], "stiffness": 1000, "command": 0.004, "limit": { "saturates": 6 } }],
///                 "contacts": [{ "point": [-1, 0], "normal": [1, 0], "series_stiffness": [1e4, 1e4], "friction": 0.5 }]
///             },
///             {
///                 "joints": [{ "name": "right jaw", "prismatic": [-1, 0], "stiffness": 1000, "command": 0.004, "limit": { "saturates": 6 } }],
///                 "contacts": [{ "point": [1, 0], "normal": [-1, 0], "series_stiffness": [1e4, 1e4], "friction": 0.5 }]
///             }
///         ],
///         "questions": [{ "onset": { "direction": { "force": [1, 0] } } }, { "follow": { "legs": [{ "joints_to": [0.01, 0.01] }] } }]
///     }
/// }"#)?;
/// let answers = serde_json::to_value(scene.answers()?)?;
/// // Told 4 mm, 1.1 mm/N a side: pulled by W the right jaw carries 4/1.1 N + W/2.
/// let onset = &answers[0]["onset"];
/// assert!((onset["factor"].as_f64().unwrap() - 2.0 * (6.0 - 4.0 / 1.1)).abs() < 1e-12);
/// assert_eq!(onset["drives"][0], serde_json::json!({ "joint": 1, "name": "right jaw", "what": "yields" }));
/// let end = &answers[1]["follow"]["state"];
/// assert_eq!(end["joints"][0]["state"], "yields");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct FingerSetup<const C: usize> {
    /// A comment for the reader of the file.
    pub comment: Option<String>,
    /// The joints from the palm on; none for a finger that only has a compliance.
    pub joints: Vec<Joint<C>>,
    /// The stiffness matrix of the joints, N m/rad, added to their own springs; see [`grasp::Finger::coupled`].
    pub stiffness_matrix: Option<DMatrix<f64>>,
    /// The compliance matrix of the contacts, m/N; see [`grasp::Finger::compliant`].
    pub compliance: Option<DMatrix<f64>>,
    /// The contacts, at least one.
    pub contacts: Vec<Fingertip<C>>,
}

impl<const C: usize> FingerSetup<C> {
    /// A finger with these joints and no contact yet.
    pub fn new(joints: impl IntoIterator<Item = Joint<C>>) -> Self {
        Self {
            comment: None,
            joints: joints.into_iter().list(),
            stiffness_matrix: None,
            compliance: None,
            contacts: Vec::new(),
        }
    }

    /// This finger with one more contact: a [`Contact`](grasp::Contact), or a [`Fingertip`] with the link it is on.
    pub fn contact(mut self, contact: impl Into<Fingertip<C>>) -> Self {
        self.contacts.push(contact.into());
        self
    }

    /// Returns an error for a finger without contacts. If there were no error, such a finger would be ignored silently.
    fn checked(self) -> Result<Self, String> {
        if self.contacts.is_empty() {
            return Err("contacts: none given, must be at least one a finger".to_owned());
        }
        Ok(self)
    }
}

impl FingerSetup<3> {
    /// This finger as a part of the hand that holds the object. Each of its soft fingertips is divided into point contacts. `first` is the index in
    /// the scene of the finger's first contact.
    pub(super) fn spread(&self, first: usize) -> Result<grasp::Finger<3>, Error> {
        let points = |k: usize| self.contacts[k].points(first + k);
        let mut finger = grasp::Finger::new(self.joints.iter().cloned());
        finger.coupling.clone_from(&self.stiffness_matrix);
        finger.compliance.clone_from(&self.compliance);
        for (k, entry) in self.contacts.iter().enumerate() {
            for point in points(k)? {
                finger = match &entry.moved_by {
                    MovedBy::LastLink => finger.contact(point),
                    MovedBy::Link(joints) => finger.contact_on(*joints, point),
                    MovedBy::Jacobian(twists) if point.space == Space::Spatial && twists.nrows() == 6 => {
                        let arm = point.point - entry.contact.point;
                        finger.contact_moved_by(moved_at(twists, &arm), point)
                    }
                    MovedBy::Jacobian(_) if entry.is_spread() => {
                        return Err(Error::Hand {
                            what: format!("contact {}", first + k),
                            field: "number of points",
                            value: entry.count()? as f64,
                            allowed: "1 with a jacobian, which is that of one point; one of six rows, angular velocities last, is that of a link",
                        });
                    }
                    MovedBy::Jacobian(matrix) => finger.contact_moved_by(matrix.clone(), point),
                };
            }
        }
        Ok(finger)
    }
}

/// Jacobian of a point of a finger's link: the velocity `v + ω × r` of this point for unit velocity of each joint. Rows 0 to 2 of `twists` are the
/// velocities v of the contact, rows 3 to 5 the angular velocities ω of the link. The vector r, m, from the contact to the point is `arm`.
fn moved_at(twists: &DMatrix<f64>, arm: &SVector<f64, 3>) -> DMatrix<f64> {
    matrix_of(3, twists.ncols(), &|a, j| {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        twists[(a, j)] + twists[(3 + b, j)] * arm[c] - twists[(3 + c, j)] * arm[b]
    })
}

#[derive(serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Written<const C: usize> {
    /// A comment for the reader of the file.
    comment: Option<String>,
    /// The joints from the palm on; none if left out.
    #[serde(default)]
    joints: Vec<Joint<C>>,
    /// Rows of the symmetric stiffness matrix of the joints, added to their own springs, N m/rad.
    stiffness_matrix: Option<Rows>,
    /// Rows of the symmetric compliance matrix of the contacts, m/N, ordered by contact and then by axis of its frame.
    compliance: Option<Rows>,
    /// The constant normal force of the finger's only contact, N.
    #[serde(default, with = "AsGiven::<Option<f64>>")]
    presses_with: Option<f64>,
    /// The contacts, at least one. Their stiffness may be left out if a `compliance` is given.
    contacts: Vec<LinkedContact<C>>,
}

#[derive(serde::Serialize)]
struct FingerText<'a, const C: usize> {
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'a str>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    joints: &'a [Joint<C>],
    #[serde(skip_serializing_if = "Option::is_none")]
    stiffness_matrix: Option<Rows>,
    #[serde(skip_serializing_if = "Option::is_none")]
    compliance: Option<Rows>,
    contacts: &'a [Fingertip<C>],
}

impl<const C: usize> Serialize for FingerSetup<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        FingerText {
            comment: self.comment.as_deref(),
            joints: &self.joints,
            stiffness_matrix: self.stiffness_matrix.as_ref().map(Rows::of),
            compliance: self.compliance.as_ref().map(Rows::of),
            contacts: &self.contacts,
        }
        .serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for FingerSetup<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a finger", |written: Written<C>| {
            let matrix = |rows: Option<Rows>, field| rows.map(|rows| rows.matrix(field)).transpose();
            let mut contacts: Vec<_> = moved(written.contacts, &|LinkedContact(entry)| entry);
            if let Some(force) = written.presses_with {
                let [entry] = &mut contacts[..] else {
                    return Err(
                        "presses_with: it is the force of one contact; say `force` of each".to_owned()
                    );
                };
                entry.contact = entry.contact.clone().force(force);
            }
            Self {
                comment: written.comment,
                joints: written.joints,
                stiffness_matrix: matrix(written.stiffness_matrix, "stiffness_matrix")?,
                compliance: matrix(written.compliance, "compliance")?,
                contacts,
            }
            .checked()
        })
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Finger", FingerSetup<C>, Written<C>, C);
