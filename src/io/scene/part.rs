//! A part as a mesh in a file, and pads that touch it in place of contact points (feature `mesh`). A pad is the surface of a finger that touches the
//! part, a rectangle or a disc. A setup is a grasp with its questions. A link is a rigid part of a robot (feature `urdf`), whose collision shapes may
//! form a pad.

use std::path::Path;
use std::sync::Arc;

use super::fingertip::Fingertip;
use super::setup::Setup;
use super::warning::Warning;
use super::written::Scene;
use crate::error::Error;
use crate::grasp::Contact;
use crate::numerics;
use crate::numerics::IntoList;
use crate::touch::{Pad, Part, Touch, Touched, Unit};

/// The grasped part, `{"mesh": "part.stl", "unit": "mm", "density": 7850}` or with `vertices` and `faces`; see [`Part`].
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PartSetup {
    /// A file that ends in `.stl` or `.obj`; a relative path counts from the folder of the scene.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub mesh: String,
    /// Corners of the mesh, in place of a file.
    #[serde(default, skip_serializing_if = "<[_]>::is_empty")]
    pub vertices: Arc<[[f64; 3]]>,
    /// The three corners of each face, by their index from 0, counterclockwise as seen from outside.
    #[serde(default, skip_serializing_if = "<[_]>::is_empty")]
    pub faces: Arc<[[usize; 3]]>,
    /// The unit of the mesh's lengths; m if left out.
    #[serde(default)]
    pub unit: Unit,
    /// The mass of the part, kg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// The density of the part, kg/m³, in place of its mass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<f64>,
    /// The mesh, once its file is read.
    #[serde(skip)]
    pub read: Option<Arc<Part>>,
}

/// A pad that closes on the part, in place of the point and the normal of a contact; see [`Touch`]. The pad is either a rectangle or a disc.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PadTouch {
    /// Sides of the pad along the first and the second tangent, m, if it is a rectangle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rectangle: Option<[f64; 2]>,
    /// Radius of the pad, m, if it is a disc.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub disc: Option<f64>,
    /// Radius of a round finger, m: the rectangle is bent around an axis along the second tangent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub round: Option<f64>,
    /// Opening angle of a V, degrees: the rectangle is folded along the second tangent, the bottom of the V.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub v_deg: Option<f64>,
    /// Whether the pad is given by the collision shapes of the robot's link, limited to the rectangle if one is given. Only the component of `from`
    /// across the closing direction then matters.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub collision_shapes: bool,
    /// For a rectangle: the numbers of strips in half of each side of the pad, with two points each; 2 and 2 if left out (4 and 4 with
    /// `collision_shapes`). For a disc: the numbers of rings, and of points on each ring; 2 and 8 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strips: Option<[usize; 2]>,
    /// The middle of the pad before it closes, m.
    pub from: [f64; 3],
    /// The direction in which the pad closes, of any length.
    pub closing: [f64; 3],
    /// The soft elastic layer that covers the pad, in place of a finger stiffness of the contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layer: Option<PadLayer>,
    /// The grasped part, once its mesh is read.
    #[serde(skip)]
    pub part: Option<Arc<Part>>,
    /// The pad that follows from the collision shapes, once the robot is read.
    #[serde(skip)]
    pub shape: Option<Arc<Pad>>,
}

/// The soft elastic layer that covers a pad and takes the place of its springs; see [`Pad::of_layer`].
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PadLayer {
    /// Young's modulus of the soft layer, Pa.
    pub modulus: f64,
    /// Thickness of the soft layer, m.
    pub thickness: f64,
}

impl PartSetup {
    /// A part whose mesh is in the file `mesh`, without mass.
    #[must_use]
    pub fn new(mesh: impl Into<String>, unit: Unit) -> Self {
        let (vertices, faces) = (Arc::new([]), Arc::new([]));
        Self { mesh: mesh.into(), vertices, faces, unit, mass: None, density: None, read: None }
    }

    /// The part, from `vertices` and `faces` or from its file; a relative path counts from `folder`.
    fn read_from(&self, folder: &Path) -> Result<Part, Error> {
        let part = if self.vertices.is_empty() {
            Part::read(folder.join(&self.mesh), self.unit)?
        } else {
            let corner = |corner: &[f64; 3]| corner.map(|x| self.unit.in_metres(x));
            Part::new(&self.vertices.iter().map(corner).list(), &self.faces)?
        };
        match (self.mass, self.density) {
            (Some(mass), _) => part.of_mass(mass),
            (None, Some(density)) => part.of_density(density),
            (None, None) => Ok(part),
        }
    }
}

impl PadTouch {
    /// A rectangular pad with these sides, m, whose middle is at `from`, m, before the pad closes along the direction `closing`.
    #[must_use]
    pub fn rectangle(sides: [f64; 2], from: [f64; 3], closing: [f64; 3]) -> Self {
        let (rectangle, disc, round, v_deg) = (Some(sides), None, None, None);
        let (strips, layer, part, shape) = (None, None, None, None);
        Self {
            rectangle,
            disc,
            round,
            v_deg,
            collision_shapes: false,
            strips,
            from,
            closing,
            layer,
            part,
            shape,
        }
    }

    /// The pad that these fields describe.
    ///
    /// # Errors
    /// [`Error::Fingertip`] for numbers out of range, and unless the shape is either a rectangle or a disc.
    pub(super) fn pad(&self) -> Result<Pad, Error> {
        let strips = self.strips.unwrap_or([2, if self.disc.is_some() { 8 } else { 2 }]);
        let has_another_shape = self.disc.or(self.round).or(self.v_deg).is_some();
        let pad = match (self.rectangle, self.disc, self.round, self.v_deg) {
            // Until the robot is read, a rectangle stands in for the collision shapes of its link.
            _ if self.collision_shapes && !has_another_shape => match &self.shape {
                Some(shape) => Pad::clone(shape),
                None => Pad::rectangle(self.rectangle.unwrap_or([1.0; 2]), strips)?,
            },
            _ if self.collision_shapes => {
                let fault =
                    "collision_shapes: with a rectangle at most, and not a disc, a round finger or a V";
                return Err(Error::Mesh { fault: fault.to_owned() });
            }
            (Some(sides), None, None, None) => Pad::rectangle(sides, strips)?,
            (Some(sides), None, Some(radius), None) => Pad::cylinder(radius, sides, strips)?,
            (Some(sides), None, None, Some(degrees)) => Pad::v(degrees.to_radians(), sides, strips)?,
            (None, Some(radius), None, None) => Pad::disc(radius, strips[0], strips[1])?,
            (rectangle, disc, ..) => {
                let value = f64::from(u8::from(rectangle.is_some()) + u8::from(disc.is_some()));
                let allowed = "1, and of a rectangle one of round and v_deg at most";
                return Err(Error::Fingertip { what: "number of shapes that touch", value, allowed });
            }
        };
        Ok(self.layer.iter().fold(pad, |pad, layer| pad.of_layer(layer.modulus, layer.thickness)))
    }

    /// The contact between the pad and the part, with the friction and springs of `contact`. Errors name the contact by `index`.
    pub(super) fn touched(&self, index: usize, contact: &Contact<3>) -> Result<Touched, Error> {
        let Some(part) = &self.part else {
            let fault =
                "the part is not read; `Scene::with_files_from` reads it from a folder, as the program does";
            return Err(Error::Mesh { fault: fault.to_owned() });
        };
        Touch::new(self.pad()?, contact.clone()).on_for_contact(index, part)
    }

    /// One contact for every point at which the pad touches the part. Errors name the contact by `index`.
    pub(super) fn points(&self, index: usize, contact: &Contact<3>) -> Result<Vec<Contact<3>>, Error> {
        Ok(self.touched(index, contact)?.into_contacts())
    }
}

impl<const C: usize> Fingertip<C> {
    /// This contact as a pad that closes on the part of the scene, in space. The position of the pad before it closes takes the place of its point,
    /// and the closing direction that of its normal.
    pub fn touching(mut self, touches: PadTouch) -> Self {
        self.contact.point = nalgebra::SVector::from_fn(|a, _| touches.from[a]);
        self.contact.normal = nalgebra::SVector::from_fn(|a, _| touches.closing[a]);
        Self { touches: Some(touches), soft: None, cup: None, ..self }
    }
}

impl<const C: usize> Setup<C> {
    /// The grasped part, if the scene has one and its mesh is read.
    #[must_use]
    pub fn part_read(&self) -> Option<&Part> {
        self.part.as_ref()?.read.as_deref()
    }
}

impl Setup<3> {
    /// This setup with `part`, whose lengths are in m, as the part that all pads touch.
    pub fn on_part(mut self, part: Arc<Part>) -> Self {
        let of_fingers = self.fingers.iter_mut().flat_map(|finger| &mut finger.contacts);
        for touches in self.contacts.iter_mut().chain(of_fingers).filter_map(|entry| entry.touches.as_mut()) {
            touches.part = Some(Arc::clone(&part));
        }
        if let Some(setup) = &mut self.part {
            setup.read = Some(part);
        }
        self
    }

    fn with_files_from(self, folder: &Path) -> Result<Self, Error> {
        #[cfg(feature = "urdf")]
        let this = self.with_robot_from(folder)?;
        #[cfg(not(feature = "urdf"))]
        let this = self;
        this.with_part_from(folder)
    }

    fn with_part_from(self, folder: &Path) -> Result<Self, Error> {
        let Some(part) = &self.part else { return Ok(self) };
        let part = Arc::new(part.read_from(folder)?);
        Ok(self.on_part(part))
    }

    /// Checks the part, and builds it if `vertices` and `faces` give it. Returns the setup, and whether the contact points of all contacts are known;
    /// those of pads are known once the part is built.
    pub(super) fn with_part_of_arrays(self) -> Result<(Self, bool), String> {
        let has_points = self.check_part()?;
        if self.part.as_ref().is_none_or(|part| part.vertices.is_empty()) {
            return Ok((self, has_points));
        }
        Ok((self.with_part_from(Path::new("")).map_err(|error| error.to_string())?, true))
    }

    /// Refuses pads without a part, a part in the plane, and a part with both mass and density, or with a mesh file and vertices. Returns whether the
    /// points of all contacts are known. The points of pads are known only once the mesh is read.
    fn check_part(&self) -> Result<bool, String> {
        let touches = self.entries().position(|entry| entry.touches.is_some());
        match (&self.part, touches) {
            (None, Some(contact)) => {
                Err(format!("contact {contact}: touches nothing, the scene has no `part`"))
            }
            (Some(_), _) if self.space == numerics::Space::Planar => {
                Err("part: a mesh belongs to a spatial scene".to_owned())
            }
            (Some(part), _) if part.mass.is_some() && part.density.is_some() => {
                Err("part: mass and density given, must be one of them".to_owned())
            }
            (Some(part), _) if part.mesh.is_empty() == part.vertices.is_empty() => {
                Err("part: must have a `mesh`, or `vertices` and `faces`".to_owned())
            }
            _ => Ok(touches.is_none()),
        }
    }

    /// Warnings about pads that touch the part with only a fraction of their area, or that lie over an edge of the part.
    pub(super) fn badly_touching(&self) -> Result<Vec<Warning>, Error> {
        let mut warnings = Vec::new();
        for (contact, entry) in self.entries().enumerate() {
            let Some(touches) = &entry.touches else { continue };
            let touched = touches.touched(contact, &entry.contact)?;
            let name = || entry.contact.label_text(contact);
            if touched.missing() > 0.0 {
                warnings.push(Warning::MissesInPart { contact, name: name(), missing: touched.missing() });
            }
            if touched.is_over_an_edge() {
                let (name, angle) = (name(), touched.steepest().to_degrees());
                warnings.push(Warning::OverAnEdge { contact, name, angle });
            }
        }
        Ok(warnings)
    }
}

impl Scene {
    /// This scene with the mesh of its part and with the fingers of its robot (feature `urdf`), both read from files. Relative paths count from
    /// `folder`, which is usually the folder of the scene's file.
    ///
    /// # Errors
    /// [`Error::Mesh`] if the mesh cannot be read or has no volume for its density. [`Error::Argument`] for a mass or density out of range, and the
    /// errors of reading a `Robot`.
    pub fn with_files_from(self, folder: impl AsRef<Path>) -> Result<Self, Error> {
        let setup = self.setup.with_files_from(folder.as_ref())?;
        Ok(Self { setup, ..self })
    }
}
