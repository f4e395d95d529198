//! A contact in the text of a scene, and its checks. A soft fingertip is a contact that is spread over a patch of points. A part is a grasped object
//! that is given as a mesh, and a pad is the surface of a finger that closes on the part.

use std::sync::Arc;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::cup::WrittenSuction;
use super::fingertip::{Fingertip, MovedBy};
use super::matrix::Rows;
use super::patch::FingertipPatch;
use super::springs::Springs;
use crate::error::{ContactLabel, Error};
use crate::grasp::{CommandAxes, Contact, Hold, Stiffness, inside};
use crate::improve::Surface;
use crate::serial::{AsGiven, AxisRow, Friction, Given, Number, object, space_of_text};

/// A contact in the text of a scene.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(all(feature = "schema", not(feature = "mesh")), schemars(extend("required" = ["point", "normal"])))]
#[cfg_attr(
    all(feature = "schema", feature = "mesh"),
    schemars(extend("oneOf" = [{ "required": ["point", "normal"] }, { "required": ["touches"] }]))
)]
#[cfg_attr(feature = "schema", schemars(transform = super::schema::with_stiffness))]
#[serde(deny_unknown_fields)]
struct Written<const C: usize> {
    /// The name of the contact in messages and answers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<Arc<str>>,
    /// A comment for the reader of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    comment: Option<String>,
    /// With several bodies: the body that the normal points into.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    on: Option<Arc<str>>,
    /// With several bodies: the body on the other side; the ground or a finger if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    against: Option<Arc<str>>,
    /// The point of contact, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    point: Option<AxisRow<Given, C>>,
    /// The direction of the normal into the object, of any length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    normal: Option<AxisRow<Given, C>>,
    /// A pad that closes on the part, in place of point and normal.
    #[cfg(feature = "mesh")]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    touches: Option<super::part::PadTouch>,
    /// The direction of the first tangent; chosen from the normal if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tangent: Option<AxisRow<Given, C>>,
    /// The object's normal and tangential stiffness, N/m; the object is rigid if only the finger's stiffness is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    body_stiffness: Option<Springs<C>>,
    /// The finger's normal and tangential stiffness, N/m; the finger is rigid if only the object's stiffness is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    finger_stiffness: Option<Springs<C>>,
    /// The stiffness of object and finger in series, N/m, in place of their separate stiffnesses; 1e4 in all directions if no stiffness is given.
    #[serde(default, alias = "stiffness", skip_serializing_if = "Option::is_none")]
    series_stiffness: Option<Springs<C>>,
    /// The coefficient of friction; 0 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    friction: Option<Number<Friction>>,
    /// The coefficient of friction while the contact slides, at most `friction`, and equal to it if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    kinetic_friction: Option<Number<Friction>>,
    /// The commanded displacement of the finger in the contact frame, normal part first, m; 0 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    command: Option<AxisRow<Given, C>>,
    /// The commanded displacement along the coordinate axes, m, instead of `command`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    command_world: Option<AxisRow<Given, C>>,
    /// The clamping force, N, instead of the normal command.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    pressed_with: Option<f64>,
    /// A constant normal force, N, whatever the object's motion; instead of a position of the finger.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    force: Option<f64>,
    /// Gap before anything moves, negative for an overlap, m; 0 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    clearance: Option<f64>,
    /// Whether the contact may open, is kept closed, or is bonded; it may open if left out.
    #[serde(default, skip_serializing_if = "is_unilateral")]
    hold: Hold,
    /// The patch of a soft fingertip instead of the point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    soft: Option<FingertipPatch>,
    /// A suction cup instead of the point, or the force of a vacuum within a soft fingertip, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    suction: Option<WrittenSuction>,
    /// The curve or surface along which `improve` may move the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    surface: Option<Surface<C>>,
    /// The joints of the finger that move the contact: the first n with `{"link": n}`, counted from the palm, or all by a `jacobian`; all if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    moved_by: Option<WrittenMover>,
}

/// The joints that move a contact of a finger.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "MovedBy"))]
#[serde(rename_all = "snake_case")]
enum WrittenMover {
    Link(usize),
    Jacobian(Rows),
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
fn is_unilateral(hold: &Hold) -> bool {
    *hold == Hold::Unilateral
}

impl<const C: usize> Serialize for Fingertip<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let contact = &self.contact;
        #[cfg(feature = "mesh")]
        let (is_placed, has_layer) =
            (self.touches.is_none(), self.touches.as_ref().is_some_and(|touches| touches.layer.is_some()));
        #[cfg(not(feature = "mesh"))]
        let (is_placed, has_layer) = (true, false);
        let rigid = |k: &SVector<f64, C>| k.iter().all(|k| *k == f64::INFINITY);
        let unless_rigid = |k: &SVector<f64, C>| (!rigid(k)).then_some(Springs(*k));
        let (body, finger, series) = match &contact.stiffness {
            _ if self.no_stiffness => (None, None, None),
            Stiffness::BodyAndFinger { body, finger } => {
                (unless_rigid(body), unless_rigid(finger).filter(|_| !has_layer), None)
            }
            Stiffness::Series(k) => (None, None, unless_rigid(k)),
        };
        let said = |x: f64| x.to_bits() != 0;
        let command_along = |axes: CommandAxes| {
            let given = axes == CommandAxes::World || contact.command.iter().any(|x| said(*x));
            (given && axes == contact.command_axes).then(|| AxisRow::new(contact.command))
        };
        Written {
            name: contact.name.clone(),
            comment: self.comment.clone(),
            on: contact.on.clone(),
            against: contact.against.clone(),
            point: is_placed.then(|| AxisRow::new(contact.point)),
            normal: is_placed.then(|| AxisRow::new(contact.normal)),
            #[cfg(feature = "mesh")]
            touches: self.touches.clone(),
            tangent: contact.tangent.map(AxisRow::new),
            body_stiffness: body,
            finger_stiffness: finger,
            series_stiffness: series,
            friction: said(contact.friction).then(|| Number::new(contact.friction)),
            kinetic_friction: contact.kinetic.map(Number::new),
            command: command_along(CommandAxes::Frame),
            command_world: command_along(CommandAxes::World),
            pressed_with: contact.press,
            force: contact.force,
            clearance: said(contact.clearance).then_some(contact.clearance),
            hold: contact.hold,
            soft: self.soft.clone(),
            suction: match &self.cup {
                Some(cup) => Some(WrittenSuction::Cup(cup.clone())),
                None => said(contact.suction).then_some(WrittenSuction::Force(contact.suction)),
            },
            surface: self.surface.clone(),
            moved_by: match &self.moved_by {
                MovedBy::LastLink => None,
                MovedBy::Link(joints) => Some(WrittenMover::Link(*joints)),
                MovedBy::Jacobian(matrix) => Some(WrittenMover::Jacobian(Rows::of(matrix))),
            },
        }
        .serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for Fingertip<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a contact", |written: Written<C>| {
            if written.moved_by.is_some() {
                return Err("moved_by: of the contacts of a finger alone".to_owned());
            }
            let stiffness = written.stiffness()?;
            let entry = Self::of_written(written, stiffness.unwrap_or_default())?;
            let entry = if stiffness.is_some() { entry } else { entry.without_stiffness() };
            entry.checked(true)
        })
    }
}

/// A contact of a finger. It may name the joints of the finger that move it. A contact without a stiffness is allowed here, since the compliance
/// matrix of the finger may replace the springs of its contacts.
pub(super) struct LinkedContact<const C: usize>(pub(super) Fingertip<C>);

impl<'de, const C: usize> Deserialize<'de> for LinkedContact<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a contact", |written: Written<C>| {
            let given = written.stiffness()?;
            let stiffness = given.unwrap_or(Stiffness::Series(SVector::repeat(f64::INFINITY)));
            Fingertip::of_written(written, stiffness)?.checked(given.is_some()).map(Self)
        })
    }
}

impl<const C: usize> Fingertip<C> {
    fn of_written(written: Written<C>, stiffness: Stiffness<C>) -> Result<Self, String> {
        let (point, normal) = written.place()?;
        let mut contact = Contact::new(point, normal);
        contact.space = space_of_text::<C>();
        contact.name = written.name;
        (contact.on, contact.against) = (written.on, written.against);
        contact.tangent = written.tangent.map(|row| row.0);
        contact.stiffness = stiffness;
        contact.friction = written.friction.map_or(0.0, |mu| mu.0);
        contact.kinetic = written.kinetic_friction.map(|mu| mu.0);
        contact = match (written.command, written.command_world) {
            (Some(u), None) => contact.command(u.0),
            (None, Some(u)) => contact.command_world(u.0),
            (None, None) => contact,
            (Some(_), Some(_)) => {
                return Err("command and command_world: a contact has one of them".to_owned());
            }
        };
        let pressed = [("pressed_with", written.pressed_with), ("force", written.force)];
        if let Some((field, _)) = pressed.iter().find(|(_, given)| given.is_some())
            && contact.command_axes == CommandAxes::Frame
            && contact.command[0] != 0.0
        {
            let name = named(contact.name.as_deref());
            return Err(format!(
                "{name}{field} is given, must be left out beside a command with a normal part: both say how the finger presses"
            ));
        }
        contact = match (written.pressed_with, written.force) {
            (Some(_), Some(_)) => {
                return Err("pressed_with and force: a finger holds a position or a force, give one of them"
                    .to_owned());
            }
            (Some(press), None) => contact.pressed_with(press),
            (None, Some(force)) => contact.force(force),
            (None, None) => contact,
        };
        contact.clearance = written.clearance.unwrap_or(0.0);
        contact.hold = written.hold;
        let cup = match written.suction {
            None => None,
            Some(WrittenSuction::Force(force)) => {
                contact.suction = force;
                None
            }
            Some(WrittenSuction::Cup(_)) if written.soft.is_some() => {
                let name = named(contact.name.as_deref());
                return Err(format!("{name}soft and suction: a cup has a lip of its own, give one of them"));
            }
            Some(WrittenSuction::Cup(cup)) => Some(cup),
        };
        let moved_by = match written.moved_by {
            None => MovedBy::LastLink,
            Some(WrittenMover::Link(joints)) => MovedBy::Link(joints),
            Some(WrittenMover::Jacobian(rows)) => MovedBy::Jacobian(rows.matrix("jacobian")?),
        };
        let (soft, surface, comment) = (written.soft, written.surface, written.comment);
        Ok(Self {
            contact,
            soft,
            cup,
            #[cfg(feature = "mesh")]
            touches: written.touches,
            surface,
            no_stiffness: false,
            comment,
            moved_by,
        })
    }

    /// Refuses data that no grasp accepts. The stiffness is checked only if `springs` is true, since the compliance of a finger may replace it.
    fn checked(self, springs: bool) -> Result<Self, String> {
        let contact = &self.contact;
        // The index of the contact in its list is unknown here; the message therefore has the name alone.
        let fault = |error| match error {
            Error::Contact { contact: ContactLabel { name, .. }, field, value, allowed } => {
                format!("{}{field} {} {value}, must be {allowed}", named(name.as_deref()), field.is())
            }
            other => format!("{}{other}", named(contact.name.as_deref())),
        };
        if springs {
            contact.check(0).map_err(fault)?;
        }
        contact.frame(0).map_err(fault)?;
        inside(&self).patch().map_err(fault)?;
        #[cfg(feature = "mesh")]
        self.touches.as_ref().map(super::part::PadTouch::pad).transpose().map_err(fault)?;
        Ok(self)
    }
}

/// The beginning of a message about a contact: its name, if it has one.
fn named(name: Option<&str>) -> String {
    name.map_or(String::new(), |name| format!("{name}: "))
}

impl<const C: usize> Written<C> {
    /// The point and the normal. For a contact that touches the part, the middle of its pad before it closes, and the closing direction.
    fn place(&self) -> Result<(SVector<f64, C>, SVector<f64, C>), String> {
        #[cfg(feature = "mesh")]
        if let Some(touches) = &self.touches {
            let others = [
                ("point", self.point.is_some()),
                ("normal", self.normal.is_some()),
                ("soft", self.soft.is_some()),
                ("surface", self.surface.is_some()),
            ];
            if let Some((field, _)) = others.iter().find(|(_, given)| *given) {
                return Err(format!("{field} and touches: a pad finds its points itself, give one of them"));
            }
            if matches!(self.suction, Some(WrittenSuction::Cup(_))) {
                return Err("suction and touches: a cup has a lip of its own, give one of them".to_owned());
            }
            let of_axes = |given: [f64; 3]| SVector::from_fn(|a, _| given[a]);
            return Ok((of_axes(touches.from), of_axes(touches.closing)));
        }
        let missing = |field: &str| format!("missing field `{field}`");
        let point = self.point.as_ref().ok_or_else(|| missing("point"))?;
        let normal = self.normal.as_ref().ok_or_else(|| missing("normal"))?;
        Ok((point.0, normal.0))
    }

    /// The stiffness of the contact; `None` if none is given.
    fn stiffness(&self) -> Result<Option<Stiffness<C>>, String> {
        #[cfg(feature = "mesh")]
        if let Some(touches) = &self.touches
            && touches.layer.is_some()
        {
            let given = [
                ("finger_stiffness", self.finger_stiffness.is_some()),
                ("series_stiffness", self.series_stiffness.is_some()),
            ];
            if let Some((field, _)) = given.iter().find(|(_, given)| *given) {
                return Err(format!(
                    "{field} and layer: both are the springs of the finger, give one of them"
                ));
            }
            let [normal, tangential] =
                touches.pad().map_err(|error| error.to_string())?.stiffness().unwrap_or_default();
            let finger = SVector::from_fn(|a, _| if a == 0 { normal } else { tangential });
            let body = self.body_stiffness.as_ref().map_or(SVector::repeat(f64::INFINITY), |k| k.0);
            return Ok(Some(Stiffness::BodyAndFinger { body, finger }));
        }
        let axes = |side: &Option<Springs<C>>| side.as_ref().map_or(SVector::repeat(f64::INFINITY), |k| k.0);
        match (&self.body_stiffness, &self.finger_stiffness, &self.series_stiffness) {
            (None, None, None) => Ok(None),
            (None, None, Some(k)) => Ok(Some(Stiffness::Series(k.0))),
            (body, finger, None) => {
                Ok(Some(Stiffness::BodyAndFinger { body: axes(body), finger: axes(finger) }))
            }
            _ => Err(
                "series_stiffness is body and finger together: give it, or body_stiffness and finger_stiffness"
                    .to_owned(),
            ),
        }
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Contact", Fingertip<C>, Written<C>, C);
#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Contact", LinkedContact<C>, Written<C>, C);
