//! Readers of STL, as text or binary, and of OBJ. They make a part, the mesh of an object to be held.

use std::fs;
use std::path::Path;

use super::part::Part;
use crate::error::Error;
use crate::numerics::{mapped, numbered};
use crate::words::Unit;

/// Bytes of a binary STL before its triangles: a comment of 80 bytes and the number of triangles.
const HEAD: usize = 84;
/// Bytes per triangle: its normal, three vertices, and two unused bytes.
const TRIANGLE: usize = 50;

impl Part {
    /// A part from a file that ends in `.stl` or `.obj`, with lengths in this unit.
    ///
    /// # Errors
    /// [`Error::Mesh`] if the file cannot be read or is neither STL nor OBJ, if it has no faces, or if a vertex is missing or not finite.
    pub fn read(path: impl AsRef<Path>, unit: Unit) -> Result<Self, Error> {
        let path = path.as_ref();
        let fault = |fault: String| Error::Mesh { fault: format!("{}: {fault}", path.display()) };
        let bytes = fs::read(path).map_err(|error| fault(error.to_string()))?;
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let part = match ending.as_deref() {
            Some("stl") => Self::from_stl(&bytes, unit),
            Some("obj") => Self::from_obj(&String::from_utf8_lossy(&bytes), unit),
            _ => return Err(fault("is no mesh that is read here, must end in .stl or .obj".to_owned())),
        };
        part.map_err(|error| match error {
            Error::Mesh { fault: inner } => fault(inner),
            other => other,
        })
    }

    /// A part from the bytes of an STL, binary or text, with lengths in this unit.
    ///
    /// # Errors
    /// [`Error::Mesh`] if the bytes are no STL, if there are no faces, or if a vertex is not finite.
    pub fn from_stl(bytes: &[u8], unit: Unit) -> Result<Self, Error> {
        let number = |at: usize| bytes.get(at..at + 4).and_then(|four| <[u8; 4]>::try_from(four).ok());
        let count = number(HEAD - 4).map_or(0, |four| u32::from_le_bytes(four) as usize);
        let mut corners = Vec::new();
        // Some binary files start with `solid` like text files, so the length of the file shows whether it is binary.
        if bytes.len() >= HEAD && bytes.len() - HEAD == count.saturating_mul(TRIANGLE) {
            for triangle in 0..count {
                for corner in 0..3 {
                    let at = HEAD + TRIANGLE * triangle + 12 * (corner + 1);
                    let axis =
                        |a: usize| number(at + 4 * a).map_or(f64::NAN, |x| f32::from_le_bytes(x).into());
                    corners.push([axis(0), axis(1), axis(2)]);
                }
            }
        } else {
            let text = String::from_utf8_lossy(bytes);
            if !text.trim_start().starts_with("solid") {
                return Err(fault(
                    "is no STL: it neither begins with `solid` nor has the length of a binary file",
                ));
            }
            for (index, line) in text.lines().enumerate() {
                let mut words = line.split_whitespace();
                if words.next() == Some("vertex") {
                    corners.push(three(words, index)?);
                }
            }
        }
        let faces: Vec<[usize; 3]> = numbered(corners.len() / 3, &|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        Self::of_corners(&corners, &faces, unit)
    }

    /// A part from the text of an OBJ, with lengths in this unit. Polygons are divided into triangles that share their first vertex. All objects
    /// of the file form one part.
    ///
    /// # Errors
    /// [`Error::Mesh`] if a vertex or a face cannot be read, if there are no faces, or if a vertex does not exist or is not finite.
    pub fn from_obj(text: &str, unit: Unit) -> Result<Self, Error> {
        let (mut corners, mut faces) = (Vec::new(), Vec::new());
        for (index, line) in text.lines().enumerate() {
            let mut words = line.split_whitespace();
            match words.next() {
                Some("v") => corners.push(three(words, index)?),
                Some("f") => {
                    let of_face = words.map(|word| {
                        let number = word.split('/').next().and_then(|first| first.parse::<isize>().ok());
                        // Vertices are numbered from 1. A negative number counts backwards from the latest vertex.
                        let place = number.and_then(|n| match n {
                            0 => None,
                            n if n > 0 => Some(n.unsigned_abs() - 1),
                            n => corners.len().checked_sub(n.unsigned_abs()),
                        });
                        place.ok_or_else(|| on_line(index, "face"))
                    });
                    let of_face = of_face.collect::<Result<Vec<usize>, _>>()?;
                    faces.extend(of_face.windows(2).skip(1).map(|pair| [of_face[0], pair[0], pair[1]]));
                }
                _ => {}
            }
        }
        Self::of_corners(&corners, &faces, unit)
    }

    fn of_corners(corners: &[[f64; 3]], faces: &[[usize; 3]], unit: Unit) -> Result<Self, Error> {
        let corners: Vec<_> = mapped(corners, &|corner| corner.map(|x| unit.in_metres(x)));
        Self::new(&corners, faces)
    }
}

fn three<'t>(words: impl Iterator<Item = &'t str>, index: usize) -> Result<[f64; 3], Error> {
    let numbers: Vec<f64> = words.take(3).map_while(|word| word.parse().ok()).collect();
    numbers.try_into().map_err(|_| on_line(index, "corner"))
}

fn on_line(index: usize, what: &str) -> Error {
    Error::Mesh { fault: format!("line {}: is no {what} with its numbers", index + 1) }
}

fn fault(fault: &str) -> Error {
    Error::Mesh { fault: fault.to_owned() }
}
