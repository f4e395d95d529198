//! Paper to draw on in pixels: lines, areas and texts of plotters without axes.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::error::{Drawn, PictureError};
use super::palette::FONT;

/// The back end rounds to whole pixels; drawn this many times as large and shown at its size, a
/// picture has smooth curves.
const FINE: u32 = 4;

/// Fine pixels from the corner of the paper beyond which nothing is drawn any farther: a hundred
/// times the paper, and differences of squares of it stay far below the largest integer, which
/// plotters would run over.
const FARTHEST: f64 = 1e6;

/// A colour, with or without its opacity.
pub(super) trait Ink: Into<RGBAColor> {}

impl<T: Into<RGBAColor>> Ink for T {}

/// A place on the paper, pixels to the right and downwards.
pub(super) type Place = (f64, f64);

pub(super) struct Sheet<'a> {
    root: DrawingArea<SVGBackend<'a>, Shift>,
}

/// Draws on a white sheet of so many pixels.
pub(super) fn sheet(
    (wide, high): (u32, u32),
    draw: impl FnOnce(&Sheet) -> Drawn,
) -> Result<String, PictureError> {
    let mut svg = String::new();
    {
        let size = (wide * FINE, high * FINE);
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE).map_err(PictureError::from_backend)?;
        let sheet = Sheet { root };
        draw(&sheet)?;
        sheet.root.present().map_err(PictureError::from_backend)?;
    }
    let drawn = format!("width=\"{}\" height=\"{}\"", wide * FINE, high * FINE);
    Ok(svg.replacen(&drawn, &format!("width=\"{wide}\" height=\"{high}\""), 1))
}

/// So many pixels for each of so many things.
pub(super) fn pixels(count: usize, each: u32) -> Result<u32, PictureError> {
    let all = u32::try_from(count).ok().and_then(|count| count.checked_mul(each * FINE));
    all.map(|all| all / FINE).ok_or_else(|| PictureError(format!("{count} are too many to be drawn")))
}

/// The nearest pixel of the fine grid; far outside it is kept away from the limits of integers.
pub(super) fn pixel((x, y): Place) -> (i32, i32) {
    #[expect(clippy::cast_possible_truncation, reason = "clamped")]
    let whole = |v: f64| (v * f64::from(FINE)).round().clamp(-FARTHEST, FARTHEST) as i32;
    (whole(x), whole(y))
}

impl Sheet<'_> {
    /// A line through places.
    pub(super) fn line(&self, places: impl IntoIterator<Item = Place>, ink: impl Ink, width: f64) -> Drawn {
        self.pixels(places.into_iter().map(pixel).collect(), ink, width)
    }

    /// A line through places that have been rounded to pixels.
    pub(super) fn pixels(&self, places: Vec<(i32, i32)>, ink: impl Ink, width: f64) -> Drawn {
        if places.len() < 2 {
            return Ok(());
        }
        self.root
            .draw(&PathElement::new(places, ink.into().stroke_width(fine(width))))
            .map_err(PictureError::from_backend)
    }

    /// A dashed line.
    pub(super) fn dashes(&self, places: &[Place], ink: impl Ink, width: f64) -> Drawn {
        let pixels: Vec<_> = places.iter().map(|place| pixel(*place)).collect();
        let style = ink.into().stroke_width(fine(width));
        let line = DashedPathElement::new(pixels, fine(7.0), fine(5.0), style);
        self.root.draw(&line).map_err(PictureError::from_backend)
    }

    /// A filled area.
    pub(super) fn area(&self, corners: impl IntoIterator<Item = Place>, ink: impl Ink) -> Drawn {
        self.fill(corners.into_iter().map(pixel).collect(), ink)
    }

    /// A filled area whose corners have been rounded to pixels.
    pub(super) fn fill(&self, corners: Vec<(i32, i32)>, ink: impl Ink) -> Drawn {
        self.root.draw(&Polygon::new(corners, ink.into())).map_err(PictureError::from_backend)
    }

    /// A circle, filled or drawn with a line of some width.
    pub(super) fn circle(&self, middle: Place, radius: f64, ink: impl Ink, line: Option<f64>) -> Drawn {
        let color = ink.into();
        let style = line.map_or(color.filled(), |width| ShapeStyle {
            color,
            filled: false,
            stroke_width: fine(width),
        });
        self.root.draw(&Circle::new(pixel(middle), fine(radius), style)).map_err(PictureError::from_backend)
    }

    /// A line of text, with a part of its width (0, 1/2 or 1) to the left of the place and half of
    /// its height above.
    pub(super) fn text(&self, place: Place, words: &str, size: f64, left: f64, color: RGBColor) -> Drawn {
        let side = match left {
            l if l < 0.25 => HPos::Left,
            l if l > 0.75 => HPos::Right,
            _ => HPos::Center,
        };
        let style = (FONT, fine(size)).into_font().color(&color).pos(Pos::new(side, VPos::Center));
        // XML has no place for these.
        let forbidden = |c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}');
        let words: String = words.chars().map(|c| if forbidden(c) { '\u{fffd}' } else { c }).collect();
        self.root.draw(&Text::new(words, pixel(place), style)).map_err(PictureError::from_backend)
    }

    /// A line of text on a light ground, so that it can be read on anything.
    pub(super) fn plaque(&self, place: Place, words: &str, size: f64, left: f64) -> Drawn {
        let (wide, high) = plaque_size(words, size);
        let (x, y) = (place.0 - left * wide - (1.0 - 2.0 * left) * 2.0, place.1);
        let half = high / 2.0;
        let corners = [(x, y - half), (x + wide, y - half), (x + wide, y + half), (x, y + half)];
        self.area(corners, WHITE.mix(0.75))?;
        self.text(place, words, size, left, BLACK)
    }
}

/// Width and height of a text with the ground it stands on.
pub(super) fn plaque_size(words: &str, size: f64) -> (f64, f64) {
    // Letters of a sans serif face are a little more than half as wide as high.
    (0.54 * size * words.chars().count() as f64 + 4.0, 1.24 * size)
}

fn fine(length: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lengths of a few pixels")]
    let whole = (length * f64::from(FINE)).round() as u32;
    whole.max(1)
}
