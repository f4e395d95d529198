//! Which basic variable blocks the entering one, and who leaves when several do.
//!
//! **Ties.** Symmetric problems tie all the time, and breaking ties by index or size can cycle. The rule here is the
//! lexicographic one (Cottle, Pang & Stone, section 4.9) with a single generic vector p: think of q + ε p with
//! ε → 0+. The perturbed problem has no ties, and its path is found by comparing, among rows that tie, the column of p next.
//! Nothing is added to the data. If z₀ is among the tied it leaves, always: then z₀ = 0, and the point solves the problem.

use super::dictionary::{Dictionary, Variable};
use super::settings::Settings;

/// The row in which a basic variable reaches zero first as the entering one grows; `None` if none ever does.
pub(crate) fn blocking_row(dictionary: &Dictionary, settings: &Settings) -> Option<usize> {
    let size = dictionary.u.iter().fold(dictionary.unit, |size, u| size.max(u.abs()));
    let least = -settings.pivot_tolerance * size;
    let mut step = f64::INFINITY;
    for (x, u) in dictionary.x.iter().zip(&dictionary.u) {
        if *u < least {
            step = step.min(x.max(0.0) / -u);
        }
    }
    if step == f64::INFINITY {
        return None;
    }
    let mut best: Option<(usize, f64)> = None;
    for (row, u) in dictionary.u.iter().enumerate() {
        let margin = settings.tie_tolerance * dictionary.level[row].max(u.abs() * step);
        if *u < least && dictionary.x[row].max(0.0) + u * step <= margin {
            if dictionary.basic[row] == Variable::Covering {
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

/// The row of the smallest (q_i + ε p_i) / d_i with q_i < 0: there w_i leaves when z₀ enters the slack basis.
///
/// `Err(i)` if q_i < 0 but d_i is not positive, so that no z₀ makes row i feasible.
pub(crate) fn most_violated_row(
    dictionary: &Dictionary,
    settings: &Settings,
) -> Result<Option<usize>, usize> {
    let mut least = 0.0_f64;
    for (row, (x, d)) in dictionary.x.iter().zip(&dictionary.u).enumerate() {
        if *x < 0.0 {
            if *d <= 0.0 {
                return Err(row);
            }
            least = least.min(x / d);
        }
    }
    let mut best: Option<(usize, f64)> = None;
    for (row, (x, d)) in dictionary.x.iter().zip(&dictionary.u).enumerate() {
        if *x < 0.0 && *x - least * d <= settings.tie_tolerance * x.abs() {
            let ratio = dictionary.p[row] / d;
            if best.is_none_or(|(_, least)| ratio < least) {
                best = Some((row, ratio));
            }
        }
    }
    Ok(best.map(|(row, _)| row))
}
