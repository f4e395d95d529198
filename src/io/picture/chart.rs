//! Charts with two axes: lines, dots or bars, and vertical lines with labels.

use super::canvas::Canvas;
use super::chart_strokes::{
    draw_ground, draw_label, draw_marks, draw_names, draw_note, draw_series, rectangle,
};
use super::error::PictureError;
use super::layout::CHART;
use super::legend_position::{best_legend_position, legend_width, most_letters};
use super::palette::{BLACK, GREY, PALETTE};
use super::series::{ChartSeries, Stroke};
use super::sheet::{PaperPoint, Sheet, plaque_size, sheet};
use crate::numerics::{least, mapped};

/// A chart of one or more series: add series and vertical lines to it, then call [`Chart::to_svg`]. Points, labels and marks that are not finite are
/// omitted; a line is interrupted at such a point.
#[derive(Debug, Clone, Default, PartialEq)]
#[must_use]
pub struct Chart {
    title: String,
    x_label: String,
    y_label: String,
    series: Vec<ChartSeries>,
    marks: Vec<(f64, String)>,
    labels: Vec<((f64, f64), String)>,
    shaded: Option<(f64, String)>,
    note: Option<String>,
    logarithmic: bool,
}

impl Chart {
    /// An empty chart with its title and the labels of its axes (including units).
    ///
    /// ```
    /// use grasp_lcp::picture::{Chart, Stroke};
    ///
    /// let force = (0..=10).map(|i| f64::from(i) / 10.0).map(|x| (x, x * x)).collect();
    /// let svg = Chart::new("A spring that stiffens", "stretch (mm)", "force (N)")
    ///     .series("measured", force, Stroke::Line)
    ///     .mark(0.5, "yields")
    ///     .mark(f64::INFINITY, "breaks")
    ///     .to_svg()?;
    /// assert!(svg.contains("stretch (mm)") && svg.contains("yields") && !svg.contains("breaks"));
    /// let apart = Chart::new("Two points", "x", "y").series("", vec![(-1e308, 0.0), (1e308, 1.0)], Stroke::Dots);
    /// assert!(apart.to_svg().is_err());
    /// # Ok::<(), grasp_lcp::picture::PictureError>(())
    /// ```
    pub fn new(title: impl Into<String>, x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        Self { title: title.into(), x_label: x_label.into(), y_label: y_label.into(), ..Self::default() }
    }

    setters! {
        /// Adds a series of points (x, y) with its name in the legend; lines join the points in their order.
        pub fn series(mut self, name: impl Into<String>, points: Vec<(f64, f64)>, stroke: Stroke) {
            self.series.push(ChartSeries { name: name.into(), points, stroke });
        }

        /// Draws a vertical line at x with a label; the axis is extended to include x.
        pub fn mark(mut self, x: f64, label: impl Into<String>) { self.marks.push((x, label.into())); }

        /// Labels a point (x, y) with a few letters on a light background.
        pub fn label(mut self, point: (f64, f64), words: impl Into<String>) {
            self.labels.push((point, words.into()));
        }

        /// Shades everything to the right of x; the label says why.
        pub fn shade_from(mut self, x: f64, label: impl Into<String>) {
            self.shaded = Some((x, label.into()));
        }

        /// Sets the sentence below the chart, in place of an earlier sentence. It is broken into lines.
        pub fn note(mut self, words: impl Into<String>) { self.note = Some(words.into()); }
    }

    /// Whether the chart has no finite point to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
        !self.series.iter().any(|series| series.points.iter().any(is_finite))
    }

    /// Makes both axes logarithmic. Points and marks that are not positive are omitted.
    pub fn log_log(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// Draws the chart, 860 by 540 pixels.
    ///
    /// # Errors
    /// [`PictureError`] if there is no finite point to draw, or if the distances between points and marks are not finite.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        Self::sheet(std::slice::from_ref(self), 1)
    }

    /// Draws several charts on one sheet, row by row, in `columns` columns or as many as there are charts, whichever is less.
    ///
    /// # Errors
    /// [`PictureError`] if there is no chart or no column, or if [`Chart::to_svg`] fails for one of the charts.
    pub fn sheet(charts: &[Self], columns: usize) -> Result<String, PictureError> {
        if charts.is_empty() || columns == 0 {
            return Err(PictureError("no chart".into()));
        }
        let columns = columns.min(charts.len());
        let rows = charts.len().div_ceil(columns);
        let (wide, high) = CHART.size;
        let size = (wide * columns as f64, high * rows as f64);
        // A [`Sheet`] clamps coordinates to this size (pixels). Charts farther out are therefore misplaced.
        if size.0.max(size.1) > 1e7 {
            return Err(PictureError(format!("{} are too many to be drawn", charts.len())));
        }
        let mut fault = None;
        let svg = sheet(size, &mut |paper| {
            for (k, chart) in charts.iter().enumerate() {
                let corner = (wide * (k % columns) as f64, high * (k / columns) as f64);
                if let Err(error) = chart.draw_on(paper, corner) {
                    fault.get_or_insert(error);
                }
            }
        });
        fault.map_or(Ok(svg), Err)
    }

    fn draw_on(&self, paper: &mut Sheet, corner: PaperPoint) -> Result<(), PictureError> {
        let mut chart = if self.logarithmic { self.in_decades() } else { self.clone() };
        chart.marks.retain(|(x, _)| x.is_finite());
        let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
        chart.labels.retain(|(point, _)| is_finite(point));
        let mut finite = Vec::new();
        for series in &chart.series {
            finite.extend(series.corners().into_iter().filter(is_finite));
        }
        if finite.is_empty() {
            return Err(PictureError("no finite point".into()));
        }
        let apart = chart.series.iter().any(|series| !matches!(series.stroke, Stroke::Line | Stroke::Dashed));
        // Margins along x and y, as fractions of the range; along x there is a margin only for dots, circles and bars, which have a width.
        // Logarithmic axes need no margins: they end at whole decades.
        let room = if self.logarithmic { (0.0, 0.0) } else { (if apart { 0.02 } else { 0.0 }, 0.06) };
        let across = [mapped(&finite, &|p| p.0), mapped(&chart.marks, &|m| m.0)].concat();
        let (x0, x1) = range(&across, room.0);
        let (y0, y1) = range(&mapped(&finite, &|p| p.1), room.1);
        if !((x1 - x0).is_finite() && (y1 - y0).is_finite()) {
            return Err(PictureError("points or marks are too far apart".into()));
        }
        let window =
            if self.logarithmic { [x0.floor(), x1.ceil(), y0.floor(), y1.ceil()] } else { [x0, x1, y0, y1] };
        chart.draw(paper, corner, window);
        Ok(())
    }

    /// The chart with decimal logarithms in place of its numbers.
    fn in_decades(&self) -> Self {
        let mut chart = self.clone();
        for series in &mut chart.series {
            for (x, y) in &mut series.points {
                (*x, *y) = (x.log10(), y.log10());
            }
        }
        for (x, _) in &mut chart.marks {
            *x = x.log10();
        }
        for ((x, y), _) in &mut chart.labels {
            (*x, *y) = (x.log10(), y.log10());
        }
        if let Some((from, _)) = &mut chart.shaded {
            *from = from.log10();
        }
        chart
    }

    fn draw(&self, paper: &mut Sheet, (left, top): PaperPoint, window: [f64; 4]) {
        let (wide, high) = CHART.size;
        // The title has smaller letters if it does not fit otherwise.
        let size = CHART.title.min((wide - 36.0) / (0.6 * self.title.chars().count() as f64));
        paper.text((left + wide / 2.0, top + 26.0), &self.title, size, 0.5, BLACK);
        let below = draw_note(paper, (left, top + high), self.note.as_deref().unwrap_or_default());
        // A legend of many names takes so much room that it hides the curves; many names are therefore written beside the chart.
        let is_beside = self.series.len() > CHART.most_inside;
        let beside = if is_beside { legend_width(&self.series, CHART.longest_beside) } else { 0.0 };
        // The margins around the plot, in pixels, hold the numbers and labels of the axes. The right margin holds half of the last number of the x
        // axis.
        let canvas = Canvas {
            left: left + 96.0,
            top: top + 46.0,
            wide: wide - 126.0 - beside,
            high: high - 110.0 - below,
            window,
        };
        self.draw_shade(paper, &canvas);
        canvas.draw_axes(paper, [&self.x_label, &self.y_label], self.logarithmic);
        for (series, color) in self.series.iter().zip(PALETTE.iter().cycle()) {
            draw_series(paper, &canvas, series, *color);
        }
        draw_marks(paper, &canvas, &self.marks);
        for (point, label) in &self.labels {
            draw_label(paper, canvas.place(*point), label);
        }
        if is_beside {
            let at = (canvas.left + canvas.wide + 12.0, canvas.top + 2.0);
            draw_names(paper, at, &self.series, CHART.longest_beside, (CHART.label, 20.0));
        } else {
            self.draw_legend(paper, &canvas);
        }
    }

    fn draw_shade(&self, paper: &mut Sheet, canvas: &Canvas) {
        let (Some((from, label)), [x0, x1, y0, y1]) = (&self.shaded, canvas.window) else { return };
        let corners = rectangle(canvas.place((from.clamp(x0, x1), y0)), canvas.place((x1, y1)));
        paper.area(&corners, GREY.mix(0.15));
        // If there is little room to the right of x, the label ends at the right edge.
        let little = *from > x0 + 0.75 * (x1 - x0);
        let (x, y) = canvas.place((if little { x1 } else { *from }, y0 + 0.04 * (y1 - y0)));
        let aside = 0.01 * canvas.wide;
        let (x, left) = if little { (x - aside, 1.0) } else { (x + aside, 0.0) };
        paper.text((x, y), label, CHART.label, left, GREY);
    }

    /// Draws the legend at the position at which it hides least of the curves and labels.
    fn draw_legend(&self, paper: &mut Sheet, canvas: &Canvas) {
        let (marked, shaded) = (!self.marks.is_empty(), self.shaded.is_some());
        let (side, anchor) = best_legend_position(canvas.window, &self.series, marked, shaded);
        let longest = "x".repeat(most_letters(&self.series, CHART.longest_inside));
        let line = 1.3 * CHART.letters;
        let (wide, high) =
            (plaque_size(&longest, CHART.letters).0 + 48.0, line * self.series.len() as f64 + 12.0);
        let aside = 8.0;
        let left = canvas.left + aside + side * (canvas.wide - wide - 2.0 * aside);
        let top = canvas.top + aside + (1.0 - anchor) * (canvas.high - high - 2.0 * aside);
        draw_ground(paper, (left, top), (left + wide, top + high), [0.85, 0.4]);
        let at = (left + 10.0, top + 6.0);
        draw_names(paper, at, &self.series, CHART.longest_inside, (CHART.letters, line));
    }
}

/// Smallest and largest value with margins on both sides, each `room` times the range; a range of zero width is widened.
fn range(values: &[f64], room: f64) -> (f64, f64) {
    let (low, high) = (least(values, &|v| *v), -least(values, &|v| -v));
    let width = if high > low { high - low } else { low.abs().max(1.0) * 0.1 };
    (low - room * width, high + room * width + if high > low { 0.0 } else { width })
}
