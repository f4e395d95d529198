//! Wrenches and twists in the text of a scene: linear and angular part by name.
//!
//! `{"force": [0, -1], "moment": 0.2}` in the plane, `{"force": [0, 0, -1], "moment": [0, 0.1, 0]}` in space. Parts that are left out are zero.
//! `"at": [0.1, 0]` lets the force act at a point other than the origin; the moment of this force about the origin is added. If a force and a moment
//! other than zero are given without `"at"`, only the line of action of the force is known. The point on this line at which the force acts is then
//! unknown.

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::load_by_mass::{WrittenMass, WrittenTurning};
use crate::grasp::{Face, PointsOfAction, Space, Twist, Wrench};
use crate::numerics::{Vector, by_axis};
use crate::serial::{Computed, Given, Number, ShortList, object, space_of_text};

fn write<S: Serializer>(
    serializer: S,
    space: Space,
    coordinates: &Vector,
    [name, linear_name, angular_name]: [&'static str; 3],
) -> Result<S::Ok, S::Error> {
    let (linear, angular) = coordinates.as_slice()[..space.of_the_object()].split_at(space.axes());
    let mut out = serializer.serialize_struct(name, 2)?;
    out.serialize_field(linear_name, &ShortList::<Computed, 3>::of(linear))?;
    if let [moment] = angular {
        out.serialize_field(angular_name, &Number::<Computed>::new(*moment))?;
    } else {
        out.serialize_field(angular_name, &ShortList::<Computed, 3>::of(angular))?;
    }
    out.end()
}

/// The components, `expected` in number, of the vector in the field `name`; zero if it is left out.
pub(super) fn vector_of_field<K>(
    given: Option<&ShortList<K, 3>>,
    expected: usize,
    name: &str,
) -> Result<[f64; 3], String> {
    let mut part = [0.0; 3];
    if let Some(given) = given.map(ShortList::as_slice) {
        if given.len() != expected {
            let (count, space) = (given.len(), if expected == 3 { "space" } else { "the plane" });
            let numbers = if count == 1 { "number" } else { "numbers" };
            return Err(format!("{name}: {count} {numbers} given, must be {expected} in {space}"));
        }
        part[..expected].copy_from_slice(given);
    }
    Ok(part)
}

/// The linear and the angular part in one vector; `names` are the names of the parts, for messages.
fn join<K>(space: Space, parts: [Option<&ShortList<K, 3>>; 2], names: [&str; 2]) -> Result<Vector, String> {
    let (axes, turns) = (space.axes(), space.planes().len());
    let (linear, angular) =
        (vector_of_field(parts[0], axes, names[0])?, vector_of_field(parts[1], turns, names[1])?);
    let mut coordinates = Vector::zeros();
    for a in 0..axes {
        coordinates[a] = linear[a];
    }
    for k in 0..turns {
        coordinates[axes + k] = angular[k];
    }
    Ok(coordinates)
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenWrench {
    force: Option<ShortList<Given, 3>>,
    moment: Option<ShortList<Given, 3>>,
    at: Option<ShortList<Given, 3>>,
    mass: Option<Number<Given>>,
    inertia: Option<ShortList<Given, 3>>,
    gravity: Option<ShortList<Given, 3>>,
    accelerated: Option<ShortList<Given, 3>>,
    turning: Option<WrittenTurning>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenTwist {
    translation: Option<ShortList<Computed, 3>>,
    rotation: Option<ShortList<Computed, 3>>,
}

/// The expected form of a wrench, for the message about any other value.
const WRENCH_FORM: &str = "a wrench, such as {\"force\": [0, -1]}, with three numbers in space";

/// Written as `{"force": …, "moment": …}` (feature `serde`), see [`crate::scene`].
impl<const C: usize> Serialize for Wrench<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let space = space_of_text::<C>();
        write(serializer, space, &self.coordinates(space), ["Wrench", "force", "moment"])
    }
}

/// Read from `{"force": …, "moment": …, "at": …}` or with a `"mass"`, all optional (feature `serde`), see [`crate::scene`]. Refuses the numbers that
/// a grasp refuses.
impl<'de, const C: usize> Deserialize<'de> for Wrench<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, WRENCH_FORM, |written: WrittenWrench| {
            let WrittenWrench { force, moment, at, mass, inertia, gravity, accelerated, turning } = &written;
            let parts = [force.as_ref(), moment.as_ref()];
            let space = space_of_text::<C>();
            let axes = space.axes();
            let mut wrench = join(space, parts, ["force", "moment"])?;
            let mut points = None;
            if at.is_some() && force.is_none() && mass.is_none() {
                return Err(
                    "at: is given without a force or a mass, must be left out: a moment acts anywhere".into(),
                );
            }
            if at.is_some() {
                let at = vector_of_field(at.as_ref(), axes, "at")?;
                let force = |a: usize| if a < axes { wrench[a] } else { 0.0 };
                let force: SVector<f64, 3> = by_axis(force);
                points = Some(PointsOfAction::of(&force, &at.into()));
                let through = Space::Spatial.wrench_of(&at.into(), &force);
                // `through` is the wrench of the force at the point `at`. It has six components, the last three of which are moments. In the plane
                // only the very last counts, the moment about z.
                let object = space.of_the_object();
                for k in axes..object {
                    wrench[k] += through[6 + k - object];
                }
            }
            let carried = WrittenMass {
                mass: mass.as_ref(),
                at: at.as_ref(),
                inertia: inertia.as_ref(),
                gravity: gravity.as_ref(),
                accelerated: accelerated.as_ref(),
                turning: turning.as_ref(),
            };
            let mut wrench = Self::among(space, &wrench);
            if let Some(points) = points {
                wrench = wrench.acting_at(points);
            }
            // The weight and inertial force of a body that an arm carries are added only if the wrench has a `mass`. Adding a zero wrench would
            // change -0 to 0.
            Ok(carried.load_in(space)?.map_or(wrench, |pull| wrench + Self::from_inside(pull)))
        })
    }
}

/// Written as `{"translation": …, "rotation": …}` (feature `serde`), see [`crate::scene`].
impl<const C: usize> Serialize for Twist<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let space = space_of_text::<C>();
        write(serializer, space, &self.coordinates(space), ["Twist", "translation", "rotation"])
    }
}

/// Read from `{"translation": …, "rotation": …}`, both optional (feature `serde`), see [`crate::scene`].
impl<'de, const C: usize> Deserialize<'de> for Twist<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, "a twist", |WrittenTwist { translation, rotation }| {
            let parts = [translation.as_ref(), rotation.as_ref()];
            let space = space_of_text::<C>();
            join(space, parts, ["translation", "rotation"])
                .map(|coordinates| Self::among(space, &coordinates))
        })
    }
}
