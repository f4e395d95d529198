//! The strokes of a chart: series, vertical lines and labels.

use super::canvas::Canvas;
use super::layout::CHART;
use super::palette::{BLACK, GREY, PALETTE, Rgb, WHITE};
use super::series::{ChartSeries, Stroke};
use super::sheet::{PaperPoint, Sheet, plaque_size};
use super::words::{lines, shortened};
use crate::numerics::mapped;

/// Opacity of clouds of points and bars, so that strokes drawn before them remain visible.
const FAINT: f64 = 0.65;

/// Draws the lines, dots or bars of a series. Points that are not finite are omitted and interrupt lines.
pub(super) fn draw_series(paper: &mut Sheet, canvas: &Canvas, series: &ChartSeries, color: Rgb) {
    let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
    for piece in series.points.split(|point| !is_finite(point)) {
        draw_piece(paper, &mapped(piece, &|point| canvas.place(*point)), series.stroke, color);
    }
    if series.stroke == Stroke::Bars {
        for ends in series.bars() {
            if ends.iter().all(is_finite) {
                let [a, b] = [canvas.place(ends[0]), canvas.place(ends[1])];
                paper.area(&rectangle(a, b), color.mix(FAINT));
            }
        }
    }
}

/// Draws consecutive finite points of a series, and the line through these points.
fn draw_piece(paper: &mut Sheet, places: &[PaperPoint], stroke: Stroke, color: Rgb) {
    match stroke {
        Stroke::Line | Stroke::Marked | Stroke::Directed => paper.line(places, color, 2.0),
        Stroke::Dashed => paper.dashes(places, color, 2.0),
        Stroke::Circles | Stroke::Dots | Stroke::Bars => {}
    }
    if stroke == Stroke::Directed {
        for ends in places.windows(2) {
            draw_arrow(paper, ends[0], ends[1], color);
        }
    }
    for place in places {
        match stroke {
            Stroke::Marked => paper.circle(*place, 3.0, color, None),
            Stroke::Circles => paper.circle(*place, 4.0, color, Some(2.0)),
            Stroke::Dots => paper.circle(*place, 2.0, color.mix(FAINT), None),
            Stroke::Line | Stroke::Directed | Stroke::Dashed | Stroke::Bars => {}
        }
    }
}

/// Draws an arrow in the middle of one segment of a line, if the segment is long enough.
fn draw_arrow(paper: &mut Sheet, a: PaperPoint, b: PaperPoint, color: Rgb) {
    let (x, y) = (b.0 - a.0, b.1 - a.1);
    let size = x.hypot(y);
    // A segment shorter than this (pixels) has no room for an arrow.
    if size < 14.0 {
        return;
    }
    let middle = (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
    // Length and half the width of the arrow, as fractions of the segment.
    let (long, wide) = (11.0 / size, 4.5 / size);
    let corner =
        |along: f64, across: f64| (middle.0 + x * along - y * across, middle.1 + y * along + x * across);
    paper.area(&[corner(0.5 * long, 0.0), corner(-0.5 * long, wide), corner(-0.5 * long, -wide)], color);
}

/// Writes the names of series below each other, with samples of their strokes. The list begins at the position (x, y) on paper, and `line` is the
/// height of each line, pixels.
pub(super) fn draw_names(
    paper: &mut Sheet,
    (x, y): PaperPoint,
    series: &[ChartSeries],
    letters: usize,
    (size, line): (f64, f64),
) {
    for ((series, color), k) in series.iter().zip(PALETTE.iter().cycle()).zip(0..) {
        let y = y + line * (f64::from(k) + 0.5);
        match series.stroke {
            Stroke::Bars => paper.area(&rectangle((x, y - 5.0), (x + 20.0, y + 5.0)), color.mix(FAINT)),
            Stroke::Line | Stroke::Directed | Stroke::Dashed => {
                draw_piece(paper, &[(x, y), (x + 20.0, y)], series.stroke, *color);
            }
            Stroke::Circles | Stroke::Dots => draw_piece(paper, &[(x + 10.0, y)], series.stroke, *color),
            Stroke::Marked => {
                paper.line(&[(x, y), (x + 20.0, y)], *color, 2.0);
                paper.circle((x + 10.0, y), 3.0, *color, None);
            }
        }
        paper.text((x + 28.0, y), &shortened(&series.name, letters), size, 0.0, BLACK);
    }
}

/// The four corners of a rectangle with these two opposite corners.
pub(super) fn rectangle(a: PaperPoint, b: PaperPoint) -> [PaperPoint; 4] {
    [a, (b.0, a.1), b, (a.0, b.1)]
}

/// Draws a light background for a text between two opposite corners, with a line around it. `ground` and `around` are the opacities of background and
/// line.
pub(super) fn draw_ground(paper: &mut Sheet, a: PaperPoint, b: PaperPoint, [ground, around]: [f64; 2]) {
    let corners = rectangle(a, b);
    paper.area(&corners, WHITE.mix(ground));
    paper.line(&[&corners[..], &corners[..1]].concat(), GREY.mix(around), 1.0);
}

/// Draws vertical lines with labels at the top. A label that overlaps another label at the same height is moved down.
pub(super) fn draw_marks(paper: &mut Sheet, canvas: &Canvas, marks: &[(f64, String)]) {
    let mut taken: Vec<[f64; 3]> = Vec::new();
    for (x, label) in marks {
        let (x, _) = canvas.place((*x, 0.0));
        paper.dashes(&[(x, canvas.top + canvas.high), (x, canvas.top)], BLACK, 1.0);
        // The label is written to the right of its line; to the left if the line is in the right two fifths of the chart.
        let part = (x - canvas.left) / canvas.wide;
        let side = if part > 0.6 { -1.0 } else { 1.0 };
        let long = plaque_size(label, CHART.label).0 / canvas.wide;
        let from = if side > 0.0 { part } else { part - long };
        // A label that extends beyond an edge of the chart is moved inside.
        let moved = from.min(1.0 - long).max(0.0) - from;
        let from = from + moved;
        let meets = |row: f64| taken.iter().any(|[at, to, r]| *r == row && from < *to && from + long > *at);
        let row = (0..20).map(f64::from).find(|row| !meets(*row)).unwrap_or(0.0);
        taken.push([from, from + long, row]);
        let y = canvas.top + 0.02 * canvas.high + (0.5 + 1.3 * row) * CHART.label;
        let x = x + (0.008 * side + moved) * canvas.wide;
        paper.text((x, y), label, CHART.label, if side > 0.0 { 0.0 } else { 1.0 }, BLACK);
    }
}

/// Writes a sentence, broken into lines, just above the lower edge of a chart. The lower left corner of the chart is (`left`, `foot`). Returns the
/// height of the lines.
pub(super) fn draw_note(paper: &mut Sheet, (left, foot): PaperPoint, words: &str) -> f64 {
    let note = lines(words, 105);
    let high = CHART.note_line * note.len() as f64;
    for (k, words) in note.iter().enumerate() {
        let y = foot - 14.0 - high + CHART.note_line * (k + 1) as f64;
        paper.text((left + 24.0, y), words, CHART.plaque, 0.0, GREY);
    }
    high
}

/// Writes a short label on a light background at a point of the chart.
pub(super) fn draw_label(paper: &mut Sheet, (x, y): PaperPoint, words: &str) {
    let (wide, high) = plaque_size(words, CHART.plaque);
    let (across, up) = (0.45 * wide.max(0.8 * high), 0.5 * high);
    draw_ground(paper, (x - across, y - up), (x + across, y + up), [0.9, 1.0]);
    paper.text((x, y), words, CHART.plaque, 0.5, BLACK);
}
