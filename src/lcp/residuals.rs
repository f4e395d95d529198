//! The residuals of a point z, computed from the given M and q. The problem is 0 ≤ z ⟂ w = M z + q ≥ 0.

use super::tolerances::{BACKWARD_ERROR, FAINT_ROW, LOST, residual_rounding};
use crate::numerics::{Each, ExactSum, Reals, every_index, times_power_of_two};
use core::fmt;
use nalgebra::DMatrix;

/// Residuals of 0 ≤ z ⟂ w = M z + q ≥ 0 at a point z, without units.
///
/// Row i is measured relative to the magnitude of its terms, a_i = |q_i| + Σ_j |M_ij| |z_j| (W. Oettli and W. Prager, Numer. Math. 6, 1964). An
/// entry z_j is measured by its largest contribution to any row, s_j = max_i |M_ij| |z_j| / a_i.
///
/// Both measures are independent of the units of rows, columns and the whole problem. A row without terms (a_i = 0) is satisfied exactly.
///
/// A z_j ≠ 0 whose column of M is zero has s_j = 1, since no change of the rows could compensate it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Residuals {
    /// How negative entries of z are: max_j s_j over the j with z_j < 0. s_j is the largest contribution of z_j to a row, relative to the terms of
    /// this row.
    pub negative_z: f64,
    /// How negative slacks are: max_i −w_i / a_i over the i with w_i < 0. a_i is the magnitude of the terms of w_i.
    pub negative_w: f64,
    /// Violation of z_i w_i = 0: max_i min(max(w_i, 0) / a_i, s_i) over the i with z_i > 0. a_i is the magnitude of the terms of w_i. s_i is the
    /// largest contribution of z_i to a row, relative to the terms of this row.
    pub complementarity: f64,
}

impl Residuals {
    /// The largest of the three residuals; NaN if any of them is NaN.
    #[must_use]
    pub fn max(&self) -> f64 {
        let all = self.all();
        if all.iter().any(|r| r.is_nan()) { f64::NAN } else { all.into_iter().most() }
    }

    /// Whether all three residuals are at most `tolerance`; false if one is NaN.
    #[must_use]
    pub fn within(&self, tolerance: f64) -> bool {
        self.all().iter().all(|r| *r <= tolerance)
    }

    fn all(&self) -> [f64; 3] {
        [self.negative_z, self.negative_w, self.complementarity]
    }

    /// Infinite residuals, which exceed every tolerance.
    pub(super) const UNUSABLE: Self =
        Self { negative_z: f64::INFINITY, negative_w: f64::INFINITY, complementarity: f64::INFINITY };
}

impl fmt::Display for Residuals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "residuals up to {:.1e}", self.max())
    }
}

/// Whether a point with these residuals also solves, up to rounding, a problem with a very different q. It does so, for example, if z is so large
/// that q vanishes beside M z. Such a point does not count as a solution. `terms` holds a_i = |q_i| + Σ_j |M_ij| |z_j| for each row i, and `row` the
/// factors, powers of two, that balance the rows.
pub(super) fn ignores_q(residuals: Residuals, q: &[f64], terms: &[f64], row: &[f64]) -> bool {
    let balanced = |v: &[f64]| v.iter().zip(row).fold(0.0_f64, |size, (v, row)| size.max(v.abs() * row));
    let missed = residuals.max();
    if missed > residual_rounding(q.len()) && missed * balanced(terms) > BACKWARD_ERROR * balanced(q) {
        return true;
    }
    q.iter().any(|q| *q != 0.0) && every_index(q.len(), &|i| is_lost(q[i], terms[i]))
}

/// Whether q_i is so small beside the terms of row i of M z + q that rounding may hide it: at most the fraction [`LOST`], 1e-11, of their magnitude
/// `terms`.
fn is_lost(q: f64, terms: f64) -> bool {
    q.abs() <= LOST * terms
}

/// Computes w = M z + q from the columns with z_j ≠ 0, and a_i = |q_i| + Σ_j |M_ij| |z_j|.
pub(super) fn slack_and_terms(m: &DMatrix<f64>, q: &[f64], z: &[f64], w: &mut [f64], terms: &mut [f64]) {
    w.copy_from_slice(q);
    for (a, q) in terms.iter_mut().zip(q) {
        *a = q.abs();
    }
    let n = q.len();
    if n == 0 {
        return;
    }
    // Four columns of M, each times its z_j, are added at a time.
    let column = |j: usize| &m.as_slice()[j * n..(j + 1) * n];
    let mut support = z.iter().enumerate().filter(|(_, z)| **z != 0.0).map(|(j, z)| (j, *z));
    while let Some(first) = support.next() {
        let [b, c, d] = [support.next(), support.next(), support.next()];
        if let (Some(b), Some(c), Some(d)) = (b, c, d) {
            add_four([first, b, c, d].each(|(j, z)| (column(j), z)), w, terms);
        } else {
            for (j, z) in [Some(first), b, c, d].into_iter().flatten() {
                for ((w, a), m) in w.iter_mut().zip(terms.iter_mut()).zip(column(j)) {
                    let product = m * z;
                    *w += product;
                    *a += product.abs();
                }
            }
        }
    }
}

fn add_four(columns: [(&[f64], f64); 4], w: &mut [f64], terms: &mut [f64]) {
    let n = w.len();
    let [(a, za), (b, zb), (c, zc), (d, zd)] = columns;
    let (a, b, c, d, terms) = (&a[..n], &b[..n], &c[..n], &d[..n], &mut terms[..n]);
    for i in 0..n {
        let (a, b, c, d) = (a[i] * za, b[i] * zb, c[i] * zc, d[i] * zd);
        w[i] += (a + b) + (c + d);
        terms[i] += (a.abs() + b.abs()) + (c.abs() + d.abs());
    }
}

/// The residuals at z, computed from w = M z + q and from the magnitudes a_i of its terms.
pub(super) fn residuals_from(m: &DMatrix<f64>, q: &[f64], z: &[f64], w: &[f64], terms: &[f64]) -> Residuals {
    let n = z.len();
    let mut out = Residuals { negative_z: 0.0, negative_w: 0.0, complementarity: 0.0 };
    if n == 0 {
        return out;
    }
    if !([z, w, terms].iter().all(|list| list.iter().all(|x| x.is_finite()))) {
        return Residuals::UNUSABLE;
    }
    let rows = Rows { m, q, z, terms };
    for (i, ((&z, &w), column)) in z.iter().zip(w).zip(m.as_slice().chunks_exact(n)).enumerate() {
        let slack = rows.relative_slack(i, w);
        out.negative_w = out.negative_w.max(-slack);
        if z == 0.0 || (z > 0.0 && slack <= out.complementarity) {
            continue;
        }
        let enough = if z > 0.0 { slack } else { f64::INFINITY };
        let contribution = rows.largest_contribution(column, z, enough);
        if z < 0.0 {
            out.negative_z = out.negative_z.max(contribution);
        } else {
            out.complementarity = out.complementarity.max(slack.min(contribution));
        }
    }
    out
}

/// The rows of M z + q at a point z, with the magnitudes of their terms.
struct Rows<'a> {
    m: &'a DMatrix<f64>,
    q: &'a [f64],
    z: &'a [f64],
    terms: &'a [f64],
}

impl Rows<'_> {
    /// The relative slack w_i / a_i, with the magnitude a_i of the terms of w_i; zero in a row without terms.
    fn relative_slack(&self, i: usize, w: f64) -> f64 {
        let a = self.terms[i];
        if a >= FAINT_ROW {
            return w / a;
        }
        self.exact_terms(i).map_or(0.0, |a| ratio(&ExactSum::of_products(self.products(i)), &a))
    }

    /// The largest contribution of an entry z_j to a row, s_j = max_i |M_ij| |z_j| / a_i, where a_i is the magnitude of the terms of row i. The
    /// search stops at the first contribution that reaches `enough`.
    fn largest_contribution(&self, column: &[f64], z: f64, enough: f64) -> f64 {
        let mut contribution = None;
        for (i, (m, a)) in column.iter().zip(self.terms).enumerate() {
            if *m == 0.0 {
                continue;
            }
            let part = if *a >= FAINT_ROW {
                m.abs() * z.abs() / a
            } else {
                let Some(a) = self.exact_terms(i) else { continue };
                ratio(&ExactSum::of_products([(m.abs(), z.abs())]), &a)
            };
            let largest = contribution.unwrap_or(0.0_f64).max(part);
            if largest >= enough {
                return largest;
            }
            contribution = Some(largest);
        }
        contribution.unwrap_or(1.0)
    }

    /// The pairs of factors whose products sum to w_i: M_ij and z_j for each j, then q_i and 1.
    fn products(&self, i: usize) -> impl Iterator<Item = (f64, f64)> + Clone + '_ {
        let &Self { m, q, z, .. } = self;
        z.iter().enumerate().map(move |(j, z)| (m[(i, j)], *z)).chain([(q[i], 1.0)])
    }

    /// The exact magnitude a_i of the terms of row i; `None` for a row without terms.
    fn exact_terms(&self, i: usize) -> Option<ExactSum> {
        let sizes = self.products(i).map(|(a, b)| (a.abs(), b.abs()));
        sizes.clone().any(|(a, b)| a > 0.0 && b > 0.0).then(|| ExactSum::of_products(sizes))
    }
}

/// The quotient of two exact sums, each of which may lie outside the range of doubles.
fn ratio(sum: &ExactSum, of: &ExactSum) -> f64 {
    let ((x, k), (y, l)) = (sum.leading(), of.leading());
    times_power_of_two(x / y, k - l)
}
