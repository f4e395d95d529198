//! Elements and attributes of a URDF, read from its XML.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use roxmltree::Node;

use super::described::fault;
use crate::error::Error;

/// The fault of an element, after the kind and the name of the nearest element around it that has a name.
pub(super) fn at(element: Node, said: &str) -> Error {
    let named = |around: Node| Some(format!("{} {}: ", around.tag_name().name(), around.attribute("name")?));
    let place = element.ancestors().find_map(named).unwrap_or_default();
    fault(format!("{place}{} {said}", element.tag_name().name()))
}

/// The elements with this name in an element, in file order.
pub(super) fn children<'a>(element: Node<'a, 'a>, name: &str) -> Vec<Node<'a, 'a>> {
    element.children().filter(|child| child.has_tag_name(name)).collect()
}

pub(super) fn child<'a>(element: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    element.children().find(|child| child.has_tag_name(name))
}

/// An attribute that the element must have.
pub(super) fn word<'a>(element: Node<'a, 'a>, name: &str) -> Result<&'a str, Error> {
    element.attribute(name).ok_or_else(|| at(element, &format!("has no {name}")))
}

/// Numbers of an attribute that may be left out.
pub(super) fn numbers<const N: usize>(element: Node, name: &str) -> Result<Option<[f64; N]>, Error> {
    let Some(text) = element.attribute(name) else { return Ok(None) };
    let read: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse).collect();
    let read = read.ok().and_then(|numbers| numbers.try_into().ok());
    let allowed = || if N == 1 { "a number".to_owned() } else { format!("{N} numbers") };
    read.map(Some).ok_or_else(|| at(element, &format!("has {name} \"{text}\", must be {}", allowed())))
}

/// Numbers of an attribute that the element must have.
pub(super) fn sizes<const N: usize>(element: Node, name: &str) -> Result<[f64; N], Error> {
    word(element, name)?;
    Ok(numbers(element, name)?.unwrap_or([0.0; N]))
}

/// A number of an element, or its default value.
pub(super) fn number(element: Option<Node>, name: &str, otherwise: f64) -> Result<f64, Error> {
    let read = element.map_or(Ok(None), |element| numbers(element, name))?;
    Ok(read.map_or(otherwise, |[number]| number))
}

/// Major and minor version of the format.
pub(super) fn version(element: Node) -> [u32; 2] {
    let given = element.document().root_element().attribute("version");
    let numbers = given.and_then(|version| version.trim().split_once('.'));
    let read = numbers.and_then(|(major, minor)| Some([major.parse().ok()?, minor.parse().ok()?]));
    read.unwrap_or([1, 0])
}

/// Pose of an element in the frame of its parent, from its origin.
pub(super) fn place(element: Node) -> Result<Isometry3<f64>, Error> {
    let Some(origin) = child(element, "origin") else { return Ok(Isometry3::identity()) };
    let at_point = numbers(origin, "xyz")?.unwrap_or([0.0; 3]);
    let angles = numbers(origin, "rpy")?;
    let quaternion = if version(element) < [1, 1] { None } else { numbers(origin, "quat_xyzw")? };
    let turned = match (angles, quaternion) {
        (Some(_), Some(_)) => return Err(at(origin, "has rpy and quat_xyzw, must have one of them")),
        (None, Some([x, y, z, w])) => {
            UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 0.0).unwrap_or_default()
        }
        _ => {
            let [roll, pitch, yaw] = angles.unwrap_or([0.0; 3]);
            UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        }
    };
    Ok(Isometry3::from_parts(Translation3::from(at_point), turned))
}
