//! Convex parts of the object between its outlines. Drawn as areas, they make the object look like a solid instead of a wire frame.

use super::content::MovingLine;
use crate::numerics::{IntoList, mapped};

/// Convex parts of the object: every ring, and the convex hull of two consecutive rings of at least eight corners. A ring is an outline, or a part of
/// it that returns to its start.
pub(super) fn bodies(outlines: &[MovingLine]) -> Vec<Vec<[f64; 3]>> {
    // No convex part spans two bodies.
    let of_one_body = outlines.chunk_by(|a, b| a.body == b.body);
    of_one_body.map(solids).list().concat()
}

fn solids(outlines: &[MovingLine]) -> Vec<Vec<[f64; 3]>> {
    let rings = mapped(outlines, &|outline| rings(&outline.corners)).concat();
    // A ring of fewer than eight corners may be a face of a polyhedron or the line of a handle. The space up to the next ring may then be empty. Only
    // larger rings are joined by a hull.
    let between = rings.windows(2).filter(|pair| pair.iter().all(|ring| ring.len() >= 8));
    let mut solids: Vec<_> = between.map(<[Vec<_>]>::concat).list();
    solids.extend(rings);
    solids
}

fn rings(outline: &[[f64; 3]]) -> Vec<Vec<[f64; 3]>> {
    let (mut rings, mut line): (Vec<Vec<_>>, Vec<[f64; 3]>) = (Vec::new(), Vec::new());
    for corner in outline {
        if let Some(begin) = line.iter().position(|earlier| earlier == corner) {
            rings.push(line.split_off(begin));
            line.clear();
        }
        line.push(*corner);
    }
    if rings.is_empty() {
        rings.push(line);
    }
    rings.retain(|ring| ring.len() > 2);
    rings
}
