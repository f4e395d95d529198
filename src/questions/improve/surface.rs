//! Curves and surfaces that contacts may move along in the search for better finger placement. The goal of this search is a late first slip, or a
//! large reserve of friction.

use crate::numerics::{Each, IntoList, Reals};
use nalgebra::SVector;

use super::spline::Spline;
use super::surface_location::SurfaceLocation;
use crate::error::{ContactLabel, Error, MODERATE, is_moderate};
use crate::grasp::Face;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

/// A curve in the plane or a surface in space that a contact may move along. A surface has two opposite normals. The contact takes the one that
/// points into the object, as its given normal does: the angle between them is at most 90°. [`Grasp::improve`](crate::ask::Grasp::improve) refuses an
/// invalid surface.
///
/// ```
/// use grasp_lcp::improve::Surface;
///
/// let edge = Surface::segment([-0.04, -0.02], [-0.04, 0.02]);
/// let disc = Surface::circle([0.0, 0.0], 0.05);
/// let can = Surface::cylinder([0.0, 0.0, -0.05], [0.0, 0.0, 0.05], 0.03);
/// # let _ = (edge, disc, can);
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Surface<const C: usize>(pub(super) Shape);

/// The shape of a curve or surface. All vectors have three components; in the plane the third is zero.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// Segments of a straight edge or a polyline: the two ends of each, m.
    Segments(Vec<[SVector<f64, 3>; 2]>),
    /// An arc in the plane from angle `from` counterclockwise over the angle `over`, rad; a full circle if `over` is `None`.
    Arc {
        centre: SVector<f64, 3>,
        radius: f64,
        from: f64,
        over: Option<f64>,
    },
    /// A cubic spline in the plane.
    Spline(Spline),
    /// A corner and the two sides from it as vectors, at a right angle, m.
    Rectangle {
        corner: SVector<f64, 3>,
        sides: [SVector<f64, 3>; 2],
    },
    /// The whole lateral surface of a cylinder, between the two ends of its axis, m.
    Cylinder {
        ends: [SVector<f64, 3>; 2],
        radius: f64,
    },
    Sphere {
        centre: SVector<f64, 3>,
        radius: f64,
    },
    /// Triangles: the three corners of each, m.
    Triangles(Vec<[SVector<f64, 3>; 3]>),
}

impl Surface<2> {
    /// A straight edge between two points, m.
    pub fn segment(from: impl Into<[f64; 2]>, to: impl Into<[f64; 2]>) -> Self {
        Self(Shape::Segments(vec![[in_space(from), in_space(to)]]))
    }

    /// Straight edges from point to point, m. The search for better places moves a contact from one edge to the next if that increases the value of
    /// the goal.
    pub fn polyline(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self(Shape::polyline(&points.into_iter().map(in_space).list()))
    }

    /// A circle: centre and radius, m.
    pub fn circle(centre: impl Into<[f64; 2]>, radius: f64) -> Self {
        Self(Shape::Arc { centre: in_space(centre), radius, from: 0.0, over: None })
    }

    /// Part of a circle: it begins at the angle `from`, rad, counted from x to y, and extends in this sense over the angle `over`, rad.
    pub fn arc(centre: impl Into<[f64; 2]>, radius: f64, from: f64, over: f64) -> Self {
        Self(Shape::Arc { centre: in_space(centre), radius, from, over: Some(over) })
    }

    /// A cubic spline through points, m, parametrised by the distances between them. A closed spline returns to its first point; an open spline has
    /// no curvature at its ends.
    pub fn spline(points: impl IntoIterator<Item = [f64; 2]>, closed: bool) -> Self {
        Self(Shape::spline(points.into_iter().map(in_space).list(), closed))
    }
}

/// A point of the plane as a vector of three components, the third zero.
fn in_space(point: impl Into<[f64; 2]>) -> SVector<f64, 3> {
    SVector::from(point.into()).into_inside()
}

impl Surface<3> {
    /// A plane rectangle: a corner and the two sides from this corner, at a right angle, m.
    pub fn rectangle(corner: impl Into<[f64; 3]>, sides: [[f64; 3]; 2]) -> Self {
        Self(Shape::Rectangle { corner: corner.into().into(), sides: sides.each(SVector::from) })
    }

    /// A cylinder over its whole circumference, between the ends of its axis, m.
    pub fn cylinder(from: impl Into<[f64; 3]>, to: impl Into<[f64; 3]>, radius: f64) -> Self {
        Self(Shape::Cylinder { ends: [from.into().into(), to.into().into()], radius })
    }

    /// A sphere: centre and radius, m.
    pub fn sphere(centre: impl Into<[f64; 3]>, radius: f64) -> Self {
        Self(Shape::Sphere { centre: centre.into().into(), radius })
    }

    /// Triangles, such as the triangles of a mesh, by their corners, m. Seen from outside, the corners of all triangles must follow each other in the
    /// same sense. The search for better places moves a contact from one triangle to the next if that increases the value of the goal.
    pub fn triangles(corners: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Self {
        Self(Shape::Triangles(corners.into_iter().map(|corners| corners.each(SVector::from)).list()))
    }
}

impl<const C: usize> Surface<C> {
    /// The point of the surface nearest to `point`, m, and the unit normal at this point. The sign of the normal is such that its angle to `normal`
    /// is at most 90°; the length of `normal` does not matter. A contact that may move along the surface has to be at such a point.
    ///
    /// ```
    /// use grasp_lcp::improve::Surface;
    ///
    /// let ball = Surface::sphere([0.0, 0.0, 0.0], 0.05);
    /// let (point, normal) = ball.nearest([0.0, 0.0, 0.06], [0.0, 0.0, -1.0])?;
    /// assert_eq!((point, normal), ([0.0, 0.0, 0.05], [0.0, 0.0, -1.0]));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Argument`] for an invalid surface, a coordinate that is not finite or above 1e50 m, or a normal without direction.
    pub fn nearest(
        &self,
        point: impl Into<[f64; C]>,
        normal: impl Into<[f64; C]>,
    ) -> Result<([f64; C], [f64; C]), Error> {
        let [point, normal] =
            self.0.nearest_to(point.into().into_inside().into(), normal.into().into_inside().into())?;
        Ok((Face::from_inside(point), Face::from_inside(normal)))
    }
}

/// The reason why a curve or surface is invalid: the field, its value and the allowed values.
struct NoSurface {
    field: &'static str,
    value: f64,
    allowed: &'static str,
}

impl Shape {
    pub(crate) fn polyline(points: &[SVector<f64, 3>]) -> Self {
        Self::Segments(points.windows(2).map(|ends| [ends[0], ends[1]]).list())
    }

    pub(crate) fn spline(points: Vec<SVector<f64, 3>>, closed: bool) -> Self {
        Self::Spline(Spline::through(points, closed))
    }
}

#[cfg(feature = "serde")]
impl<const C: usize> Surface<C> {
    pub(crate) fn of(shape: Shape) -> Self {
        Self(shape)
    }

    pub(crate) fn shape(&self) -> &Shape {
        &self.0
    }
}

impl Shape {
    /// The point of the surface nearest to `point`, and the normal there, in the engine's form, whose vectors have three components in the plane,
    /// too.
    fn nearest_to(&self, point: SVector<f64, 3>, normal: SVector<f64, 3>) -> Result<[[f64; 3]; 2], Error> {
        let refused = |what, value, allowed| Err(Error::Argument { what, value, allowed });
        if let Err(NoSurface { field, value, allowed }) = self.is_one() {
            return refused(field, value, allowed);
        }
        if let Some(&value) = point.as_slice().iter().find(|x| !is_moderate(**x)) {
            return refused("coordinate of the point", value, MODERATE);
        }
        let length = normal.norm();
        if !(length > 0.0 && is_moderate(length)) {
            return refused("length of the normal", length, "finite, above 0 and at most 1e50");
        }
        let location = SurfaceLocation::nearest(self, &point, &normal);
        Ok([location.point.into(), location.normal.into()])
    }

    /// The name of the kind of curve or surface, singular or plural: "edge", "edges", "circle", …
    pub(super) fn name(&self) -> &'static str {
        match self {
            Shape::Segments(parts) if parts.len() > 1 => "edges",
            Shape::Segments(_) => "edge",
            Shape::Arc { over: None, .. } => "circle",
            Shape::Arc { .. } => "arc",
            Shape::Spline(_) => "spline",
            Shape::Rectangle { .. } => "rectangle",
            Shape::Cylinder { .. } => "cylinder",
            Shape::Sphere { .. } => "sphere",
            Shape::Triangles(parts) if parts.len() > 1 => "mesh",
            Shape::Triangles(_) => "triangle",
        }
    }

    /// An error with the label of this contact if its curve or surface is invalid or has numbers that are not finite.
    pub(super) fn check(&self, contact: &ContactLabel) -> Result<(), Error> {
        self.is_one().map_err(|NoSurface { field, value, allowed }| Error::Surface {
            contact: contact.clone(),
            field,
            value,
            allowed,
        })
    }

    fn is_one(&self) -> Result<(), NoSurface> {
        let refused = |field, value, allowed| Err(NoSurface { field, value, allowed });
        let wrong = |points: &[SVector<f64, 3>]| {
            points.iter().find_map(|point| point.as_slice().iter().find(|x| !is_moderate(**x)).copied())
        };
        let size = "finite, above 0 and at most 1e50 m";
        let long = |length: f64| length > 0.0 && is_moderate(length);
        let (points, length): (Option<f64>, (&'static str, f64)) = match self {
            Shape::Segments(parts) => {
                let least = parts.iter().map(|[a, b]| (b - a).norm()).least();
                let least = if parts.is_empty() { 0.0 } else { least };
                (wrong(&parts.concat()), ("length of an edge of its surface", least))
            }
            Shape::Arc { centre, radius, from, over } => {
                let over = over.unwrap_or(1.0);
                if !(over > 0.0 && over <= core::f64::consts::TAU && is_moderate(*from)) {
                    let value = if is_moderate(*from) { over } else { *from };
                    return refused(
                        "angle of its arc",
                        value,
                        "finite, the arc above 0 and at most a full turn, rad",
                    );
                }
                (wrong(&[*centre]), ("radius of its surface", *radius))
            }
            Shape::Spline(spline) => {
                let least = spline.least_distance();
                (wrong(spline.points()), ("least distance of points of its spline", least))
            }
            Shape::Rectangle { corner, sides } => {
                let [a, b] = sides.each(|side| side.norm());
                let skew = sides[0].dot(&sides[1]) / (a * b);
                if skew.abs() > NEGLIGIBLE {
                    return refused("cosine between the sides of its rectangle", skew, "0, a right angle");
                }
                (wrong(&[*corner, sides[0], sides[1]]), ("side of its rectangle", a.min(b)))
            }
            Shape::Cylinder { ends, radius } => {
                let least = radius.min((ends[1] - ends[0]).norm());
                (wrong(ends), ("radius or length of its cylinder", least))
            }
            Shape::Sphere { centre, radius } => (wrong(&[*centre]), ("radius of its surface", *radius)),
            Shape::Triangles(parts) => {
                let height = |[a, b, c]: &[SVector<f64, 3>; 3]| {
                    let (side, other) = (b - a, c - a);
                    (other - side * (side.dot(&other) / side.norm_squared())).norm()
                };
                let least = parts.iter().map(height).least();
                let least = if parts.is_empty() { 0.0 } else { least };
                (wrong(&parts.concat()), ("height of a triangle of its surface", least))
            }
        };
        if let Some(value) = points {
            return refused("coordinate of its surface", value, crate::error::MODERATE);
        }
        if long(length.1) { Ok(()) } else { refused(length.0, length.1, size) }
    }
}
