//! Round numbers for rings, levels and labels.

use crate::numerics::tolerances::NEGLIGIBLE;

/// The largest whole number not above x. If x is below a whole number by a rounding error only, this whole number.
pub(super) fn whole_below(x: f64) -> f64 {
    (x + NEGLIGIBLE).floor()
}

/// The least whole number not below x. If x is above a whole number by a rounding error only, this whole number.
pub(super) fn whole_above(x: f64) -> f64 {
    (x - NEGLIGIBLE).ceil()
}

/// The least round number (1, 2 or 5 times a power of ten) that is not below the positive number x.
pub(super) fn round_up(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps
        .into_iter()
        .map(|step| step * power)
        .find(|rounded| *rounded >= x * (1.0 - NEGLIGIBLE))
        .unwrap_or(10.0 * power)
}

/// The largest round number (1, 2 or 5 times a power of ten) that is not above the positive number x.
pub(super) fn round_down(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [10.0, 5.0, 2.0, 1.0];
    steps.into_iter().map(|step| step * power).find(|rounded| *rounded <= x * (1.0 + NEGLIGIBLE)).unwrap_or(x)
}

/// A multiple of `step` as text, with no more digits than the step needs.
pub(super) fn in_steps(x: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let digits = (-step.log10() - NEGLIGIBLE).ceil().clamp(0.0, 12.0) as usize;
    without_minus_zero(if (1e-4..1e6).contains(&step) { format!("{x:.digits$}") } else { format!("{x:.1e}") })
}

/// Removes the sign of a number that was rounded to zero.
pub(super) fn without_minus_zero(written: String) -> String {
    match written.strip_prefix('-') {
        Some(size)
            if size.split('e').next().is_some_and(|digits| digits.chars().all(|c| "0.".contains(c))) =>
        {
            size.to_owned()
        }
        _ => written,
    }
}
