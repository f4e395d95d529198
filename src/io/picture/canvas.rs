//! A drawing plane of plotters with round numbers at its axes.

use std::ops::Range;

use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{Cartesian2d, DrawingArea, SVGBackend};

use super::round_numbers::{in_steps, round_up, whole_above, whole_below};

pub(super) type Canvas<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<AxisRange, AxisRange>>;
/// The part of the paper for one chart.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// The result of a drawing call of plotters.
pub(super) type Plotted = Result<(), Box<dyn std::error::Error>>;

/// Magnification while drawing. plotters rounds to whole pixels, so that a chart is drawn larger and shown smaller, with smooth curves.
pub(super) const FINE: u32 = 4;

/// The range of an axis.
pub(super) struct AxisRange {
    coordinates: RangedCoordf64,
    step: f64,
    /// Whether positions on the axis are decimal logarithms; its numbers are then powers of ten.
    logarithmic: bool,
}

impl AxisRange {
    pub(super) fn new(range: Range<f64>, logarithmic: bool) -> Self {
        // About ten numbers fit along an axis.
        let step = (range.end - range.start) / 10.0;
        let step = if logarithmic { step.ceil().max(1.0) } else { round_up(step) };
        Self { coordinates: range.into(), step, logarithmic }
    }
}

impl Ranged for AxisRange {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.coordinates.map(value, limit)
    }

    fn key_points<H: KeyPointHint>(&self, _: H) -> Vec<f64> {
        let Range { start, end } = self.range();
        let first = whole_above(start / self.step);
        // The limit of twenty numbers guards against rounding of the bounds.
        let steps = (0..20).map(|k| first + f64::from(k));
        steps.take_while(|k| *k <= whole_below(end / self.step)).map(|k| k * self.step).collect()
    }

    fn range(&self) -> Range<f64> {
        self.coordinates.range()
    }
}

impl ValueFormatter<f64> for AxisRange {
    fn format_ext(&self, value: &f64) -> String {
        if self.logarithmic { power_of_ten(*value) } else { in_steps(*value, self.step) }
    }
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
