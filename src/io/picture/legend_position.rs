//! The position of the legend in a chart.

use super::series::{ChartSeries, Stroke};
use crate::numerics::{counted, lowest};

/// Possible positions of the legend. The first number is the part of the free width that lies to the left of the legend. The second number is the
/// part of the free height that lies below it.
const LEGEND_POSITIONS: [(f64, f64); 6] =
    [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.5), (1.0, 0.5), (0.0, 0.0)];

/// Width, pixels, that the names of series take beside a chart, each shortened to at most `longest` letters.
pub(super) fn legend_width(series: &[ChartSeries], longest: usize) -> f64 {
    52.0 + 9.0 * most_letters(series, longest) as f64
}

/// Number of letters of the longest name, at most `longest`.
pub(super) fn most_letters(series: &[ChartSeries], longest: usize) -> usize {
    series.iter().map(|series| series.name.chars().count().min(longest)).max().unwrap_or(0)
}

/// The entry of [`LEGEND_POSITIONS`] at which the legend hides least of the curves and labels. `marked` is true if the chart has vertical lines with
/// labels; `shaded` is true if an area is shaded and has a label.
pub(super) fn best_legend_position(
    [x0, x1, y0, y1]: [f64; 4],
    series: &[ChartSeries],
    marked: bool,
    shaded: bool,
) -> (f64, f64) {
    // Fractions of the plot's width and height that the legend covers, estimated from its lines and letters.
    let height = 0.08 + 0.06 * series.len() as f64;
    let width = (0.08 + 0.009 * most_letters(series, usize::MAX) as f64).max(0.32);
    let hidden = |&(side, anchor): &(f64, f64)| {
        let (left, bottom) = (side * (1.0 - width), anchor * (1.0 - height));
        let inside = |x: f64, y: f64| {
            let (x, y) = ((x - x0) / (x1 - x0), (y - y0) / (y1 - y0));
            (left..left + width).contains(&x) && (bottom..bottom + height).contains(&y)
        };
        let mut count = 0;
        for ChartSeries { points, stroke, .. } in series {
            if matches!(stroke, Stroke::Circles | Stroke::Dots | Stroke::Bars) {
                count += 20 * counted(points, &|(x, y)| inside(*x, *y));
                continue;
            }
            for pair in points.windows(2) {
                for k in 0..=20 {
                    let along = |a: f64, b: f64| a + f64::from(k) / 20.0 * (b - a);
                    let (x, y) = (along(pair[0].0, pair[1].0), along(pair[0].1, pair[1].1));
                    count += usize::from(inside(x, y));
                }
            }
        }
        // Labels of vertical lines are at the top, the label of a shaded area is at the bottom right.
        let marked = marked && anchor == 1.0;
        let shaded = shaded && side > 0.0 && anchor == 0.0;
        count + 10 * (usize::from(marked) + usize::from(shaded))
    };
    *lowest(&LEGEND_POSITIONS, &|position| hidden(position) as f64).unwrap_or(&LEGEND_POSITIONS[0])
}
