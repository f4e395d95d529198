//! The marks of a spatial picture, in the coordinates of the grasp: the marks of the grasp alone, and the marks of each answer. A mark is a line, an
//! arrow, a cone, a dot or a name; a fixture is something that does not move. A fingertip is a contact with all its points. A link joins two bodies,
//! as a hinge or a cable does.

use nalgebra::{Matrix3, Vector3};

use super::drawing::{Drawing, displacement_at};
use super::frame::Frame;
use super::leaving::MovedLines;
use super::mark::{Mark, MarkLayer, MarkShape};
use super::paint::hull;
use crate::grasp::ContactPoints;
use crate::numerics::{Each, IntoList, mapped};
use crate::picture::contact_look::{cone_ratio, cone_size, ink, word};
use crate::picture::fingertip::Resultant;
use crate::picture::layout::{MARKS, SPATIAL};
use crate::picture::palette::{BROWN, FIXTURE, GREY, PINK, Rgb, SKY, VERMILION};
use crate::picture::words::short;
use crate::spatial::{Contact, ContactState, Equilibrium, Wrench};

/// The marks that all answers share: the object, fixtures, fingers and their names.
pub(super) fn marks_of_the_grasp(drawing: &Drawing) -> Vec<Mark> {
    let page = drawing.page;
    let mut marks: Vec<Mark> =
        mapped(&drawing.bodies, &|corners| MarkShape::Body { corners: points(corners) }.always());
    for corners in &page.fixtures {
        marks.extend(closed(points(corners)).map(|corners| line(corners, FIXTURE, None).always()));
    }
    for outline in &page.outlines {
        marks.extend(closed(points(&outline.corners)).map(|corners| MarkShape::Edge { corners }.always()));
    }
    let (contacts, frames): (_, Vec<_>) = (page.grasp.contacts(), page.grasp.frames().list());
    let names = if drawing.tips.len() > MARKS.most_named { MarkLayer::Pointed } else { MarkLayer::Names };
    for (k, tip) in drawing.tips.iter().enumerate() {
        // A contact is drawn with a finger behind it. A link is drawn as a line between its two ends.
        let at = tip.middle(contacts);
        let tail = at - frames[tip.range.start].column(0) * (SPATIAL.finger * drawing.span);
        let corners = tip.ends_of_link(contacts).map_or(vec![tail, at], |ends| ends.to_vec());
        marks.push(MarkShape::Line { corners, ink: GREY, width: 5.0, dashes: None }.always());
        marks.push(MarkShape::Name { at: tail, words: tip.text() }.on(names).of(k));
    }
    marks
}

/// The marks of an answer: forces, displacements, the load, and motions; without an answer the contacts alone.
pub(super) fn marks_of_the_answer(drawing: &Drawing, frame: Option<&Frame>) -> Vec<Mark> {
    let (page, state) = (drawing.page, frame.and_then(Frame::state));
    let mut marks = Vec::new();
    if let Some(state) = state.filter(|_| drawing.displacement > 0.0) {
        for outline in &page.outlines {
            let moved = |corner: &Vector3<f64>| {
                corner + displacement_at(state, outline.body, corner) * drawing.displacement
            };
            marks.extend(
                closed(mapped(&points(&outline.corners), &moved)).map(|corners| {
                    line(corners, PINK, Some(SPATIAL.moved_dashes)).on(MarkLayer::Displacements)
                }),
            );
        }
    }
    let (contacts, frames): (_, Vec<_>) = (page.grasp.contacts(), page.grasp.frames().list());
    for (k, tip) in drawing.tips.iter().enumerate() {
        let first = tip.range.start;
        let ink = state.map_or(GREY, |state| ink(tip.resultant(contacts, state).word));
        marks.extend(rim(contacts, frames[first], tip, ink).map(|mark| mark.of(k)));
        if let (Some(frame), Some(state)) = (frame, state) {
            let axes = [0, 1, 2].each(|axis| frames[first].column(axis).into_owned());
            let cone_ratio = frame.cone_ratio(first, cone_ratio(&contacts[first]));
            let of_tip = marks_of_a_fingertip(drawing, cone_ratio, axes, &tip.resultant(contacts, state));
            of_tip.into_iter().chain(dots(contacts, state, tip)).map(|mark| mark.of(k)).append_to(&mut marks);
        } else {
            let at = tip.middle(contacts);
            let dot = MarkShape::Dot { at, radius: SPATIAL.contact, ink: GREY, open: true };
            marks.push(dot.always().of(k));
        }
    }
    if let Some(load) = frame.and_then(Frame::load) {
        marks.extend(marks_of_the_load(drawing, load));
    }
    if let Some(motion) = frame.and_then(|frame| frame.leaving.as_ref()) {
        marks.extend(marks_of_the_way_out(&drawing.way_out(motion)));
    }
    if let Some(state) = state {
        for (name, at) in page.actuators.that_yield(state) {
            let Some(at) = at else { continue };
            marks.push(MarkShape::Dot { at, radius: SPATIAL.contact, ink: VERMILION, open: false }.always());
            marks.push(MarkShape::Name { at, words: format!("{name} yields") }.on(MarkLayer::Names));
        }
        for motion in &state.free_motions {
            let axis = drawing.axis(&motion.object);
            let half = axis.along * (SPATIAL.axis * drawing.span);
            let corners = vec![axis.at - half, axis.at + half];
            let dashes = Some((9.0, 6.0));
            marks.push(MarkShape::Line { corners, ink: SKY, width: 2.0, dashes }.on(MarkLayer::FreeMotions));
            let words = if axis.turns { "turns freely" } else { "moves freely" };
            marks
                .push(MarkShape::Name { at: axis.at + half, words: words.into() }.on(MarkLayer::FreeMotions));
        }
    }
    marks
}

/// The friction cone of a fingertip, its force, its displacement and its slip.
fn marks_of_a_fingertip(
    drawing: &Drawing,
    cone_ratio: f64,
    [n, t, b]: [Vector3<f64>; 3],
    resultant: &Resultant,
) -> Vec<Mark> {
    let (from, ink) = (resultant.at, ink(resultant.word));
    let mut marks = Vec::new();
    if let Some([high, wide]) =
        cone_size(cone_ratio, resultant.normal_force * drawing.force, 0.5 * drawing.size)
    {
        let radii = [t * wide, b * wide];
        marks.push(MarkShape::Cone { apex: from, middle: from + n * high, radii, ink }.on(MarkLayer::Cones));
    }
    let mut arrow = |along: Vector3<f64>, ink, width, layer: Option<MarkLayer>| {
        if along.amax() > 0.0 {
            marks.push(Mark {
                shape: MarkShape::Arrow { from, along, ink, width, heads: 1 },
                layer,
                tip: None,
            });
        }
    };
    arrow(resultant.force * drawing.force, ink, 3.0, Some(MarkLayer::Forces));
    arrow(resultant.displacement * drawing.displacement, PINK, 2.0, Some(MarkLayer::Displacements));
    if let Some(direction) = resultant.slides {
        arrow(direction * (SPATIAL.slip * drawing.span), BROWN, 2.0, None);
    }
    marks
}

/// The points of a fingertip, each in the colour of its contact state.
fn dots(contacts: &[Contact], state: &Equilibrium, tip: &ContactPoints) -> Vec<Mark> {
    let radius = if tip.is_soft() { SPATIAL.soft_point } else { SPATIAL.contact };
    let dot = |i: usize| {
        let answer = &state.contacts[i];
        let open = answer.state == ContactState::Separated;
        MarkShape::Dot { at: contacts[i].point(), radius, ink: ink(word(answer)), open }.always()
    };
    tip.range.clone().filter(|i| tip.shows(word(&state.contacts[*i]))).map(dot).list()
}

/// The rim of a soft fingertip: the convex hull of its points, seen along its normal. `None` for a single point or a link.
fn rim(contacts: &[Contact], frame: &Matrix3<f64>, tip: &ContactPoints, ink: Rgb) -> Option<Mark> {
    if !tip.is_soft() || tip.label.link.is_some() {
        return None;
    }
    let places = contacts[tip.range.clone()].iter().map(|contact| {
        let across = frame.tr_mul(&contact.point());
        ((across[1], across[2]), contact.point())
    });
    let places: Vec<_> = places.list();
    let corners = hull(mapped(&places, &|(place, _)| *place));
    let point =
        |corner: &(f64, f64)| places.iter().find(|(place, _)| place == corner).map(|(_, point)| *point);
    let corners: Vec<_> = corners.iter().filter_map(point).list();
    (corners.len() > 2).then(|| MarkShape::Line { corners, ink, width: 1.5, dashes: None }.always())
}

/// The arrows of the force and of the moment of a load.
fn marks_of_the_load(drawing: &Drawing, load: &Wrench) -> Vec<Mark> {
    let load = drawing.load(load);
    let [force, moment] = [load.force.norm(), load.moment.norm()];
    let arrow = |along: Vector3<f64>, size: f64, heads, name: &str, unit: &str| {
        let width = if heads == 1 { 3.0 } else { 2.0 };
        let name = format!("{name} {} {unit}", short(size));
        let otherwise = format!("{name}, not to scale");
        MarkShape::Load { from: load.at, along, width, heads, name, otherwise }.on(MarkLayer::Load)
    };
    let mut marks = Vec::new();
    if force > 0.0 {
        marks.push(arrow(load.force * drawing.force, force, 1, "load", "N"));
    }
    if moment > 0.0 {
        let name = if force == 0.0 { "load" } else { "moment" };
        marks.push(arrow(load.moment * drawing.moment, moment, 2, name, "N m"));
    }
    marks
}

fn marks_of_the_way_out(way: &MovedLines) -> Vec<Mark> {
    let mut marks = Vec::new();
    for corners in way.lines.iter().filter_map(|corners| closed(corners.clone())) {
        let dashes = Some(SPATIAL.moved_dashes);
        marks.push(MarkShape::Line { corners, ink: VERMILION, width: 1.5, dashes }.on(MarkLayer::WayOut));
    }
    for [from, to] in &way.arrows {
        let (from, along) = (*from, to - from);
        marks.push(
            MarkShape::Arrow { from, along, ink: VERMILION, width: 1.5, heads: 1 }.on(MarkLayer::WayOut),
        );
    }
    marks
}

fn points(corners: &[[f64; 3]]) -> Vec<Vector3<f64>> {
    mapped(corners, &|corner| Vector3::from(*corner))
}

/// A line closed back to its first corner; for two corners the line between them, for fewer `None`.
fn closed(mut corners: Vec<Vector3<f64>>) -> Option<Vec<Vector3<f64>>> {
    match corners.len() {
        0 | 1 => return None,
        2 => {}
        _ => corners.push(corners[0]),
    }
    Some(corners)
}

fn line(corners: Vec<Vector3<f64>>, ink: Rgb, dashes: Option<(f64, f64)>) -> MarkShape {
    MarkShape::Line { corners, ink, width: 1.0, dashes }
}
