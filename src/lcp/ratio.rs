//! The ratio test of a pivot: which basic variable reaches zero first (blocks) as the entering variable increases, and the choice if several do so at
//! once. Noise is a value that rounding alone may have produced.
//!
//! **Ties.** Symmetric problems have ties at almost every step, and if they are broken by index or by magnitude, the path may cycle. The rule used
//! here is the lexicographic rule (Cottle, Pang & Stone, section 4.9). It follows the path of the problem with q + ε p in place of q, where ε → 0+
//! and the vector p has irregular entries. This perturbed problem has no ties. Its path is found by comparing entries of p among rows that tie; q is
//! not changed.
//!
//! z₀ is the covering variable of w = q + M z + d z₀. If z₀ is among the tied variables, it leaves, since the point with z₀ = 0 solves the problem.

use super::dictionary::{Dictionary, LemkeVariable, largest};
use super::settings::Settings;
use crate::numerics::tolerances::ROUNDED_SUM;
use crate::numerics::{Loop, Reals, wide};

/// The role of the covering variable z₀ on a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Covering {
    /// z₀ is an artificial variable of Lemke's method and must become zero: it leaves the basis as soon as it can.
    Artificial,
    /// z₀ is the parameter of a family of problems, and may have any value.
    Parameter,
}

/// The row whose basic variable reaches zero first as the entering variable increases; `None` if no basic variable ever reaches zero. If the
/// covering variable z₀ is `Artificial` and reaches zero together with others, the row of z₀ is returned. If z₀ is a `Parameter`, its row never
/// blocks.
///
/// u is the entering column: the change of each basic variable per unit of the entering variable. p is the perturbation that breaks ties. Only rows
/// with u_i < −`noise` are considered. Among tied rows, rows with u_i < −`certain` are preferred, and among the preferred rows the row with the
/// smallest p_i / −u_i is chosen.
pub(super) fn blocking_row(
    dictionary: &Dictionary,
    noise: f64,
    certain: f64,
    role: Covering,
    settings: &Settings,
) -> Option<usize> {
    let least = -noise;
    // The parameter z₀ of a family of problems may have any sign, so its row does not block the entering variable.
    let exempt = if role == Covering::Parameter {
        dictionary.basic.iter().position(|basic| *basic == LemkeVariable::Covering)
    } else {
        None
    };
    let step = match exempt {
        None => wide(ShortestStep { x: &dictionary.x, u: &dictionary.u, least }),
        Some(row) => {
            let before = wide(ShortestStep { x: &dictionary.x[..row], u: &dictionary.u[..row], least });
            before.min(wide(ShortestStep { x: &dictionary.x[row + 1..], u: &dictionary.u[row + 1..], least }))
        }
    };
    if step == f64::INFINITY {
        return None;
    }
    let mut best: Option<(usize, bool, f64)> = None;
    let blocks = |x: f64, u: f64, term_size: f64| {
        let margin = settings.tie_tolerance * (u.abs() * step) + ROUNDED_SUM * term_size;
        (u < least) & (if x > 0.0 { x } else { 0.0 } + u * step <= margin)
    };
    // Blocking rows are rare, so eight rows are first tested together without a branch for each.
    let n = dictionary.u.len();
    let (x, u, term_sizes) = (&dictionary.x[..n], &dictionary.u[..n], &dictionary.term_sizes[..n]);
    for start in (0..n).step_by(8) {
        let end = n.min(start + 8);
        let mut any = end - start < 8;
        if !any {
            let (x, u, term_sizes) =
                (&x[start..start + 8], &u[start..start + 8], &term_sizes[start..start + 8]);
            for lane in 0..8 {
                any |= blocks(x[lane], u[lane], term_sizes[lane]);
            }
        }
        if !any {
            continue;
        }
        for row in start..end {
            let u = dictionary.u[row];
            if blocks(dictionary.x[row], u, dictionary.term_sizes[row]) && exempt != Some(row) {
                if dictionary.basic[row] == LemkeVariable::Covering {
                    return Some(row);
                }
                let doubtful = u >= -certain;
                let ratio = dictionary.p[row] / -u;
                if best.is_none_or(|(_, doubt, least)| (doubtful, ratio) < (doubt, least)) {
                    best = Some((row, doubtful, ratio));
                }
            }
        }
    }
    best.map(|(row, ..)| row)
}

/// The row `firm` limits the step of the entering variable. Returns whether this step makes the value of a doubtful row negative. u_i is the change
/// of the basic variable of row i per unit of the entering variable. Row i is doubtful if −`certain` ≤ u_i < 0: u_i may then be noise.
///
/// A value counts as negative only beyond rounding: beyond its own rounding error, or the rounding error of the largest value. If no value becomes
/// negative, a doubtful row that blocks earlier may be ignored.
pub(super) fn doubtful_row_breaks(
    dictionary: &Dictionary,
    certain: f64,
    firm: usize,
    role: Covering,
) -> bool {
    let size = largest(&dictionary.x);
    let step = dictionary.x[firm].max(0.0) / -dictionary.u[firm];
    let values = dictionary.x.iter().zip(&dictionary.u).zip(&dictionary.term_sizes).zip(&dictionary.basic);
    values.into_iter().any(|(((x, u), term_size), basic)| {
        let exempt = role == Covering::Parameter && *basic == LemkeVariable::Covering;
        let doubtful = *u < 0.0 && *u >= -certain && !exempt;
        doubtful && x.max(0.0) + u * step < -ROUNDED_SUM * term_size.max(size)
    })
}

/// The shortest step of the entering variable: min x_i / −u_i over the rows with u_i < `least`. x_i is the value of the basic variable of row i
/// (negative x_i count as 0), and u_i its change per unit step. `least` is zero or negative: a u_i between `least` and zero may be noise, so
/// that row i does not count.
///
/// The loop has no branches. If it had, a processor would predict many of them wrongly.
struct ShortestStep<'a> {
    x: &'a [f64],
    u: &'a [f64],
    least: f64,
}

impl Loop for ShortestStep<'_> {
    type Output = f64;

    #[inline(always)]
    fn run(self) -> f64 {
        let ratio = |x: f64, u: f64| {
            let ratio = if x > 0.0 { x } else { 0.0 } / -u;
            if u < self.least { ratio } else { f64::INFINITY }
        };
        let mut lanes = [f64::INFINITY; 8];
        let mut xs = self.x.chunks_exact(8);
        let mut us = self.u.chunks_exact(8);
        for (x, u) in (&mut xs).zip(&mut us) {
            for lane in 0..8 {
                let ratio = ratio(x[lane], u[lane]);
                lanes[lane] = if ratio < lanes[lane] { ratio } else { lanes[lane] };
            }
        }
        for (x, u) in xs.remainder().iter().zip(us.remainder()) {
            lanes[0] = lanes[0].min(ratio(*x, *u));
        }
        lanes.into_iter().least()
    }
}

/// The row with the smallest (x_i + ε p_i) / u_i among the rows with x_i < 0, for ε → 0+. x_i is the value of the basic variable, u_i its change per
/// unit of z₀, and p_i the perturbation that breaks ties. The variable of this row leaves when z₀ enters an infeasible basis. `Ok(None)` if no x_i is
/// negative.
///
/// `Err(row)` if x_i < 0 but u_i is not positive: then no z₀ makes that row feasible.
pub(super) fn most_violated_row(
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
