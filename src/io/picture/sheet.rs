//! A sheet of paper in pixels: lines, areas, circles and texts are written as SVG in the order of drawing.

use crate::numerics::IntoList;
use std::fmt::{self, Display, Formatter, Write};

use super::palette::{BLACK, FONT, Ink, Rgb, WHITE};
use super::words::escaped;

/// Positions are rounded to a pixel divided by this number, finer than any screen shows.
const PARTS_OF_A_PIXEL: f64 = 100.0;

/// A position on the paper, pixels to the right and downwards.
pub(super) type PaperPoint = (f64, f64);

/// A length in whole hundredths of a pixel. An integer cannot be −0, and a point that two shapes share is written with the same digits for both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct HundredthsOfPixel(i32);

/// A position rounded to hundredths of a pixel.
pub(super) type Pixel = (HundredthsOfPixel, HundredthsOfPixel);

/// The nearest position that can be written; positions far outside are clamped.
pub(super) fn pixel((x, y): PaperPoint) -> Pixel {
    (fine(x), fine(y))
}

fn fine(length: f64) -> HundredthsOfPixel {
    #[expect(clippy::cast_possible_truncation, reason = "clamped")]
    // The limit of 1e7 pixels is far beyond the size of a picture, and its number of hundredths fits into a 32-bit integer.
    let whole = (length.clamp(-1e7, 1e7) * PARTS_OF_A_PIXEL).round() as i32;
    HundredthsOfPixel(whole)
}

impl Display for HundredthsOfPixel {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{}", f64::from(self.0) / PARTS_OF_A_PIXEL)
    }
}

pub(super) struct Sheet {
    svg: String,
    wide: f64,
}

/// Draws on a white sheet of the given size, pixels, and returns the SVG text.
pub(super) fn sheet((wide, high): PaperPoint, draw: &mut dyn FnMut(&mut Sheet)) -> String {
    let size = pixel((wide, high));
    let mut paper = Sheet { svg: String::new(), wide };
    let (w, h) = size;
    paper.put(format_args!(
        "<svg width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" xmlns=\"http://www.w3.org/2000/svg\" \
         font-family=\"{FONT}\" stroke-linejoin=\"round\">"
    ));
    paper.area(&[(0.0, 0.0), (wide, 0.0), (wide, high), (0.0, high)], WHITE);
    draw(&mut paper);
    paper.put(format_args!("</svg>"));
    paper.svg
}

impl Sheet {
    /// Appends one SVG element as a line of text. Writing into a string cannot fail.
    fn put(&mut self, element: fmt::Arguments) {
        let _ = writeln!(self.svg, "{element}");
    }

    pub(super) fn line(&mut self, places: &[PaperPoint], ink: impl Into<Ink>, width: f64) {
        self.stroke(places, ink.into(), width, "");
    }

    pub(super) fn dashes(&mut self, places: &[PaperPoint], ink: impl Into<Ink>, width: f64) {
        self.stroke(places, ink.into(), width, " stroke-dasharray=\"7,5\"");
    }

    fn stroke(&mut self, places: &[PaperPoint], ink: Ink, width: f64, dashes: &str) {
        let points = points(places);
        // A line needs at least two points, which are separated by a space in `points`.
        if points.contains(' ') {
            let (ink, width) = (paint("stroke", ink), fine(width));
            self.put(format_args!(
                "<polyline fill=\"none\"{ink} stroke-width=\"{width}\"{dashes} points=\"{points}\"/>"
            ));
        }
    }

    pub(super) fn area(&mut self, corners: &[PaperPoint], ink: impl Into<Ink>) {
        let (ink, points) = (paint("fill", ink.into()), points(corners));
        self.put(format_args!("<polygon{ink} points=\"{points}\"/>"));
    }

    /// Draws a filled area bounded by closed lines of one orientation, with an optional line of another ink around it.
    pub(super) fn region(&mut self, loops: &[Vec<Pixel>], ink: impl Into<Ink>, around: Option<(Ink, f64)>) {
        let closed = |line: &Vec<Pixel>| format!("M{}Z", line.iter().copied().map(written).list().join(" "));
        let (ink, way) = (paint("fill", ink.into()), loops.iter().map(closed).collect::<String>());
        let around = around
            .map(|(ink, width)| format!("{} stroke-width=\"{}\"", paint("stroke", ink), fine(width)))
            .unwrap_or_default();
        self.put(format_args!("<path{ink}{around} d=\"{way}\"/>"));
    }

    /// Draws a circle, filled or as a line of the given width.
    pub(super) fn circle(&mut self, middle: PaperPoint, radius: f64, ink: impl Into<Ink>, line: Option<f64>) {
        let ink = ink.into();
        let style = match line {
            Some(width) => {
                format!(" fill=\"none\"{} stroke-width=\"{}\"", paint("stroke", ink), fine(width))
            }
            None => paint("fill", ink),
        };
        let ((x, y), r) = (pixel(middle), fine(radius));
        self.put(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{style}/>"));
    }

    /// Writes a line of text, vertically centred at the position `place`; `left` (0, 1/2 or 1) is the fraction of its width to the left of this
    /// position.
    pub(super) fn text(&mut self, place: PaperPoint, words: &str, size: f64, left: f64, color: Rgb) {
        self.letters(place, words, size, left, color, "");
    }

    /// Writes a line of text that runs upwards; its middle is at the position `place`.
    pub(super) fn text_upwards(&mut self, place: PaperPoint, words: &str, size: f64, color: Rgb) {
        let (x, y) = pixel(place);
        self.letters(place, words, size, 0.5, color, &format!(" transform=\"rotate(-90 {x} {y})\""));
    }

    fn letters(&mut self, place: PaperPoint, words: &str, size: f64, left: f64, color: Rgb, turn: &str) {
        let anchor = match left {
            l if l < 0.25 => "start",
            l if l > 0.75 => "end",
            _ => "middle",
        };
        // This shift centres letters without descenders vertically at the position `place`.
        let (x, y) = pixel((place.0, place.1 + 0.36 * size));
        let (ink, size, words) = (paint("fill", color.into()), fine(size), escaped(words));
        self.put(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\"{ink}{turn}>{words}</text>"
        ));
    }

    /// Writes the title of the picture in its upper left corner, in smaller letters if it does not fit otherwise.
    pub(super) fn title(&mut self, words: &str) {
        self.title_line(0.0, words);
    }

    /// Writes a further line of the title, `below` pixels lower.
    pub(super) fn title_line(&mut self, below: f64, words: &str) {
        let aside = 18.0;
        let room = (self.wide - 2.0 * aside) / (0.6 * words.chars().count() as f64);
        self.text((aside, 26.0 + below), words, 20.0_f64.min(room), 0.0, BLACK);
    }

    /// Writes a line of text on a light background, legible on any ground.
    pub(super) fn plaque(&mut self, place: PaperPoint, words: &str, size: f64, left: f64) {
        let (wide, high) = plaque_size(words, size);
        let (x, y) = (place.0 - left * wide - (1.0 - 2.0 * left) * 2.0, place.1);
        let half = high / 2.0;
        let corners = [(x, y - half), (x + wide, y - half), (x + wide, y + half), (x, y + half)];
        self.area(&corners, WHITE.mix(0.75));
        self.text(place, words, size, left, BLACK);
    }
}

/// Width and height of a text with its background, pixels.
pub(super) fn plaque_size(words: &str, size: f64) -> (f64, f64) {
    // In a sans serif font hardly any letter is wider than 0.57 times the font size.
    (0.57 * size * words.chars().count() as f64 + 4.0, 1.24 * size)
}

fn points(places: &[PaperPoint]) -> String {
    let mut points = String::new();
    for place in places {
        let (x, y) = pixel(*place);
        let apart = if points.is_empty() { "" } else { " " };
        let _ = write!(points, "{apart}{x},{y}");
    }
    points
}

fn written((x, y): Pixel) -> String {
    format!("{x},{y}")
}

/// The attributes for filling or stroking an element with an ink.
fn paint(what: &str, Ink { color: Rgb(r, g, b), opacity }: Ink) -> String {
    let opaque = format!(" {what}=\"#{r:02X}{g:02X}{b:02X}\"");
    if opacity == 1.0 { opaque } else { format!("{opaque} {what}-opacity=\"{opacity}\"") }
}
