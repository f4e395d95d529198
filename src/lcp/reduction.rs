//! Eliminating free variables by pivoting.

use super::outcome::Solution;
use super::problem::Lcp;
use super::scaling::Scaling;
use super::tolerances::{DEPENDENT, FREE_PIVOT};
use nalgebra::{DMatrix, DVector};

/// The tableau after all free variables that can be were made basic.
pub(crate) struct Reduction {
    /// The complementarity problem that is left, in balanced units; `None` if its numbers are not finite or an equality
    /// that depends on the others is not satisfied.
    pub(crate) problem: Option<Lcp>,
    /// The pairs that changed their roles: there the problem's unknown is w_i.
    pub(crate) swapped: Vec<bool>,
    /// Free variables without a pivot.
    pub(crate) undetermined: Vec<usize>,
    /// Equality rows without a pivot.
    pub(crate) dependent: Vec<usize>,
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
    /// Eliminates the first `free` unknowns of 0 = …, w = M z + q, whose first `free` rows are equalities.
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
            row_of_pair: (free..size).collect(),
            column_of_pair: (free..size).collect(),
            scaling,
        };
        let mut rows: Vec<usize> = (0..free).collect();
        let mut columns: Vec<usize> = (0..free).collect();
        while !columns.is_empty()
            && (out.pivot_direct(&mut rows, &mut columns) || out.pivot_pair(&mut rows, &mut columns))
        {
        }
        let noise = DEPENDENT * (1.0 + out.constant.amax());
        let consistent = rows.iter().all(|r| {
            out.constant[*r].abs() <= noise
                && out.column_of_pair.iter().all(|c| out.tableau[(*r, *c)].abs() <= FREE_PIVOT)
        });
        // A free variable that still acts on some w_i cannot be set to zero.
        let idle =
            columns.iter().all(|c| out.row_of_pair.iter().all(|r| out.tableau[(*r, *c)].abs() <= FREE_PIVOT));
        out.undetermined = columns;
        out.dependent = rows;
        if consistent && idle {
            let m = DMatrix::from_fn(n, n, |i, j| out.tableau[(out.row_of_pair[i], out.column_of_pair[j])]);
            let q = DVector::from_fn(n, |i, _| out.constant[out.row_of_pair[i]]);
            out.problem = Lcp::new(m, q).ok();
        }
        out
    }

    /// A free variable takes the place of an equality row.
    fn pivot_direct(&mut self, rows: &mut Vec<usize>, columns: &mut Vec<usize>) -> bool {
        let mut best = (0, 0, FREE_PIVOT);
        for (a, r) in rows.iter().enumerate() {
            for (b, c) in columns.iter().enumerate() {
                let size = self.tableau[(*r, *c)].abs();
                if size > best.2 {
                    best = (a, b, size);
                }
            }
        }
        if best.2 <= FREE_PIVOT {
            return false;
        }
        let (r, c) = (rows.swap_remove(best.0), columns.swap_remove(best.1));
        self.exchange(r, c);
        self.row_of_free[c] = Some(r);
        self.tableau.column_mut(c).fill(0.0);
        true
    }

    /// A free variable takes the place of w_i, and z_i that of an equality row.
    fn pivot_pair(&mut self, rows: &mut Vec<usize>, columns: &mut Vec<usize>) -> bool {
        let mut best = (0, 0, 0, FREE_PIVOT);
        for (pair, (r_pair, c_pair)) in self.row_of_pair.iter().zip(&self.column_of_pair).enumerate() {
            for (a, r) in rows.iter().enumerate() {
                for (b, c) in columns.iter().enumerate() {
                    let size = self.tableau[(*r_pair, *c)].abs().min(self.tableau[(*r, *c_pair)].abs());
                    if size > best.3 {
                        best = (pair, a, b, size);
                    }
                }
            }
        }
        if best.3 <= FREE_PIVOT {
            return false;
        }
        let pair = best.0;
        let (r, c) = (rows.swap_remove(best.1), columns.swap_remove(best.2));
        let (r_pair, c_pair) = (self.row_of_pair[pair], self.column_of_pair[pair]);
        // First u for w_i: column c then belongs to w_i. Then z_i for the equality: row r belongs to z_i.
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

    /// (u, z) in the caller's units from a solution of the problem that is left.
    pub(crate) fn point(&self, solution: &Solution) -> Vec<f64> {
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
