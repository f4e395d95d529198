//! The region of a triangle mesh in which a function is at least some level, as one area.
//!
//! The function is linear on each triangle. The part of a triangle on which the function is at least the level is therefore a polygon. Edges that two
//! of these polygons share cancel. The other edges surround the whole region, which is drawn as one area and has no visible seams.

use super::sheet::{PaperPoint, Pixel, pixel};

/// A corner of a triangle: its position on paper, and the value of the function there.
pub(super) type Corner = (PaperPoint, f64);

/// The closed lines around the region in which the function is at least `level`.
pub(super) fn outlines(triangles: &[[Corner; 3]], level: f64) -> Vec<Vec<Pixel>> {
    // For each edge, the number of polygons (the parts of triangles above the level) that traverse the edge forwards, minus the number that traverse
    // it backwards.
    let mut edges: Vec<(Pixel, Pixel, i32)> = Vec::new();
    for triangle in triangles {
        let piece = above(triangle, level);
        for (k, &from) in piece.iter().enumerate() {
            let to = piece[(k + 1) % piece.len()];
            if from < to {
                edges.push((from, to, 1));
            } else if to < from {
                edges.push((to, from, -1));
            }
        }
    }
    edges.sort_unstable();
    // Edges that the polygons (parts of triangles above the level) traverse more often in one direction than in the other. Each has the more frequent
    // direction. These edges surround the region.
    let mut onward: Vec<(Pixel, Pixel, i32)> = Vec::new();
    for same in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let (a, b, _) = same[0];
        let count: i32 = same.iter().map(|edge| edge.2).sum();
        for _ in 0..count.abs() {
            onward.push(if count > 0 { (a, b, 0) } else { (b, a, 0) });
        }
    }
    onward.sort_unstable();
    // At every corner as many edges end as begin. Following edges therefore always leads back to the start.
    let (mut loops, mut used, mut first) = (Vec::new(), vec![false; onward.len()], 0);
    while first < onward.len() {
        if used[first] {
            first += 1;
            continue;
        }
        let start = onward[first].0;
        let (mut line, mut here) = (vec![start], start);
        loop {
            let begin = onward.partition_point(|way| way.0 < here);
            let end = onward.partition_point(|way| way.0 <= here);
            let Some(way) = (begin..end).rev().find(|way| !used[*way]) else { break };
            used[way] = true;
            here = onward[way].1;
            line.push(here);
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
fn cut(a: &Corner, b: &Corner, level: f64) -> PaperPoint {
    let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
    let part = (level - low.1) / (high.1 - low.1);
    (low.0.0 + part * (high.0.0 - low.0.0), low.0.1 + part * (high.0.1 - low.0.1))
}
