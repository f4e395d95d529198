//! Collision shapes of links, converted to triangle meshes that can touch a part (the mesh of an object to be held).

use core::f64::consts::{PI, TAU};
use std::path::Path;

use nalgebra::{Isometry3, Point3};
use roxmltree::Node;

use super::described::{Robot, fault};
use super::urdf::{at, child, numbers, place, sizes, word};
use crate::error::Error;
use crate::touch::{Part, Unit};

/// Number of sides of a cylinder, and of meridians of a sphere. The faces of a cylinder deviate from it by 1 - cos(π/360) = 4e-5 of the radius.
const SIDES: usize = 360;
/// Number of rings of faces of a sphere from pole to pole. Along a meridian the faces deviate from the sphere by 1 - cos(π/180) = 1.5e-4 of the
/// radius.
const BANDS: usize = 90;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    /// Pose of the shape in the frame of the link.
    origin: Isometry3<f64>,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    Box([f64; 3]),
    /// Radius and length of the cylinder, m.
    Cylinder([f64; 2]),
    /// Radius, and length of the cylinder between the two hemispheres, m; zero for a sphere.
    Capsule([f64; 2]),
    Mesh {
        filename: String,
        scale: [f64; 3],
    },
}

/// Vertices and triangles of a surface.
#[derive(Default)]
struct Faces {
    corners: Vec<[f64; 3]>,
    faces: Vec<[usize; 3]>,
}

impl Shape {
    /// The shape of a collision element.
    pub(super) fn read(collision: Node) -> Result<Self, Error> {
        let shape = child(collision, "geometry").and_then(|geometry| geometry.first_element_child());
        let shape = shape.ok_or_else(|| at(collision, "has no geometry"))?;
        let size = |name| sizes(shape, name).map(|[size]| size);
        let form = match shape.tag_name().name() {
            "box" => Form::Box(sizes(shape, "size")?),
            "cylinder" => Form::Cylinder([size("radius")?, size("length")?]),
            "capsule" => Form::Capsule([size("radius")?, size("length")?]),
            "sphere" => Form::Capsule([size("radius")?, 0.0]),
            "mesh" => Form::Mesh {
                filename: word(shape, "filename")?.to_owned(),
                scale: numbers(shape, "scale")?.unwrap_or([1.0; 3]),
            },
            _ => return Err(at(shape, "is no shape, must be box, cylinder, capsule, sphere or mesh")),
        };
        Ok(Self { origin: place(collision)?, form })
    }
}

impl Robot {
    /// The surface of all collision shapes of a link, in the frame of the link; [`Pad::of_surface`](crate::touch::Pad::of_surface) makes a jaw
    /// of it. Meshes in STL or OBJ are read at this call. `package://name/` is searched in the folder of the description file and in its parent
    /// folders.
    ///
    /// # Errors
    /// [`Error::Robot`] for a link that is unknown or has no collision shape, and for a mesh that is not found; [`Error::Mesh`] if a mesh cannot
    /// be read.
    pub fn surface(&self, link: &str) -> Result<Part, Error> {
        let shapes = &self.shapes[self.link(link)?];
        if shapes.is_empty() {
            return Err(fault(format!("link {link}: has no collision shape, must have one to touch")));
        }
        let mut all = Faces::default();
        for shape in shapes {
            let of_one = self.faces_of(link, &shape.form)?;
            let first = all.corners.len();
            let placed =
                |corner: &[f64; 3]| -> [f64; 3] { (shape.origin * Point3::from(*corner)).coords.into() };
            all.corners.extend(of_one.corners.iter().map(placed));
            all.faces.extend(of_one.faces.iter().map(|face| face.map(|corner| first + corner)));
        }
        Part::new(&all.corners, &all.faces)
    }

    fn faces_of(&self, link: &str, form: &Form) -> Result<Faces, Error> {
        Ok(match form {
            Form::Box(size) => cuboid(*size),
            Form::Cylinder([radius, length]) => {
                let end = 0.5 * length;
                revolved(&[(0.0, -end), (*radius, -end), (*radius, end), (0.0, end)])
            }
            Form::Capsule([radius, length]) => revolved(&arc(*radius, *length)),
            Form::Mesh { filename, scale } => {
                let part = Part::read(self.found(link, filename)?, Unit::Metre)?;
                let mut faces = Faces::default();
                for triangle in part.corners() {
                    let first = faces.corners.len();
                    faces
                        .corners
                        .extend(triangle.map(|corner| core::array::from_fn(|a| scale[a] * corner[a])));
                    faces.faces.push([first, first + 1, first + 2]);
                }
                faces
            }
        })
    }

    /// Path of a mesh file that a link names: the first file found in the folder of the description file and, for a `package://` name, in the folders
    /// above it.
    fn found(&self, link: &str, filename: &str) -> Result<std::path::PathBuf, Error> {
        let name = filename.trim_start_matches("file://");
        let (name, package) = match name.strip_prefix("package://") {
            Some(within) => (within, within.split_once('/').map_or("", |(_, inside)| inside)),
            None => (name, name),
        };
        for folder in self.folder.ancestors() {
            for path in [folder.join(name), folder.join(package)] {
                if path.is_file() {
                    return Ok(path);
                }
            }
            if !filename.starts_with("package://") {
                break;
            }
        }
        Err(fault(format!("link {link}: mesh {filename} is not found from {}", Path::display(&self.folder))))
    }
}

/// A box centred at the origin.
fn cuboid(size: [f64; 3]) -> Faces {
    let sign = |bit: usize, corner: usize| if corner >> bit & 1 == 1 { 0.5 } else { -0.5 };
    let corners = (0..8).map(|corner| core::array::from_fn(|a| size[a] * sign(a, corner))).collect();
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = sides.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    Faces { corners, faces }
}

/// Half section of a sphere, or of a capsule with a cylinder of this length: radii and heights from pole to pole.
fn arc(radius: f64, length: f64) -> Vec<(f64, f64)> {
    let at = |k: usize| {
        let (sin, cos) = (PI * k as f64 / BANDS as f64).sin_cos();
        (radius * sin, -radius * cos + if 2 * k < BANDS { -0.5 } else { 0.5 } * length)
    };
    let mut section: Vec<_> = (0..=BANDS).map(at).collect();
    // The lower hemisphere ends at the start of the cylinder.
    section.insert(BANDS / 2, (radius, -0.5 * length));
    section
}

/// The surface of revolution about z with this half section: radii and heights, from bottom to top.
fn revolved(section: &[(f64, f64)]) -> Faces {
    let mut faces = Faces::default();
    for (radius, height) in section {
        for side in 0..SIDES {
            let (sin, cos) = (TAU * side as f64 / SIDES as f64).sin_cos();
            faces.corners.push([radius * cos, radius * sin, *height]);
        }
    }
    for ring in 1..section.len() {
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            let [a, b, c, d] = [(ring - 1, side), (ring - 1, next), (ring, next), (ring, side)]
                .map(|(ring, side)| ring * SIDES + side);
            faces.faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    faces
}
