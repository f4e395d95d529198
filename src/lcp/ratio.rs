//! Which basic variable blocks the entering one, and who leaves when several do.
//!
//! **Ties.** Symmetric problems tie all the time, and breaking ties by index or size can cycle. The rule here is the
//! lexicographic one (Cottle, Pang & Stone, section 4.9) with a single generic vector p: think of q + ε p with
//! ε → 0+. The perturbed problem has no ties, and its path is found by comparing, among rows that tie, the column of p next.
//! Nothing is added to the data. If z₀ is among the tied it leaves, always: then z₀ = 0, and the point solves the problem.

use super::dictionary::{Dictionary, Unknown, largest};
use super::settings::Settings;

/// The rounding error a value may carry, as a fraction of the largest term that has gone into it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What z₀ is on the path that is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Covering {
    /// To be brought to zero: it leaves as soon as it can.
    Artificial,
    /// The parameter of a family of problems, which may take any value.
    Parameter,
}

/// The row in which a basic variable reaches zero first as the entering one grows; `None` if none ever does.
pub(crate) fn blocking_row(dictionary: &Dictionary, role: Covering, settings: &Settings) -> Option<usize> {
    let size = largest(&dictionary.u).max(dictionary.unit);
    let least = -settings.pivot_tolerance * size;
    let blocks = |row: usize, u: f64| {
        u < least && (role == Covering::Artificial || dictionary.basic[row] != Unknown::Covering)
    };
    let mut step = f64::INFINITY;
    for (row, (x, u)) in dictionary.x.iter().zip(&dictionary.u).enumerate() {
        // Multiplied out, since divisions are slow; u is negative.
        if *u < least && x.max(0.0) < -u * step && blocks(row, *u) {
            step = x.max(0.0) / -u;
        }
    }
    if step == f64::INFINITY {
        return None;
    }
    let mut best: Option<(usize, f64)> = None;
    for (row, u) in dictionary.u.iter().enumerate() {
        let margin = settings.tie_tolerance * (u.abs() * step) + ROUNDING * dictionary.level[row];
        if *u < least && dictionary.x[row].max(0.0) + u * step <= margin && blocks(row, *u) {
            if dictionary.basic[row] == Unknown::Covering {
                return Some(row);
            }
            let ratio = dictionary.p[row] / -u;
            if best.is_none_or(|(_, least)| ratio < least) {
                best = Some((row, ratio));
            }
        }
    }
    best.map(|(row, _)| row)
}

/// The row of the smallest (x_i + ε p_i) / u_i with x_i < 0: there a variable leaves when z₀ enters an infeasible basis.
///
/// `Err(row)` if x_i < 0 but u_i is not positive, so that no z₀ makes that row feasible.
pub(crate) fn most_violated_row(
    dictionary: &Dictionary,
    settings: &Settings,
) -> Result<Option<usize>, usize> {
    let mut least = 0.0_f64;
    for (row, (x, u)) in dictionary.x.iter().zip(&dictionary.u).enumerate() {
        if *x < 0.0 {
            if *u <= 0.0 {
                return Err(row);
            }
            least = least.min(x / u);
        }
    }
    let mut best: Option<(usize, f64)> = None;
    for (row, (x, u)) in dictionary.x.iter().zip(&dictionary.u).enumerate() {
        if *x < 0.0 && *x - least * u <= settings.tie_tolerance * x.abs() {
            let ratio = dictionary.p[row] / u;
            if best.is_none_or(|(_, least)| ratio < least) {
                best = Some((row, ratio));
            }
        }
    }
    Ok(best.map(|(row, _)| row))
}
