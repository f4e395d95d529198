//! Pads: the surface with which a finger or a jaw touches. A pad moves along its closing direction until it touches a part (the mesh of an object to
//! be held).

use core::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::part::Part;
use crate::error::{Error, LARGEST};
use crate::grasp::{Contact, Pressure, SoftFingertip};

/// A point of a surface becomes a point of the pad only if its outward unit normal has at least this component along the closing direction. Where the
/// component is smaller, the surface is nearly parallel to the closing direction and hardly presses. If this limit were larger, inclined faces that
/// press would be left out.
const TURNED_AWAY: f64 = 0.1;

/// The surface of a jaw or of a fingertip, and its elastic layer.
///
/// A contact gives its position: the centre of the pad is the contact's point, and the pad closes along the contact's normal. The first side of the
/// pad is parallel to the first tangent.
#[derive(Debug, Clone, PartialEq)]
pub struct Pad {
    pub(super) points: Vec<PadPoint>,
    outline: Outline,
    profile: Profile,
    /// Area of the pad's surface, m².
    area: f64,
    /// Normal and tangential stiffness of the layer per unit area, N/m³; `None` without a layer.
    layer: Option<[f64; 2]>,
}

/// The outline of the pad as seen along the closing direction, m.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Outline {
    Rectangle([f64; 2]),
    Disc(f64),
    /// The outline of a surface that is known only at sampled points.
    Sampled,
}

/// The height profile of the pad along its first tangent.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Profile {
    Flat,
    /// A convex cylinder of this radius, m.
    Round(f64),
    /// A V: the height grows from the middle to both sides by this slope, m of height per m of distance.
    V(f64),
}

impl Profile {
    /// Height along the closing direction, m, and its derivative, at the signed distance `u` from the middle along the first tangent, m.
    fn at(self, u: f64) -> (f64, f64) {
        match self {
            Self::Flat => (0.0, 0.0),
            Self::Round(radius) => {
                let height = (radius * radius - u * u).sqrt();
                (height - radius, -u / height)
            }
            Self::V(rise) => (rise * u.abs(), rise * u.signum()),
        }
    }
}

/// A sample point of the pad, in the frame of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PadPoint {
    /// Position relative to the centre, m; the first component is along the closing direction.
    pub(super) offset: Vector3<f64>,
    /// Outward unit normal of the pad's surface at this point.
    pub(super) facing: Vector3<f64>,
    /// Fraction of the pad's area that this point represents.
    pub(super) share: f64,
}

impl Pad {
    /// A flat rectangle with sides along the first and the second tangent, m. `strips` is the number of strips in half of each side; two points
    /// represent each strip. `[1, 1]` suffices for a flat face. A curved part needs about six points across the contact width.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the sides are from 1e-50 to 1e50, there is at least one strip along each, and there are at most
    /// [`SoftFingertip::MOST_POINTS`] points.
    pub fn rectangle(sides: [f64; 2], strips: [usize; 2]) -> Result<Self, Error> {
        Self::on_rectangle(sides, strips, Profile::Flat)
    }

    /// A flat disc of this radius, m, divided into annuli of equal width. Two rings of `points` points represent each annulus. Each point stands for
    /// a part of the disc's area, with the weights that [`SoftFingertip::disc`] has under uniform pressure.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the radius is from 1e-50 to 1e50, there is at least one annulus, each ring has at least 3 points, and there are at
    /// most [`SoftFingertip::MOST_POINTS`] points.
    pub fn disc(radius: f64, annuli: usize, points: usize) -> Result<Self, Error> {
        let patch = SoftFingertip::disc(radius, annuli, points, Pressure::Uniform)?;
        Ok(Self::of_profile(&patch, Outline::Disc(radius), Profile::Flat))
    }

    /// A round finger: part of a cylinder of this radius, m, with its axis along the second tangent. `sides` are the sides of its rectangular
    /// outline, m, as seen along the closing direction; `strips` is the number of strips in half of each side.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the sides are from 1e-50 to 1e50, there is at least one strip along each, and there are at most
    /// [`SoftFingertip::MOST_POINTS`] points. The same error if the first side is not less than the diameter.
    pub fn cylinder(radius: f64, sides: [f64; 2], strips: [usize; 2]) -> Result<Self, Error> {
        if !(sides[0] < 2.0 * radius && radius <= LARGEST) {
            let (what, allowed) = ("radius of the pad", "more than half of its first side, and at most 1e50");
            return Err(Error::Fingertip { what, value: radius, allowed });
        }
        Self::on_rectangle(sides, strips, Profile::Round(radius))
    }

    /// A V-shaped jaw with this opening angle, rad. The bottom of the V runs along the second tangent through the middle of the rectangle. `sides`
    /// are the sides of this rectangle, m, and `strips` is the number of strips in half of each side.
    ///
    /// # Errors
    /// [`Error::Fingertip`] unless the sides are from 1e-50 to 1e50, there is at least one strip along each, and there are at most
    /// [`SoftFingertip::MOST_POINTS`] points. The same error if the angle is not from 0.1 to π.
    pub fn v(opening: f64, sides: [f64; 2], strips: [usize; 2]) -> Result<Self, Error> {
        if !(0.1..=PI).contains(&opening) {
            let (what, allowed) = ("opening angle of the V", "from 0.1 to π rad");
            return Err(Error::Fingertip { what, value: opening, allowed });
        }
        Self::on_rectangle(sides, strips, Profile::V((0.5 * opening).tan().recip()))
    }

    fn on_rectangle(sides: [f64; 2], strips: [usize; 2], profile: Profile) -> Result<Self, Error> {
        Ok(Self::of_profile(&SoftFingertip::rectangle(sides, strips)?, Outline::Rectangle(sides), profile))
    }

    /// A jaw with this surface, in the frame in which the contact is given. It consists of the foremost points along the contact's normal. `sides`
    /// limits it to a rectangle about the contact's point with sides along the tangents, m. `strips` is the number of strips in half of each side;
    /// two points represent each strip. Points that miss the surface are omitted, and so are points at which the normal of the surface is nearly
    /// perpendicular to the closing direction. The position of the contact's point along the normal is ignored: the returned contact lies at the
    /// foremost point of the surface. Without `sides` it also lies in the middle of the surface across the normal.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for sides or numbers of strips out of range. [`Error::Misses`] if the surface has no point within the rectangle.
    /// [`Error::Contact`] with index 0 for a contact whose normal or tangent gives no frame.
    pub fn of_surface(
        surface: &Part,
        contact: &Contact<3>,
        sides: Option<[f64; 2]>,
        strips: [usize; 2],
    ) -> Result<(Self, Contact<3>), Error> {
        let frame = contact.frame(0)?;
        let (closing, [one, other]) = (frame.column(0), [1, 2].map(|axis| frame.column(axis).into_owned()));
        let mut contact = contact.clone();
        let [low, high] = surface.along(&frame);
        if sides.is_none() {
            contact.point = frame * (0.5 * (low + high));
        }
        let sides = sides.unwrap_or([1, 2].map(|axis| high[axis] - low[axis]));
        let flat = Self::rectangle(sides, strips)?;
        // Rays start in front of the surface, and run against the closing direction of the pad.
        let front = contact.point + closing * (high[0] + surface.size - closing.dot(&contact.point));
        let of_rays = Matrix3::from_columns(&[-closing, one, -other]);
        let hits = surface.hits_of_pad(&flat, &of_rays, &front).hits;
        let (mut points, mut stretch) = (Vec::new(), 0.0);
        for (point, hit) in flat.points.iter().zip(hits) {
            let Some(hit) = hit else { continue };
            let facing = frame.tr_mul(&-hit.normal);
            if facing[0] > TURNED_AWAY {
                let height = high[0] + surface.size - hit.depth;
                let (offset, share) =
                    (Vector3::new(height, point.offset[1], -point.offset[2]), point.share / facing[0]);
                stretch += share;
                points.push(PadPoint { offset, facing, share });
            }
        }
        let foremost = points.iter().map(|point| point.offset[0]).fold(f64::NEG_INFINITY, f64::max);
        if points.is_empty() {
            let fault = "has no surface there: no point of its shape faces the closing direction";
            return Err(Error::Misses { contact: contact.label(0), fault });
        }
        for point in &mut points {
            (point.share, point.offset[0]) = (point.share / stretch, point.offset[0] - foremost);
        }
        contact.point += closing * (foremost - closing.dot(&contact.point));
        let area = sides[0] * sides[1] * stretch;
        let (outline, profile) = (Outline::Sampled, Profile::Flat);
        Ok((Self { points, outline, profile, area, layer: None }, contact))
    }

    /// The centre of the pad in the pad's own frame, i.e. its origin; `None` for a sampled surface, whose height at the centre is not known.
    pub(super) fn middle(&self) -> Option<Vector3<f64>> {
        (self.outline != Outline::Sampled).then(Vector3::zeros)
    }

    /// A pad whose points are those of a flat patch, moved along the closing direction by the height of the profile. The share of a point is
    /// proportional to the area that it represents on the inclined surface.
    fn of_profile(patch: &SoftFingertip<3>, outline: Outline, profile: Profile) -> Self {
        let mut points = Vec::new();
        let mut stretch = 0.0;
        for (offset, share) in patch.points() {
            let (height, slope) = profile.at(offset[1]);
            let length = slope.hypot(1.0);
            let facing = Vector3::new(1.0, -slope, 0.0) / length;
            stretch += share * length;
            let offset = Vector3::new(height, offset[1], offset[2]);
            points.push(PadPoint { offset, facing, share: share * length });
        }
        for point in &mut points {
            point.share /= stretch;
        }
        let flat = match outline {
            Outline::Rectangle([one, other]) => one * other,
            Outline::Disc(radius) => PI * radius * radius,
            Outline::Sampled => 0.0,
        };
        Self { points, outline, profile, area: flat * stretch, layer: None }
    }

    /// Height of the pad's surface along the closing direction, m, at the tangential position (u, v), m; `None` outside the outline.
    pub(super) fn height_at(&self, u: f64, v: f64) -> Option<f64> {
        let covers = match self.outline {
            Outline::Rectangle([one, other]) => u.abs() <= 0.5 * one && v.abs() <= 0.5 * other,
            Outline::Disc(radius) => u.hypot(v) <= radius,
            Outline::Sampled => false,
        };
        covers.then(|| self.profile.at(u).0)
    }

    /// This pad with an elastic layer of Young's modulus E = `modulus`, Pa, and thickness t = `thickness`, m. The layer is an elastic foundation: its
    /// stiffness per unit area is `E/t` along the normal and `E/3t` along tangents, N/m³. This stiffness replaces the finger stiffness of the
    /// contact.
    #[must_use]
    pub fn of_layer(self, modulus: f64, thickness: f64) -> Self {
        let normal = modulus / thickness;
        // Rubber is nearly incompressible: its shear modulus is a third of Young's modulus.
        Self { layer: Some([normal, normal / 3.0]), ..self }
    }

    /// Area of the pad, m².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area
    }

    /// Normal and tangential stiffness of the whole layer, N/m; `None` without a layer.
    #[must_use]
    pub fn stiffness(&self) -> Option<[f64; 2]> {
        self.layer.map(|layer| layer.map(|k| k * self.area))
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points.len()
    }
}
