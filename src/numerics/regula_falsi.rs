//! The argument at which a function of one variable changes sign, by regula falsi with the rule of Illinois.
//!
//! The secant through both ends of a bracket crosses zero at the next argument, which replaces one end. If the same end is replaced twice in a row,
//! the value stored for the other end is halved. Thus both ends approach the root. Near the root, three evaluations reduce the error to about its
//! cube (order of convergence three).
//!
//! Source: Dowell and Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11, 1971.

use super::tolerances::FEW_ROUNDINGS;

/// The root of a function that is positive below the root and negative above it. The bracket has one argument below the root and one above it, each
/// with its function value. The returned argument is above the root. Its function value is between `-2 within` and zero, unless the bracket has
/// shrunk to rounding before; `within` is the caller's tolerance for the value. If a value is infinite, the bracket is bisected. `None` if a value is
/// NaN, or after a hundred evaluations.
pub(crate) fn regula_falsi(
    [mut low, mut high]: [(f64, f64); 2],
    within: f64,
    value: &mut dyn FnMut(f64) -> f64,
) -> Option<f64> {
    let (mut reached, mut last) = (high.1, None);
    // At most a hundred evaluations. Bisection alone would need some fifty; secants rarely need ten.
    for _ in 0..100 {
        if reached >= -2.0 * within || high.0 - low.0 <= FEW_ROUNDINGS * high.0.abs() {
            return Some(high.0);
        }
        let secant = low.0 + (high.0 - low.0) * ((low.1 + within) / (low.1 - high.1));
        let to = if secant > low.0 && secant < high.0 { secant } else { 0.5 * (low.0 + high.0) };
        let there = value(to);
        if there.is_nan() {
            return None;
        }
        let is_beyond = there <= 0.0;
        let (moved, kept) = if is_beyond { (&mut high, &mut low) } else { (&mut low, &mut high) };
        *moved = (to, there);
        kept.1 *= if last == Some(is_beyond) { 0.5 } else { 1.0 };
        reached = if is_beyond { there } else { reached };
        last = Some(is_beyond);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The root that is found, and the number of evaluations.
    fn found(from: [f64; 2], within: f64, value: impl Fn(f64) -> f64) -> (Option<f64>, usize) {
        let mut count = 0;
        let root = regula_falsi(from.map(|x| (x, value(x))), within, &mut |x| {
            count += 1;
            value(x)
        });
        (root, count)
    }

    #[test]
    fn ends_just_beyond_the_root() {
        for power in [2, 3, 9] {
            let (root, count) = found([0.0, 3.0], 1e-14, |x| 2.0 - x.powi(power));
            let left = root.map(|root| 2.0 - root.powi(power));
            assert!(
                left.is_some_and(|left| (-2e-14..=0.0).contains(&left)) && count <= 25,
                "{left:?} {count}"
            );
        }
    }

    #[test]
    fn halves_a_bracket_where_values_jump_or_are_infinite() {
        let jump = |x: f64| if x < 0.3 { f64::INFINITY } else { -1.0 };
        let (root, count) = found([0.0, 1.0], 0.0, jump);
        assert!(
            root.is_some_and(|root| (0.0..2e-16).contains(&(root - 0.3))) && count < 60,
            "{root:?} {count}"
        );
        assert_eq!(found([0.0, 1.0], 0.0, |x| if x == 0.5 { f64::NAN } else { 0.5 - x }).0, None);
    }
}
