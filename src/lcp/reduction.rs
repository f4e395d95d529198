//! Elimination of free variables by pivoting.

use super::problem::Lcp;
use super::scaling::Scaling;
use super::solution::Solution;
use super::tolerances::{DEPENDENT_EQUALITY, FREE_PIVOT};
use crate::numerics::{Each, IntoList, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// The tableau after every free variable that has a pivot was made basic.
pub(super) struct Reduction {
    /// The remaining complementarity problem, in balanced units. `None` if its numbers are not finite, a dependent equality is not satisfied, or
    /// a free variable without a pivot still affects some w_i.
    pub(super) problem: Option<Lcp>,
    /// For each pair, whether its roles are exchanged: w_i is then the unknown of the remaining problem.
    pub(super) swapped: Vec<bool>,
    /// Free variables without a pivot.
    pub(super) undetermined: Vec<usize>,
    /// Equality rows without a pivot.
    pub(super) dependent: Vec<usize>,
    free: usize,
    tableau: DMatrix<f64>,
    constant: DVector<f64>,
    /// For each free variable the row in which it is basic.
    row_of_free: Vec<Option<usize>>,
    row_of_pair: Vec<usize>,
    column_of_pair: Vec<usize>,
    scaling: Scaling,
}

impl Reduction {
    /// Eliminates the first `free` unknowns of a problem whose first `free` rows are equalities.
    pub(super) fn of(whole: &Lcp, free: usize) -> Self {
        let size = whole.len();
        let n = size - free;
        let mut scaling = Scaling::default();
        scaling.balance(size, whole.m.as_slice(), whole.q.as_slice());
        let (tableau, constant) = scaling.balanced(&whole.m, &whole.q);
        let mut out = Self {
            problem: None,
            swapped: vec![false; n],
            undetermined: Vec::new(),
            dependent: Vec::new(),
            free,
            tableau,
            constant,
            row_of_free: vec![None; free],
            row_of_pair: (free..size).list(),
            column_of_pair: (free..size).list(),
            scaling,
        };
        let mut rows: Vec<usize> = (0..free).list();
        let mut columns: Vec<usize> = (0..free).list();
        while !columns.is_empty()
            && (out.pivot_direct(&mut rows, &mut columns) || out.pivot_pair(&mut rows, &mut columns))
        {
        }
        let noise = DEPENDENT_EQUALITY * (1.0 + out.constant.amax());
        let consistent = rows.iter().all(|r| {
            out.constant[*r].abs() <= noise
                && out.column_of_pair.iter().all(|c| out.tableau[(*r, *c)].abs() <= FREE_PIVOT)
        });
        // A free variable that affects some w_i cannot simply be set to zero.
        let idle =
            columns.iter().all(|c| out.row_of_pair.iter().all(|r| out.tableau[(*r, *c)].abs() <= FREE_PIVOT));
        out.undetermined = columns;
        out.dependent = rows;
        if consistent && idle {
            let m = matrix_of(n, n, &|i, j| out.tableau[(out.row_of_pair[i], out.column_of_pair[j])]);
            let q = vector_of(n, &|i| out.constant[out.row_of_pair[i]]);
            out.problem = Lcp::new(m, q).ok();
        }
        out
    }

    /// Powers of two that balance the rows.
    pub(super) fn row_factors(&self) -> &[f64] {
        &self.scaling.row
    }

    /// Makes a free variable basic in an equality row. Returns whether a pivot was found.
    fn pivot_direct(&mut self, rows: &mut Vec<usize>, columns: &mut Vec<usize>) -> bool {
        let places = (0..rows.len()).flat_map(|a| (0..columns.len()).map(move |b| (a, b)));
        let sizes = places.map(|(a, b)| ((a, b), self.tableau[(rows[a], columns[b])].abs()));
        let Some((a, b)) = largest_pivot(sizes) else { return false };
        let (r, c) = (rows.swap_remove(a), columns.swap_remove(b));
        self.exchange(r, c);
        self.row_of_free[c] = Some(r);
        self.tableau.column_mut(c).fill(0.0);
        true
    }

    /// Makes a free variable basic in the row of some w_i, and z_i basic in an equality row. Returns whether both pivots were found.
    fn pivot_pair(&mut self, rows: &mut Vec<usize>, columns: &mut Vec<usize>) -> bool {
        let (height, width) = (rows.len(), columns.len());
        let pairs = 0..self.swapped.len();
        let places = pairs.flat_map(|p| (0..height).flat_map(move |a| (0..width).map(move |b| (p, a, b))));
        let sizes = places.map(|(pair, a, b)| {
            let (r_pair, c_pair) = (self.row_of_pair[pair], self.column_of_pair[pair]);
            let sizes = [(r_pair, columns[b]), (rows[a], c_pair)].each(|at| self.tableau[at].abs());
            ((pair, a, b), sizes[0].min(sizes[1]))
        });
        let Some((pair, a, b)) = largest_pivot(sizes) else { return false };
        let (r, c) = (rows.swap_remove(a), columns.swap_remove(b));
        let (r_pair, c_pair) = (self.row_of_pair[pair], self.column_of_pair[pair]);
        // The first exchange makes u basic in place of w_i, so that column c belongs to w_i. The second makes z_i basic in the equality row r.
        self.exchange(r_pair, c);
        self.exchange(r, c_pair);
        self.tableau.column_mut(c_pair).fill(0.0);
        self.row_of_free[c] = Some(r_pair);
        self.row_of_pair[pair] = r;
        self.column_of_pair[pair] = c;
        self.swapped[pair] = !self.swapped[pair];
        true
    }

    /// Exchanges the variable of row r with that of column c.
    fn exchange(&mut self, r: usize, c: usize) {
        let size = self.constant.len();
        let inverse = 1.0 / self.tableau[(r, c)];
        for j in (0..size).filter(|j| *j != c) {
            let factor = -self.tableau[(r, j)] * inverse;
            if factor != 0.0 {
                for i in (0..size).filter(|i| *i != r) {
                    let add = self.tableau[(i, c)] * factor;
                    self.tableau[(i, j)] += add;
                }
            }
            self.tableau[(r, j)] = factor;
        }
        let factor = -self.constant[r] * inverse;
        for i in (0..size).filter(|i| *i != r) {
            self.constant[i] += self.tableau[(i, c)] * factor;
        }
        self.constant[r] = factor;
        for i in (0..size).filter(|i| *i != r) {
            self.tableau[(i, c)] *= inverse;
        }
        self.tableau[(r, c)] = inverse;
    }

    /// Converts a solution of the remaining problem to (u, z) in the caller's units.
    pub(super) fn point(&self, solution: &Solution) -> Vec<f64> {
        let n = self.swapped.len();
        let mut point = vec![0.0; self.free + n];
        for (u, row) in self.row_of_free.iter().enumerate() {
            if let Some(r) = *row {
                let sum: f64 =
                    (0..n).map(|j| self.tableau[(r, self.column_of_pair[j])] * solution.z[j]).sum();
                point[u] = (sum + self.constant[r]) * self.scaling.column[u];
            }
        }
        for i in 0..n {
            let z = if self.swapped[i] { solution.w[i] } else { solution.z[i] };
            point[self.free + i] = z * self.scaling.column[self.free + i];
        }
        point
    }
}

/// The first position with the largest size; `None` unless that size exceeds [`FREE_PIVOT`].
fn largest_pivot<P>(sizes: impl Iterator<Item = (P, f64)>) -> Option<P> {
    let mut best = (None, FREE_PIVOT);
    for (place, size) in sizes {
        if size > best.1 {
            best = (Some(place), size);
        }
    }
    best.0
}
