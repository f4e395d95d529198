//! Points of a curve, and how they are drawn.

/// One series of a chart.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Its points (x, y).
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Stroke {
    /// A line from point to point.
    #[default]
    Line,
    /// A line with a dot at each point.
    Marked,
    /// A dashed line.
    Dashed,
    /// Circles.
    Circles,
    /// Small dots, for clouds of points.
    Dots,
    /// Bars from zero to y around x, as wide as the first two points are apart.
    Bars,
}
