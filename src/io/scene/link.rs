//! A link in the text of a scene: it joins two bodies, or one body to the ground.

use std::sync::Arc;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use super::setup::Setup;
use crate::error::Error;
use crate::grasp::{Contact, Link, LinkGeometry, Space};
use crate::serial::{AsGiven, AxisRow, Given, object, space_of_text};

/// A link of a scene with its comment; see [`Link`].
///
/// ```
/// use grasp_lcp::planar::Link;
/// use grasp_lcp::scene::LinkSetup;
///
/// let written = r#"{ "name": "pin", "hinge": { "point": [0, 0.1] }, "between": ["left lever", "right lever"] }"#;
/// let pin: LinkSetup<2> = serde_json::from_str(written)?;
/// assert_eq!(pin.link, Link::hinge([0.0, 0.1]).name("pin").between("left lever", "right lever"));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LinkSetup<const C: usize> {
    /// The link between two bodies, or between a body and the ground.
    pub link: Link<C>,
    /// A comment for the reader of the file.
    pub comment: Option<String>,
}

impl<const C: usize> From<Link<C>> for LinkSetup<C> {
    fn from(link: Link<C>) -> Self {
        Self { link, comment: None }
    }
}

/// A link in the text of a scene: exactly one of hinge, ball, slide, rigid, spring and cable.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Written<const C: usize> {
    /// The name of the link in messages and answers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<Arc<str>>,
    /// A comment for the reader of the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    comment: Option<String>,
    /// A hinge: bodies turn about a point, in space about an axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    hinge: Option<Hinge<C>>,
    /// A ball joint: bodies turn about a point in any direction; in space only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    ball: Option<Point<C>>,
    /// A slide: bodies move past each other only along a direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slide: Option<Slide<C>>,
    /// A rigid link: bodies move as one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rigid: Option<Rigid<C>>,
    /// A spring that pulls and pushes along a line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spring: Option<Line<C>>,
    /// A cable that pulls along a line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cable: Option<Line<C>>,
    /// The two bodies that the link joins: a line begins on the first body and ends on the second.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    between: Option<[Arc<str>; 2]>,
    /// The body that the link joins to the ground, instead of `between`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    on: Option<Arc<str>>,
    /// Stiffness along each direction in which the link prevents relative motion, N/m; 1e9 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    stiffness: Option<f64>,
    /// The pull of a spring or cable before anything moves, N; 0 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    pretension: Option<f64>,
    /// The pull of a spring or cable without load, N, after all other springs have deflected; instead of the pretension.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    tension: Option<f64>,
    /// The length of a cable in excess of the distance between its ends, m; 0 if left out.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    slack: Option<f64>,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Hinge<const C: usize> {
    /// The point of the hinge, m.
    point: AxisRow<Given, C>,
    /// The axis of the hinge, a vector of any length; in space only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    axis: Option<AxisRow<Given, C>>,
    /// The distance between the two bearings of the hinge along its axis, m; in space only.
    #[serde(default, with = "AsGiven::<Option<f64>>", skip_serializing_if = "Option::is_none")]
    length: Option<f64>,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "BallJoint"))]
#[serde(deny_unknown_fields)]
struct Point<const C: usize> {
    /// The centre of the ball, m.
    point: AxisRow<Given, C>,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Slide<const C: usize> {
    /// The middle between the two bearings of the slide, m.
    point: AxisRow<Given, C>,
    /// The direction along which the slide is free, a vector of any length.
    direction: AxisRow<Given, C>,
    /// The distance between the two bearings of the slide, m.
    #[serde(with = "AsGiven::<f64>")]
    length: f64,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Rigid<const C: usize> {
    /// The centre of the rigid link, m.
    point: AxisRow<Given, C>,
    /// The width of the rigid link, m.
    #[serde(with = "AsGiven::<f64>")]
    size: f64,
}

#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Between"))]
#[serde(deny_unknown_fields)]
struct Line<const C: usize> {
    /// The start of the line, m: a point of the linked body, or of the first of the two linked bodies.
    from: AxisRow<Given, C>,
    /// The end of the line, m: a point of the ground, or of the second body.
    to: AxisRow<Given, C>,
}

impl<const C: usize> Serialize for LinkSetup<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { link, comment } = self;
        let row = |x: SVector<f64, C>| AxisRow::new(x);
        let line = |from, to| Some(Line { from: row(from), to: row(to) });
        let unless_zero = |x: f64| (x != 0.0).then_some(x);
        let mut written = Written {
            name: link.name.clone(),
            comment: comment.clone(),
            hinge: None,
            ball: None,
            slide: None,
            rigid: None,
            spring: None,
            cable: None,
            between: link.on.clone().zip(link.against.clone()).map(|(one, other)| [one, other]),
            on: if link.against.is_none() { link.on.clone() } else { None },
            stiffness: link.stiffness,
            pretension: if link.tension.is_some() { None } else { unless_zero(link.pretension) },
            tension: link.tension,
            slack: unless_zero(link.slack),
        };
        match link.geometry {
            LinkGeometry::Hinge { point, bearings } => {
                let (axis, length) = bearings.map(|(axis, length)| (row(axis), length)).unzip();
                written.hinge = Some(Hinge { point: row(point), axis, length });
            }
            LinkGeometry::Ball { point } => written.ball = Some(Point { point: row(point) }),
            LinkGeometry::Slide { point, direction, length } => {
                written.slide = Some(Slide { point: row(point), direction: row(direction), length });
            }
            LinkGeometry::Rigid { point, size } => written.rigid = Some(Rigid { point: row(point), size }),
            LinkGeometry::Spring { from, to } => written.spring = line(from, to),
            LinkGeometry::Cable { from, to } => written.cable = line(from, to),
        }
        written.serialize(serializer)
    }
}

impl<'de, const C: usize> Deserialize<'de> for LinkSetup<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        object::read(deserializer, "a link", |written: Written<C>| {
            let called = written.name.as_ref().map_or_else(String::new, |name| format!("{name}: "));
            Self::of_written(written).map_err(|fault| format!("{called}{fault}"))
        })
    }
}

impl<const C: usize> LinkSetup<C> {
    fn of_written(written: Written<C>) -> Result<Self, String> {
        let space = space_of_text::<C>();
        let Written { hinge, ball, slide, rigid, spring, cable, .. } = written;
        let line = |Line { from, to }: &Line<C>| (from.0, to.0);
        let mut geometries = Vec::new();
        if let Some(hinge) = hinge {
            geometries.push(hinge.geometry(space)?);
        }
        if let Some(Point { point }) = ball {
            if space == Space::Planar {
                return Err(
                    "ball: given, must be left out in the plane, where a hinge is what turns".to_owned()
                );
            }
            geometries.push(LinkGeometry::Ball { point: point.0 });
        }
        geometries.extend(slide.map(|Slide { point, direction, length }| LinkGeometry::Slide {
            point: point.0,
            direction: direction.0,
            length,
        }));
        geometries.extend(rigid.map(|Rigid { point, size }| LinkGeometry::Rigid { point: point.0, size }));
        if spring.is_some() && written.stiffness.is_none() {
            return Err("stiffness: left out, must be given of a spring, N/m".to_owned());
        }
        geometries.extend(spring.as_ref().map(line).map(|(from, to)| LinkGeometry::Spring { from, to }));
        geometries.extend(cable.as_ref().map(line).map(|(from, to)| LinkGeometry::Cable { from, to }));
        let [geometry] = geometries[..] else {
            let ball = if space == Space::Spatial { "ball, " } else { "" };
            let kinds = format!("one of hinge, {ball}slide, rigid, spring, cable");
            return Err(format!("{} kinds of link given, must be {kinds}", geometries.len()));
        };
        let mut link = Link::at(geometry);
        link.name = written.name;
        (link.on, link.against) = match (written.between, written.on) {
            (Some(_), Some(_)) => return Err("between and on: a link has one of them".to_owned()),
            (Some([one, other]), None) => (Some(one), Some(other)),
            (None, on) => (on, None),
        };
        link.stiffness = written.stiffness;
        link.pretension = written.pretension.or(written.tension).unwrap_or(0.0);
        link.tension = written.tension;
        if written.pretension.is_some() && written.tension.is_some() {
            return Err(
                "pretension and tension: before anything gives way, or at rest; give one of them".to_owned()
            );
        }
        link.slack = written.slack.unwrap_or(0.0);
        // The caller adds the name of the link to this error message.
        link.check_in(space).map_err(|error| match error {
            Error::Link { kind, field, value, allowed, .. } => {
                format!("{field} of the {kind} is {value}, must be {allowed}")
            }
            other => other.to_string(),
        })?;
        Ok(Self { link, comment: written.comment })
    }
}

impl<const C: usize> Hinge<C> {
    fn geometry(self, space: Space) -> Result<LinkGeometry<C>, String> {
        let Self { point, axis, length } = self;
        let bearings = match (space, axis, length) {
            (Space::Spatial, Some(axis), Some(length)) => Some((axis.0, length)),
            (Space::Planar, None, None) => None,
            (Space::Planar, ..) => {
                return Err("hinge: axis or length given, must be left out in the plane".to_owned());
            }
            _ => return Err("hinge: axis or length left out, must both be given in space".to_owned()),
        };
        Ok(LinkGeometry::Hinge { point: point.0, bearings })
    }
}

impl Setup<3> {
    /// The point contacts by which all links are modelled. In the grasp these contacts come after all others.
    pub(super) fn points_of_links(&self) -> Result<Vec<Contact<3>>, Error> {
        let mut points = Vec::new();
        for (number, LinkSetup { link, .. }) in self.links.iter().enumerate() {
            points.extend(link.contacts_in(self.space, &link.called(number))?);
        }
        Ok(points)
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Link", LinkSetup<C>, Written<C>, C);
