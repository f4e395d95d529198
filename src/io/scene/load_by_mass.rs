//! A load that is given by its mass: a body that an arm carries, `{"mass": 0.5, "at": [0.5, 0], "turning": {"velocity_deg": 90}}`.

use super::wrench::vector_of_field;
use crate::grasp::{ArmMotion, Payload, Space, Wrench};
use crate::numerics::Each;
use crate::serial::{Given, Number, ShortList};

/// The end of the message about a field `accelerated` without a `mass`. It also says in which scenes the mass may be left out.
pub(super) const ALONE: &str = "needs a `mass` beside it; without one it is that of all bodies by their own masses, in a scene with \"gravity\" and \"shared_by_mass\": true";

/// The rotation of the arm: its axis, its angular velocity and its angular acceleration.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct WrittenTurning {
    /// A point on the axis of rotation, m; the origin if left out.
    about: Option<ShortList<Given, 3>>,
    /// The angular velocity, degrees a second: one number in the plane, three along the axis in space.
    velocity_deg: Option<ShortList<Given, 3>>,
    /// The angular velocity in rad/s, instead of `velocity_deg`.
    velocity_rad: Option<ShortList<Given, 3>>,
    /// The angular acceleration, degrees a second squared.
    acceleration_deg: Option<ShortList<Given, 3>>,
    /// The angular acceleration in rad/s², instead of `acceleration_deg`.
    acceleration_rad: Option<ShortList<Given, 3>>,
}

/// Fields of a wrench that describe a carried body.
pub(super) struct WrittenMass<'w> {
    pub(super) mass: Option<&'w Number<Given>>,
    pub(super) at: Option<&'w ShortList<Given, 3>>,
    pub(super) inertia: Option<&'w ShortList<Given, 3>>,
    pub(super) gravity: Option<&'w ShortList<Given, 3>>,
    pub(super) accelerated: Option<&'w ShortList<Given, 3>>,
    pub(super) turning: Option<&'w WrittenTurning>,
}

impl WrittenMass<'_> {
    /// The load of the carried body on the grasp, i.e. its weight and inertial force, in the plane or in space; `None` if no mass is given.
    pub(super) fn load_in(&self, space: Space) -> Result<Option<Wrench<3>>, String> {
        let Some(mass) = self.mass else {
            let others = [
                ("inertia", self.inertia.is_some()),
                ("gravity", self.gravity.is_some()),
                ("accelerated", self.accelerated.is_some()),
                ("turning", self.turning.is_some()),
            ];
            return match others.iter().find(|(_, given)| *given) {
                Some(("accelerated", _)) => Err(format!("accelerated: {ALONE}")),
                Some((name, _)) => Err(format!("{name}: needs a `mass` beside it")),
                None => Ok(None),
            };
        };
        let along =
            |given: Option<&ShortList<Given, 3>>, name: &str| vector_of_field(given, space.axes(), name);
        // In the plane the rotation is about z, the last axis of space; its number therefore comes last.
        let planes = space.planes().len();
        let about_axes = |given: Option<&ShortList<Given, 3>>, name: &str| {
            let listed = vector_of_field(given, planes, name)?;
            let mut axes = [0.0; 3];
            axes[3 - planes..].copy_from_slice(&listed[..planes]);
            Ok::<_, String>(axes)
        };
        let mut arm = ArmMotion::<3>::still_in(space).accelerated(along(self.accelerated, "accelerated")?);
        if let Some(gravity) = self.gravity {
            arm = arm.gravity(along(Some(gravity), "gravity")?);
        }
        if let Some(turning) = self.turning {
            let rate =
                |degrees: Option<&ShortList<Given, 3>>, radians: Option<&ShortList<Given, 3>>, name: &str| {
                    let [in_degrees, in_radians] = [format!("{name}_deg"), format!("{name}_rad")];
                    match (degrees, radians) {
                        (Some(_), Some(_)) => {
                            Err(format!("{in_degrees} and {in_radians}: a turn has one of them"))
                        }
                        (Some(_), None) => Ok(about_axes(degrees, &in_degrees)?.each(f64::to_radians)),
                        (None, _) => about_axes(radians, &in_radians),
                    }
                };
            let velocity = rate(turning.velocity_deg.as_ref(), turning.velocity_rad.as_ref(), "velocity")?;
            let speeding =
                rate(turning.acceleration_deg.as_ref(), turning.acceleration_rad.as_ref(), "acceleration")?;
            arm = arm.and_turning(along(turning.about.as_ref(), "about")?, velocity, speeding);
        }
        let mut body = Payload::new(mass.0, along(self.at, "at")?);
        if let Some(inertia) = self.inertia {
            body = body.of_inertia(about_axes(Some(inertia), "inertia")?);
        }
        body.load_in(space, &arm).map(Some).map_err(|error| error.to_string())
    }
}
