//! Lemke's method.
//!
//! The augmented problem w = q + M z + d z₀ is followed along the path of points with w_i z_i = 0 for all i, from
//! z = 0 with large z₀ to z₀ = 0 (Cottle, Pang & Stone, algorithm 4.4.5): the variable driven next is always
//! the complement of the one that left last.

use super::basis::Basis;
use super::dictionary::{Dictionary, Variable};
use super::outcome::{BreakdownCause, Outcome, Ray, Solution};
use super::ratio::{blocking_row, most_violated_row};
use super::residuals::{Residuals, residuals_from, slack_and_terms};
use super::scaling::{Scaling, power_of_two};
use super::settings::Settings;
use nalgebra::{DMatrix, DVector};

/// Values below this fraction of the largest term they were computed from are zero.
const ZERO: f64 = 1e-13;

/// Solves (M, q); the sizes match and all entries are finite.
pub(crate) fn solve(m: &DMatrix<f64>, q: &DVector<f64>, settings: &Settings) -> Outcome {
    let n = q.len();
    if q.iter().all(|q| *q >= 0.0) {
        return finish(m, q, &Basis::slack(n), &vec![false; n], 0, settings);
    }
    let mut scaling = Scaling::default();
    scaling.balance(n, m.as_slice());
    let scaled: Vec<f64> = q.iter().zip(&scaling.row).map(|(q, row)| q * power_of_two(*row)).collect();
    let d = match covering(q, &scaling, settings) {
        Ok(d) => d,
        Err(cause) => return Outcome::Breakdown { pivots: 0, cause },
    };
    let p: Vec<f64> = scaling.row_unit.iter().enumerate().map(|(i, unit)| unit * generic(i)).collect();
    let mut dictionary = Dictionary::default();
    dictionary.reset(&scaled, &p, &d);

    let mut entering = Variable::Covering;
    let mut pivots = 0;
    loop {
        if pivots >= settings.pivot_limit(n) {
            return Outcome::PivotLimit { pivots };
        }
        dictionary.enter(entering, m.as_slice(), &scaling);
        if dictionary.x.iter().chain(&dictionary.u).any(|x| !x.is_finite()) {
            return Outcome::Breakdown { pivots, cause: BreakdownCause::Overflow };
        }
        let blocking = if entering == Variable::Covering {
            match most_violated_row(&dictionary, settings) {
                Ok(blocking) => blocking,
                Err(row) => {
                    let value = settings.covering.as_ref().and_then(|d| d.get(row)).copied().unwrap_or(0.0);
                    return Outcome::Breakdown {
                        pivots,
                        cause: BreakdownCause::CoveringEntry { row, value },
                    };
                }
            }
        } else {
            blocking_row(&dictionary, settings)
        };
        let Some(row) = blocking else {
            return Outcome::Ray(ray(&dictionary, entering, &scaling, pivots));
        };
        let leaving = dictionary.pivot(entering, row);
        pivots += 1;
        if leaving == Variable::Covering {
            break;
        }
        entering = leaving.complement();
    }
    let zero = |(x, level): (&f64, &f64)| *x <= ZERO * level;
    let mut vanishing = vec![false; n];
    let mut alpha = Vec::new();
    for (row, basic) in dictionary.basic.iter().enumerate() {
        let (Variable::Slack(i) | Variable::Unknown(i)) = *basic else { continue };
        vanishing[i] = zero((&dictionary.x[row], &dictionary.level[row]));
        if let Variable::Unknown(i) = *basic {
            alpha.push(i);
        }
    }
    finish(m, q, &Basis::from_indices(n, alpha), &vanishing, pivots, settings)
}

/// The covering vector in balanced rows.
fn covering(q: &DVector<f64>, scaling: &Scaling, settings: &Settings) -> Result<Vec<f64>, BreakdownCause> {
    let Some(d) = &settings.covering else {
        return Ok(scaling.row_unit.clone());
    };
    if d.len() != q.len() {
        return Err(BreakdownCause::CoveringLength { given: d.len(), needed: q.len() });
    }
    for (row, (d, q)) in d.iter().zip(q).enumerate() {
        if !(d.is_finite() && *d >= 0.0) || (*q < 0.0 && *d == 0.0) {
            return Err(BreakdownCause::CoveringEntry { row, value: *d });
        }
    }
    Ok(d.iter().zip(&scaling.row).map(|(d, row)| d * power_of_two(*row)).collect())
}

/// Entry i of a fixed vector without structure, between 1/2 and 3/2 (the mixing function of splitmix64).
fn generic(i: usize) -> f64 {
    let mut x = (i as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^= x >> 31;
    0.5 + (x >> 11) as f64 / (1_u64 << 53) as f64
}

/// The direction in which the entering variable grows for ever, in the caller's units, with largest entry 1.
fn ray(dictionary: &Dictionary, entering: Variable, scaling: &Scaling, pivots: usize) -> Ray {
    let n = dictionary.u.len();
    let mut direction = DVector::zeros(n);
    let mut covering_rate = 0.0;
    if let Variable::Unknown(e) = entering {
        direction[e] = power_of_two(scaling.column[e]);
    }
    for (basic, u) in dictionary.basic.iter().zip(&dictionary.u) {
        match *basic {
            Variable::Unknown(i) => direction[i] = u.max(0.0) * power_of_two(scaling.column[i]),
            Variable::Covering => covering_rate = u.max(0.0),
            Variable::Slack(_) => {}
        }
    }
    let size = direction.amax();
    if size > 0.0 && size.is_finite() {
        direction /= size;
        covering_rate /= size;
    }
    Ray { direction, covering_rate, pivots }
}

/// Computes the point of a basis from the M and q given, refines it and says "solved" only if the residuals do.
fn finish(
    m: &DMatrix<f64>,
    q: &DVector<f64>,
    basis: &Basis,
    vanishing: &[bool],
    pivots: usize,
    settings: &Settings,
) -> Outcome {
    let n = q.len();
    let alpha: Vec<usize> = basis.iter().collect();
    // A basic variable which is zero in exact arithmetic comes out as noise. Leaving it out is best if the smaller
    // block is regular; if not, only negative noise is cut off.
    let support: Vec<usize> = alpha.iter().copied().filter(|i| !vanishing[*i]).collect();
    let mut best: Option<Candidate> = None;
    for indices in [&support, &alpha] {
        if let Some(candidate) = Candidate::new(m, q, indices) {
            let better = best.as_ref().is_none_or(|best| candidate.residuals.max() < best.residuals.max());
            if better {
                best = Some(candidate);
            }
        }
        if best.as_ref().is_some_and(|best| best.residuals.max() <= ZERO) {
            break;
        }
    }
    let Some(Candidate { z, mut w, terms, residuals }) = best else {
        return Outcome::Breakdown { pivots, cause: BreakdownCause::SingularBasis };
    };
    if residuals == Residuals::UNUSABLE {
        return Outcome::Breakdown { pivots, cause: BreakdownCause::Overflow };
    }
    if residuals.max().is_nan() || residuals.max() > settings.residual_tolerance {
        return Outcome::Breakdown { pivots, cause: BreakdownCause::Residual(residuals) };
    }
    let mut degenerate = false;
    for i in 0..n {
        if basis.contains(i) {
            w[i] = 0.0;
            degenerate |= z[i] == 0.0;
        } else {
            degenerate |= w[i] <= ZERO * terms[i];
            w[i] = w[i].max(0.0);
        }
    }
    Outcome::Solved(Solution { z, w, basis: basis.clone(), residuals, pivots, degenerate })
}

/// The point of a basis, and how well it solves the problem.
struct Candidate {
    z: DVector<f64>,
    w: DVector<f64>,
    terms: Vec<f64>,
    residuals: Residuals,
}

impl Candidate {
    fn new(m: &DMatrix<f64>, q: &DVector<f64>, support: &[usize]) -> Option<Self> {
        let n = q.len();
        let basic = principal_solution(m, q, support)?;
        let mut z = DVector::zeros(n);
        for (i, value) in support.iter().zip(&basic) {
            z[*i] = value.max(0.0);
        }
        let mut w = DVector::zeros(n);
        let mut terms = vec![0.0; n];
        slack_and_terms(m, q.as_slice(), z.as_slice(), w.as_mut_slice(), &mut terms);
        let residuals = residuals_from(m, z.as_slice(), w.as_slice(), &terms);
        Some(Self { z, w, terms, residuals })
    }
}

/// Solves M_αα z_α = −q_α by row-equilibrated LU with complete pivoting and two steps of refinement.
fn principal_solution(m: &DMatrix<f64>, q: &DVector<f64>, alpha: &[usize]) -> Option<DVector<f64>> {
    let k = alpha.len();
    if k == 0 {
        return Some(DVector::zeros(0));
    }
    let exponent = |size: f64| if size > 0.0 && size.is_finite() { -size.log2().round() } else { 0.0 };
    let mut block = DMatrix::from_fn(k, k, |i, j| m[(alpha[i], alpha[j])]);
    let mut row = vec![1.0; k];
    let mut column = vec![1.0; k];
    for i in 0..k {
        row[i] = exponent(block.row(i).amax()).exp2();
        block.row_mut(i).scale_mut(row[i]);
    }
    for j in 0..k {
        column[j] = exponent(block.column(j).amax()).exp2();
        block.column_mut(j).scale_mut(column[j]);
    }
    let rhs = DVector::from_fn(k, |i, _| -row[i] * q[alpha[i]]);
    let lu = block.clone().full_piv_lu();
    let mut y = lu.solve(&rhs)?;
    for _ in 0..2 {
        let defect = &rhs - &block * &y;
        y += lu.solve(&defect)?;
    }
    Some(DVector::from_fn(k, |j, _| y[j] * column[j]))
}
