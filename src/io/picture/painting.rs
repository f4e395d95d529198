//! Lines, arrows, areas and dots, painted from back to front. The depth of a stroke is its position towards the eye, in pixels; what is nearer to the
//! eye is painted later and covers the rest. Pictures of planar grasps lie at depth zero.

use super::palette::{Ink, Rgb, WHITE};
use std::f64::consts::{FRAC_PI_4, PI};

use super::sheet::{PaperPoint, Sheet};
use crate::numerics::{Each, IntoList, increasing, mapped};
use nalgebra::{Vector2, Vector3};

/// Depth, pixels, by which a dot lies in front of the lines that end at it. A tenth of it separates the head of an arrow from its line. This depth is
/// invisible, and far above rounding errors.
const IN_FRONT: f64 = 1e-2;
/// Length and half the width of the head of an arrow, in widths of its line.
const ARROW_HEAD: (f64, f64) = (4.5, 1.6);

/// Pixels to the right and downwards, and depth towards the eye in pixels.
pub(super) type EyePoint = Vector3<f64>;

/// The shape of one stroke of a painting: a line, an area or a dot.
enum Shape {
    Line { places: Vec<PaperPoint>, ink: Rgb, width: f64 },
    Dashes { ends: [PaperPoint; 2], ink: Rgb, width: f64 },
    Area { corners: Vec<PaperPoint>, ink: Ink },
    Dot { at: PaperPoint, radius: f64, ink: Rgb, open: bool },
}

/// Strokes with their depths, pixels; a larger depth is nearer to the eye and drawn later.
#[derive(Default)]
pub(super) struct Painting {
    strokes: Vec<(f64, Shape)>,
}

/// A point on paper with depth zero.
pub(super) fn flat((x, y): PaperPoint) -> EyePoint {
    EyePoint::new(x, y, 0.0)
}

impl Painting {
    pub(super) fn line(&mut self, ends: [EyePoint; 2], ink: Rgb, width: f64) {
        let depth = f64::midpoint(ends[0].z, ends[1].z);
        let places = mapped(&ends, &place);
        self.strokes.push((depth, Shape::Line { places, ink, width }));
    }

    /// Paints a closed line.
    pub(super) fn contour(&mut self, mut places: Vec<PaperPoint>, ink: Rgb, width: f64, depth: f64) {
        places.extend(places.first().copied());
        self.strokes.push((depth, Shape::Line { places, ink, width }));
    }

    /// Paints a dashed line just behind all strokes at depth zero, so that these strokes cover it.
    pub(super) fn dashes(&mut self, ends: [PaperPoint; 2], ink: Rgb, width: f64) {
        self.strokes.push((-IN_FRONT, Shape::Dashes { ends, ink, width }));
    }

    /// Paints a dashed line at depth zero, among the other strokes of a planar picture.
    pub(super) fn dashed_line(&mut self, ends: [PaperPoint; 2], ink: Rgb, width: f64) {
        self.strokes.push((0.0, Shape::Dashes { ends, ink, width }));
    }

    pub(super) fn area(&mut self, corners: Vec<PaperPoint>, ink: Ink, depth: f64) {
        self.strokes.push((depth, Shape::Area { corners, ink }));
    }

    /// Paints a dot in front of the lines that end at it; if `open`, a circle, which marks a contact without force.
    pub(super) fn dot(&mut self, at: EyePoint, radius: f64, ink: Rgb, open: bool) {
        self.strokes.push((at.z + IN_FRONT, Shape::Dot { at: place(&at), radius, ink, open }));
    }

    pub(super) fn arrow(&mut self, [from, tip]: [EyePoint; 2], ink: Rgb, width: f64, heads: usize) {
        let along = (tip - from).xy();
        let size = along.norm();
        // The direction of an arrow that is shorter than this on paper, pixels, consists of rounding errors.
        if size < 1e-6 {
            // The arrow points to the eye or has no length.
            return;
        }
        let long = (ARROW_HEAD.0 * width).min(size);
        // The line of the arrow ends inside its last arrowhead.
        let neck = (1.0 - 3.0 * width * heads as f64 / size).max(0.0);
        self.line([from, from.lerp(&tip, neck)], ink, width);
        let along = along / size;
        for k in 0..heads {
            let back = (long * k as f64).min(size - long);
            self.head(tip - (along * back).push(0.0), along * long, ink, width);
        }
    }

    /// Paints an arrow along the line of sight: a dot in a circle if it points to the eye, a cross in a circle otherwise.
    pub(super) fn end_on(&mut self, at: EyePoint, to_the_eye: bool, ink: Rgb, width: f64) {
        let radius = 3.0 * width;
        self.dot(at, radius, ink, true);
        if to_the_eye {
            self.dot(at + EyePoint::new(0.0, 0.0, IN_FRONT), width, ink, false);
        } else {
            let out = radius * std::f64::consts::FRAC_1_SQRT_2;
            for side in [-1.0, 1.0] {
                let arm = EyePoint::new(out, side * out, 0.0);
                let front = EyePoint::new(0.0, 0.0, 2.0 * IN_FRONT);
                self.line([at - arm + front, at + arm + front], ink, 2.0);
            }
        }
    }

    /// Paints three quarters of a circle with an arrow at its end, clockwise or counterclockwise. The open quarter is in the direction `gap`, rad,
    /// counterclockwise from the right.
    pub(super) fn arc(
        &mut self,
        middle: PaperPoint,
        radius: f64,
        gap: f64,
        clockwise: bool,
        ink: Rgb,
        width: f64,
    ) {
        let way = if clockwise { -1.0 } else { 1.0 };
        let at = |turn: f64| {
            let (sin, cos) = (gap + way * turn).sin_cos();
            (middle.0 + radius * cos, middle.1 - radius * sin)
        };
        let last = 2.0 * PI - FRAC_PI_4;
        let head = (ARROW_HEAD.0 * width).min(radius);
        let neck = last - 0.7 * head / radius;
        let pieces = 48_u32;
        let part = |k: u32| FRAC_PI_4 + (neck - FRAC_PI_4) * f64::from(k) / f64::from(pieces);
        let places = (0..=pieces).map(|k| at(part(k))).list();
        self.strokes.push((0.0, Shape::Line { places, ink, width }));
        let (tip, base) = (flat(at(last)), flat(at(last - head / radius)));
        self.head(tip, (tip - base).xy(), ink, width);
    }

    /// Paints the head of an arrow; `along` is the vector from its base to its tip, pixels.
    fn head(&mut self, tip: EyePoint, along: Vector2<f64>, ink: Rgb, width: f64) {
        let base = tip.xy() - along;
        let across = Vector2::new(-along.y, along.x).normalize() * (ARROW_HEAD.1 * width);
        let corners = mapped(&[tip.xy(), base + across, base - across], &|corner| (corner.x, corner.y));
        self.area(corners, ink.into(), tip.z + 0.1 * IN_FRONT);
    }

    pub(super) fn draw(&mut self, paper: &mut Sheet) {
        let depths: Vec<f64> = mapped(&self.strokes, &|(depth, _)| *depth);
        for i in increasing(&depths) {
            match &self.strokes[i].1 {
                Shape::Line { places, ink, width } => paper.line(places, *ink, *width),
                Shape::Dashes { ends, ink, width } => paper.dashes(ends, *ink, *width),
                Shape::Area { corners, ink } => paper.area(corners, *ink),
                Shape::Dot { at, radius, ink, open } => {
                    paper.circle(*at, radius + 1.0, WHITE, None);
                    let (radius, line) = if *open { (radius - 0.5, Some(2.0)) } else { (*radius, None) };
                    paper.circle(*at, radius, *ink, line);
                }
            }
        }
    }

    /// Points that names should not cover, each with the cost of covering it: about the covered area, in pixels².
    pub(super) fn ink(&self) -> Vec<(PaperPoint, f64)> {
        let mut inked = Vec::new();
        for (_, shape) in &self.strokes {
            match shape {
                Shape::Line { places, width, .. } => {
                    places.windows(2).for_each(|ends| along(ends[0], ends[1], *width, &mut inked));
                }
                Shape::Dashes { ends, width, .. } => along(ends[0], ends[1], *width, &mut inked),
                Shape::Area { corners, ink } if ink.opacity == 1.0 => {
                    corners.iter().map(|corner| (*corner, 20.0)).append_to(&mut inked);
                }
                // Names may cover the inside of a tinted area, such as a friction cone, but should not cover its outline.
                Shape::Area { corners, .. } => {
                    corners.windows(2).for_each(|ends| along(ends[0], ends[1], 1.0, &mut inked));
                }
                Shape::Dot { at, radius, .. } => {
                    let around = [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
                    inked.extend(around.each(|(x, y)| ((at.0 + radius * x, at.1 + radius * y), 40.0)));
                }
            }
        }
        inked
    }
}

/// Adds points about 3 pixels apart on a line. The cost of covering each is the area of the line divided by the number of points.
fn along(from: PaperPoint, to: PaperPoint, width: f64, inked: &mut Vec<(PaperPoint, f64)>) {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let size = x.hypot(y);
    let steps = (size / 3.0).ceil().clamp(1.0, 1e4);
    let mut place = 0.5;
    while place < steps {
        let part = place / steps;
        inked.push(((from.0 + part * x, from.1 + part * y), width * size / steps));
        place += 1.0;
    }
}

fn place(point: &EyePoint) -> PaperPoint {
    (point.x, point.y)
}
