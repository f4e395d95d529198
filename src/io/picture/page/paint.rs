//! Projection of marks (lines, arrows, cones, areas and dots of a spatial picture) onto paper.

use std::f64::consts::TAU;

use super::eye::Eye;
use super::mark::{Mark, MarkShape};
use crate::numerics::{Each, IntoList, increasing, mapped, moved, summed};
use crate::picture::layout::MARKS;
use crate::picture::painting::{EyePoint, Painting};
use crate::picture::palette::{BLACK, CONTOUR, FACE, Rgb};
use nalgebra::Vector3;

/// Projects marks onto paper, and returns the strokes to be drawn; names are left out.
pub(super) fn painting(eye: &Eye, marks: &[Mark]) -> Painting {
    let mut painting = Painting::default();
    let shade = shades(eye, marks);
    for mark in marks {
        match &mark.shape {
            MarkShape::Line { corners, ink, width, dashes } => {
                let corners: Vec<_> = mapped(corners, &|corner| eye.to_view(corner));
                let pieces = dashes.map_or_else(|| pairs(&corners), |(on, off)| dashed(&corners, on, off));
                for ends in pieces {
                    painting.line(ends, *ink, *width);
                }
            }
            MarkShape::Edge { corners } => {
                let corners: Vec<_> = mapped(corners, &|corner| eye.to_view(corner));
                for ends in pairs(&corners) {
                    painting.line(ends, shade(f64::midpoint(ends[0].z, ends[1].z)), 1.2);
                }
            }
            MarkShape::Arrow { from, along, ink, width, heads } => {
                painting.arrow([eye.to_view(from), eye.to_view(&(from + along))], *ink, *width, *heads);
            }
            MarkShape::Load { from, along, width, heads, .. } => {
                let (ends, _) = load_ends(eye, from, along);
                let long = (ends[1] - ends[0]).xy().norm();
                // In space the arrow of a load is at least 18 pixels long. If it is shorter than 8 pixels on paper, it points almost to the eye or
                // away from it. It is then drawn as seen from its end: a dot or a cross in a circle.
                if long < 8.0 {
                    painting.end_on(ends[0], ends[1].z > ends[0].z, BLACK, *width);
                } else {
                    painting.arrow(ends, BLACK, *width, *heads);
                }
            }
            MarkShape::Cone { apex, middle, radii: [a, b], ink } => {
                let sides = 72_u32;
                let rim = (0..=sides).map(|k| {
                    let (sin, cos) = (TAU * f64::from(k % sides) / f64::from(sides)).sin_cos();
                    eye.to_view(&(middle + a * cos + b * sin))
                });
                let rim: Vec<_> = rim.list();
                for ends in pairs(&rim) {
                    painting.line(ends, *ink, 1.0);
                }
                cone(&mut painting, &eye.to_view(apex), &rim[1..], *ink);
            }
            MarkShape::Dot { at, radius, ink, open } => painting.dot(eye.to_view(at), *radius, *ink, *open),
            MarkShape::Body { corners } => {
                let corners =
                    corners.iter().map(|corner| eye.to_view(corner)).map(|point| (point.x, point.y));
                let corners = hull(corners.list());
                // Bodies are behind all other marks. Faces are painted over contours. Only the outer half of a contour, outside all bodies, remains
                // visible.
                painting.contour(corners.clone(), CONTOUR, 2.4, f64::NEG_INFINITY);
                painting.area(corners, FACE.into(), f64::MIN);
            }
            MarkShape::Name { .. } => {}
        }
    }
    painting
}

/// The ends of the arrow of a load, and whether its length is to scale.
pub(super) fn load_ends(eye: &Eye, from: &Vector3<f64>, along: &Vector3<f64>) -> ([EyePoint; 2], bool) {
    let long = along.norm() * eye.scale;
    let is_to_scale = long >= MARKS.shortest_load;
    // The vector is divided by its largest component first, because the square of a tiny component underflows to zero.
    let size = along.amax();
    let unit = if size > 0.0 { (along / size).normalize() } else { *along };
    let along = if is_to_scale { *along } else { unit * (MARKS.shortest_load / eye.scale) };
    ([eye.to_view(from), eye.to_view(&(from + along))], is_to_scale)
}

/// The grey of an edge of the object as a function of its depth.
fn shades(eye: &Eye, marks: &[Mark]) -> impl Fn(f64) -> Rgb + use<> {
    let (mut far, mut near) = (f64::INFINITY, f64::NEG_INFINITY);
    for mark in marks {
        if matches!(mark.shape, MarkShape::Edge { .. }) {
            for point in mark.points() {
                let depth = eye.to_view(&point).z;
                (far, near) = (far.min(depth), near.max(depth));
            }
        }
    }
    move |depth| {
        let part = if near > far { (depth - far) / (near - far) } else { 1.0 };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a part of a byte")]
        // Edges near the eye are darker.
        let grey = (200.0 + (90.0 - 200.0) * part.clamp(0.0, 1.0)).round() as u8;
        Rgb(grey, grey, grey)
    }
}

/// Paints a cone as two faces, a near one and a far one, so that the arrow of the force is drawn between them. With more and smaller faces, seams are
/// visible.
fn cone(painting: &mut Painting, apex: &EyePoint, rim: &[EyePoint], ink: Rgb) {
    let sides = rim.len();
    let next = |k: usize| (k + 1) % sides;
    let clockwise = |k: usize| {
        let (a, b) = (rim[k] - apex, rim[next(k)] - apex);
        a.x * b.y - a.y * b.x > 0.0
    };
    let ends: Vec<usize> = (0..sides).filter(|k| clockwise(*k) != clockwise(next(*k))).map(next).list();
    let mut face = |corners: Vec<EyePoint>, depth: f64| {
        painting.area(corners.iter().map(|corner| (corner.x, corner.y)).list(), ink.mix(0.12), depth);
    };
    let depth = |part: &[EyePoint]| {
        let mean = summed(part, &|corner| corner.z) / part.len() as f64;
        (apex.z + 2.0 * mean) / 3.0
    };
    if ends.is_empty() {
        face(rim.to_vec(), depth(rim));
    }
    for (k, first) in ends.iter().enumerate() {
        let last = ends[(k + 1) % ends.len()];
        let count = (last + sides - first) % sides;
        let part: Vec<EyePoint> = (0..=count).map(|step| rim[(first + step) % sides]).list();
        let depth = depth(&part);
        face(part.into_iter().chain([*apex]).list(), depth);
    }
}

/// Corners of the convex hull of these points (Andrew's monotone chain); the first corner is repeated at the end.
pub(super) fn hull(mut places: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    // Sorts by the second coordinate, then by the first. The sort is stable: points with the same first coordinate stay sorted by the second.
    for coordinate in [|place: &(f64, f64)| place.1, |place: &(f64, f64)| place.0] {
        let values: Vec<f64> = mapped(&places, &coordinate);
        places = moved(increasing(&values), &|i| places[i]);
    }
    let mut corners: Vec<(f64, f64)> = Vec::new();
    let turns_back =
        |[a, b]: [(f64, f64); 2], c: (f64, f64)| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0) <= 0.0;
    let (there, back) = (places.iter().copied(), places.iter().rev().skip(1).copied());
    let mut first = 0;
    for way in [there.list(), back.list()] {
        for place in way {
            while corners.len() >= first + 2
                && turns_back([corners[corners.len() - 2], corners[corners.len() - 1]], place)
            {
                corners.pop();
            }
            corners.push(place);
        }
        first = corners.len().saturating_sub(1);
    }
    corners
}

fn pairs(corners: &[EyePoint]) -> Vec<[EyePoint; 2]> {
    corners.windows(2).map(|ends| [ends[0], ends[1]]).list()
}

/// Cuts a line into dashes that continue around its corners.
fn dashed(corners: &[Vector3<f64>], on: f64, off: f64) -> Vec<[EyePoint; 2]> {
    let mut dashes = Vec::new();
    // Length along the whole line, pixels.
    let mut start = 0.0;
    for ends in corners.windows(2) {
        let size = (ends[1] - ends[0]).xy().norm();
        let stop = start + size;
        let mut dash = (start / (on + off)).floor() * (on + off);
        while dash < stop {
            let (from, to) = (dash.max(start), (dash + on).min(stop));
            if from < to {
                dashes.push([from, to].each(|at| ends[0].lerp(&ends[1], (at - start) / size)));
            }
            dash += on + off;
        }
        start = stop;
    }
    dashes
}
