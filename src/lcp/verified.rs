//! Verified solutions: proofs that the given data have an exact solution with a given basis, and bounds on it.
//!
//! For a basis α let A = M_αα and R a computed inverse of it. If G = |I − R A| has a norm below one, A is regular. The exact point z with A z =
//! −q_α is then close to any computed point ẑ (S. M. Rump, *Verification methods*, Acta Numerica 19, 2010):
//!
//! ```text
//! |z − ẑ| ≤ |R r| + G e,     r = −q_α − A ẑ,     e = ‖R r‖ / (1 − ‖G‖)
//! ```
//!
//! The residual r is summed without rounding, and ẑ is the sum of two doubles. Bounds of entries that are not tiny compared with others are
//! therefore as tight as doubles allow. All other rounding widens them.
//!
//! If a z or a w is exactly zero, no bound proves its sign. The proof is then that a row allows no other value, or that two rows are equal or
//! opposite. Otherwise ẑ is tried as a vector of fractions.

use super::basis::Basis;
use super::farkas::cleaned;
use super::problem::Lcp;
use super::scaling::Scaling;
use super::tolerances::{SAFE_BOUND, UNDERFLOW};
use crate::numerics::{ExactSum, matrix_of, vector_of};
use crate::prelude::*;
use core::cmp::Ordering;
use nalgebra::{DMatrix, DVector};

/// Bounds on the exact solution of a problem for a given basis; see [`Lcp::verify`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Verified {
    /// Lower bounds of z (n entries, none negative; zero where z_i is not basic).
    pub lower: DVector<f64>,
    /// Upper bounds of z (n entries).
    pub upper: DVector<f64>,
}

impl Lcp {
    /// Bounds on the exact solution for the given M and q with z_i = 0 outside the basis and w_i = 0 inside it, if one is proved to exist.
    ///
    /// A computed [`Solution`](super::Solution) solves the problem up to its residuals. This is a proof, by interval and exact arithmetic.
    /// `None` means that no proof was found:
    ///
    /// * the block of the basis is singular or close to it,
    /// * some z_i or w_i is negative,
    /// * or one of them is exactly zero, no single row proves it, and the z are not fractions with a small denominator.
    ///
    /// The cost is some 6k³ flops for a basis of k entries, and a few times n k products that are summed without rounding.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    ///
    /// let problem = Lcp::from_rows(&[[2.0, 1.0], [1.0, 2.0]], &[-5.0, -6.0])?;
    /// let outcome = problem.solve();
    /// let solution = outcome.solution().expect("M is positive definite");
    /// let verified = problem.verify(&solution.basis).expect("far from singular");
    /// // z = (4/3, 7/3) lies between neighbouring doubles.
    /// assert!(verified.upper[0] - verified.lower[0] <= 4.0 * f64::EPSILON);
    /// assert!(verified.lower[0] <= solution.z[0] && solution.z[0] <= verified.upper[0]);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    #[must_use]
    pub fn verify(&self, basis: &Basis) -> Option<Verified> {
        let n = self.len();
        if basis.len() != n {
            return None;
        }
        let block = Block::of(self, basis)?;
        let point = block.refined();
        let alpha = &block.columns;
        let mut fractions = DVector::zeros(n);
        for (k, i) in alpha.iter().enumerate() {
            fractions[*i] = point.0[k];
        }
        if let Some(exact) = self.exact_fractions(&fractions, basis) {
            return Some(exact);
        }
        let errors = block.errors(&point)?;
        let mut verified = Verified { lower: DVector::zeros(n), upper: DVector::zeros(n) };
        for (k, i) in alpha.iter().enumerate() {
            let error =
                (errors[k] + point.1[k].abs()) * SAFE_BOUND + point.0[k].abs() * f64::EPSILON + UNDERFLOW;
            verified.lower[*i] = point.0[k] - error;
            verified.upper[*i] = point.0[k] + error;
            // The bound of a sum of two doubles determines a sign more sharply than that of one double.
            if point.0[k] + point.1[k] <= errors[k] * SAFE_BOUND + UNDERFLOW {
                return None;
            }
            verified.lower[*i] = verified.lower[*i].max(0.0);
        }
        let holds = |i: usize| {
            let w = block.row(i, &point).rounded();
            let moved: f64 = alpha.iter().zip(&errors).map(|(j, error)| self.m[(i, *j)].abs() * error).sum();
            w - w.abs() * 4.0 * f64::EPSILON >= moved * SAFE_BOUND + UNDERFLOW
        };
        (0..n).all(|i| basis.contains(i) || holds(i) || self.is_settled(i, alpha)).then_some(verified)
    }

    /// Whether w_i is the same nonnegative number for all z_α that the basis allows.
    ///
    /// It equals q_i if row i has no entries in the columns α. It is zero if row i equals a row of α or its negative, as for the two directions
    /// of a friction force.
    fn is_settled(&self, i: usize, alpha: &[usize]) -> bool {
        let alike = |j: usize, sign: f64| {
            self.q[i] == sign * self.q[j] && alpha.iter().all(|k| self.m[(i, *k)] == sign * self.m[(j, *k)])
        };
        self.q[i] >= 0.0 && alpha.iter().all(|j| self.m[(i, *j)] == 0.0)
            || alpha.iter().any(|j| alike(*j, -1.0) || alike(*j, 1.0))
    }

    /// The solution as fractions p / D with a common denominator D, if z has such entries up to rounding. Summed without rounding, M p + q D
    /// must be zero for rows in the basis and nonnegative for the others.
    fn exact_fractions(&self, z: &DVector<f64>, basis: &Basis) -> Option<Verified> {
        let n = self.len();
        // The denominator D is appended as the entry that corresponds to 1.
        let with_one = z.clone().insert_row(n, 1.0);
        let holds = |p: &DVector<f64>| {
            p.iter().all(|p| p.is_finite() && *p >= 0.0)
                && p[n] > 0.0
                && (0..n).all(|i| {
                    let row = (0..n).map(|j| (self.m[(i, j)], p[j])).chain([(self.q[i], p[n])]);
                    let sign = ExactSum::of_products(row).sign();
                    if basis.contains(i) { sign == Ordering::Equal } else { sign != Ordering::Less }
                })
        };
        let p = cleaned(&with_one).find(holds)?;
        let bound = |outwards: f64| vector_of(n, &|i| p[i] / p[n] * (1.0 + outwards * f64::EPSILON));
        Some(Verified { lower: bound(-1.0), upper: bound(1.0) })
    }
}

/// The block of a basis, balanced by powers of two, with its computed inverse. It omits each z_j that a single row with q_i = 0 forces to zero,
/// and that row.
struct Block<'a> {
    lcp: &'a Lcp,
    rows: Vec<usize>,
    columns: Vec<usize>,
    inverse: DMatrix<f64>,
    a: DMatrix<f64>,
    scaling: Scaling,
}

/// A point as the sum of two doubles for each entry.
type Twice = (DVector<f64>, DVector<f64>);

impl<'a> Block<'a> {
    fn of(lcp: &'a Lcp, basis: &Basis) -> Option<Self> {
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = basis.iter().map(|i| (i, i)).unzip();
        // If a row with q_i = 0 has only one entry, the z of that entry is zero.
        let vanishes = |rows: &[usize], columns: &[usize]| {
            rows.iter().enumerate().filter(|(_, i)| lcp.q[**i] == 0.0).find_map(|(at, i)| {
                let mut entries = columns.iter().enumerate().filter(|(_, j)| lcp.m[(*i, **j)] != 0.0);
                let (only, _) = entries.next()?;
                entries.next().is_none().then_some((at, only))
            })
        };
        while let Some((row, column)) = vanishes(&rows, &columns) {
            rows.swap_remove(row);
            columns.swap_remove(column);
        }
        let size = columns.len();
        let block = matrix_of(size, size, &|i, j| lcp.m[(rows[i], columns[j])]);
        let mut scaling = Scaling::default();
        scaling.balance(size, block.as_slice(), &vec![0.0; size]);
        let a = matrix_of(size, size, &|i, j| block[(i, j)] * scaling.row[i] * scaling.column[j]);
        // Powers of two cause no rounding unless the result is subnormal.
        let kept = |i: usize, j: usize| {
            let halfway = block[(i, j)] * scaling.row[i];
            block[(i, j)] == 0.0 || halfway.is_normal() && a[(i, j)].is_normal()
        };
        if !(0..size).all(|i| (0..size).all(|j| kept(i, j))) {
            return None;
        }
        let inverse = if size == 0 { a.clone() } else { a.clone().lu().try_inverse()? };
        Some(Self { lcp, rows, columns, inverse, a, scaling })
    }

    /// The exact sum q_i + M_iα z.
    fn row(&self, i: usize, point: &Twice) -> ExactSum {
        let mut sum = ExactSum::of_products([(self.lcp.q[i], 1.0)]);
        for (k, j) in self.columns.iter().enumerate() {
            sum.add_product(self.lcp.m[(i, *j)], point.0[k]);
            sum.add_product(self.lcp.m[(i, *j)], point.1[k]);
        }
        sum
    }

    /// The residual −q_α − M_αα z in balanced rows, each rounded once.
    fn residual(&self, point: &Twice) -> DVector<f64> {
        vector_of(self.columns.len(), &|k| -self.row(self.rows[k], point).rounded_in(self.scaling.row[k]))
    }

    /// The refinement step for a residual, in the caller's units.
    fn step(&self, residual: &DVector<f64>) -> DVector<f64> {
        let balanced = &self.inverse * residual;
        vector_of(residual.len(), &|k| balanced[k] * self.scaling.column[k])
    }

    fn refined(&self) -> Twice {
        let size = self.columns.len();
        let mut point = (DVector::zeros(size), DVector::zeros(size));
        // Each step gains some digits, up to the precision of two doubles.
        for _ in 0..4 {
            let step = self.step(&self.residual(&point));
            for i in 0..size {
                // The pair is renormalised: the second double holds what the first one cannot.
                let rest = point.1[i] + step[i];
                let high = point.0[i] + rest;
                point.1[i] = rest - (high - point.0[i]);
                point.0[i] = high;
            }
        }
        point
    }

    /// Bounds on |z − ẑ|, in the caller's units; `None` if the block may be singular.
    fn errors(&self, point: &Twice) -> Option<DVector<f64>> {
        let size = self.columns.len();
        let rounding = (size as f64 + 4.0) * f64::EPSILON;
        let product = &self.inverse * &self.a;
        let sizes = self.inverse.abs() * self.a.abs();
        // Row sums of G, including the rounding of the product.
        let g = vector_of(size, &|i| {
            let row = (0..size).map(|j| {
                (product[(i, j)] - f64::from(u8::from(i == j))).abs() + rounding * sizes[(i, j)] + UNDERFLOW
            });
            row.sum::<f64>() * SAFE_BOUND
        });
        let norm = g.iter().fold(0.0_f64, |norm, g| norm.max(*g));
        if !norm.is_finite() || norm >= 0.5 {
            return None;
        }
        let residual = self.residual(point);
        // Each residual is rounded once, each sum of the product k times.
        let first = self.inverse.abs() * residual.abs() * rounding + (&self.inverse * &residual).abs();
        let most =
            (first.iter().fold(0.0_f64, |most, e| most.max(*e)) + UNDERFLOW) / (1.0 - norm) * SAFE_BOUND;
        let error =
            |i: usize| (first[i] + g[i] * most + UNDERFLOW) * SAFE_BOUND * self.scaling.column[i] + UNDERFLOW;
        let errors = vector_of(size, &|i| error(i));
        errors.iter().all(|e| e.is_finite()).then_some(errors)
    }
}
