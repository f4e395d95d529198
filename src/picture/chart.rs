//! Curves against a load factor, with events marked.

use plotters::coord::Shift;
use plotters::element::{DashedPathElement, IntoDynElement};
use plotters::prelude::*;
use plotters::style::text_anchor as text_style;

use super::canvas::{Canvas, Plotted};
use super::error::{Drawn, PictureError};
use super::legend_corner::emptiest_corner;
use super::palette::{FONT, GREY, PALETTE};
use super::series::{Series, Stroke};
use super::sheet::pixels;

/// A chart of one or more series; build it up, then [`Chart::to_svg`]. Points and marks that are
/// not finite are left out; a line ends before such a point and goes on behind it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chart {
    title: String,
    x_label: String,
    y_label: String,
    series: Vec<Series>,
    marks: Vec<(f64, String)>,
    shaded: Option<(f64, String)>,
    logarithmic: bool,
}

impl Chart {
    /// An empty chart with its title and the labels of its axes (say the units).
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

    /// Adds a series of points (x, y), with its name in the legend; lines go from point to point in
    /// their order.
    #[must_use]
    pub fn series(mut self, name: impl Into<String>, points: Vec<(f64, f64)>, stroke: Stroke) -> Self {
        self.series.push(Series { name: name.into(), points, stroke });
        self
    }

    /// Marks an event by a vertical line at x with a label; the axis is made long enough for it.
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

    /// Both axes logarithmic. Points and marks without a logarithm are left out.
    #[must_use]
    pub fn log_log(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// Draws it, 860 by 540 pixels.
    ///
    /// # Errors
    /// [`PictureError`] if there is no finite point to draw, or points and marks are so far apart
    /// that their distance is not finite.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        Self::sheet(std::slice::from_ref(self), 1)
    }

    /// Draws several charts on one sheet, row by row, with so many columns or as many as there are
    /// charts.
    ///
    /// # Errors
    /// [`PictureError`] if there is no chart or no column, or one cannot be drawn by
    /// [`Chart::to_svg`].
    pub fn sheet(charts: &[Self], columns: usize) -> Result<String, PictureError> {
        if charts.is_empty() || columns == 0 {
            return Err(PictureError("no chart".into()));
        }
        let columns = columns.min(charts.len());
        let rows = charts.len().div_ceil(columns);
        let mut svg = String::new();
        {
            let size = (pixels(columns, 860)?, pixels(rows, 540)?);
            let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            root.fill(&WHITE).map_err(PictureError::from_backend)?;
            for (chart, area) in charts.iter().zip(root.split_evenly((rows, columns))) {
                chart.draw_on(&area)?;
            }
            root.present().map_err(PictureError::from_backend)?;
        }
        Ok(svg)
    }

    fn draw_on(&self, area: &Area<'_>) -> Drawn {
        let mut chart = if self.logarithmic { self.in_decades() } else { self.clone() };
        chart.marks.retain(|(x, _)| x.is_finite());
        let finite: Vec<(f64, f64)> = chart
            .series
            .iter()
            .flat_map(|s| s.points.iter().copied())
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect();
        if finite.is_empty() {
            return Err(PictureError("no finite point".into()));
        }
        let (x0, x1) = range(finite.iter().map(|p| p.0).chain(chart.marks.iter().map(|m| m.0)), 0.0);
        let (y0, y1) = range(finite.iter().map(|p| p.1), if self.logarithmic { 0.0 } else { 0.06 });
        let window =
            if self.logarithmic { [x0.floor(), x1.ceil(), y0.floor(), y1.ceil()] } else { [x0, x1, y0, y1] };
        if !((x1 - x0).is_finite() && (y1 - y0).is_finite()) {
            return Err(PictureError("points or marks are too far apart".into()));
        }
        chart.draw(area, window).map_err(PictureError::from_backend)
    }

    /// This chart with decimal logarithms for numbers.
    fn in_decades(&self) -> Self {
        let mut chart = self.clone();
        for (x, y) in chart.series.iter_mut().flat_map(|s| &mut s.points) {
            (*x, *y) = (x.log10(), y.log10());
        }
        for (x, _) in &mut chart.marks {
            *x = x.log10();
        }
        if let Some((from, _)) = &mut chart.shaded {
            *from = from.log10();
        }
        chart
    }

    fn draw(&self, root: &Area<'_>, window: [f64; 4]) -> Plotted {
        let [x0, x1, y0, y1] = window;
        let mut chart = ChartBuilder::on(root)
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
        self.draw_axes(&mut chart, window)?;
        for (series, color) in self.series.iter().zip(PALETTE.iter().cycle()) {
            draw_series(&mut chart, series, *color)?;
        }
        for (x, label) in &self.marks {
            draw_mark(&mut chart, window, *x, label)?;
        }
        chart
            .configure_series_labels()
            .position(emptiest_corner(window, &self.series, !self.marks.is_empty(), self.shaded.is_some()))
            .background_style(WHITE.mix(0.85))
            .border_style(GREY.mix(0.4))
            .label_font((FONT, 14))
            .draw()?;
        Ok(())
    }

    fn draw_axes(&self, chart: &mut Canvas, [x0, x1, y0, y1]: [f64; 4]) -> Plotted {
        let mut mesh = chart.configure_mesh();
        mesh.light_line_style(TRANSPARENT)
            .bold_line_style(GREY.mix(0.2))
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .label_style((FONT, 14))
            .axis_desc_style((FONT, 15));
        // Lines at whole decades only.
        let decades =
            |from: f64, to: f64| (0..=MOST_DECADES).take_while(|&k| from + f64::from(k) <= to).count();
        if self.logarithmic {
            mesh.x_labels(decades(x0, x1)).y_labels(decades(y0, y1).min(10));
            mesh.x_label_formatter(&|x| power_of_ten(*x)).y_label_formatter(&|y| power_of_ten(*y));
        }
        mesh.draw()?;
        Ok(())
    }
}

fn draw_series<'a, 'b: 'a>(chart: &mut Canvas<'a, 'b>, series: &Series, color: RGBColor) -> Plotted {
    let style = color.stroke_width(2);
    let is_finite = |(x, y): &(f64, f64)| x.is_finite() && y.is_finite();
    // All pieces of a line but the last, which has the entry of the legend.
    let pieces = series.points.split(|point| !is_finite(point));
    let mut pieces: Vec<_> = pieces.filter(|piece| !piece.is_empty()).collect();
    let last = pieces.pop().unwrap_or_default().iter().copied();
    for piece in pieces {
        let piece = piece.iter().copied();
        match series.stroke {
            Stroke::Line => chart.draw_series(LineSeries::new(piece, style))?,
            Stroke::Marked => chart.draw_series(LineSeries::new(piece, style.filled()).point_size(3))?,
            Stroke::Dashed => chart.draw_series(DashedLineSeries::new(piece, 7, 5, style))?,
            Stroke::Circles | Stroke::Dots | Stroke::Bars => break,
        };
    }
    let points = series.points.iter().copied().filter(is_finite);
    let drawn = match series.stroke {
        Stroke::Line => chart.draw_series(LineSeries::new(last, style))?,
        Stroke::Marked => chart.draw_series(LineSeries::new(last, style.filled()).point_size(3))?,
        Stroke::Dashed => chart.draw_series(DashedLineSeries::new(last, 7, 5, style))?,
        Stroke::Circles => chart.draw_series(points.map(|p| Circle::new(p, 4, style)))?,
        Stroke::Dots => chart.draw_series(points.map(|p| Circle::new(p, 2, color.mix(0.6).filled())))?,
        Stroke::Bars => {
            let wide = series.points.windows(2).next().map_or(1.0, |pair| pair[1].0 - pair[0].0);
            let bar = |(x, y): (f64, f64)| {
                let corners = [(x - 0.48 * wide, 0.0), (x + 0.48 * wide, y)];
                Rectangle::new(corners, color.mix(0.7).filled())
            };
            chart.draw_series(points.map(bar))?
        }
    };
    let stroke = series.stroke;
    drawn.label(&series.name).legend(move |(x, y)| {
        let line = [(x, y), (x + 20, y)];
        match stroke {
            Stroke::Circles | Stroke::Dots => Circle::new((x + 10, y), 4, style).into_dyn(),
            Stroke::Dashed => DashedPathElement::new(line, 5, 3, style).into_dyn(),
            Stroke::Line | Stroke::Marked | Stroke::Bars => PathElement::new(line, style).into_dyn(),
        }
    });
    Ok(())
}

fn draw_mark(chart: &mut Canvas, [x0, x1, y0, y1]: [f64; 4], x: f64, label: &str) -> Plotted {
    chart.draw_series(DashedLineSeries::new([(x, y0), (x, y1)], 4, 4, BLACK.stroke_width(1)))?;
    // To the side on which there is room.
    let left = (x - x0) > 0.6 * (x1 - x0);
    let text = (FONT, 14).into_font().color(&BLACK);
    let anchor = if left { text_style::HPos::Right } else { text_style::HPos::Left };
    let shift = 0.008 * (x1 - x0) * if left { -1.0 } else { 1.0 };
    let style = text.pos(text_style::Pos::new(anchor, text_style::VPos::Top));
    chart.draw_series([Text::new(label.to_owned(), (x + shift, y1 - 0.02 * (y1 - y0)), style)])?;
    Ok(())
}

/// Between the least and the largest number.
const MOST_DECADES: u32 = 700;

/// Where one chart is drawn.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The label of a decade.
fn power_of_ten(exponent: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32('⁰' as u32 + c as u32 - '0' as u32).unwrap_or(c),
    };
    format!("10{}", format!("{exponent:.0}").chars().map(raised).collect::<String>())
}

/// Smallest and largest value, with some room; a range of zero width gets one.
fn range(values: impl Iterator<Item = f64>, room: f64) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let width = if high > low { high - low } else { low.abs().max(1.0) * 0.1 };
    (low - room * width, high + room * width + if high > low { 0.0 } else { width })
}
