//! An equal-area map of a value that depends on a direction in space.

use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Each, IntoList, mapped};
use std::f64::consts::{FRAC_PI_2, SQRT_2, TAU};

use super::bands::Bands;
use super::error::PictureError;
use super::layout::SPHERE;
use super::palette::{BLACK, GREY, VERMILION, WHITE};
use super::regions::{Corner, outlines};
use super::sheet::{PaperPoint, Sheet, sheet};
use super::sphere_grid::SphereGrid;
use super::words::lines;

/// A map of a sphere on two discs with equal areas (Lambert's azimuthal projection). Directions that point upwards (z > 0) are on the left,
/// directions that point downwards on the right. Both are seen from above, x to the right and y up. The middle of a disc is ±z, its rim the
/// directions perpendicular to z.
///
/// ```
/// use grasp_lcp::picture::{SphereGrid, SphereMap};
///
/// let grid = SphereGrid::new(12, 24);
/// let values = grid.directions().iter().map(|d| 2.0 + d[0]).collect();
/// let svg = SphereMap::new("Two and a bit", "2 + x", grid, values)?.mark([-1.0, 0.0, 0.0], "least").to_svg()?;
/// assert!(svg.starts_with("<svg"));
/// # Ok::<(), grasp_lcp::picture::PictureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct SphereMap {
    title: String,
    quantity: String,
    grid: SphereGrid,
    values: Vec<f64>,
    marks: Vec<([f64; 3], String)>,
    rays: Vec<([f64; 3], String)>,
    notes: Vec<String>,
    unbounded: String,
    missing: String,
}

impl SphereMap {
    /// A map with one value for each of the grid's [directions](SphereGrid::directions), in their order. `quantity` names the mapped value with its
    /// unit; it is written at the colour scale. If the value is a bound, infinity means that there is no bound in this direction, NaN that no bound
    /// is known. Infinite values and NaN have colours of their own.
    ///
    /// # Errors
    /// [`PictureError`] if the number of values differs from the number of directions, or if no value is finite.
    pub fn new(
        title: impl Into<String>,
        quantity: impl Into<String>,
        grid: SphereGrid,
        values: Vec<f64>,
    ) -> Result<Self, PictureError> {
        if values.len() != grid.len() {
            let (given, expected) = (values.len(), grid.len());
            return Err(PictureError(format!("{given} values for {expected} directions")));
        }
        if !values.iter().any(|value| value.is_finite()) {
            return Err(PictureError("no finite value".into()));
        }
        Ok(Self {
            title: title.into(),
            quantity: quantity.into(),
            grid,
            values,
            marks: Vec::new(),
            rays: Vec::new(),
            notes: Vec::new(),
            unbounded: "no bound".into(),
            missing: "not known".into(),
        })
    }

    setters! {
        /// Marks a direction (a non-zero vector) with a dot and a label.
        pub fn mark(mut self, direction: impl Into<[f64; 3]>, label: impl Into<String>) {
            self.marks.push((direction.into(), label.into()));
        }

        /// Marks a direction (a non-zero vector) with a cross and a label, for reference directions such as contact normals.
        pub fn ray(mut self, direction: impl Into<[f64; 3]>, label: impl Into<String>) {
            self.rays.push((direction.into(), label.into()));
        }

        /// Adds a line of text below the map.
        pub fn note(mut self, text: impl Into<String>) { self.notes.push(text.into()); }

        /// Sets the words of the legend for infinite values and for NaN; "no bound" and "not known" by default.
        pub fn meanings(mut self, unbounded: impl Into<String>, missing: impl Into<String>) {
            (self.unbounded, self.missing) = (unbounded.into(), missing.into());
        }
    }

    /// Draws the map.
    ///
    /// # Errors
    /// [`PictureError`] if a marked direction has no length or is not finite.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in &self.values {
            if value.is_finite() {
                (low, high) = (low.min(*value), high.max(*value));
            }
        }
        let bands = Bands::new(low, high);
        let mut marked = Vec::new();
        for (list, dot) in [(&self.rays, false), (&self.marks, true)] {
            for (direction, label) in list {
                marked.push((way(*direction, label)?, label, dot));
            }
        }
        let notes = mapped(&self.notes, &|note| lines(note, 114)).concat();
        Ok(sheet((SPHERE.wide, 530.0 + 18.0 * notes.len() as f64), &mut |paper| {
            paper.title(&self.title);
            for (side, middle) in SPHERE.discs.into_iter().enumerate() {
                self.draw_disc(paper, side, middle, &bands);
            }
            for (direction, label, dot) in &marked {
                draw_mark(paper, *direction, label, *dot);
            }
            self.draw_scale(paper, &bands);
            for (k, note) in notes.iter().enumerate() {
                paper.text((18.0, SPHERE.foot + 18.0 * k as f64), note, 13.0, 0.0, GREY);
            }
        }))
    }

    fn draw_disc(&self, paper: &mut Sheet, side: usize, middle: PaperPoint, bands: &Bands) {
        // Regions without finite values are painted over afterwards.
        let filled = self.filled();
        let triangles = self.triangles(side, middle, &|index| bands.measure(filled[index]));
        for band in 0..bands.count() {
            let level = if band == 0 { f64::NEG_INFINITY } else { bands.measure(bands.levels[band]) };
            let loops = outlines(&triangles, level);
            if loops.is_empty() {
                continue;
            }
            let contour = (band > 0).then(|| (WHITE.mix(0.55), 0.6));
            paper.region(&loops, bands.color(band), contour);
        }
        for (color, is) in [
            (SPHERE.unbounded, f64::is_infinite as fn(f64) -> bool),
            (SPHERE.missing, f64::is_nan as fn(f64) -> bool),
        ] {
            let triangles = self.triangles(side, middle, &|k| f64::from(u8::from(is(self.values[k]))));
            let loops = outlines(&triangles, 0.5);
            if !loops.is_empty() {
                paper.region(&loops, color, None);
            }
        }
        for degrees in [30.0_f64, 60.0] {
            let radius = SPHERE.radius * SQRT_2 * (degrees.to_radians() / 2.0).sin();
            paper.circle(middle, radius, BLACK.mix(0.35), Some(0.6));
            let place = (middle.0 + radius * 0.5_f64.sqrt(), middle.1 + radius * 0.5_f64.sqrt());
            paper.plaque(place, &format!("{degrees:.0}°"), 10.0, 0.5);
        }
        for k in 0..12 {
            let (sin, cos) = (f64::from(k) * TAU / 12.0).sin_cos();
            let end =
                |part: f64| (middle.0 + part * SPHERE.radius * cos, middle.1 - part * SPHERE.radius * sin);
            paper.line(&[end(0.0), end(1.0)], BLACK.mix(0.18), 0.6);
        }
        paper.circle(middle, SPHERE.radius, BLACK, Some(1.2));
        for (k, name) in ["+x", "+y", "−x", "−y"].into_iter().enumerate() {
            let (sin, cos) = (k as f64 * FRAC_PI_2).sin_cos();
            let place = (middle.0 + (SPHERE.radius + 15.0) * cos, middle.1 - (SPHERE.radius + 13.0) * sin);
            paper.text(place, name, 14.0, 0.5, BLACK);
        }
        let words = if side == 0 { "upwards: +z in the middle" } else { "downwards: −z in the middle" };
        paper.text((middle.0, 60.0), words, 15.0, 0.5, BLACK);
    }

    /// The values of the map without infinite values and NaN. Each of these is replaced by the mean of its finite neighbours, or by the largest
    /// finite value if it has no finite neighbour. Regions without finite values are painted over later, and must not distort the contours next to
    /// them.
    fn filled(&self) -> Vec<f64> {
        let SphereGrid { rings, around } = self.grid;
        let finite = || self.values.iter().copied().filter(|value| value.is_finite());
        let overall = finite().fold(f64::NEG_INFINITY, f64::max);
        let mut filled = self.values.clone();
        for ring in 0..=2 * rings {
            let pole = ring == 0 || ring == 2 * rings;
            for k in 0..if pole { 1 } else { around } {
                let index = self.grid.index(ring, k);
                if self.values[index].is_finite() {
                    continue;
                }
                let aside: Vec<usize> =
                    if pole { (0..around).list() } else { vec![k + around - 1, k, k + 1] };
                let rows = ring.saturating_sub(1)..=(ring + 1).min(2 * rings);
                let (mut sum, mut count) = (0.0, 0.0);
                for row in rows {
                    for k in &aside {
                        let value = self.values[self.grid.index(row, *k)];
                        if value.is_finite() {
                            (sum, count) = (sum + value, count + 1.0);
                        }
                    }
                }
                filled[index] = if count > 0.0 { sum / count } else { overall };
            }
        }
        filled
    }

    /// Triangles that cover one hemisphere, all of the same orientation. Each corner has the value `field(k)`, where k is the index of its direction.
    fn triangles(&self, side: usize, middle: PaperPoint, field: &dyn Fn(usize) -> f64) -> Vec<[Corner; 3]> {
        let SphereGrid { rings, around } = self.grid;
        let corner = |ring: usize, k: usize| {
            let from_pole = self.grid.polar_angle(ring);
            let radius = SPHERE.radius * SQRT_2 * (from_pole / 2.0).sin();
            let (sin, cos) = self.grid.azimuth(k % around).sin_cos();
            let place = (middle.0 + radius * cos, middle.1 - radius * sin);
            let of_sphere = if side == 0 { ring } else { 2 * rings - ring };
            (place, field(self.grid.index(of_sphere, k)))
        };
        let mut triangles = Vec::new();
        for ring in 0..rings {
            for k in 0..around {
                let [a, b, c, d] =
                    [corner(ring, k), corner(ring + 1, k), corner(ring + 1, k + 1), corner(ring, k + 1)];
                triangles.push([a, b, c]);
                if ring > 0 {
                    triangles.push([a, c, d]);
                }
            }
        }
        triangles
    }

    fn draw_scale(&self, paper: &mut Sheet, bands: &Bands) {
        // The right edge of the colour scale, and its height.
        let (right, high) = (848.0, 320.0);
        let (left, bottom) = (right - 16.0, SPHERE.discs[1].1 + high / 2.0);
        let each = high / bands.count() as f64;
        for (k, level) in bands.levels.iter().enumerate() {
            let (low, top) = (bottom - each * k as f64, bottom - each * (k + 1) as f64);
            if k < bands.count() {
                paper.area(&[(left, low), (right, low), (right, top), (left, top)], bands.color(k));
            }
            paper.text((left - 4.0, low), &bands.label(*level), 11.0, 1.0, BLACK);
        }
        paper.text((SPHERE.wide - 8.0, bottom - high - 20.0), &self.quantity, 13.0, 1.0, BLACK);
        let mut x = 18.0;
        let present = [
            (SPHERE.unbounded, &self.unbounded, self.values.iter().any(|value| value.is_infinite())),
            (SPHERE.missing, &self.missing, self.values.iter().any(|value| value.is_nan())),
        ];
        for (color, words, _) in present.into_iter().filter(|(_, _, there)| *there) {
            let y = SPHERE.foot - 24.0;
            let corners = [(x, y - 6.0), (x + 16.0, y - 6.0), (x + 16.0, y + 6.0), (x, y + 6.0)];
            paper.area(&corners, color);
            paper.line(&[&corners[..], &corners[..1]].concat(), GREY, 0.7);
            paper.text((x + 22.0, y), words, 13.0, 0.0, BLACK);
            x += 60.0 + 7.0 * words.chars().count() as f64;
        }
    }
}

/// The unit vector of a marked direction; an error if the direction has no finite, positive length.
fn way(direction: [f64; 3], label: &str) -> Result<[f64; 3], PictureError> {
    let [x, y, z] = direction;
    let size = x.hypot(y).hypot(z);
    if !(size > 0.0 && size.is_finite()) {
        return Err(PictureError(format!("the direction of \"{label}\" has no length")));
    }
    Ok(direction.each(|part| part / size))
}

/// Draws a mark on the disc of its hemisphere; on both discs if the direction is perpendicular to z.
fn draw_mark(paper: &mut Sheet, [x, y, z]: [f64; 3], label: &str, dot: bool) {
    let level = z.abs() <= NEGLIGIBLE;
    for (side, middle) in SPHERE.discs.into_iter().enumerate() {
        if !level && (z > 0.0) != (side == 0) {
            continue;
        }
        let from_pole = x.hypot(y).atan2(z.abs());
        let radius = SPHERE.radius * SQRT_2 * (from_pole / 2.0).sin();
        let flat = x.hypot(y).max(f64::MIN_POSITIVE);
        let place = (middle.0 + radius * x / flat, middle.1 - radius * y / flat);
        if dot {
            paper.circle(place, 6.0, WHITE, None);
            paper.circle(place, 4.5, VERMILION, None);
        } else {
            for (ink, width) in [(WHITE, 4.0), (BLACK, 1.8)] {
                for slope in [1.0, -1.0] {
                    let ends = [-5.0, 5.0].each(|d| (place.0 + d, place.1 + slope * d));
                    paper.line(&ends, ink, width);
                }
            }
        }
        // The label extends towards the middle, where there is room.
        let left = if place.0 > middle.0 { 1.0 } else { 0.0 };
        let aside = if left > 0.0 { -10.0 } else { 10.0 };
        paper.plaque((place.0 + aside, place.1), label, 12.0, left);
    }
}
