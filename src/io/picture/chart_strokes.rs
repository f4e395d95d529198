//! The strokes of a chart: series, marks and labels.

use crate::numerics::Each;
use plotters::element::{DashedPathElement, DynElement, EmptyElement, IntoDynElement};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::canvas::{Area, Canvas, FINE, Plotted};
use super::layout::CHART;
use super::palette::{FONT, GREY, PALETTE};
use super::series::{ChartSeries, Stroke};
use super::sheet::plaque_size;
use super::words::{lines, shortened};

/// Contour of the legend sample of a line with dots, pixels.
const DOTTED_SAMPLE: [(i32, i32); 10] =
    [(0, -1), (7, -1), (10, -4), (13, -1), (20, -1), (20, 1), (13, 1), (10, 4), (7, 1), (0, 1)];
/// Contour of the legend sample of a line with arrows, pixels.
const ARROWED_SAMPLE: [(i32, i32); 10] =
    [(0, -1), (6, -1), (6, -5), (15, -1), (20, -1), (20, 1), (15, 1), (6, 5), (6, 1), (0, 1)];

/// Draws a series and its entry in the legend, with a name of at most `letters` letters.
pub(super) fn draw_series<'a, 'b: 'a>(
    chart: &mut Canvas<'a, 'b>,
    series: &ChartSeries,
    color: RGBColor,
    letters: usize,
) -> Plotted {
    let (style, stroke) = (color.stroke_width(2 * FINE), series.stroke);
    let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
    for piece in series.points.split(|point| !is_finite(point)) {
        let piece = piece.iter().copied();
        match stroke {
            Stroke::Line | Stroke::Marked => _ = chart.draw_series(LineSeries::new(piece, style))?,
            Stroke::Directed => {
                chart.draw_series(LineSeries::new(piece.clone(), style))?;
                draw_arrows(chart, &piece.collect::<Vec<_>>(), color)?;
            }
            Stroke::Dashed => {
                _ = chart.draw_series(DashedLineSeries::new(piece, 7 * FINE, 5 * FINE, style))?;
            }
            Stroke::Circles | Stroke::Dots | Stroke::Bars => break,
        }
    }
    let points = series.points.iter().copied().filter(is_finite);
    match stroke {
        Stroke::Marked => _ = chart.draw_series(points.map(|p| Circle::new(p, 3 * FINE, color.filled())))?,
        Stroke::Circles => _ = chart.draw_series(points.map(|p| Circle::new(p, 4 * FINE, style)))?,
        Stroke::Dots => _ = chart.draw_series(points.map(|p| Circle::new(p, 2 * FINE, faint(color))))?,
        Stroke::Bars => {
            let corners = series.bars().into_iter().filter(|corners| corners.iter().all(is_finite));
            chart.draw_series(corners.map(|corners| Rectangle::new(corners, faint(color))))?;
        }
        Stroke::Line | Stroke::Directed | Stroke::Dashed => {}
    }
    let entry = chart.draw_series(std::iter::empty::<Circle<(f64, f64), u32>>())?;
    entry.label(shortened(&series.name, letters)).legend(move |at| sample(stroke, color, at));
    Ok(())
}

/// The legend sample of a stroke.
fn sample<'b>(
    stroke: Stroke,
    color: RGBColor,
    (x, y): (i32, i32),
) -> DynElement<'static, SVGBackend<'b>, (i32, i32)> {
    let (style, fine) = (color.stroke_width(2 * FINE), FINE.cast_signed());
    let (line, middle) = ([(x, y), (x + 20 * fine, y)], (x + 10 * fine, y));
    let around = |corners: &[(i32, i32)]| {
        let corners = corners.iter().map(|(across, down)| (x + across * fine, y + down * fine));
        Polygon::new(corners.collect::<Vec<_>>(), color.filled())
    };
    match stroke {
        Stroke::Circles => Circle::new(middle, 4 * FINE, style).into_dyn(),
        Stroke::Dots => Circle::new(middle, 2 * FINE, faint(color)).into_dyn(),
        Stroke::Bars => {
            let corners = [(x, y - 5 * fine), (x + 20 * fine, y + 5 * fine)];
            Rectangle::new(corners, faint(color)).into_dyn()
        }
        Stroke::Dashed => DashedPathElement::new(line, 5 * FINE, 3 * FINE, style).into_dyn(),
        Stroke::Marked => around(&DOTTED_SAMPLE).into_dyn(),
        Stroke::Directed => around(&ARROWED_SAMPLE).into_dyn(),
        Stroke::Line => PathElement::new(line, style).into_dyn(),
    }
}

/// Writes the names of series below each other from a place in the sheet.
pub(super) fn draw_names(
    root: &Area<'_>,
    (x, y): (i32, i32),
    series: &[ChartSeries],
    letters: usize,
) -> Plotted {
    let fine = FINE.cast_signed();
    for ((series, color), k) in series.iter().zip(PALETTE.iter().cycle()).zip(0..) {
        let y = y + (20 * k + 12) * fine;
        root.draw(&sample(series.stroke, *color, (x, y)))?;
        let style =
            (FONT, CHART.label * FINE).into_font().color(&BLACK).pos(Pos::new(HPos::Left, VPos::Center));
        root.draw(&Text::new(shortened(&series.name, letters), (x + 28 * fine, y), style))?;
    }
    Ok(())
}

/// Half-transparent ink for clouds of points and bars, so that strokes below remain visible.
fn faint(color: RGBColor) -> ShapeStyle {
    color.mix(0.65).filled()
}

/// An arrow in the middle of each piece of a line that is long enough.
fn draw_arrows(chart: &mut Canvas, line: &[(f64, f64)], color: RGBColor) -> Plotted {
    for ends in line.windows(2) {
        let [a, b] = [ends[0], ends[1]].each(|end| chart.plotting_area().map_coordinate(&end));
        let (x, y) = (f64::from(b.0 - a.0), f64::from(b.1 - a.1));
        let size = x.hypot(y);
        // A shorter piece of a line has no room for an arrow.
        if size < 14.0 * f64::from(FINE) {
            continue;
        }
        // Length and half the width of an arrow on a line, pixels.
        let (long, wide) = (11.0 * f64::from(FINE) / size, 4.5 * f64::from(FINE) / size);
        #[expect(clippy::cast_possible_truncation, reason = "some pixels")]
        let corner = |along: f64, across: f64| {
            ((x * along - y * across).round() as i32, (y * along + x * across).round() as i32)
        };
        let head = vec![corner(0.5 * long, 0.0), corner(-0.5 * long, wide), corner(-0.5 * long, -wide)];
        let middle = (f64::midpoint(ends[0].0, ends[1].0), f64::midpoint(ends[0].1, ends[1].1));
        chart.draw_series([EmptyElement::at(middle) + Polygon::new(head, color.filled())])?;
    }
    Ok(())
}

/// Draws vertical lines with labels at the top; labels that would overlap are moved down.
pub(super) fn draw_marks(chart: &mut Canvas, [x0, x1, y0, y1]: [f64; 4], marks: &[(f64, String)]) -> Plotted {
    let (wide, high) = chart.plotting_area().dim_in_pixel();
    let mut taken: Vec<[f64; 3]> = Vec::new();
    for (x, label) in marks {
        let style = BLACK.stroke_width(FINE);
        chart.draw_series(DashedLineSeries::new([(*x, y0), (*x, y1)], 4 * FINE, 4 * FINE, style))?;
        // The label is written on the side with more room.
        let part = (x - x0) / (x1 - x0);
        let (anchor, side) = if part > 0.6 { (HPos::Right, -1.0) } else { (HPos::Left, 1.0) };
        let long = plaque_size(label, f64::from(CHART.label * FINE)).0 / f64::from(wide);
        let from = if side > 0.0 { part } else { part - long };
        // A label that would leave the chart is moved back.
        let moved = from.min(1.0 - long).max(0.0) - from;
        let from = from + moved;
        let meets = |row: f64| taken.iter().any(|[at, to, r]| *r == row && from < *to && from + long > *at);
        let row = (0..20).map(f64::from).find(|row| !meets(*row)).unwrap_or(0.0);
        taken.push([from, from + long, row]);
        let style = (FONT, CHART.label * FINE).into_font().color(&BLACK).pos(Pos::new(anchor, VPos::Top));
        let down = 0.02 + 1.3 * row * f64::from(CHART.label * FINE) / f64::from(high);
        let at = (x + (0.008 * side + moved) * (x1 - x0), y1 - down * (y1 - y0));
        chart.draw_series([Text::new(label.to_owned(), at, style)])?;
    }
    Ok(())
}

/// Writes a sentence at the foot of a chart, broken into lines, and returns their height in fine pixels.
pub(super) fn draw_note(root: &Area<'_>, words: &str) -> Result<u32, Box<dyn std::error::Error>> {
    let note = lines(words, 105);
    let (_, high) = root.dim_in_pixel();
    let below = (0..u32::try_from(note.len()).unwrap_or(0)).rev();
    for (words, up) in note.iter().zip(below) {
        let style =
            (FONT, CHART.plaque * FINE).into_font().color(&GREY).pos(Pos::new(HPos::Left, VPos::Center));
        let y = high.cast_signed() - (14 * FINE + up * CHART.note_line * FINE).cast_signed();
        root.draw(&Text::new(words.as_str(), (24 * FINE.cast_signed(), y), style))?;
    }
    Ok(CHART.note_line * FINE * u32::try_from(note.len()).unwrap_or(0))
}

/// Writes a few letters on a plaque.
pub(super) fn draw_label(chart: &mut Canvas, point: (f64, f64), words: &str) -> Plotted {
    let (wide, high) = plaque_size(words, f64::from(CHART.plaque * FINE));
    #[expect(clippy::cast_possible_truncation, reason = "some pixels")]
    let (x, y) = ((0.45 * wide.max(0.8 * high)).round() as i32, (0.5 * high).round() as i32);
    let style =
        (FONT, CHART.plaque * FINE).into_font().color(&BLACK).pos(Pos::new(HPos::Center, VPos::Center));
    chart.draw_series([EmptyElement::at(point)
        + Rectangle::new([(-x, -y), (x, y)], WHITE.mix(0.9).filled())
        + Rectangle::new([(-x, -y), (x, y)], GREY.stroke_width(FINE))
        + Text::new(words.to_owned(), (0, 0), style)])?;
    Ok(())
}
