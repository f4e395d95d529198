//! Curves and surfaces in the text of a scene, along which contacts may move.

use serde::de::{Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::grasp::{Face, Space};
use crate::improve::{Shape, Surface};
use crate::numerics::{Each, IntoList, mapped};
use crate::serial::{AsGiven, AxisRow, Given, object, space_of_text};

/// A curve in the plane or a surface in space, all lengths in m.
#[derive(serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields, bound = "")]
enum WrittenSurface<const C: usize> {
    /// In the plane: the ends of a straight edge.
    Segment([AxisRow<Given, C>; 2]),
    /// In the plane: straight edges that join the points in order.
    Polyline(Vec<AxisRow<Given, C>>),
    /// In the plane: a circle.
    Circle {
        /// The centre of the circle, m.
        centre: AxisRow<Given, C>,
        /// The radius of the circle, m.
        #[serde(with = "AsGiven::<f64>")]
        radius: f64,
    },
    /// In the plane: part of a circle.
    Arc {
        /// The centre of the arc, m.
        centre: AxisRow<Given, C>,
        /// The radius of the arc, m.
        #[serde(with = "AsGiven::<f64>")]
        radius: f64,
        /// The angle at which the arc begins, degrees from x to y.
        #[serde(with = "AsGiven::<f64>")]
        from_deg: f64,
        /// The angle that the arc spans, degrees.
        #[serde(with = "AsGiven::<f64>")]
        over_deg: f64,
    },
    /// In the plane: a cubic spline through points.
    Spline(Vec<AxisRow<Given, C>>),
    /// In the plane: a closed cubic spline through points, from the last back to the first.
    ClosedSpline(Vec<AxisRow<Given, C>>),
    /// In space: a rectangle.
    Rectangle {
        /// One corner of the rectangle, m.
        corner: AxisRow<Given, C>,
        /// The two sides of the rectangle from this corner, at a right angle, m.
        sides: [AxisRow<Given, C>; 2],
    },
    /// In space: the curved surface of a cylinder.
    Cylinder {
        /// The two ends of the axis of the cylinder, m.
        axis: [AxisRow<Given, C>; 2],
        /// The radius of the cylinder, m.
        #[serde(with = "AsGiven::<f64>")]
        radius: f64,
    },
    /// In space: a sphere.
    Sphere {
        /// The centre of the sphere, m.
        centre: AxisRow<Given, C>,
        /// The radius of the sphere, m.
        #[serde(with = "AsGiven::<f64>")]
        radius: f64,
    },
    /// In space: triangles, each by its three corners, m.
    Triangles(Vec<[AxisRow<Given, C>; 3]>),
}

impl<const C: usize> WrittenSurface<C> {
    /// The surface; an error for a curve of the plane in a spatial scene, or a surface of space in a planar scene.
    fn surface(self) -> Result<Surface<C>, String> {
        let (name, axes) = match &self {
            Self::Segment(_) => ("segment", 2),
            Self::Polyline(_) => ("polyline", 2),
            Self::Circle { .. } => ("circle", 2),
            Self::Arc { .. } => ("arc", 2),
            Self::Spline(_) => ("spline", 2),
            Self::ClosedSpline(_) => ("closed_spline", 2),
            Self::Rectangle { .. } => ("rectangle", 3),
            Self::Cylinder { .. } => ("cylinder", 3),
            Self::Sphere { .. } => ("sphere", 3),
            Self::Triangles(_) => ("triangles", 3),
        };
        let text = space_of_text::<C>();
        if axes != text.axes() {
            let is_planar = text == Space::Planar;
            let allowed = if is_planar {
                "segment, polyline, circle, arc, spline and closed_spline"
            } else {
                "rectangle, cylinder, sphere and triangles"
            };
            let space = if is_planar { "the plane" } else { "space" };
            return Err(format!("{name} given, must be one of {allowed} in {space}"));
        }
        let points = |rows: Vec<AxisRow<Given, C>>| mapped(&rows, &|row| row.0.into_inside());
        let two = |ends: [AxisRow<Given, C>; 2]| ends.each(|row| row.0.into_inside());
        Ok(Surface::of(match self {
            Self::Segment(ends) => Shape::Segments(vec![two(ends)]),
            Self::Polyline(rows) => Shape::polyline(&points(rows)),
            Self::Circle { centre, radius } => {
                Shape::Arc { centre: centre.0.into_inside(), radius, from: 0.0, over: None }
            }
            Self::Arc { centre, radius, from_deg, over_deg } => Shape::Arc {
                centre: centre.0.into_inside(),
                radius,
                from: from_deg.to_radians(),
                over: Some(over_deg.to_radians()),
            },
            Self::Spline(rows) => Shape::spline(points(rows), false),
            Self::ClosedSpline(rows) => Shape::spline(points(rows), true),
            Self::Rectangle { corner, sides } => {
                Shape::Rectangle { corner: corner.0.into_inside(), sides: two(sides) }
            }
            Self::Cylinder { axis, radius } => Shape::Cylinder { ends: two(axis), radius },
            Self::Sphere { centre, radius } => Shape::Sphere { centre: centre.0.into_inside(), radius },
            Self::Triangles(rows) => {
                Shape::Triangles(mapped(&rows, &|corners| corners.each_ref().each(|row| row.0.into_inside())))
            }
        }))
    }

    fn of(surface: &Surface<C>) -> Self {
        let row = |inside| AxisRow::new(Face::from_inside(inside));
        match surface.shape() {
            Shape::Segments(parts) => match &parts[..] {
                [ends] => Self::Segment(ends.each(row)),
                parts => {
                    let mut rows = Vec::new();
                    for (k, ends) in parts.iter().enumerate() {
                        if k == 0 {
                            rows.push(row(ends[0]));
                        }
                        rows.push(row(ends[1]));
                    }
                    Self::Polyline(rows)
                }
            },
            Shape::Arc { centre, radius, over: None, .. } => {
                Self::Circle { centre: row(*centre), radius: *radius }
            }
            Shape::Arc { centre, radius, from, over: Some(over) } => Self::Arc {
                centre: row(*centre),
                radius: *radius,
                from_deg: from.to_degrees(),
                over_deg: over.to_degrees(),
            },
            Shape::Spline(spline) => {
                let given = spline.interpolated_points().iter().copied().map(row).list();
                if spline.is_closed() { Self::ClosedSpline(given) } else { Self::Spline(given) }
            }
            Shape::Rectangle { corner, sides } => {
                Self::Rectangle { corner: row(*corner), sides: sides.each(row) }
            }
            Shape::Cylinder { ends, radius } => Self::Cylinder { axis: ends.each(row), radius: *radius },
            Shape::Sphere { centre, radius } => Self::Sphere { centre: row(*centre), radius: *radius },
            Shape::Triangles(parts) => Self::Triangles(mapped(parts, &|corners| corners.each(row))),
        }
    }
}

impl<const C: usize> Serialize for Surface<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        WrittenSurface::of(self).serialize(serializer)
    }
}

/// The expected form of a surface, for the message about any other value.
const SURFACE_FORM: &str = "a surface with its numbers, such as {\"circle\": {\"centre\": [0, 0], \"radius\": 0.05}}, with three numbers in space";

impl<'de, const C: usize> Deserialize<'de> for Surface<C> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        object::read(deserializer, SURFACE_FORM, WrittenSurface::<C>::surface)
    }
}

#[cfg(feature = "schema")]
crate::serial::schema_as_written!("Surface", Surface<C>, WrittenSurface<C>, C);
