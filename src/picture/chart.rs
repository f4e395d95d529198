//! Curves against a load factor, with events marked.

use plotters::element::IntoDynElement;
use plotters::prelude::*;
use plotters::style::text_anchor as text_style;

use super::{FONT, GREY, PALETTE, PictureError};

/// A chart of one or more series; build it up, then [`Chart::to_svg`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chart {
    title: String,
    x_label: String,
    y_label: String,
    series: Vec<Series>,
    marks: Vec<(f64, String)>,
    shaded: Option<(f64, String)>,
}

/// One series of a chart.
#[derive(Debug, Clone, PartialEq)]
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
pub enum Stroke {
    /// A line from point to point.
    #[default]
    Line,
    /// A dashed line.
    Dashed,
    /// Circles.
    Circles,
}

impl Chart {
    /// An empty chart with its title and the labels of its axes (say the units).
    #[must_use]
    pub fn new(title: impl Into<String>, x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        Self { title: title.into(), x_label: x_label.into(), y_label: y_label.into(), ..Self::default() }
    }

    /// Adds a series.
    #[must_use]
    pub fn series(mut self, name: impl Into<String>, points: Vec<(f64, f64)>, stroke: Stroke) -> Self {
        self.series.push(Series { name: name.into(), points, stroke });
        self
    }

    /// Marks an event by a vertical line with a label.
    #[must_use]
    pub fn mark(mut self, x: f64, label: impl Into<String>) -> Self {
        self.marks.push((x, label.into()));
        self
    }

    /// Shades everything to the right of x and says why.
    #[must_use]
    pub fn shade_from(mut self, x: f64, label: impl Into<String>) -> Self {
        self.shaded = Some((x, label.into()));
        self
    }

    /// Draws it.
    ///
    /// # Errors
    /// [`PictureError`] if there is no finite point to draw.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        let finite: Vec<(f64, f64)> = self
            .series
            .iter()
            .flat_map(|s| s.points.iter().copied())
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect();
        if finite.is_empty() {
            return Err(PictureError("no finite point".into()));
        }
        let (x0, x1) = range(finite.iter().map(|p| p.0).chain(self.marks.iter().map(|m| m.0)), 0.0);
        let (y0, y1) = range(finite.iter().map(|p| p.1), 0.06);
        let mut svg = String::new();
        self.draw(&mut svg, [x0, x1, y0, y1]).map_err(PictureError::from_backend)?;
        Ok(svg)
    }

    fn draw(&self, svg: &mut String, [x0, x1, y0, y1]: [f64; 4]) -> Result<(), Box<dyn std::error::Error>> {
        let root = SVGBackend::with_string(svg, (860, 540)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(&self.title, (FONT, 20))
            .margin(14)
            .x_label_area_size(46)
            .y_label_area_size(76)
            .build_cartesian_2d(x0..x1, y0..y1)?;
        if let Some((from, label)) = &self.shaded {
            let corners = [(from.max(x0), y0), (x1, y1)];
            chart.draw_series([Rectangle::new(corners, GREY.mix(0.15).filled())])?;
            let at = (from + 0.02 * (x1 - x0), y0 + 0.05 * (y1 - y0));
            chart.draw_series([Text::new(label.clone(), at, (FONT, 14).into_font().color(&GREY))])?;
        }
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GREY.mix(0.2))
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .label_style((FONT, 14))
            .axis_desc_style((FONT, 15))
            .draw()?;
        for (i, series) in self.series.iter().enumerate() {
            let color = PALETTE[i % PALETTE.len()];
            let style = color.stroke_width(2);
            let points = series.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite());
            let drawn = match series.stroke {
                Stroke::Line => chart.draw_series(LineSeries::new(points, style))?,
                Stroke::Dashed => chart.draw_series(DashedLineSeries::new(points, 7, 5, style))?,
                Stroke::Circles => chart.draw_series(points.map(|p| Circle::new(p, 4, style)))?,
            };
            let circles = series.stroke == Stroke::Circles;
            drawn.label(&series.name).legend(move |(x, y)| {
                if circles {
                    Circle::new((x + 10, y), 4, style).into_dyn()
                } else {
                    PathElement::new([(x, y), (x + 20, y)], style).into_dyn()
                }
            });
        }
        for (x, label) in &self.marks {
            let line = [(*x, y0), (*x, y1)];
            chart.draw_series(DashedLineSeries::new(line, 4, 4, BLACK.stroke_width(1)))?;
            // To the side on which there is room.
            let left = (x - x0) > 0.6 * (x1 - x0);
            let text = (FONT, 14).into_font().color(&BLACK);
            let anchor = if left { text_style::HPos::Right } else { text_style::HPos::Left };
            let shift = 0.008 * (x1 - x0) * if left { -1.0 } else { 1.0 };
            let style = text.pos(text_style::Pos::new(anchor, text_style::VPos::Top));
            chart.draw_series([Text::new(label.clone(), (x + shift, y1 - 0.02 * (y1 - y0)), style)])?;
        }
        chart
            .configure_series_labels()
            .position(self.emptiest_corner([x0, x1, y0, y1]))
            .background_style(WHITE.mix(0.85))
            .border_style(GREY.mix(0.4))
            .label_font((FONT, 14))
            .draw()?;
        root.present()?;
        Ok(())
    }
}

/// Places for the legend, with the lower left corner of each in units of the plot.
const PLACES: [(SeriesLabelPosition, f64, f64); 6] = [
    (SeriesLabelPosition::UpperRight, 0.68, 1.0),
    (SeriesLabelPosition::LowerRight, 0.68, 0.0),
    (SeriesLabelPosition::UpperLeft, 0.0, 1.0),
    (SeriesLabelPosition::MiddleLeft, 0.0, 0.5),
    (SeriesLabelPosition::MiddleRight, 0.68, 0.5),
    (SeriesLabelPosition::LowerLeft, 0.0, 0.0),
];

impl Chart {
    /// Where the legend hides least of the curves.
    fn emptiest_corner(&self, [x0, x1, y0, y1]: [f64; 4]) -> SeriesLabelPosition {
        let height = 0.08 + 0.06 * self.series.len() as f64;
        let hidden = |&(_, left, anchor): &(SeriesLabelPosition, f64, f64)| {
            let bottom = anchor * (1.0 - height);
            let mut count = 0;
            for series in &self.series {
                for pair in series.points.windows(2) {
                    for k in 0..=20 {
                        let s = f64::from(k) / 20.0;
                        let x = (pair[0].0 + s * (pair[1].0 - pair[0].0) - x0) / (x1 - x0);
                        let y = (pair[0].1 + s * (pair[1].1 - pair[0].1) - y0) / (y1 - y0);
                        let inside =
                            (left..left + 0.32).contains(&x) && (bottom..bottom + height).contains(&y);
                        count += usize::from(inside);
                    }
                }
            }
            // Labels of marks stand at the top, that of a shaded area at the bottom right.
            let marked = !self.marks.is_empty() && anchor == 1.0;
            let shaded = self.shaded.is_some() && left > 0.0 && anchor == 0.0;
            count + 10 * (usize::from(marked) + usize::from(shaded))
        };
        PLACES.iter().min_by_key(|place| hidden(place)).map_or(PLACES[0].0.clone(), |place| place.0.clone())
    }
}

/// Smallest and largest value, with some room; a range of zero width gets one.
fn range(values: impl Iterator<Item = f64>, room: f64) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let width = if high > low { high - low } else { low.abs().max(1.0) * 0.1 };
    (low - room * width, high + room * width + if high > low { 0.0 } else { width })
}
