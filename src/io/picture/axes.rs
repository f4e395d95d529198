//! The map from metres in a plane to pixels, and the axes beside it.

use super::palette::{BLACK, GREY};
use super::round_numbers::{in_steps, round_up, whole_above, whole_below};
use super::sheet::{PaperPoint, Sheet};
use super::window::Window;
use crate::numerics::Each;
use nalgebra::Vector2;

/// A map from metres in a plane to pixels of a window, with the same scale in both directions.
pub(super) struct EqualScales {
    window: Window,
    /// The point at the middle of the window, m.
    middle: Vector2<f64>,
    /// Scale of the map: pixels per metre.
    scale: f64,
}

impl EqualScales {
    /// The map with the largest scale at which all `points` (m) fit into the window. `border` is the width of the margins left and right, then above
    /// and below, pixels.
    pub(super) fn new(
        window: Window,
        border: (f64, f64),
        points: impl IntoIterator<Item = Vector2<f64>>,
    ) -> Self {
        let (low, high) = bounds(points);
        let size = high - low;
        let room = Vector2::new(window.wide - 2.0 * border.0, window.high - 2.0 * border.1);
        let scale = (room.x / size.x).min(room.y / size.y);
        Self { window, middle: low / 2.0 + high / 2.0, scale }
    }

    /// Whether scale and middle are finite; otherwise nothing can be drawn.
    pub(super) fn are_finite(&self) -> bool {
        self.scale > 0.0 && self.scale.is_finite() && self.middle.iter().all(|x| x.is_finite())
    }

    pub(super) fn place(&self, point: Vector2<f64>) -> PaperPoint {
        let (x, y) = self.window.middle();
        let away = (point - self.middle) * self.scale;
        (x + away.x, y - away.y)
    }

    /// The two points on paper, pixels, between which the straight line through `point` (m) in the direction `along` runs inside the window.
    pub(super) fn line_ends(&self, point: Vector2<f64>, along: Vector2<f64>) -> [PaperPoint; 2] {
        let half = Vector2::new(self.window.wide, self.window.high) / (2.0 * self.scale);
        let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..2 {
            let ends =
                [-1.0, 1.0].each(|side| (self.middle[axis] + side * half[axis] - point[axis]) / along[axis]);
            if along[axis] != 0.0 {
                (from, to) = (from.max(ends[0].min(ends[1])), to.min(ends[0].max(ends[1])));
            }
        }
        [from, to].each(|way| self.place(point + along * way))
    }

    pub(super) fn draw(&self, paper: &mut Sheet) {
        let Window { left, top, wide, high } = self.window;
        let (right, bottom) = (left + wide, top + high);
        paper.line(&[(left, top), (left, bottom), (right, bottom)], BLACK, 1.0);
        let letters = 14.0;
        // About eleven numbers fit along the horizontal axis; the vertical axis has the same step.
        let step = round_up(wide / self.scale / 11.0);
        for (axis, size) in [(0, wide), (1, high)] {
            let [low, up] = [-0.5, 0.5].each(|side| (self.middle[axis] + side * size / self.scale) / step);
            let first = whole_above(low);
            // An axis never has more than twenty numbers, even if its ends are affected by rounding errors.
            let numbers = (0..20).map(|k| first + f64::from(k)).take_while(|k| *k <= whole_below(up));
            for number in numbers.map(|k| k * step) {
                let (x, y) = self
                    .place(self.middle.map_with_location(|row, _, at| if row == axis { number } else { at }));
                let words = in_steps(number, step);
                if axis == 0 {
                    paper.line(&[(x, bottom), (x, bottom + 5.0)], BLACK, 1.0);
                    paper.text((x, bottom + 15.0), &words, letters, 0.5, BLACK);
                } else {
                    paper.line(&[(left, y), (left - 5.0, y)], BLACK, 1.0);
                    paper.text((left - 9.0, y), &words, letters, 1.0, BLACK);
                }
            }
        }
        paper.text((left + wide / 2.0, bottom + 36.0), "x (m)", letters, 0.5, GREY);
        paper.text_upwards((left - 50.0, top + high / 2.0), "y (m)", letters, GREY);
    }
}

pub(super) fn bounds(points: impl IntoIterator<Item = Vector2<f64>>) -> (Vector2<f64>, Vector2<f64>) {
    let none = (Vector2::repeat(f64::INFINITY), Vector2::repeat(f64::NEG_INFINITY));
    points.into_iter().fold(none, |(low, high), p| (low.inf(&p), high.sup(&p)))
}
