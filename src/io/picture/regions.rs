//! The region of a triangle mesh where a function is at least some level, as one area.
//!
//! The function is linear on each triangle, so that its part above the level is a polygon. Edges that two of these polygons share cancel. The other
//! edges surround the whole region, which is drawn as one area and has no visible seams.

use std::collections::BTreeMap;

use super::sheet::{Pixel, Place, pixel};

/// A corner of a triangle: its place, and the value of the function there.
pub(super) type Corner = (Place, f64);

/// The closed lines around `{f >= level}`.
pub(super) fn outlines(triangles: &[[Corner; 3]], level: f64) -> Vec<Vec<Pixel>> {
    // For each edge, the number of polygons that traverse it forwards minus the number that traverse it backwards.
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
    // At every corner as many edges end as begin, so that following edges always leads back to the start.
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

/// The part of a triangle in which the function is at least `level`, as corners in order.
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

/// The point on an edge at which the function equals `level`, bit for bit the same for both triangles at the edge.
fn cut(a: &Corner, b: &Corner, level: f64) -> Place {
    let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
    let part = (level - low.1) / (high.1 - low.1);
    (low.0.0 + part * (high.0.0 - low.0.0), low.0.1 + part * (high.0.1 - low.0.1))
}
