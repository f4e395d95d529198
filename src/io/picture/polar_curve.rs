//! One curve of a polar chart. The rim is the outer circle of the chart. The curve is a line inside the rim, and an arc along the rim at radii beyond
//! it.

use crate::numerics::picked;
use std::f64::consts::TAU;

use super::layout::POLAR;
use super::palette::PALETTE;
use super::polar_plane::{at, width_of};
use super::series::{ChartSeries, Stroke};
use super::sheet::{PaperPoint, Sheet};

/// Draws curve number `index`, from 0, which determines its colour. `rim` is the radius of the rim in the unit of the curve.
pub(super) fn draw_curve(paper: &mut Sheet, rim: f64, index: usize, curve: &ChartSeries) {
    let ChartSeries { points, stroke, .. } = curve;
    let ink = PALETTE[index % PALETTE.len()];
    let place = |(angle, radius): (f64, f64)| at(angle, POLAR.radius * radius / rim);
    let inside = picked(points, &|point| (point.1 <= rim).then(|| place(*point)));
    match stroke {
        Stroke::Circles => return inside.iter().for_each(|at| paper.circle(*at, 4.0, ink, Some(1.5))),
        Stroke::Dots => return inside.iter().for_each(|at| paper.circle(*at, 2.0, ink, None)),
        Stroke::Bars => return inside.iter().for_each(|at| paper.line(&[POLAR.middle, *at], ink, 1.5)),
        Stroke::Marked => inside.iter().for_each(|at| paper.circle(*at, 3.0, ink, None)),
        Stroke::Line | Stroke::Directed | Stroke::Dashed => {}
    }
    let draw = |paper: &mut Sheet, line: Vec<PaperPoint>| match stroke {
        Stroke::Dashed => paper.dashes(&line, ink, 2.0),
        _ => paper.line(&line, ink, width_of(index)),
    };
    // Every curve has its own arc radius, so that arcs of several curves lie side by side.
    let arc_radius = POLAR.radius + 3.0 + 4.0 * index as f64;
    let (mut line, mut arc): (Vec<PaperPoint>, Vec<PaperPoint>) = (Vec::new(), Vec::new());
    for (k, &(angle, radius)) in points.iter().enumerate() {
        let (next_angle, next) = points[(k + 1) % points.len()];
        let at_crossing = angle + crossing(radius, next, rim) * (next_angle - angle).rem_euclid(TAU);
        if radius <= rim {
            line.push(place((angle, radius)));
        } else if radius > rim {
            arc.push(at(angle, arc_radius));
        }
        if radius.is_nan() || next.is_nan() {
            draw(paper, std::mem::take(&mut line));
            paper.line(&std::mem::take(&mut arc), ink, 4.0);
        } else if radius <= rim && next > rim {
            line.push(at(at_crossing, POLAR.radius));
            draw(paper, std::mem::take(&mut line));
            arc.push(at(at_crossing, arc_radius));
        } else if radius > rim && next <= rim {
            arc.push(at(at_crossing, arc_radius));
            paper.line(&std::mem::take(&mut arc), ink, 4.0);
            line.push(at(at_crossing, POLAR.radius));
        }
    }
    if let Some(&(angle, radius)) = points.first() {
        if radius <= rim {
            line.push(place((angle, radius)));
        } else if radius > rim {
            arc.push(at(angle, arc_radius));
        }
    }
    paper.line(&arc, ink, 4.0);
    draw(paper, line);
}

/// The fraction, from 0 to 1, of the angle between two points of a curve at which the curve crosses the rim. The points have the radii `from` and
/// `to`. The reciprocal of the radius is interpolated linearly, since it is finite even if a radius is infinite. 0 if both radii are equal.
fn crossing(from: f64, to: f64, rim: f64) -> f64 {
    let part = (1.0 / from - 1.0 / rim) / (1.0 / from - 1.0 / to);
    if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 }
}
