//! Numbers, directions and names as people read them.

use std::fmt;

use nalgebra::SVector;

/// Digits that a person reads.
const DIGITS: usize = 6;
/// A direction this close to an axis is called by its name.
const ALONG_AN_AXIS: f64 = 1e-6;
/// What is this small beside the largest of some numbers is rounding.
const ROUNDING: f64 = 1e-9;

/// Names in a row: "left, right and thumb".
pub(crate) fn listed<T: fmt::Display>(names: &[T]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [one] => one.to_string(),
        [first @ .., last] => {
            let first: Vec<_> = first.iter().map(ToString::to_string).collect();
            format!("{} and {last}", first.join(", "))
        }
    }
}

/// "−z", or the components.
pub(crate) fn along<const C: usize>(direction: &SVector<f64, C>) -> String {
    let (axis, sign) = (direction.iamax(), if direction[direction.iamax()] < 0.0 { "−" } else { "+" });
    let mut across = *direction;
    across[axis] = 0.0;
    if across.norm() <= ALONG_AN_AXIS * direction.norm() {
        format!("{sign}{}", ["x", "y", "z"][axis])
    } else {
        numbers(direction.as_slice())
    }
}

/// Numbers in brackets; what is rounding beside the largest is zero.
pub(crate) fn numbers(components: &[f64]) -> String {
    let largest = components.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let clean = |x: &f64| if x.abs() <= ROUNDING * largest { number(0.0) } else { number(*x) };
    format!("({})", components.iter().map(clean).collect::<Vec<_>>().join(", "))
}

/// A length in mm, or in m from 0.1 m on.
pub(crate) fn length(metres: f64) -> String {
    if metres < 0.1 { format!("{} mm", number(1e3 * metres)) } else { format!("{} m", number(metres)) }
}

/// A number with six digits, without zeros behind them, and without a minus before zero.
pub(crate) fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let magnitude = x.abs().log10().floor();
    if !(-4.0..9.0).contains(&magnitude) {
        let text = format!("{x:.*e}", DIGITS - 1);
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    let decimals = (DIGITS as f64 - 1.0 - magnitude).max(0.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 9")]
    let text = format!("{x:.*}", decimals as usize);
    trimmed(&text).to_owned()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
