//! Curves against a load factor, with events marked.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::canvas::{Area, AxisRange, Canvas, FINE, Plotted};
use super::chart_strokes::{draw_label, draw_marks, draw_names, draw_note, draw_series};
use super::error::PictureError;
use super::layout::CHART;
use super::legend_corner::{emptiest_corner, legend_width};
use super::palette::{FONT, GREY, PALETTE};
use super::series::{ChartSeries, Stroke};

/// A chart of one or more series: add series and marks to it, then call [`Chart::to_svg`]. Points, labels and marks that are not finite are omitted;
/// a line is interrupted at such a point.
#[derive(Debug, Clone, Default, PartialEq)]
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
    #[must_use]
    pub fn new(title: impl Into<String>, x_label: impl Into<String>, y_label: impl Into<String>) -> Self {
        Self { title: title.into(), x_label: x_label.into(), y_label: y_label.into(), ..Self::default() }
    }

    /// Adds a series of points (x, y) with its name in the legend; lines join the points in their order.
    #[must_use]
    pub fn series(mut self, name: impl Into<String>, points: Vec<(f64, f64)>, stroke: Stroke) -> Self {
        self.series.push(ChartSeries { name: name.into(), points, stroke });
        self
    }

    /// Marks an event by a vertical line at x with a label; the axis is extended to include x.
    #[must_use]
    pub fn mark(mut self, x: f64, label: impl Into<String>) -> Self {
        self.marks.push((x, label.into()));
        self
    }

    /// Labels a point (x, y) with a few letters on a plaque, such as the number of an event.
    #[must_use]
    pub fn label(mut self, point: (f64, f64), words: impl Into<String>) -> Self {
        self.labels.push((point, words.into()));
        self
    }

    /// Shades everything to the right of x, with a label for the reason.
    #[must_use]
    pub fn shade_from(mut self, x: f64, label: impl Into<String>) -> Self {
        self.shaded = Some((x, label.into()));
        self
    }

    /// Sets a sentence below the chart, broken into lines; it replaces an earlier one.
    #[must_use]
    pub fn note(mut self, words: impl Into<String>) -> Self {
        self.note = Some(words.into());
        self
    }

    /// Whether the chart has no finite point to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let mut points = self.series.iter().flat_map(|series| &series.points);
        !points.any(|(x, y)| x.is_finite() && y.is_finite())
    }

    /// Makes both axes logarithmic. Points and marks that are not positive are omitted.
    #[must_use]
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
    /// [`PictureError`] if there is no chart or no column, or if [`Chart::to_svg`] fails for one of them.
    pub fn sheet(charts: &[Self], columns: usize) -> Result<String, PictureError> {
        if charts.is_empty() || columns == 0 {
            return Err(PictureError("no chart".into()));
        }
        let columns = columns.min(charts.len());
        let rows = charts.len().div_ceil(columns);
        let mut svg = String::new();
        let shown;
        {
            let size = (fine_pixels(columns, CHART.size.0)?, fine_pixels(rows, CHART.size.1)?);
            let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            root.fill(&WHITE).map_err(PictureError::from_backend)?;
            for (chart, area) in charts.iter().zip(root.split_evenly((rows, columns))) {
                chart.draw_on(&area)?;
            }
            root.present().map_err(PictureError::from_backend)?;
            let size_of = |(wide, high)| format!("width=\"{wide}\" height=\"{high}\"");
            shown = [size_of(size), size_of((size.0 / FINE, size.1 / FINE))];
        }
        Ok(svg.replacen(&shown[0], &shown[1], 1))
    }

    fn draw_on(&self, area: &Area<'_>) -> Result<(), PictureError> {
        let mut chart = if self.logarithmic { self.in_decades() } else { self.clone() };
        chart.marks.retain(|(x, _)| x.is_finite());
        let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
        chart.labels.retain(|(point, _)| is_finite(point));
        let corners = chart.series.iter().flat_map(ChartSeries::corners);
        let finite: Vec<(f64, f64)> = corners.filter(is_finite).collect();
        if finite.is_empty() {
            return Err(PictureError("no finite point".into()));
        }
        let apart = chart.series.iter().any(|series| !matches!(series.stroke, Stroke::Line | Stroke::Dashed));
        // Marks have a size in pixels and need margins around their points. Logarithmic axes need none: they end at whole decades.
        let room = if self.logarithmic { (0.0, 0.0) } else { (if apart { 0.02 } else { 0.0 }, 0.06) };
        let (x0, x1) = range(finite.iter().map(|p| p.0).chain(chart.marks.iter().map(|m| m.0)), room.0);
        let (y0, y1) = range(finite.iter().map(|p| p.1), room.1);
        let window =
            if self.logarithmic { [x0.floor(), x1.ceil(), y0.floor(), y1.ceil()] } else { [x0, x1, y0, y1] };
        if !((x1 - x0).is_finite() && (y1 - y0).is_finite()) {
            return Err(PictureError("points or marks are too far apart".into()));
        }
        chart.draw(area, window).map_err(PictureError::from_backend)
    }

    /// The chart with decimal logarithms in place of its numbers.
    fn in_decades(&self) -> Self {
        let mut chart = self.clone();
        for (x, y) in chart.series.iter_mut().flat_map(|s| &mut s.points) {
            (*x, *y) = (x.log10(), y.log10());
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

    fn draw(&self, root: &Area<'_>, window: [f64; 4]) -> Plotted {
        let [x0, x1, y0, y1] = window;
        // The title has smaller letters if it would not fit.
        let room = f64::from(CHART.size.0 * FINE) / self.title.chars().count() as f64;
        // 0.5 is the width of a letter relative to its font size, as plotters assumes it.
        let title = (FONT, f64::from(CHART.title * FINE).min(room / 0.5))
            .into_font()
            .color(&BLACK)
            .pos(Pos::new(HPos::Center, VPos::Center));
        let (wide, _) = root.dim_in_pixel();
        root.draw(&Text::new(self.title.as_str(), (wide.cast_signed() / 2, 26 * FINE.cast_signed()), title))?;
        let below = draw_note(root, self.note.as_deref().unwrap_or_default())?;
        // A legend of many names would hide the curves. With more than `most_inside` series names are written beside the chart.
        let beside =
            (self.series.len() > CHART.most_inside).then(|| legend_width(&self.series, CHART.longest_beside));
        let mut chart = ChartBuilder::on(root)
            .margin(14 * FINE)
            // Room for the title.
            .margin_top(46 * FINE)
            // Room for half of the last number at the axis.
            .margin_right(30 * FINE + beside.unwrap_or(0))
            .margin_bottom(14 * FINE + below)
            .x_label_area_size(50 * FINE)
            .y_label_area_size(82 * FINE)
            .build_cartesian_2d(
                AxisRange::new(x0..x1, self.logarithmic),
                AxisRange::new(y0..y1, self.logarithmic),
            )?;
        if let Some((from, label)) = &self.shaded {
            let corners = [(from.max(x0), y0), (x1, y1)];
            chart.draw_series([Rectangle::new(corners, GREY.mix(0.15).filled())])?;
            // If the shaded area is narrow, the label ends at the right edge of the chart.
            let little = *from > x0 + 0.75 * (x1 - x0);
            let (x, side) = if little { (x1, HPos::Right) } else { (*from, HPos::Left) };
            let shift = 0.01 * (x1 - x0) * if little { -1.0 } else { 1.0 };
            let style = (FONT, 15 * FINE).into_font().color(&GREY).pos(Pos::new(side, VPos::Center));
            let at = (x + shift, y0 + 0.04 * (y1 - y0));
            chart.draw_series([Text::new(label.clone(), at, style)])?;
        }
        self.draw_axes(&mut chart)?;
        for (series, color) in self.series.iter().zip(PALETTE.iter().cycle()) {
            draw_series(
                &mut chart,
                series,
                *color,
                if beside.is_some() { CHART.longest_beside } else { CHART.longest_inside },
            )?;
        }
        draw_marks(&mut chart, window, &self.marks)?;
        for (point, label) in &self.labels {
            draw_label(&mut chart, *point, label)?;
        }
        if beside.is_some() {
            let (right, top) = chart.plotting_area().get_pixel_range();
            return draw_names(
                root,
                (right.end + 12 * FINE.cast_signed(), top.start),
                &self.series,
                CHART.longest_beside,
            );
        }
        chart
            .configure_series_labels()
            .position(emptiest_corner(window, &self.series, !self.marks.is_empty(), self.shaded.is_some()))
            .background_style(WHITE.mix(0.85))
            .border_style(GREY.mix(0.4).stroke_width(FINE))
            .label_font((FONT, CHART.letters * FINE))
            .legend_area_size(30 * FINE)
            .margin(10 * FINE)
            .draw()?;
        Ok(())
    }

    fn draw_axes(&self, chart: &mut Canvas) -> Plotted {
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GREY.mix(0.2).stroke_width(FINE))
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .label_style((FONT, CHART.letters * FINE))
            .axis_desc_style((FONT, CHART.letters * FINE))
            .draw()?;
        Ok(())
    }
}

/// The size of `count` charts of `each` pixels side by side, in fine pixels ([`FINE`] of them are one pixel).
fn fine_pixels(count: usize, each: u32) -> Result<u32, PictureError> {
    let all = u32::try_from(count).ok().and_then(|count| count.checked_mul(each * FINE));
    all.ok_or_else(|| PictureError(format!("{count} are too many to be drawn")))
}

/// Smallest and largest value with margins on both sides, each `room` times the range; a range of zero width is widened.
fn range(values: impl Iterator<Item = f64>, room: f64) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let width = if high > low { high - low } else { low.abs().max(1.0) * 0.1 };
    (low - room * width, high + room * width + if high > low { 0.0 } else { width })
}
