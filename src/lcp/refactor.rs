//! Recomputation of dictionaries from M, q and d of w = q + M z + d z₀: measurement of drift by rounding, refactorisation of the current basis, and
//! factorisation of another basis. A dictionary is the condensed tableau of one basis. d is the covering vector, z₀ the covering variable. Rows and
//! columns of M are balanced: scaled by powers of two, so that nonzero entries lie near 1. A perturbation p breaks ties of the ratio test as if the
//! right-hand side were q + ε p with ε → 0+.

use super::dictionary::{LemkeVariable, largest};
use super::memory::refill;
use super::outcome::BreakdownCause;
use super::path::LemkePath;
use super::scaling::Scaling;
use super::tolerances::{DRIFT_FLOOR, ELIMINATED_PIVOT};
use crate::numerics::{IntoList, add_times, generic};

impl LemkePath {
    /// Drift of the basic values, which rounding causes from pivot to pivot. It is the largest violation of w = q + M z + d z₀ in any row, relative
    /// to a reference of this row. The reference is the magnitude of the terms of the row plus [`DRIFT_FLOOR`] (1e-3) times the largest |q_i|. If
    /// nothing were added, rows whose terms are all rounding errors would have a large drift.
    pub(super) fn drift(&mut self, m: &[f64]) -> f64 {
        self.compute_defect(m);
        let floor = DRIFT_FLOOR * largest(&self.q);
        self.defect
            .iter()
            .zip(&self.terms)
            .fold(0.0, |drift, (r, a)| r.abs().max(drift * (a + floor)) / (a + floor))
    }

    /// Computes the defect q + M z + d z₀ − w of the current values, row by row. Also computes the magnitude of the terms of each row of the
    /// defect, to which its rounding error is proportional.
    fn compute_defect(&mut self, m: &[f64]) {
        self.defect.clone_from(&self.q);
        self.terms.clear();
        self.q.iter().map(|q| q.abs()).append_to(&mut self.terms);
        let Self { dictionary, scaling, d, defect, terms, .. } = self;
        add_basic_columns(defect, terms, (&dictionary.basic, &dictionary.x), d, scaling, m);
    }

    /// One step of refinement of the entering column u. Let A_v be the column of a variable v in q + M z + d z₀ − w, and e the entering variable. The
    /// step is computed from the defect A_e + Σ A_v u_v, where the sum runs over the basic variables v.
    ///
    /// Returns the larger of two relative corrections: |Δu_r| / |u_r| in the given row, and max |Δu| / max |u|.
    pub(super) fn refine_column(&mut self, entering: LemkeVariable, row: usize, m: &[f64]) -> f64 {
        let n = self.q.len();
        let Self { dictionary, scaling, d, defect, terms, .. } = self;
        refill(defect, n, 0.0);
        refill(terms, n, 0.0);
        add_column(defect, terms, (entering, 1.0), d, scaling, m);
        add_basic_columns(defect, terms, (&dictionary.basic, &dictionary.u), d, scaling, m);
        dictionary.effect(defect, terms);
        add_times(&mut dictionary.u, terms, 1.0);
        (terms[row] / dictionary.u[row]).abs().max(largest(terms) / largest(&dictionary.u))
    }

    /// Recomputes the dictionary of the current basis from M, q and d, by elimination with row pivoting. Then computes the column of the entering
    /// variable.
    pub(super) fn refactor(&mut self, entering: LemkeVariable, m: &[f64]) -> Result<(), BreakdownCause> {
        self.members.clear();
        refill(&mut self.saved, 2 * self.q.len() + 1, 0.0);
        for (row, basic) in self.dictionary.basic.iter().enumerate() {
            self.saved[index(*basic, self.q.len())] = self.dictionary.p[row];
            if !matches!(basic, LemkeVariable::W(_)) {
                self.members.push(*basic);
            }
        }
        self.leaving.clear();
        self.leaving.extend((0..self.q.len()).filter(|i| self.dictionary.is_active(*i)));
        self.install(m)?;
        for row in 0..self.q.len() {
            self.dictionary.p[row] = self.saved[index(self.dictionary.basic[row], self.q.len())];
        }
        self.dictionary.enter(entering, m, &self.scaling);
        Ok(())
    }

    /// Computes from M, q and d the dictionary in which the variables in the field `members` are basic. The slacks of the rows in the field `leaving`
    /// are nonbasic, all other slacks basic. The error is [`BreakdownCause::SingularBasis`], if a pivot does not exceed its rounding error.
    fn install(&mut self, m: &[f64]) -> Result<(), BreakdownCause> {
        self.start_from_slacks();
        for member in 0..self.members.len() {
            let member = self.members[member];
            self.dictionary.enter(member, m, &self.scaling);
            let mut best = (0, 0.0);
            for (position, row) in self.leaving.iter().enumerate() {
                let u = self.dictionary.u[*row].abs();
                if u > best.1 {
                    best = (position, u);
                }
            }
            if best.1.is_nan() || best.1 <= ELIMINATED_PIVOT * self.dictionary.source_size() {
                return Err(BreakdownCause::SingularBasis);
            }
            let row = self.leaving.remove(best.0);
            self.dictionary.exchange(member, row);
        }
        self.compute_defect(m);
        self.correct();
        Ok(())
    }

    /// Corrects the values of the basic variables for the defect q + M z + d z₀ − w that was computed last. Also recomputes `term_sizes`, to which
    /// the rounding errors of these values are proportional, from the magnitudes of the terms of that defect.
    pub(super) fn correct(&mut self) {
        self.dictionary.sum_terms(&self.terms);
        let mut effect = core::mem::take(&mut self.terms);
        self.dictionary.effect(&self.defect, &mut effect);
        add_times(&mut self.dictionary.x, &effect, 1.0);
        self.terms = effect;
    }

    /// Recomputes the values of the basic variables from the right-hand side q, and `term_sizes`, the magnitudes of the terms of these values.
    pub(super) fn recompute_values(&mut self) {
        let mut x = core::mem::take(&mut self.dictionary.x);
        self.dictionary.effect(&self.q, &mut x);
        self.dictionary.x = x;
        self.dictionary.sum_terms(&self.q);
    }

    /// Prepares the covering variable z₀ to enter the current complementary basis. A row is violated if its basic value is below −`noise` times the
    /// magnitude of its terms. Returns whether there are such rows.
    ///
    /// In the dictionary, the column of z₀ gets an entry near 1 in each violated row and 0 in the others. d becomes the covering vector that has this
    /// column.
    pub(super) fn cover_violations(&mut self, m: &[f64], noise: f64) -> bool {
        let n = self.q.len();
        let dictionary = &mut self.dictionary;
        refill(&mut self.d, n, 0.0);
        let mut violated = false;
        for row in 0..n {
            // `unit` is the entry of the column of z₀ in a violated row. It would be 1 if rows and columns were balanced by exact factors. Since the
            // factors are rounded to powers of two, `unit` corrects this rounding, and lies between 1/√2 and √2.
            let unit = match dictionary.basic[row] {
                LemkeVariable::W(i) => self.scaling.row_unit[i],
                LemkeVariable::Z(j) => self.scaling.column_unit(j),
                LemkeVariable::Covering => 1.0,
            };
            // The entry of the perturbation p in a row is chosen by the row's basic variable, not by the row's position, which depends on rounding.
            dictionary.p[row] = unit * generic(index(dictionary.basic[row], n));
            dictionary.u[row] = 0.0;
            if dictionary.x[row] >= -noise * dictionary.term_sizes[row] {
                dictionary.x[row] = dictionary.x[row].max(0.0);
                continue;
            }
            violated = true;
            dictionary.u[row] = unit;
            match dictionary.basic[row] {
                LemkeVariable::W(i) => self.d[i] += unit,
                LemkeVariable::Z(j) => {
                    let column = m[j * n..(j + 1) * n].iter().zip(&self.scaling.row);
                    for (d, (m, row)) in self.d.iter_mut().zip(column) {
                        *d -= m * row * self.scaling.column[j] * unit;
                    }
                }
                LemkeVariable::Covering => {}
            }
        }
        dictionary.d.clone_from(&self.d);
        violated
    }

    /// Makes z₀ the parameter of the right-hand sides q + z₀ d and computes the column of z₀. The caller gives the vector d in the units of the
    /// caller's M, before its rows are balanced.
    pub(super) fn start_parameter(&mut self, d: &[f64], m: &[f64]) {
        self.d.clear();
        d.iter().zip(&self.scaling.row).map(|(d, row)| d * row).append_to(&mut self.d);
        self.dictionary.d.clone_from(&self.d);
        self.dictionary.enter(LemkeVariable::Covering, m, &self.scaling);
    }

    /// Computes the dictionary of a complementary basis: of each pair, z_i is basic if `active(i)` is true, otherwise w_i. An error means that the
    /// basis is singular.
    pub(super) fn install_basis(
        &mut self,
        m: &[f64],
        active: &dyn Fn(usize) -> bool,
    ) -> Result<(), BreakdownCause> {
        self.leaving.clear();
        self.leaving.extend((0..self.q.len()).filter(|i| active(*i)));
        self.members.clear();
        self.leaving.iter().map(|i| LemkeVariable::Z(*i)).append_to(&mut self.members);
        self.install(m)
    }
}

fn index(variable: LemkeVariable, n: usize) -> usize {
    match variable {
        LemkeVariable::W(i) => i,
        LemkeVariable::Z(i) => n + i,
        LemkeVariable::Covering => 2 * n,
    }
}

/// Adds to `sum` the columns of all basic variables in q + M z + d z₀ − w, each times the number given for its row. Adds the magnitudes of these
/// products to `terms`, to which the rounding error of `sum` is proportional.
fn add_basic_columns(
    sum: &mut [f64],
    terms: &mut [f64],
    (basic, numbers): (&[LemkeVariable], &[f64]),
    d: &[f64],
    scaling: &Scaling,
    m: &[f64],
) {
    for (variable, x) in basic.iter().zip(numbers) {
        add_column(sum, terms, (*variable, *x), d, scaling, m);
    }
}

/// Adds the column of one variable, times a number, to `sum`, and the magnitudes of these products to `terms`, to which the rounding error of `sum`
/// is proportional.
fn add_column(
    sum: &mut [f64],
    terms: &mut [f64],
    (variable, x): (LemkeVariable, f64),
    d: &[f64],
    scaling: &Scaling,
    m: &[f64],
) {
    let n = sum.len();
    match variable {
        LemkeVariable::W(i) => {
            sum[i] -= x;
            terms[i] += x.abs();
        }
        LemkeVariable::Covering => add_with_terms(sum, terms, d.iter().map(|d| d * x)),
        LemkeVariable::Z(j) => {
            let factor = scaling.column[j] * x;
            let column = m[j * n..(j + 1) * n].iter().zip(&scaling.row);
            add_with_terms(sum, terms, column.map(|(m, row)| m * row * factor));
        }
    }
}

fn add_with_terms(sum: &mut [f64], terms: &mut [f64], column: impl Iterator<Item = f64>) {
    for ((s, a), c) in sum.iter_mut().zip(terms).zip(column) {
        *s += c;
        *a += c.abs();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_that_has_drifted_is_put_right() {
        // A matrix of irregular entries without structure; the added 3 keeps its diagonal large.
        let m: Vec<f64> =
            (0..36).map(|k| f64::from(k + 1).sin() + if k % 7 == 0 { 3.0 } else { 0.0 }).collect();
        let mut path = LemkePath::default();
        path.prepare(&m, &[1.0, -2.0, 3.0, -1.0, 0.5, 2.0]);
        path.install_basis(&m, &|i| i % 2 == 0).expect("regular");
        for entering in [LemkeVariable::Z(1), LemkeVariable::W(2)] {
            path.dictionary.enter(entering, &m, &path.scaling);
            let sound = path.dictionary.u.clone();
            assert!(path.refine_column(entering, 4, &m) < 1e-15);
            path.dictionary.u[4] *= 1.0 + 1e-5;
            let correction = path.refine_column(entering, 4, &m);
            assert!((correction - 1e-5).abs() < 1e-9, "{correction}");
            let miss = path.dictionary.u.iter().zip(&sound).map(|(u, sound)| (u - sound).abs());
            assert!(miss.fold(0.0, f64::max) < 1e-15);
        }
    }
}
