//! Places for names, beside their points, where they cover least.

use super::sheet::{Place, Sheet, plaque_size};
use super::window::Window;

/// Ways from a point to its name, to the right and downwards, the best first.
const SIDES: [(f64, f64); 8] =
    [(1.0, -1.0), (-1.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (0.0, -1.0), (0.0, 1.0)];
/// Pixels between the point and its name.
const AWAY: [f64; 4] = [8.0, 14.0, 22.0, 32.0];
/// A pixel further away is as bad as so many pixels of a thin line covered.
const CLOSE: f64 = 1.2;

/// A name that meets another is as bad as so many pixels covered: worse than any other place.
const MEETS: f64 = 1e4;

/// Middle, width, height.
type Plate = (Place, (f64, f64));

pub(super) struct Labels {
    window: Window,
    /// What is better not covered, with weights.
    ink: Vec<(Place, f64)>,
    taken: Vec<Plate>,
}

impl Labels {
    pub(super) fn new(window: Window, ink: Vec<(Place, f64)>) -> Self {
        Self { window, ink, taken: Vec::new() }
    }

    /// Writes lines that belong to a point beside it; no later ones will stand there unless there
    /// is no other place.
    pub(super) fn write(&mut self, paper: &mut Sheet, point: Place, words: &[&str], size: f64) {
        let sizes: Vec<_> = words.iter().map(|line| plaque_size(line, size)).collect();
        let wide = sizes.iter().map(|line| line.0).fold(0.0, f64::max);
        let high: f64 = sizes.iter().map(|line| line.1).sum();
        let (x, y) = self.place(point, (wide, high));
        let (mut below, line) = (y - high / 2.0, high / words.len() as f64);
        for words in words {
            paper.plaque((x, below + line / 2.0), words, size, 0.5);
            below += line;
        }
    }

    fn place(&mut self, point: Place, (wide, high): (f64, f64)) -> Place {
        let middles = AWAY.iter().flat_map(|away| {
            SIDES.map(|(x, y)| {
                // At a corner the same distance is shared by both ways.
                let away = if x * y == 0.0 { *away } else { 0.6 * away };
                (point.0 + x * (wide / 2.0 + away), point.1 + y * (high / 2.0 + away))
            })
        });
        let plates = middles.map(|middle| (self.inside(middle, (wide, high)), (wide, high)));
        let cost = |plate: &Plate| self.cost(point, plate);
        let best = plates.map(|plate| (cost(&plate), plate)).min_by(|a, b| a.0.total_cmp(&b.0));
        let plate = best.map_or((point, (wide, high)), |(_, plate)| plate);
        self.taken.push(plate);
        plate.0
    }

    fn inside(&self, (x, y): Place, (wide, high): (f64, f64)) -> Place {
        let Window { left, top, .. } = self.window;
        let within =
            |at: f64, low: f64, room: f64, size: f64| at.min(low + room - size / 2.0).max(low + size / 2.0);
        (within(x, left, self.window.wide, wide), within(y, top, self.window.high, high))
    }

    fn cost(&self, point: Place, (middle, (wide, high)): &Plate) -> f64 {
        let aside = |other: Place| ((other.0 - middle.0).abs(), (other.1 - middle.1).abs());
        let covered = |at: Place| aside(at).0 < wide / 2.0 && aside(at).1 < high / 2.0;
        let ink: f64 = self.ink.iter().filter(|(at, _)| covered(*at)).map(|(_, weight)| weight).sum();
        let meets = |other: &&Plate| {
            let (x, y) = aside(other.0);
            x < f64::midpoint(*wide, other.1.0) + 2.0 && y < f64::midpoint(*high, other.1.1)
        };
        let names = self.taken.iter().filter(meets).count() as f64;
        let (x, y) = aside(point);
        let away = (x - wide / 2.0).max(0.0).hypot((y - high / 2.0).max(0.0));
        ink + MEETS * names + CLOSE * away
    }
}
