//! Round numbers for rings, levels and labels.

/// A number this close to a round one (in steps) counts as that round one. Steps are quotients and powers with errors of about 1e-15, and a billionth
/// of a step is invisible. With zero, rounding alone would add a ring or a level.
const NEARLY: f64 = 1e-9;
/// Steps in this range are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-4..1e6;
/// Most digits after the point.
const MOST_DIGITS: f64 = 12.0;

/// The largest whole number not above x.
pub(super) fn whole_below(x: f64) -> f64 {
    (x + NEARLY).floor()
}

/// The least whole number not below x.
pub(super) fn whole_above(x: f64) -> f64 {
    (x - NEARLY).ceil()
}

/// The least round number (1, 2 or 5 times a power of ten) not below a positive one.
pub(super) fn round_up(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps
        .into_iter()
        .map(|step| step * power)
        .find(|rounded| *rounded >= x * (1.0 - NEARLY))
        .unwrap_or(10.0 * power)
}

/// The largest round number (1, 2 or 5 times a power of ten) not above a positive one.
pub(super) fn round_down(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [10.0, 5.0, 2.0, 1.0];
    steps.into_iter().map(|step| step * power).find(|rounded| *rounded <= x * (1.0 + NEARLY)).unwrap_or(x)
}

/// A number that is a multiple of `step`, with no more digits than the step needs.
pub(super) fn in_steps(x: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let digits = (-step.log10() - NEARLY).ceil().clamp(0.0, MOST_DIGITS) as usize;
    without_minus_zero(if PLAIN.contains(&step) { format!("{x:.digits$}") } else { format!("{x:.1e}") })
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
