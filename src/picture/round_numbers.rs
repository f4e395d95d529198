//! Round numbers for rings, levels and labels.

/// A number this close to a round one is that round one: steps are quotients and powers with errors
/// of some 1e-15, and nobody sees a billionth of a step. Without it a ring or a level more would be
/// drawn for rounding alone.
const NEARLY: f64 = 1e-9;
/// Steps that are written without an exponent, and the most digits that are written for one.
const PLAIN: std::ops::Range<f64> = 1e-4..1e6;
const MOST_DIGITS: f64 = 12.0;

/// The largest whole number not above a number.
pub(super) fn whole_below(x: f64) -> f64 {
    (x + NEARLY).floor()
}

/// The least whole number not below a number.
pub(super) fn whole_above(x: f64) -> f64 {
    (x - NEARLY).ceil()
}

/// A round number, 1, 2 or 5 times a power of ten, not below a positive one.
pub(super) fn round_up(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps
        .into_iter()
        .map(|step| step * power)
        .find(|rounded| *rounded >= x * (1.0 - NEARLY))
        .unwrap_or(10.0 * power)
}

/// A round number, 1, 2 or 5 times a power of ten, not above a positive one.
pub(super) fn round_down(x: f64) -> f64 {
    let power = 10f64.powf(x.log10().floor());
    let steps = [10.0, 5.0, 2.0, 1.0];
    steps.into_iter().map(|step| step * power).find(|rounded| *rounded <= x * (1.0 + NEARLY)).unwrap_or(x)
}

/// A number that is a few steps, with no more digits than the step needs.
pub(super) fn in_steps(x: f64, step: f64) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let digits = (-step.log10() - NEARLY).ceil().clamp(0.0, MOST_DIGITS) as usize;
    without_minus_zero(if PLAIN.contains(&step) { format!("{x:.digits$}") } else { format!("{x:.1e}") })
}

/// A number that was rounded to zero has no sign.
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
