//! The colour bands of a map. The map shows a value for every direction in space. A band is a range of this value with a colour of its own. A level
//! is a value at which one band ends and the next begins.

use super::palette::Rgb;
use super::round_numbers::{in_steps, round_up, whole_above, whole_below};
use crate::numerics::IntoList;

/// Levels of a map, with one colour for the band between two neighbouring levels. The levels are evenly spaced round numbers. There is one exception:
/// the smallest value of the map is positive, and the largest is more than four times the smallest. The levels are then preferred numbers, spaced in
/// roughly equal ratios.
pub(super) struct Bands {
    /// Lower ends of the bands, and the upper end of the last band.
    pub(super) levels: Vec<f64>,
    /// Spacing of the levels, which determines the number of digits in their labels; `None` if levels are spaced in ratios.
    step: Option<f64>,
}

/// Approximate largest number of bands. With many more, the colours of neighbouring bands would hardly differ.
const MOST_BANDS: f64 = 12.0;
/// Preferred numbers (ISO 3): ten, five, three and one per decade.
const PREFERRED_NUMBERS: [&[f64]; 4] = [
    &[1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0],
    &[1.0, 1.6, 2.5, 4.0, 6.3],
    &[1.0, 2.0, 5.0],
    &[1.0],
];

/// Evenly spaced colours of matplotlib's colormap "viridis". Their brightness increases along the list, so that colour-blind readers see the order,
/// too.
const VIRIDIS: [Rgb; 8] = [
    Rgb(68, 1, 84),
    Rgb(70, 50, 127),
    Rgb(54, 92, 141),
    Rgb(39, 127, 143),
    Rgb(31, 162, 136),
    Rgb(74, 194, 110),
    Rgb(160, 219, 57),
    Rgb(254, 232, 37),
];

impl Bands {
    /// Bands for a map whose finite values lie between `low` and `high`.
    pub(super) fn new(low: f64, high: f64) -> Self {
        if low > 0.0 && high > 4.0 * low { Self::in_ratios(low, high) } else { Self::even(low, high) }
    }

    fn even(low: f64, high: f64) -> Self {
        let width = if high > low { high - low } else { high.abs().max(f64::MIN_POSITIVE) };
        let step = round_up(width / MOST_BANDS);
        let first = whole_below(low / step);
        let count = (whole_above(high / step) - first).clamp(1.0, 2.0 * MOST_BANDS);
        let levels = (0..=100).map(f64::from).take_while(|k| *k <= count).map(|k| (first + k) * step);
        Self { levels: levels.list(), step: Some(step) }
    }

    fn in_ratios(low: f64, high: f64) -> Self {
        let decades = (high / low).log10();
        let enough = |series: &&&[f64]| series.len() as f64 * decades <= MOST_BANDS + 2.0;
        let series = PREFERRED_NUMBERS.iter().find(enough).unwrap_or(&PREFERRED_NUMBERS[3]);
        let mut levels = Vec::new();
        let mut decade = 10f64.powf(low.log10().floor());
        while levels.last().is_none_or(|last| *last < high) {
            for number in *series {
                let level = number * decade;
                // The largest level that does not exceed the lowest value becomes the first level.
                if level <= low {
                    levels.clear();
                }
                if levels.last().is_none_or(|last| *last < high) {
                    levels.push(level);
                }
            }
            decade *= 10.0;
        }
        Self { levels, step: None }
    }

    pub(super) fn count(&self) -> usize {
        self.levels.len() - 1
    }

    /// The number that varies linearly between neighbouring directions of the map: `value` itself, or the logarithm of `value` if levels are spaced
    /// in ratios.
    pub(super) fn measure(&self, value: f64) -> f64 {
        if self.step.is_some() { value } else { value.ln() }
    }

    pub(super) fn label(&self, level: f64) -> String {
        match self.step {
            Some(step) => in_steps(level, step),
            // Six digits after the point show a preferred number in this range completely.
            None if (1e-3..1e5).contains(&level) => {
                format!("{level:.6}").trim_end_matches('0').trim_end_matches('.').to_owned()
            }
            None => format!("{level:.2e}"),
        }
    }

    pub(super) fn color(&self, band: usize) -> Rgb {
        let last = (self.count() - 1).max(1) as f64;
        let place = band as f64 / last * (VIRIDIS.len() - 1) as f64;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "among the colours")]
        let below = (place as usize).min(VIRIDIS.len() - 2);
        VIRIDIS[below].towards(VIRIDIS[below + 1], place - below as f64)
    }
}
