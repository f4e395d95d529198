//! Where a function on a net of triangles is at least some level, as one area.
//!
//! Linear on each triangle, the function cuts a piece off each. Edges that two pieces share cancel,
//! so that what is left runs around the whole region and no renderer shows seams.

use std::collections::BTreeMap;

use super::sheet::{Pixel, Place, pixel};

/// A corner of a triangle: where it is, and the function there.
pub(super) type Corner = (Place, f64);

/// The closed lines around `{f >= level}`.
pub(super) fn outlines(triangles: &[[Corner; 3]], level: f64) -> Vec<Vec<Pixel>> {
    // How often an edge is gone in its direction, less how often against it.
    let mut edges: BTreeMap<(Pixel, Pixel), i32> = BTreeMap::new();
    for triangle in triangles {
        let piece = above(triangle, level);
        for (k, &from) in piece.iter().enumerate() {
            let to = piece[(k + 1) % piece.len()];
            if from < to {
                *edges.entry((from, to)).or_default() += 1;
            } else if to < from {
                *edges.entry((to, from)).or_default() -= 1;
            }
        }
    }
    let mut onward: BTreeMap<Pixel, Vec<Pixel>> = BTreeMap::new();
    for ((a, b), count) in edges {
        let (from, to) = if count > 0 { (a, b) } else { (b, a) };
        for _ in 0..count.abs() {
            onward.entry(from).or_default().push(to);
        }
    }
    // As many edges end at a corner as begin there: every walk comes back to where it began.
    let mut loops = Vec::new();
    while let Some((&start, _)) = onward.iter().next() {
        let mut line = vec![start];
        let mut here = start;
        while let Some(ends) = onward.get_mut(&here) {
            let next = ends.pop();
            if ends.is_empty() {
                onward.remove(&here);
            }
            let Some(next) = next else { break };
            line.push(next);
            here = next;
            if here == start {
                break;
            }
        }
        loops.push(line);
    }
    loops
}

/// The part of a triangle in which the function is at least `level`, its corners in their order.
fn above(triangle: &[Corner; 3], level: f64) -> Vec<Pixel> {
    let mut piece = Vec::with_capacity(4);
    for (k, corner) in triangle.iter().enumerate() {
        let next = &triangle[(k + 1) % 3];
        if corner.1 >= level {
            piece.push(pixel(corner.0));
        }
        if (corner.1 >= level) != (next.1 >= level) {
            piece.push(pixel(cut(corner, next, level)));
        }
    }
    piece
}

/// Where the function has the level on an edge; the same bits from either side.
fn cut(a: &Corner, b: &Corner, level: f64) -> Place {
    let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
    let part = (level - low.1) / (high.1 - low.1);
    (low.0.0 + part * (high.0.0 - low.0.0), low.0.1 + part * (high.0.1 - low.0.1))
}
