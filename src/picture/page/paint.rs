//! Paints marks from back to front.

use nalgebra::Vector3;
use plotters::style::{Color, RGBAColor, RGBColor, colors::WHITE};

use super::eye::Eye;
use super::marks::Mark;
use crate::picture::error::Drawn;
use crate::picture::sheet::{Place, Sheet};

/// Pixels by which a dot comes before the lines that end there, and a tenth of it the head of an
/// arrow before its line: less than anything is seen by, and far more than rounding of places on
/// paper.
const IN_FRONT: f64 = 1e-2;
/// An arrow of fewer pixels points to the eye or has no length: its direction on paper would be
/// rounding.
const SHORTEST: f64 = 1e-6;

/// Pixels to the right and downwards, and towards the eye.
type Seen = Vector3<f64>;

/// One stroke of the brush.
enum Shape {
    Line { ends: [Place; 2], ink: RGBColor, width: f64 },
    Area { corners: Vec<Place>, ink: RGBAColor },
    Dot { at: Place, ink: RGBColor, open: bool },
}

/// Strokes with how far they are towards the eye.
#[derive(Default)]
pub(super) struct Painting {
    strokes: Vec<(f64, Shape)>,
}

impl Painting {
    pub(super) fn new(eye: &Eye, marks: &[Mark]) -> Self {
        let mut painting = Self::default();
        for mark in marks {
            match mark {
                Mark::Line { corners, ink, width, dashes } => {
                    let corners: Vec<_> = corners.iter().map(|corner| eye.see(corner)).collect();
                    let pieces = dashes.map_or_else(
                        || corners.windows(2).map(|ends| [ends[0], ends[1]]).collect(),
                        |(on, off)| dashed(&corners, on, off),
                    );
                    for ends in pieces {
                        painting.line(ends, *ink, *width);
                    }
                }
                Mark::Arrow { from, along, ink, width, heads } => {
                    painting.arrow([eye.see(from), eye.see(&(from + along))], *ink, *width, *heads);
                }
                Mark::Cone { apex, rim, ink } => {
                    let rim: Vec<_> = rim.iter().map(|point| eye.see(point)).collect();
                    painting.cone(&eye.see(apex), &rim, *ink);
                }
                Mark::Dot { at, ink, open } => {
                    let seen = eye.see(at);
                    let shape = Shape::Dot { at: (seen.x, seen.y), ink: *ink, open: *open };
                    // In front of the lines that end there.
                    painting.strokes.push((seen.z + IN_FRONT, shape));
                }
                Mark::Name { .. } => {}
            }
        }
        painting.strokes.sort_by(|a, b| a.0.total_cmp(&b.0));
        painting
    }

    /// An arrow that lies on the paper.
    pub(super) fn flat_arrow(&mut self, ends: [Place; 2], ink: RGBColor, width: f64, heads: usize) {
        self.arrow(ends.map(|(x, y)| Seen::new(x, y, 0.0)), ink, width, heads);
    }

    fn line(&mut self, ends: [Seen; 2], ink: RGBColor, width: f64) {
        let depth = f64::midpoint(ends[0].z, ends[1].z);
        self.strokes.push((depth, Shape::Line { ends: ends.map(|end| (end.x, end.y)), ink, width }));
    }

    fn arrow(&mut self, [from, tip]: [Seen; 2], ink: RGBColor, width: f64, heads: usize) {
        let along = (tip - from).xy();
        let size = along.norm();
        if size < SHORTEST {
            // Towards the eye, or of no length.
            return;
        }
        let long = (4.5 * width).min(size);
        // The line ends inside the last head.
        let neck = (1.0 - 3.0 * width * heads as f64 / size).max(0.0);
        self.line([from, from.lerp(&tip, neck)], ink, width);
        let (along, across) = (along / size, 1.6 * width);
        for k in 0..heads {
            let back = (long * k as f64).min(size - long);
            let end = tip.xy() - along * back;
            let base = end - along * long;
            let (x, y) = (across * along.y, across * along.x);
            let corners = vec![(end.x, end.y), (base.x - x, base.y + y), (base.x + x, base.y - y)];
            self.strokes.push((tip.z + 0.1 * IN_FRONT, Shape::Area { corners, ink: ink.to_rgba() }));
        }
    }

    /// The side of the cone that faces the eye and the side that looks away, between which there is
    /// room for the force. Seams between smaller faces would show.
    fn cone(&mut self, apex: &Seen, rim: &[Seen], ink: RGBColor) {
        let sides = rim.len();
        let next = |k: usize| (k + 1) % sides;
        let clockwise = |k: usize| {
            let (a, b) = (rim[k] - apex, rim[next(k)] - apex);
            a.x * b.y - a.y * b.x > 0.0
        };
        let ends: Vec<usize> =
            (0..sides).filter(|k| clockwise(*k) != clockwise(next(*k))).map(next).collect();
        let mut face = |corners: Vec<Seen>, depth: f64| {
            let corners = corners.iter().map(|corner| (corner.x, corner.y)).collect();
            self.strokes.push((depth, Shape::Area { corners, ink: ink.mix(0.12) }));
        };
        let depth = |part: &[Seen]| {
            let mean = part.iter().map(|corner| corner.z).sum::<f64>() / part.len() as f64;
            (apex.z + 2.0 * mean) / 3.0
        };
        if ends.is_empty() {
            face(rim.to_vec(), depth(rim));
        }
        for (k, first) in ends.iter().enumerate() {
            let last = ends[(k + 1) % ends.len()];
            let count = (last + sides - first) % sides;
            let part: Vec<Seen> = (0..=count).map(|step| rim[(first + step) % sides]).collect();
            let depth = depth(&part);
            face(part.into_iter().chain([*apex]).collect(), depth);
        }
    }

    pub(super) fn draw(&self, paper: &Sheet) -> Drawn {
        for (_, shape) in &self.strokes {
            match shape {
                Shape::Line { ends, ink, width } => paper.line(*ends, *ink, *width)?,
                Shape::Area { corners, ink } => paper.area(corners.iter().copied(), *ink)?,
                Shape::Dot { at, ink, open } => dot(paper, *at, *ink, *open)?,
            }
        }
        Ok(())
    }

    /// Places that a name had better not cover, and how much each matters.
    pub(super) fn ink(&self) -> Vec<(Place, f64)> {
        let mut places = Vec::new();
        for (_, shape) in &self.strokes {
            match shape {
                Shape::Line { ends: [a, b], width, .. } => {
                    let size = (b.0 - a.0).hypot(b.1 - a.1);
                    let steps = (size / 3.0).ceil().max(1.0);
                    let mut k = 0.5;
                    while k < steps {
                        let part = k / steps;
                        places.push((
                            (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1)),
                            width * size / steps,
                        ));
                        k += 1.0;
                    }
                }
                Shape::Area { corners, ink } if ink.alpha() == 1.0 => {
                    places.extend(corners.iter().map(|corner| (*corner, 20.0)));
                }
                Shape::Area { .. } => {}
                Shape::Dot { at, .. } => {
                    let around = [(0.0, 0.0), (5.0, 0.0), (-5.0, 0.0), (0.0, 5.0), (0.0, -5.0)];
                    places.extend(around.map(|(x, y)| ((at.0 + x, at.1 + y), 40.0)));
                }
            }
        }
        places
    }
}

/// A contact; an open circle carries nothing.
pub(super) fn dot(paper: &Sheet, at: Place, ink: RGBColor, open: bool) -> Drawn {
    paper.circle(at, 6.5, WHITE, None)?;
    if open { paper.circle(at, 5.0, ink, Some(2.0)) } else { paper.circle(at, 5.5, ink, None) }
}

/// Cuts a line into dashes that go on round its corners.
fn dashed(corners: &[Seen], on: f64, off: f64) -> Vec<[Seen; 2]> {
    let mut dashes = Vec::new();
    // Along the whole line, pixels.
    let mut start = 0.0;
    for ends in corners.windows(2) {
        let size = (ends[1] - ends[0]).xy().norm();
        let stop = start + size;
        let mut dash = (start / (on + off)).floor() * (on + off);
        while dash < stop {
            let (from, to) = (dash.max(start), (dash + on).min(stop));
            if from < to {
                dashes.push([from, to].map(|at| ends[0].lerp(&ends[1], (at - start) / size)));
            }
            dash += on + off;
        }
        start = stop;
    }
    dashes
}
