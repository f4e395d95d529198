//! Placement of names beside their points, so that a name covers no other name and as few strokes as possible.

use super::palette::GREY;
use super::sheet::{PaperPoint, Sheet, plaque_size};
use super::window::Window;
use super::words::{lines, shortened};
use crate::numerics::{IntoList, largest, lowest, mapped, picked, summed};

/// The rectangle of a name: its middle, and its width and height, pixels.
type NamePlate = (PaperPoint, (f64, f64));

/// Distance of a name from its point, pixels, beyond which a line joins them; without this line a name could seem to belong to another point.
const NEAR: f64 = 16.0;

/// Limit of the total cost of the strokes that a name beside its point may cover (see `Painting::ink`); above this limit positions farther away are
/// tried. Covering an arrow or the outline of a cone usually costs more than this limit.
const COVERS_MUCH: f64 = 60.0;

pub(super) struct Labels {
    window: Window,
    /// Points on strokes that names should not cover, each with the cost of covering it, about the covered area in pixels².
    ink: Vec<(PaperPoint, f64)>,
    taken: Vec<NamePlate>,
    /// Number of names for which no free position was left.
    pub(super) left_out: usize,
}

impl Labels {
    pub(super) fn new(window: Window, ink: Vec<(PaperPoint, f64)>) -> Self {
        Self { window, ink, taken: Vec::new(), left_out: 0 }
    }

    /// Writes a sentence in the upper left corner. Called before any name is placed, so that names do not cover the sentence.
    pub(super) fn write_in_the_corner(&mut self, paper: &mut Sheet, words: &str, size: f64) {
        let mut below = self.window.top;
        for line in lines(words, 80) {
            let (wide, high) = plaque_size(&line, size);
            let at = (self.window.left + 4.0, below + high / 2.0);
            paper.plaque(at, &line, size, 0.0);
            self.taken.push(((at.0 + wide / 2.0, at.1), (wide, high)));
            below += high;
        }
    }

    /// Writes lines beside their point without touching other names; only the first line if there is no room for all.
    pub(super) fn write(&mut self, paper: &mut Sheet, point: PaperPoint, words: &[&str], size: f64) {
        let words: Vec<_> = mapped(words, &|line| shortened(line, 36));
        for count in [words.len(), 1] {
            let sizes: Vec<_> = mapped(&words[..count], &|line| plaque_size(line, size));
            let wide = largest(&sizes, &|line| line.0);
            let high: f64 = summed(&sizes, &|line| line.1);
            let Some((x, y)) = self.place(paper, point, (wide, high)) else { continue };
            let (mut below, line) = (y - high / 2.0, high / count as f64);
            for words in &words[..count] {
                paper.plaque((x, below + line / 2.0), words, size, 0.5);
                below += line;
            }
            return;
        }
        self.left_out += 1;
    }

    /// The best position of a name: beside its point or, if a name beside the point covers too many strokes, anywhere on the paper. A line joins the
    /// name to its point if they are more than 16 pixels apart. `None` if no free position is left on the paper.
    fn place(&mut self, paper: &mut Sheet, point: PaperPoint, size: (f64, f64)) -> Option<PaperPoint> {
        let beside = self.best(point, &self.plates_beside(point, size));
        let is_clear = |plate: &NamePlate| self.cost(point, plate) <= COVERS_MUCH;
        let plate = match beside {
            Some(plate) if is_clear(&plate) => plate,
            _ => {
                let all = self.anywhere(size).into_iter().chain(beside);
                self.best(point, &all.list())?
            }
        };
        let ((x, y), (wide, high)) = plate;
        let end = |at: f64, middle: f64, size: f64| at.clamp(middle - size / 2.0, middle + size / 2.0);
        let end = (end(point.0, x, wide), end(point.1, y, high));
        if (end.0 - point.0).hypot(end.1 - point.1) > NEAR {
            paper.line(&[point, end], GREY, 0.75);
        }
        self.taken.push(plate);
        Some(plate.0)
    }

    /// The rectangle with the least cost among those that overlap no other name; `None` if each rectangle overlaps a name.
    fn best(&self, point: PaperPoint, plates: &[NamePlate]) -> Option<NamePlate> {
        let free =
            picked(plates, &|plate| (!self.overlaps(plate)).then(|| (self.cost(point, plate), *plate)));
        lowest(&free, &|(cost, _)| *cost).map(|(_, plate)| *plate)
    }

    fn plates_beside(&self, point: PaperPoint, (wide, high): (f64, f64)) -> Vec<NamePlate> {
        // Directions from a point to its name in order of preference, each with its components to the right and downwards.
        let sides = [
            (1.0, -1.0),
            (-1.0, -1.0),
            (1.0, 0.0),
            (-1.0, 0.0),
            (1.0, 1.0),
            (-1.0, 1.0),
            (0.0, -1.0),
            (0.0, 1.0),
        ];
        let mut plates = Vec::new();
        for away in [8.0, 14.0, 22.0, 32.0] {
            for (x, y) in sides {
                // A name that lies diagonally from its point is displaced by 0.6 of the distance in each of the two directions.
                let away = if x * y == 0.0 { away } else { 0.6 * away };
                let middle = (point.0 + x * (wide / 2.0 + away), point.1 + y * (high / 2.0 + away));
                plates.push((self.inside(middle, (wide, high)), (wide, high)));
            }
        }
        plates
    }

    fn anywhere(&self, (wide, high): (f64, f64)) -> Vec<NamePlate> {
        let places = |low: f64, room: f64, size: f64| {
            let (first, mut places) = (low + size / 2.0, Vec::new());
            while first + 9.0 * places.len() as f64 <= low + room - size / 2.0 {
                places.push(first + 9.0 * places.len() as f64);
            }
            places
        };
        let Window { left, top, wide: room, high: tall } = self.window;
        let mut plates = Vec::new();
        for y in places(top, tall, high) {
            for x in places(left, room, wide) {
                plates.push(((x, y), (wide, high)));
            }
        }
        plates
    }

    fn inside(&self, (x, y): PaperPoint, (wide, high): (f64, f64)) -> PaperPoint {
        let Window { left, top, .. } = self.window;
        let within =
            |at: f64, low: f64, room: f64, size: f64| at.min(low + room - size / 2.0).max(low + size / 2.0);
        (within(x, left, self.window.wide, wide), within(y, top, self.window.high, high))
    }

    fn overlaps(&self, (middle, (wide, high)): &NamePlate) -> bool {
        self.taken.iter().any(|(other, (w, h))| {
            let (x, y) = ((other.0 - middle.0).abs(), (other.1 - middle.1).abs());
            x < f64::midpoint(*wide, *w) + 2.0 && y < f64::midpoint(*high, *h)
        })
    }

    fn cost(&self, point: PaperPoint, (middle, (wide, high)): &NamePlate) -> f64 {
        let aside = |other: PaperPoint| ((other.0 - middle.0).abs(), (other.1 - middle.1).abs());
        let covered = |at: PaperPoint| aside(at).0 < wide / 2.0 && aside(at).1 < high / 2.0;
        let ink: f64 = self.ink.iter().filter(|(at, _)| covered(*at)).map(|(_, weight)| weight).sum();
        let (x, y) = aside(point);
        let away = (x - wide / 2.0).max(0.0).hypot((y - high / 2.0).max(0.0));
        // A pixel of distance costs more than covering a pixel of a thin line, so that names stay near their points.
        ink + 1.2 * away
    }
}
