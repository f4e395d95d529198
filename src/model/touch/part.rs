//! A part: a triangle mesh, with its volume and mass.

use nalgebra::{Matrix3, Vector3};

use crate::error::{Error, is_moderate};

/// Vertices of a triangle, m, counterclockwise as seen from outside.
pub(super) type Corners = [Vector3<f64>; 3];

/// A surface counts as closed only if the magnitude of the sum of its area vectors is at most this fraction of the total area. The exact sum of a
/// closed surface is zero. The single precision of binary STL leaves sums about a thousand times smaller than this limit.
const OPEN: f64 = 1e-4;

/// A part whose surface is a triangle mesh, in m.
///
/// Volume and centre of mass are those of the polyhedron with constant density, in closed form. With the volume V, the centre of mass r, and the
/// vertices a, b, c of each triangle
///
/// ```text
/// V = Σ a·(b × c) / 6        V r = Σ a·(b × c) / 6 · (a + b + c) / 4
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    pub(super) triangles: Vec<Corners>,
    /// Length of the diagonal of the bounding box, m.
    pub(super) size: f64,
    bounds: [Vector3<f64>; 2],
    /// Volume, m³, and centre of mass, m; `None` for an open surface.
    solid: Option<(f64, Vector3<f64>)>,
    /// Mass, kg; `None` if neither a mass nor a density was given.
    mass: Option<f64>,
}

impl Part {
    /// A part from the vertices of a mesh, m, and the vertex indices of each face, from 0, counterclockwise as seen from outside. A closed
    /// surface whose faces are all clockwise is reversed.
    ///
    /// # Errors
    /// [`Error::Mesh`] without faces, and for a vertex that does not exist or is not finite.
    pub fn new(corners: &[[f64; 3]], faces: &[[usize; 3]]) -> Result<Self, Error> {
        let fault = |fault: String| Err(Error::Mesh { fault });
        if faces.is_empty() {
            return fault("has no faces, must have some".to_owned());
        }
        let mut triangles = Vec::with_capacity(faces.len());
        let mut bounds = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
        for (index, face) in faces.iter().enumerate() {
            let mut triangle = [Vector3::zeros(); 3];
            for (place, corner) in triangle.iter_mut().zip(face) {
                let Some(given) = corners.get(*corner) else {
                    let there = corners.len();
                    return fault(format!("face {index}: corner {corner} is not there, there are {there}"));
                };
                if !given.iter().all(|x| is_moderate(*x)) {
                    return fault(format!(
                        "corner {corner} is {given:?}, must be finite and at most 1e50 in size"
                    ));
                }
                *place = Vector3::from(*given);
                bounds = [bounds[0].inf(place), bounds[1].sup(place)];
            }
            triangles.push(triangle);
        }
        let size = (bounds[1] - bounds[0]).norm();
        let mut part = Self { triangles, size, bounds, solid: None, mass: None };
        part.solid = part.volume_and_centre();
        if part.solid.is_some_and(|(volume, _)| volume < 0.0) {
            for triangle in &mut part.triangles {
                triangle.swap(1, 2);
            }
            part.solid = part.solid.map(|(volume, centre)| (-volume, centre));
        }
        Ok(part)
    }

    /// Volume and centre of mass; `None` for an open surface. Vertices are measured from the centre of the bounding box to reduce cancellation.
    fn volume_and_centre(&self) -> Option<(f64, Vector3<f64>)> {
        let middle = (self.bounds[0] + self.bounds[1]) * 0.5;
        let (mut area, mut areas) = (Vector3::zeros(), 0.0);
        let (mut volume, mut moment) = (0.0, Vector3::zeros());
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|corner| corner - middle);
            let normal = (b - a).cross(&(c - a));
            let tetrahedron = a.dot(&b.cross(&c)) / 6.0;
            (area, areas) = (area + normal, areas + normal.norm());
            (volume, moment) = (volume + tetrahedron, moment + (a + b + c) * (0.25 * tetrahedron));
        }
        let is_closed = area.norm() <= OPEN * areas && volume != 0.0;
        is_closed.then(|| (volume, middle + moment / volume))
    }

    /// This part with a mass, kg.
    ///
    /// # Errors
    /// [`Error::Argument`] unless the mass is above 0 and at most 1e50.
    pub fn of_mass(self, mass: f64) -> Result<Self, Error> {
        check("mass of the part", mass)?;
        Ok(Self { mass: Some(mass), ..self })
    }

    /// This part with the mass of its volume at a density, kg/m³.
    ///
    /// # Errors
    /// [`Error::Argument`] unless the density is above 0 and at most 1e50; [`Error::Mesh`] for an open surface.
    pub fn of_density(self, density: f64) -> Result<Self, Error> {
        check("density of the part", density)?;
        let Some((volume, _)) = self.solid else {
            let fault = "is not closed, so that it has no volume: say its mass in place of the density";
            return Err(Error::Mesh { fault: fault.to_owned() });
        };
        self.of_mass(density * volume)
    }

    /// Volume, m³; `None` for an open surface.
    #[must_use]
    pub fn volume(&self) -> Option<f64> {
        self.solid.map(|(volume, _)| volume)
    }

    /// Centre of mass at constant density, m; `None` for an open surface.
    #[must_use]
    pub fn centre_of_mass(&self) -> Option<[f64; 3]> {
        self.solid.map(|(_, centre)| centre.into())
    }

    /// Mass, kg, if known.
    #[must_use]
    pub fn mass(&self) -> Option<f64> {
        self.mass
    }

    /// Vertices of all triangles, m.
    #[cfg(feature = "urdf")]
    pub(crate) fn corners(&self) -> impl Iterator<Item = [[f64; 3]; 3]> {
        self.triangles.iter().map(|triangle| triangle.map(Into::into))
    }

    /// Least and largest coordinates of all vertices along the columns of a frame, m.
    pub(super) fn along(&self, frame: &Matrix3<f64>) -> [Vector3<f64>; 2] {
        let mut ends = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
        for corner in self.triangles.iter().flatten() {
            let there = frame.tr_mul(corner);
            ends = [ends[0].inf(&there), ends[1].sup(&there)];
        }
        ends
    }

    /// Number of triangles.
    #[must_use]
    pub fn faces(&self) -> usize {
        self.triangles.len()
    }

    /// Bounding box along the axes: its least and its largest coordinates, m.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        self.bounds.map(Into::into)
    }
}

fn check(what: &'static str, value: f64) -> Result<(), Error> {
    if value > 0.0 && is_moderate(value) {
        return Ok(());
    }
    Err(Error::Argument { what, value, allowed: "above 0 and at most 1e50" })
}
