//! Warnings about probable mistakes in a scene. The scene can be answered nevertheless. At rest means without load, or under the constant base load
//! of a question. A command is the displacement that a finger would make without the object. A pad is the surface of a finger that closes on the
//! grasped part. A clearance is the gap before the command; contacts with a negative clearance overlap and press. A drive is the spring of a joint or
//! tendon of a hand, with its force limit. A link (a hinge, spring or cable, for example) joins two bodies, or a body and the ground.

use serde::Serialize;

use super::setup::Setup;
use super::written::Scene;
use crate::error::Error;
use crate::grasp::inside;
use crate::numerics::moved;

/// A probable mistake in a scene.
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
    /// A question begins without load, and no command, clearance or drive presses a contact against the object.
    NothingPresses,
    /// Bodies have masses, but the scene has no gravity, and nothing else presses a contact against the object.
    NoGravity,
    /// The grasp buckles at rest: as parts turn, the forces that act on them drive them on more strongly than the springs resist. Answers for small
    /// motions do not apply. `hold`, `need` and `follow` say so in their first line.
    BucklesAtRest,
    /// The grasp has so many coordinates that no question asks whether it buckles.
    BucklingNotAsked,
    /// Without load a contact presses with another force than its `pressed_with`. That field only sets the stretch of the contact's springs before
    /// the object moves.
    PressesOtherwise {
        /// Index of the contact in the scene, from 0.
        contact: usize,
        /// The name of the contact in messages.
        name: String,
        /// The commanded normal force of the contact, its field `pressed_with`, N.
        stated: f64,
        /// The normal force of the contact without load, N.
        force: f64,
    },
    /// Several contacts have the same name, which makes answers ambiguous.
    SameName {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The name that these contacts share.
        name: String,
    },
    /// Contacts or links have no stiffness, and answers depend on the default stiffness.
    StiffnessLeftOut {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
        /// The default stiffness in all directions, N/m.
        stiffness: f64,
        /// The questions whose answers depend on the stiffness, counted from 0.
        questions: Vec<usize>,
    },
    /// Without load a spring or cable pulls with another force than its pretension, since the bodies at its ends move.
    PullsOtherwise {
        /// Index of the link in the scene, from 0.
        link: usize,
        /// The name of the link in messages.
        name: String,
        /// The given pretension of the link, N.
        stated: f64,
        /// The force with which the link pulls without load, N.
        force: f64,
    },
    /// A friction coefficient is implausibly large; it may be given in percent.
    MuchFriction {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
        /// The friction coefficient of the first of these contacts.
        friction: f64,
    },
    /// No contact has friction, and without it the contacts do not hold the object against every load.
    NoFriction,
    /// A length is implausibly large; it may be given in mm.
    ManyMetres {
        /// Beginning of the message, up to the length, for example "a load acts at a distance of".
        what: String,
        /// The implausible length, m.
        length: f64,
        /// The distance between contacts, m, if the length is too large in comparison with this distance.
        #[serde(skip_serializing_if = "Option::is_none")]
        beside: Option<f64>,
    },
    /// A force or a stiffness is out of proportion to the other contacts; perhaps it is the modulus of a material, or in another unit.
    OutOfProportion {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
        /// Whether the value is a stiffness, N/m, and not a force, N.
        is_stiffness: bool,
        /// The stiffness, N/m, or the force, N, of the first of these contacts.
        value: f64,
    },
    /// Any two normals enclose less than 90°, so that contacts cannot press against each other with their given forces.
    SameSide {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
    },
    /// All normals point away from the middle of the contacts, like the normals of fingers in a hole.
    Outwards {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
    },
    /// Suction cups have a vacuum beyond the pressure of the surrounding air.
    BeyondVacuum {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
        /// The vacuum of the first of these cups, Pa.
        pressure: f64,
    },
    /// A load is more than a hundred times the load that friction can carry at the given normal forces; perhaps its mass is given in g.
    HeavyLoad {
        /// The magnitude of the force of this load, N.
        force: f64,
        /// The sum of the normal forces with which contacts press, N.
        pressed: f64,
    },
    /// A load turns by more than two full turns; perhaps its angle is given in degrees.
    ManyTurns {
        /// The largest angle by which a load turns, rad.
        angle: f64,
    },
    /// Some of a pad's area does not meet the grasped part.
    #[cfg(feature = "mesh")]
    MissesInPart {
        /// Index of the contact in the scene, from 0.
        contact: usize,
        /// The name of the contact in messages.
        name: String,
        /// The fraction of the pad's area that does not meet the grasped part.
        missing: f64,
    },
    /// A pad presses where its surface and the surface of the grasped part meet at an angle larger than the friction angle.
    #[cfg(feature = "mesh")]
    OverAnEdge {
        /// Index of the contact in the scene, from 0.
        contact: usize,
        /// The name of the contact in messages.
        name: String,
        /// The largest angle between the surfaces of pad and part, degrees.
        angle: f64,
    },
    /// Two contacts are in one place, with parallel normals.
    OnePlace {
        /// Indices of the contacts concerned, counted from 0 in the scene.
        contacts: Vec<usize>,
        /// The names of the contacts in messages.
        names: Vec<String>,
        /// Whether the normals are opposite, which means that the object has no thickness at the contacts.
        opposite: bool,
    },
    /// A normal points out of the object's outline.
    PointsOut {
        /// Index of the contact in the scene, from 0.
        contact: usize,
        /// The name of the contact in messages.
        name: String,
    },
}

impl Scene {
    /// Warnings about probable mistakes in the scene.
    ///
    /// # Errors
    /// An [`Error`] if the scene gives no grasp, or if a question is malformed.
    pub fn warnings(&self) -> Result<Vec<Warning>, Error> {
        self.setup.warnings()
    }

    /// Probable mistakes that are found before any question is answered: all warnings except those of [`Self::stiffness_left_out`].
    ///
    /// # Errors
    /// An [`Error`] if the scene gives no grasp, or if a question is malformed.
    pub fn warnings_at_once(&self) -> Result<Vec<Warning>, Error> {
        self.setup.warnings_at_once()
    }

    /// Warnings about contacts and links without a stiffness on which an answer depends; see [`Setup::stiffness_left_out`].
    ///
    /// # Errors
    /// An [`Error`] if the scene gives no grasp, or if a question is malformed.
    pub fn stiffness_left_out(&self) -> Result<Vec<Warning>, Error> {
        self.setup.stiffness_left_out()
    }
}

impl<const C: usize> Setup<C> {
    /// Warnings about probable mistakes in the setup.
    ///
    /// # Errors
    /// An [`Error`] if the setup gives no grasp, or if a question is malformed.
    pub fn warnings(&self) -> Result<Vec<Warning>, Error> {
        inside(self).all_warnings()
    }
}

impl Setup<3> {
    /// Warnings about probable mistakes in this setup, in the plane or in space. Vectors have three components; in the plane the third is zero.
    pub(crate) fn all_warnings(&self) -> Result<Vec<Warning>, Error> {
        let mut warnings = self.warnings_at_once()?;
        warnings.extend(self.stiffness_left_out()?);
        Ok(warnings)
    }

    /// Probable mistakes that are found before any question is answered, in the plane or in space: all warnings except those of
    /// [`Self::stiffness_left_out`].
    fn warnings_at_once(&self) -> Result<Vec<Warning>, Error> {
        let grasp = self.grasp_checked()?;
        let mut warnings = self.odd_contacts(&grasp);
        #[cfg(feature = "mesh")]
        warnings.extend(self.badly_touching()?);
        warnings.extend(self.odd_loads());
        if self.nothing_presses(&grasp)? {
            let weighs_nothing = self.gravity.is_none() && self.bodies.iter().any(|body| body.mass > 0.0);
            warnings.push(if weighs_nothing { Warning::NoGravity } else { Warning::NothingPresses });
        }
        warnings.extend(self.buckles_at_rest(&grasp)?);
        if !grasp.engine.is_asked_for_buckling() {
            warnings.push(Warning::BucklingNotAsked);
        }
        warnings.extend(self.otherwise_at_rest(&grasp)?);
        warnings.extend(self.same_names());
        Ok(warnings)
    }

    /// Warnings about names that more than one contact has.
    fn same_names(&self) -> Vec<Warning> {
        let mut named: Vec<(&str, Vec<usize>)> = Vec::new();
        for (contact, entry) in self.entries().enumerate() {
            let Some(name) = entry.contact.name.as_deref() else { continue };
            let place = named.partition_point(|(other, _)| *other < name);
            match named.get_mut(place) {
                Some((same, contacts)) if *same == name => contacts.push(contact),
                _ => named.insert(place, (name, vec![contact])),
            }
        }
        named.retain(|(_, contacts)| contacts.len() > 1);
        moved(named, &|(name, contacts)| Warning::SameName { contacts, name: name.to_owned() })
    }
}
