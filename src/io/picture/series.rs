//! The series of a chart, and their strokes.

use crate::numerics::mapped;

/// One series of a chart: points that have one name and one colour, and are drawn in one way.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ChartSeries {
    /// The name in the legend.
    pub name: String,
    /// The points (x, y).
    pub points: Vec<(f64, f64)>,
    /// The way the points are drawn, such as a line or dots.
    pub stroke: Stroke,
}

impl ChartSeries {
    /// Two opposite corners of each bar.
    pub(super) fn bars(&self) -> Vec<[(f64, f64); 2]> {
        let wide = self.points.windows(2).next().map_or(1.0, |pair| pair[1].0 - pair[0].0);
        mapped(&self.points, &|(x, y)| [(x - 0.48 * wide, 0.0), (x + 0.48 * wide, *y)])
    }

    /// The points that must lie inside the chart.
    pub(super) fn corners(&self) -> Vec<(f64, f64)> {
        if self.stroke == Stroke::Bars { self.bars().concat() } else { self.points.clone() }
    }
}

/// The way a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Stroke {
    /// A line from point to point.
    #[default]
    Line,
    /// A line with a dot at each point.
    Marked,
    /// A line with an arrow in the middle of each segment, in the order of the points.
    Directed,
    /// A dashed line.
    Dashed,
    /// Circles.
    Circles,
    /// Small dots, for clouds of points.
    Dots,
    /// Bars from zero to y around x, as wide as the distance of the first two points.
    Bars,
}
