//! The marks of a still for one answer, in the coordinates of the grasp.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use plotters::style::RGBColor;

use super::drawing::{Drawing, goes};
use super::frame::Frame;
use super::leaving::MovedLines;
use crate::numerics::mapped;
use crate::picture::contact_look::{ink, slope, word};
use crate::picture::fingertip::{ContactGroup, Resultant};
use crate::picture::layout::{MARKS, SPATIAL};
use crate::picture::palette::{GREY, PALETTE, VERMILION};
use crate::picture::words::short;
use crate::spatial::{Contact, ContactState, Equilibrium, Wrench};

/// Colour of displacements.
pub(super) const PINK: RGBColor = PALETTE[3];
/// Colour of free motions.
pub(super) const SKY: RGBColor = RGBColor(58, 143, 200);
/// Colour of slips.
pub(super) const BROWN: RGBColor = RGBColor(122, 54, 0);

type Point = Vector3<f64>;

/// One mark of a still. Widths and dashes are in pixels.
pub(super) enum Mark {
    Line {
        corners: Vec<Point>,
        ink: RGBColor,
        width: f64,
        dashes: Option<(f64, f64)>,
    },
    Arrow {
        from: Point,
        along: Point,
        ink: RGBColor,
        width: f64,
        heads: usize,
    },
    Cone {
        apex: Point,
        rim: Vec<Point>,
        ink: RGBColor,
    },
    /// The arrow of a load, lengthened if it would be too short to be visible.
    Load {
        from: Point,
        along: Point,
        width: f64,
        heads: usize,
        /// Its name; its size is written beside it if the arrow is not to scale.
        name: Option<&'static str>,
        size: String,
    },
    /// An edge of the object, darker where it is nearer to the eye.
    Edge {
        corners: Vec<Point>,
    },
    /// A convex part of the object, behind everything else.
    Body {
        corners: Vec<Point>,
        ink: RGBColor,
    },
    Dot {
        at: Point,
        radius: f64,
        ink: RGBColor,
        open: bool,
    },
    Name {
        at: Point,
        words: String,
    },
}

impl Mark {
    pub(super) fn points(&self) -> Vec<Point> {
        match self {
            Self::Line { corners, .. } | Self::Edge { corners } | Self::Body { corners, .. } => {
                corners.clone()
            }
            Self::Arrow { from, along, .. } | Self::Load { from, along, .. } => vec![*from, from + along],
            Self::Cone { apex, rim, .. } => rim.iter().copied().chain([*apex]).collect(),
            Self::Dot { at, .. } | Self::Name { at, .. } => vec![*at],
        }
    }
}

/// The marks of the grasp, and of an answer if there is one.
pub(super) fn marks(drawing: &Drawing, frame: Option<&Frame<3>>) -> Vec<Mark> {
    let (page, state) = (drawing.page, frame.and_then(Frame::state));
    let mut marks = Vec::new();
    marks.extend(
        drawing
            .bodies
            .iter()
            .map(|corners| Mark::Body { corners: points(corners), ink: RGBColor(238, 239, 241) }),
    );
    marks.extend(
        page.fixtures
            .iter()
            .filter_map(|corners| Some(line(closed(points(corners))?, RGBColor(204, 204, 204), None))),
    );
    for outline in &page.outlines {
        let at = points(&outline.corners);
        marks.extend(closed(at.clone()).map(|corners| Mark::Edge { corners }));
        if let Some(state) = state {
            let corners =
                at.iter().map(|corner| corner + goes(state, outline.body, corner) * drawing.displacement);
            marks.extend(
                closed(corners.collect()).map(|corners| line(corners, PINK, Some(SPATIAL.moved_dashes))),
            );
        }
    }
    let (contacts, frames): (_, Vec<_>) = (page.grasp.contacts(), page.grasp.frames().collect());
    for tip in &drawing.tips {
        let axes = frames[tip.contacts.start];
        let [n, t, b] = [0, 1, 2].map(|k| Point::new(axes[(0, k)], axes[(1, k)], axes[(2, k)]));
        // The finger behind its contact, or a link.
        let at = tip.middle(contacts);
        let tail = at - n * (SPATIAL.finger * drawing.span);
        let corners = tip.ends_of_link(contacts).map_or(vec![tail, at], |ends| ends.to_vec());
        marks.push(Mark::Line { corners, ink: GREY, width: 5.0, dashes: None });
        match state {
            Some(state) => {
                let resultant = tip.resultant(contacts, state);
                let given = slope(&contacts[tip.contacts.start]);
                let slope = frame.map_or(given, |frame| frame.slope(tip.contacts.start, given));
                draw_answer(&mut marks, drawing, slope, [n, t, b], &resultant);
                draw_points(&mut marks, contacts, state, tip);
            }
            None => marks.push(Mark::Dot { at, radius: SPATIAL.contact, ink: GREY, open: true }),
        }
        if drawing.tips.len() <= MARKS.most_named {
            marks.push(Mark::Name { at: tail, words: tip.name.clone() });
        }
    }
    if let Some(load) = frame.and_then(Frame::load) {
        draw_load(&mut marks, drawing, load);
    }
    if let Some(motion) = frame.and_then(|frame| frame.leaving.as_ref()) {
        draw_way_out(&mut marks, &drawing.way_out(motion));
    }
    if let Some(state) = state {
        for (name, at) in page.actuators.that_yield(state).filter_map(|(name, at)| Some((name, at?))) {
            marks.push(Mark::Dot { at, radius: SPATIAL.contact, ink: VERMILION, open: false });
            marks.push(Mark::Name { at, words: format!("{name} yields") });
        }
        for motion in &state.free_motions {
            let axis = drawing.axis(&motion.object);
            let half = axis.along * (SPATIAL.axis * drawing.span);
            let corners = vec![axis.at - half, axis.at + half];
            marks.push(Mark::Line { corners, ink: SKY, width: 2.0, dashes: Some((9.0, 6.0)) });
            let words = if axis.turns { "turns freely" } else { "moves freely" };
            marks.push(Mark::Name { at: axis.at + half, words: words.into() });
        }
    }
    marks
}

fn draw_answer(
    marks: &mut Vec<Mark>,
    drawing: &Drawing,
    slope: f64,
    [n, t, b]: [Point; 3],
    resultant: &Resultant<3>,
) {
    let (from, ink) = (resultant.at, ink(resultant.word));
    let high = MARKS.cone * resultant.normal_force * drawing.force;
    if high > 0.0 && slope > 0.0 {
        // A cone with a wider rim is drawn shorter, because it would hide everything else.
        let wide = (slope * high).min(0.5 * drawing.size);
        let middle = from + n * (wide / slope);
        let sides = 72_u32;
        let rim = (0..sides).map(|k| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(sides)).sin_cos();
            middle + (t * cos + b * sin) * wide
        });
        let rim: Vec<_> = rim.collect();
        marks.extend(closed(rim.clone()).map(|corners| line(corners, ink, None)));
        marks.push(Mark::Cone { apex: from, rim, ink });
    }
    let mut arrow = |along: Point, ink, width| marks.push(Mark::Arrow { from, along, ink, width, heads: 1 });
    arrow(resultant.force * drawing.force, ink, 3.0);
    arrow(resultant.displacement * drawing.displacement, PINK, 2.0);
    if let Some(direction) = resultant.slides {
        arrow(direction * (SPATIAL.slip * drawing.span), BROWN, 2.0);
    }
}

/// The points of a fingertip, each in the colour of its state.
fn draw_points(marks: &mut Vec<Mark>, contacts: &[Contact], state: &Equilibrium, tip: &ContactGroup) {
    let radius = if tip.is_soft() { SPATIAL.soft_point } else { SPATIAL.contact };
    for i in tip.contacts.clone() {
        let answer = &state.contacts[i];
        let open = answer.state == ContactState::Separated;
        marks.push(Mark::Dot { at: contacts[i].point(), radius, ink: ink(word(answer)), open });
    }
}

fn draw_load(marks: &mut Vec<Mark>, drawing: &Drawing, load: &Wrench) {
    let load = drawing.load(load);
    let [force, moment] = [load.force.norm(), load.moment.norm()];
    let arrow = |along: Point, size: f64, width, heads, unit: &str, name| Mark::Load {
        from: load.at,
        along: along * (if heads == 1 { drawing.force } else { drawing.moment }),
        width,
        heads,
        name,
        size: format!("{} {unit}", short(size)),
    };
    if force > 0.0 {
        marks.push(arrow(load.force, force, 3.0, 1, "N", Some("load")));
    }
    if moment > 0.0 {
        marks.push(arrow(load.moment, moment, 2.0, 2, "N m", (force == 0.0).then_some("load")));
    }
}

fn draw_way_out(marks: &mut Vec<Mark>, way: &MovedLines) {
    for corners in &way.lines {
        let corners = closed(corners.clone());
        marks.extend(corners.map(|corners| Mark::Line {
            corners,
            ink: VERMILION,
            width: 1.5,
            dashes: Some(SPATIAL.moved_dashes),
        }));
    }
    for [from, to] in &way.arrows {
        marks.push(Mark::Arrow { from: *from, along: to - from, ink: VERMILION, width: 1.5, heads: 1 });
    }
}

fn points(corners: &[[f64; 3]]) -> Vec<Point> {
    mapped(corners, &|corner| Point::from(*corner))
}

/// A line closed back to its first corner; for two corners the line between them, for fewer `None`.
fn closed(mut corners: Vec<Point>) -> Option<Vec<Point>> {
    match corners.len() {
        0 | 1 => return None,
        2 => {}
        _ => corners.push(corners[0]),
    }
    Some(corners)
}

fn line(corners: Vec<Point>, ink: RGBColor, dashes: Option<(f64, f64)>) -> Mark {
    Mark::Line { corners, ink, width: 1.0, dashes }
}
