//! What a still shows of an answer, in the coordinates of the grasp.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use plotters::style::{RGBColor, colors::BLACK};

use super::drawing::{AXIS, CONE, Drawing, FINGER, MANY, SLIP};
use crate::picture::contact_look::{ink, slope};
use crate::picture::palette::{GREY, PALETTE, VERMILION};
use crate::spatial::{Contact, ContactAnswer, ContactState, Equilibrium};

/// Displacements.
pub(super) const PINK: RGBColor = PALETTE[3];
/// Free motions.
pub(super) const SKY: RGBColor = RGBColor(58, 143, 200);
/// Slips.
pub(super) const BROWN: RGBColor = RGBColor(122, 54, 0);
const OUTLINE: RGBColor = RGBColor(153, 153, 153);
const FIXTURE: RGBColor = RGBColor(204, 204, 204);
/// Pixels drawn and left out of a line of what has moved, and of the axis of a free motion.
const MOVED: (f64, f64) = (5.0, 4.0);
const FREE: (f64, f64) = (9.0, 6.0);
/// Sides of a cone.
const SIDES: u32 = 72;
/// A cone whose rim would be wider than this part of the picture is drawn shorter, or it would hide
/// everything else.
const WIDEST: f64 = 0.5;

type Point = Vector3<f64>;

/// Widths and dashes are in pixels.
pub(super) enum Mark {
    Line { corners: Vec<Point>, ink: RGBColor, width: f64, dashes: Option<(f64, f64)> },
    Arrow { from: Point, along: Point, ink: RGBColor, width: f64, heads: usize },
    Cone { apex: Point, rim: Vec<Point>, ink: RGBColor },
    Dot { at: Point, ink: RGBColor, open: bool },
    Name { at: Point, words: String },
}

impl Mark {
    pub(super) fn points(&self) -> Vec<Point> {
        match self {
            Self::Line { corners, .. } => corners.clone(),
            Self::Arrow { from, along, .. } => vec![*from, from + along],
            Self::Cone { apex, rim, .. } => rim.iter().copied().chain([*apex]).collect(),
            Self::Dot { at, .. } | Self::Name { at, .. } => vec![*at],
        }
    }
}

/// The grasp, and in it the answer.
pub(super) fn marks(drawing: &Drawing, state: Option<&Equilibrium>) -> Vec<Mark> {
    let page = drawing.page;
    let mut marks = Vec::new();
    marks.extend(page.fixtures.iter().filter_map(|corners| closed(points(corners), FIXTURE, None)));
    for outline in &page.outlines {
        marks.extend(closed(points(outline), OUTLINE, None));
        if let Some(state) = state {
            let corners = points(outline).into_iter().map(|corner| moved(drawing, state, &corner));
            marks.extend(closed(corners.collect(), PINK, Some(MOVED)));
        }
    }
    for (i, (contact, frame)) in page.grasp.contacts().iter().zip(page.grasp.frames()).enumerate() {
        let [n, t, b] = [0, 1, 2].map(|k| Point::new(frame[(0, k)], frame[(1, k)], frame[(2, k)]));
        let at = contact.point();
        // The finger, behind the contact.
        let tail = at - n * (FINGER * drawing.span);
        marks.push(Mark::Line { corners: vec![tail, at], ink: GREY, width: 5.0, dashes: None });
        match state.map(|state| &state.contacts[i]) {
            Some(answer) => draw_answer(&mut marks, drawing, contact, [n, t, b], answer),
            None => marks.push(Mark::Dot { at, ink: GREY, open: true }),
        }
        if page.grasp.len() <= MANY {
            marks.push(Mark::Name { at, words: contact.label_text(i) });
        }
    }
    if let Some(state) = state {
        draw_load(&mut marks, drawing, state);
        for (name, at) in page.actuators.that_yield(state).filter_map(|(name, at)| Some((name, at?))) {
            marks.push(Mark::Dot { at, ink: VERMILION, open: false });
            marks.push(Mark::Name { at, words: format!("{name} yields") });
        }
        for motion in &state.free_motions {
            let axis = drawing.axis(motion);
            let half = axis.along * (AXIS * drawing.span);
            let corners = vec![axis.at - half, axis.at + half];
            marks.push(Mark::Line { corners, ink: SKY, width: 2.0, dashes: Some(FREE) });
            let words = if axis.turns { "turns freely" } else { "moves freely" };
            marks.push(Mark::Name { at: axis.at + half, words: words.into() });
        }
    }
    marks
}

fn draw_answer(
    marks: &mut Vec<Mark>,
    drawing: &Drawing,
    contact: &Contact,
    [n, t, b]: [Point; 3],
    answer: &ContactAnswer,
) {
    let (from, ink) = (contact.point(), ink(answer));
    let (high, slope) = (CONE * answer.normal_force() * drawing.force, slope(contact));
    if high > 0.0 && slope > 0.0 {
        let wide = (slope * high).min(WIDEST * drawing.size);
        let middle = from + n * (wide / slope);
        let rim = (0..SIDES).map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(SIDES)).sin_cos();
            middle + (t * cos + b * sin) * wide
        });
        let rim: Vec<_> = rim.collect();
        marks.extend(closed(rim.clone(), ink, None));
        marks.push(Mark::Cone { apex: from, rim, ink });
    }
    let mut arrow = |along: Point, ink, width| marks.push(Mark::Arrow { from, along, ink, width, heads: 1 });
    arrow(answer.force_world * drawing.force, ink, 3.0);
    arrow(answer.body_core * drawing.displacement, PINK, 2.0);
    if let ContactState::Sliding { direction } = answer.state {
        arrow(direction * (SLIP * drawing.span), BROWN, 2.0);
    }
    let open = answer.state == ContactState::Separated;
    marks.push(Mark::Dot { at: from, ink, open });
}

fn draw_load(marks: &mut Vec<Mark>, drawing: &Drawing, state: &Equilibrium) {
    let load = drawing.load(state);
    let [force, moment] = [load.force * drawing.force, load.moment * drawing.moment];
    for (along, width, heads) in [(force, 3.0, 1), (moment, 2.0, 2)] {
        marks.push(Mark::Arrow { from: load.at, along, ink: BLACK, width, heads });
    }
    let along = if force == Point::zeros() { moment } else { force };
    if along != Point::zeros() {
        marks.push(Mark::Name { at: load.at + along, words: "load".into() });
    }
}

/// Where a point of the object goes, to first order, magnified.
fn moved(drawing: &Drawing, state: &Equilibrium, point: &Point) -> Point {
    let twist = state.twist.as_vector();
    let (moves, turns) = (Point::new(twist[0], twist[1], twist[2]), Point::new(twist[3], twist[4], twist[5]));
    point + (moves + turns.cross(point)) * drawing.displacement
}

fn points(corners: &[[f64; 3]]) -> Vec<Point> {
    corners.iter().map(|corner| Point::from(*corner)).collect()
}

/// A closed line, of two corners the line between them; of fewer there is none.
fn closed(mut corners: Vec<Point>, ink: RGBColor, dashes: Option<(f64, f64)>) -> Option<Mark> {
    match corners.len() {
        0 | 1 => return None,
        2 => {}
        _ => corners.push(corners[0]),
    }
    Some(Mark::Line { corners, ink, width: 1.0, dashes })
}
