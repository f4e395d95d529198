//! Polar charts: curves of a number that depends on a direction in the plane. The rim is the outer circle of a chart.

use crate::numerics::{IntoList, counted, largest, mapped};
use std::f64::consts::{FRAC_PI_2, PI};

use super::error::PictureError;
use super::layout::POLAR;
use super::palette::{BLACK, GREY, PALETTE};
use super::polar_curve::draw_curve;
use super::polar_plane::{at, turn, width_of};
use super::round_numbers::{in_steps, round_up, whole_above};
use super::series::{ChartSeries, Stroke};
use super::sheet::{Sheet, sheet};
use super::words::lines;

/// A polar chart: radius against direction, with angles from x towards y. Add curves to it, then call [`Polar::to_svg`].
///
/// Radii that are infinite or beyond the rim appear as an arc along the rim. At a radius that is NaN the curve has a gap.
///
/// ```
/// use grasp_lcp::picture::{Polar, Stroke};
///
/// let circle: Vec<_> = (0..360).map(|k| (f64::from(k).to_radians(), 2.0)).collect();
/// let svg = Polar::new("Two newtons in every direction", "N").curve("force", circle, Stroke::Line).to_svg()?;
/// assert!(svg.starts_with("<svg"));
/// # Ok::<(), grasp_lcp::picture::PictureError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[must_use]
pub struct Polar {
    title: String,
    unit: String,
    curves: Vec<ChartSeries>,
    marks: Vec<(Vec<(f64, f64)>, String)>,
    rays: Vec<(f64, String)>,
    notes: Vec<String>,
    rim: Option<f64>,
}

impl Polar {
    /// An empty chart with its title and the unit of the radii.
    pub fn new(title: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { title: title.into(), unit: unit.into(), ..Self::default() }
    }

    setters! {
        /// Adds a curve of points (angle in rad, radius) in order of their angles; the last point is joined to the first. [`Stroke::Bars`] draws spokes
        /// from the middle.
        pub fn curve(mut self, name: impl Into<String>, points: Vec<(f64, f64)>, stroke: Stroke) {
            self.curves.push(ChartSeries { name: name.into(), points, stroke });
        }

        /// Marks one or more points (angle in rad, radius), each with a spoke from the middle; the legend has the label. A radius beyond the rim is drawn
        /// on the rim.
        pub fn mark(mut self, points: Vec<(f64, f64)>, label: impl Into<String>) {
            self.marks.push((points, label.into()));
        }

        /// Marks a direction (angle in rad) with an arrow and a name outside the rim.
        pub fn ray(mut self, angle: f64, label: impl Into<String>) { self.rays.push((angle, label.into())); }

        /// Adds a line of text below the legend.
        pub fn note(mut self, text: impl Into<String>) { self.notes.push(text.into()); }

        /// Sets the largest radius that must lie inside the rim; without it all finite radii lie inside. The radii of the rings are multiples of a
        /// round number. The rim is the first ring at or beyond the given radius.
        pub fn rim(mut self, radius: f64) { self.rim = Some(radius); }
    }

    /// Draws the chart.
    ///
    /// # Errors
    /// [`PictureError`] if there is no positive finite radius to draw, or the radius of the rim is not positive and finite.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        let finite = |(_, r): &(f64, f64)| if r.is_finite() { *r } else { 0.0 };
        let most = largest(&self.curves, &|curve| largest(&curve.points, &finite));
        if most <= 0.0 {
            return Err(PictureError("no positive finite radius".into()));
        }
        let wanted = self.rim.unwrap_or(most);
        if !(wanted > 0.0 && wanted.is_finite()) {
            return Err(PictureError("the rim must have a positive, finite radius".into()));
        }
        let step = round_up(wanted / 5.0);
        let rim = step * whole_above(wanted / step);
        Ok(sheet((860.0, 640.0), &mut |paper| {
            paper.title(&self.title);
            self.draw_grid(paper, rim, step);
            // The first curve is drawn last and lies on top.
            for (k, curve) in self.curves.iter().enumerate().rev() {
                draw_curve(paper, rim, k, curve);
            }
            for (points, _) in &self.marks {
                for (angle, radius) in points {
                    let end = at(*angle, POLAR.radius * (radius / rim).min(1.0));
                    paper.line(&[POLAR.middle, end], BLACK, 1.0);
                    paper.circle(end, 4.5, BLACK, None);
                }
            }
            self.draw_rays(paper);
            self.draw_numbers(paper, rim, step);
            self.draw_legend(paper);
        }))
    }

    fn draw_grid(&self, paper: &mut Sheet, rim: f64, step: f64) {
        for radius in rings(rim, step) {
            paper.circle(POLAR.middle, POLAR.radius * radius / rim, GREY.mix(0.35), Some(0.7));
        }
        paper.circle(POLAR.middle, POLAR.radius, GREY, Some(1.2));
        for k in 0..12 {
            let angle = f64::from(k) * PI / 6.0;
            let strong = k % 3 == 0;
            let ink = GREY.mix(if strong { 0.6 } else { 0.3 });
            paper.line(&[POLAR.middle, at(angle, POLAR.radius)], ink, 0.7);
            let axis = match k {
                0 => "0°, +x",
                3 => "90°, +y",
                6 => "180°, −x",
                9 => "270°, −y",
                _ => "",
            };
            let words = if strong { axis.to_owned() } else { format!("{}°", 30 * k) };
            // The label of the angle is moved aside if a named direction is closer to the angle than `POLAR.beside`.
            let named = |(ray, _): &(f64, String)| turn(angle, *ray).abs() < POLAR.beside;
            let aside = if self.rays.iter().any(named) { 0.17 } else { 0.0 };
            outside(paper, angle + aside, POLAR.radius + 19.0, &words, 14.0);
        }
    }

    /// Draws the named directions as small arrows outside the arcs. If a name is long, or two directions are close together, letters that the legend
    /// explains replace all names.
    fn draw_rays(&self, paper: &mut Sheet) {
        let lettered = self.rays_have_letters();
        for (k, (angle, label)) in self.rays.iter().enumerate() {
            let (tip, side) = (at(*angle, POLAR.radius + 26.0), 0.022);
            let tail = [at(angle - side, POLAR.radius + 13.0), at(angle + side, POLAR.radius + 13.0)];
            paper.area(&[tip, tail[0], tail[1]], BLACK);
            // Letters of directions that are close together are written at increasing distances from the rim, so that they do not overlap.
            let before = counted(&self.rays[..k], &|(other, _)| meet(*other, *angle));
            let words = if lettered { letter(k) } else { label.clone() };
            outside(paper, *angle, POLAR.radius + 36.0 + 16.0 * before as f64, &words, 14.0);
        }
    }

    fn rays_have_letters(&self) -> bool {
        self.rays.iter().enumerate().any(|(k, (angle, label))| {
            // Names of more than ten letters do not fit outside the rim.
            label.chars().count() > 10 || self.rays[..k].iter().any(|(other, _)| meet(*other, *angle))
        })
    }

    /// Writes the radii of the rings along the spoke with the fewest points of curves nearby.
    fn draw_numbers(&self, paper: &mut Sheet, rim: f64, step: f64) {
        let numbered: Vec<f64> = rings(rim, step).chain([rim]).list();
        let mut drawn: Vec<(f64, f64)> = Vec::new();
        for curve in &self.curves {
            drawn.extend(&curve.points);
        }
        for (points, _) in &self.marks {
            points.iter().map(|(angle, _)| (*angle, numbered[0])).append_to(&mut drawn);
        }
        let crowd = |angle: f64| {
            let close = |(a, r): &(f64, f64)| {
                let near = |ring: &f64| (r - ring).abs() < 0.05 * rim;
                turn(angle, *a).abs() < POLAR.beside && numbered.iter().any(near)
            };
            counted(&drawn, &close)
        };
        let spokes = (0..12).map(|k| f64::from(k) * PI / 6.0 + PI / 12.0);
        let spoke = spokes.min_by_key(|angle| crowd(*angle)).unwrap_or(FRAC_PI_2);
        for (k, radius) in numbered.iter().enumerate() {
            let unit = if k + 1 == numbered.len() { format!(" {}", self.unit) } else { String::new() };
            let words = format!("{}{unit}", in_steps(*radius, step));
            paper.plaque(at(spoke, POLAR.radius * radius / rim), &words, 12.0, 0.5);
        }
    }

    fn draw_legend(&self, paper: &mut Sheet) {
        let mut y = 80.0;
        for (k, ChartSeries { name, stroke, .. }) in self.curves.iter().enumerate() {
            let ink = PALETTE[k % PALETTE.len()];
            let ends = [(POLAR.legend, y), (POLAR.legend + POLAR.sample, y)];
            match stroke {
                Stroke::Circles => paper.circle((POLAR.legend + POLAR.sample / 2.0, y), 4.0, ink, Some(1.5)),
                Stroke::Dots => paper.circle((POLAR.legend + POLAR.sample / 2.0, y), 2.0, ink, None),
                Stroke::Dashed => paper.dashes(&ends, ink, 2.0),
                _ => paper.line(&ends, ink, width_of(k)),
            }
            y = legend_text(paper, y, name);
        }
        for (_, label) in &self.marks {
            paper.line(&[(POLAR.legend, y), (POLAR.legend + POLAR.sample / 2.0, y)], BLACK, 1.0);
            paper.circle((POLAR.legend + POLAR.sample / 2.0, y), 4.5, BLACK, None);
            y = legend_text(paper, y, label);
        }
        if self.rays_have_letters() {
            for (k, (_, label)) in self.rays.iter().enumerate() {
                paper.text((POLAR.legend + POLAR.sample / 2.0, y), &letter(k), 14.0, 0.5, BLACK);
                y = legend_text(paper, y, label);
            }
        }
        y += 8.0;
        for note in mapped(&self.notes, &|note| lines(note, 30)).concat() {
            paper.text((POLAR.legend, y), &note, 13.0, 0.0, GREY);
            y += 18.0;
        }
    }
}

fn meet(angle: f64, other: f64) -> bool {
    // Labels outside the rim would overlap if their directions were closer than this angle, rad.
    turn(other, angle).abs() < 0.06
}

/// The letter with index `k` (a, b, c …); beyond z the index itself.
fn letter(k: usize) -> String {
    u8::try_from(k)
        .ok()
        .filter(|k| *k < 26)
        .map_or_else(|| k.to_string(), |k| char::from(b'a' + k).to_string())
}

/// Writes a text of the legend line by line from the vertical position `y`, and returns the vertical position of the next entry, pixels from the top.
fn legend_text(paper: &mut Sheet, y: f64, words: &str) -> f64 {
    let mut at = y;
    for line in words.lines() {
        for line in lines(line, 24) {
            paper.text((POLAR.legend + POLAR.sample + 8.0, at), &line, 14.0, 0.0, BLACK);
            at += 18.0;
        }
    }
    at + 6.0
}

fn rings(rim: f64, step: f64) -> impl Iterator<Item = f64> {
    // A ring this close to the rim is the rim itself, to within rounding.
    (1..100).map(move |k| f64::from(k) * step).take_while(move |radius| *radius < rim * (1.0 - 1e-6))
}

/// Writes a text outside the rim that extends away from the middle.
fn outside(paper: &mut Sheet, angle: f64, radius: f64, words: &str, size: f64) {
    let left = match angle.cos() {
        c if c > 0.2 => 0.0,
        c if c < -0.2 => 1.0,
        _ => 0.5,
    };
    paper.text(at(angle, radius), words, size, left, BLACK);
}
