//! The rectangle of a sheet in which one chart is drawn, with axes and round numbers along the axes.

use super::layout::CHART;
use super::palette::{BLACK, GREY};
use super::round_numbers::{in_steps, round_up, whole_above, whole_below};
use super::sheet::{PaperPoint, Sheet};

/// The rectangle of a chart on the paper, pixels, and the range of numbers that it shows, its `window`.
pub(super) struct Canvas {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) wide: f64,
    pub(super) high: f64,
    /// The smallest and the largest x, then the smallest and the largest y.
    pub(super) window: [f64; 4],
}

impl Canvas {
    /// The position on paper, pixels, of a point (x, y) of the chart.
    pub(super) fn place(&self, (x, y): (f64, f64)) -> PaperPoint {
        let [x0, x1, y0, y1] = self.window;
        (self.left + (x - x0) / (x1 - x0) * self.wide, self.top + (y1 - y) / (y1 - y0) * self.high)
    }

    /// Draws both axes with their numbers, and a faint grid. If `logarithmic` is true, the window contains decimal logarithms, and the labels are
    /// powers of ten.
    pub(super) fn draw_axes(&self, paper: &mut Sheet, labels: [&str; 2], logarithmic: bool) {
        let (right, bottom, grid) = (self.left + self.wide, self.top + self.high, GREY.mix(0.2));
        let [x0, x1, y0, y1] = self.window;
        for (number, words) in numbers(x0, x1, logarithmic) {
            let (x, _) = self.place((number, y0));
            paper.line(&[(x, self.top), (x, bottom)], grid, 1.0);
            paper.line(&[(x, bottom), (x, bottom + 5.0)], BLACK, 1.0);
            paper.text((x, bottom + 16.0), &words, CHART.letters, 0.5, BLACK);
        }
        for (number, words) in numbers(y0, y1, logarithmic) {
            let (_, y) = self.place((x0, number));
            paper.line(&[(self.left, y), (right, y)], grid, 1.0);
            paper.line(&[(self.left - 5.0, y), (self.left, y)], BLACK, 1.0);
            paper.text((self.left - 9.0, y), &words, CHART.letters, 1.0, BLACK);
        }
        paper.line(&[(self.left, self.top), (self.left, bottom), (right, bottom)], BLACK, 1.0);
        paper.text((self.left + self.wide / 2.0, bottom + 39.0), labels[0], CHART.letters, 0.5, BLACK);
        paper.text_upwards((self.left - 72.0, self.top + self.high / 2.0), labels[1], CHART.letters, BLACK);
    }
}

/// Round numbers from one end of an axis to the other end, each with its label.
fn numbers(start: f64, end: f64, logarithmic: bool) -> Vec<(f64, String)> {
    // About ten numbers fit along an axis.
    let step = (end - start) / 10.0;
    let step = if logarithmic { step.ceil().max(1.0) } else { round_up(step) };
    let (first, last) = (whole_above(start / step), whole_below(end / step));
    let mut all = Vec::new();
    // An axis never has more than twenty numbers, even if its ends are affected by rounding errors.
    for k in (0..20).map(|k| first + f64::from(k)) {
        if k <= last {
            let number = k * step;
            all.push((number, if logarithmic { power_of_ten(number) } else { in_steps(number, step) }));
        }
    }
    all
}

/// The label of a decade, such as 10⁻³.
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
