//! The condensed tableau and its pivot.
//!
//! Lemke's method solves w = q + M z + d z₀ with a covering vector d and a covering variable z₀. Rows and columns are balanced: scaled by powers of
//! two, so that nonzero entries of M lie near 1. Every basis gives a *dictionary*
//!
//! ```text
//! basic = x + Σ over the nonbasic variables v of D_v · v.
//! ```
//!
//! Entry r of x is the value of the basic variable of row r while all nonbasic variables are zero. Entry r of D_v is its change per unit of v. Ties
//! between rows are broken as if q were q + ε p, with a fixed vector p and ε → 0+.
//!
//! Only the columns D_v of nonbasic slacks v = w_i are stored. A slack w_i enters the equations exactly like −q_i, so all other columns follow
//! from these. The column of a nonbasic z_e is the effect of adding column e of M to q,
//!
//! ```text
//! D_e = (M_ie on the rows where w_i is basic, 0 elsewhere)
//!       − Σ over the nonbasic w_i of M_ie D_{w_i},                          (1)
//! ```
//!
//! and the column of z₀ is (1) with d in place of M_·e.
//!
//! If k slacks are nonbasic, a pivot costs 2nk flops for (1) and 2nk for the update. If k grows from 0 to n along a path, these costs are on average
//! no more than the 2n² per pivot of a full tableau. If the path ends with half of the slacks nonbasic, they are half as large. The leaving variable
//! determines the next entering variable, so the update and (1) share one pass over the stored columns.

use super::kernel::{self, Combine, Update, UpdateAndCombine};
use super::memory::{make_room, refill};
use super::scaling::Scaling;
use super::tolerances::{RETIRING_PIVOT, STORED_ROUNDING};
use crate::numerics::{amax, wide};
use crate::prelude::*;

/// One of the 2n + 1 variables of the augmented problem w = q + M z + d z₀: w_i, z_i, or the covering variable z₀.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LemkeVariable {
    W(usize),
    Z(usize),
    Covering,
}

impl LemkeVariable {
    /// The other variable of a complementary pair (w_i, z_i). The covering variable z₀ belongs to no pair and is returned itself.
    pub(super) fn complement(self) -> Self {
        match self {
            Self::W(i) => Self::Z(i),
            Self::Z(i) => Self::W(i),
            Self::Covering => Self::Covering,
        }
    }
}

/// The dictionary of one basis of a balanced problem. Its vectors are scratch buffers, which are used again from problem to problem.
#[derive(Debug, Clone, Default)]
pub(super) struct Dictionary {
    n: usize,
    pub(super) basic: Vec<LemkeVariable>,
    /// For each stored column D_{w_i}, the index i of its nonbasic slack w_i.
    kept: Vec<usize>,
    /// For each w_i, the position of its stored column D_{w_i} in `columns`, counted from 0; `None` if w_i is basic.
    slot: Vec<Option<usize>>,
    /// The stored columns D_v of the nonbasic slacks v, n entries each, one after another. Entry r of D_v is the change of the basic variable of
    /// row r per unit of v.
    columns: Vec<f64>,
    /// Values x of the basic variables, one for each row.
    pub(super) x: Vec<f64>,
    /// For each row, the change of its basic variable per unit of ε if ε p is added to q. These changes break ties between rows.
    pub(super) p: Vec<f64>,
    /// For each row, the rounding scale of its value in `x`: the magnitude of the terms from which the value was computed, to which its rounding
    /// error is proportional. [`Self::sum_terms`] sets it to the sum of the magnitudes of the terms. Each later pivot raises it to the magnitude of
    /// the term that the pivot adds, if that is larger.
    pub(super) term_sizes: Vec<f64>,
    /// The column of the entering variable: for each row, the change of the basic variable per unit of the entering variable.
    pub(super) u: Vec<f64>,
    /// The covering vector d of the balanced problem: each entry is multiplied by the scale factor of its row.
    pub(super) d: Vec<f64>,
    /// The column of the balanced M, or the covering vector d, from which the entering column is computed. An additional entry with the index n
    /// is zero; it is read for rows whose basic variable is no slack.
    source_column: Vec<f64>,
    /// For each row, the index i of its basic slack w_i; n if its basic variable is no slack.
    slack: Vec<usize>,
    /// For each row, the first term of the entering column `first_term − Σ c_i D_{w_i}`: entry i of `source_column` if w_i is basic in the row,
    /// otherwise 0.
    first_term: Vec<f64>,
    /// For each stored column D_v, the factor g in the update `D_v += g u` of a pivot with the entering column u.
    g: Vec<f64>,
    /// For each stored column D_{w_i}, its factor c_i in the entering column `first_term − Σ c_i D_{w_i}`: entry i of `source_column`.
    c: Vec<f64>,
}

impl Dictionary {
    /// Resets the dictionary to the slack basis, in which every slack w_i is basic. q is the right-hand side, p the perturbation that breaks
    /// ties, and d the covering vector.
    pub(super) fn reset(&mut self, q: &[f64], p: &[f64], d: &[f64]) {
        let n = q.len();
        self.n = n;
        self.basic.clear();
        self.basic.extend((0..n).map(LemkeVariable::W));
        self.slack.clear();
        self.slack.extend(0..n);
        refill(&mut self.slot, n, None);
        self.kept.clear();
        self.columns.clear();
        // Room for n nonbasic slacks is reserved, so that no later problem of n rows allocates.
        make_room(&mut self.kept, n);
        make_room(&mut self.columns, n * n);
        for list in [&mut self.g, &mut self.c] {
            make_room(list, n);
        }
        q.clone_into(&mut self.x);
        p.clone_into(&mut self.p);
        d.clone_into(&mut self.d);
        self.term_sizes.clear();
        self.term_sizes.extend(q.iter().map(|q| q.abs()));
        for (scratch, size) in [(&mut self.u, n), (&mut self.source_column, n + 1), (&mut self.first_term, n)]
        {
            refill(scratch, size, 0.0);
        }
    }

    /// Whether w_i is nonbasic, i.e. whether row i of w = q + M z + d z₀ holds with w_i = 0.
    pub(super) fn is_active(&self, i: usize) -> bool {
        self.slot[i].is_some()
    }

    /// The position in `columns` of the stored column of a variable; `None` unless the variable is a nonbasic slack.
    fn slot_of(&self, variable: LemkeVariable) -> Option<usize> {
        if let LemkeVariable::W(i) = variable { self.slot[i] } else { None }
    }

    /// Computes into `u` the column of a nonbasic variable: for each row, the change of the basic variable per unit of the nonbasic variable.
    pub(super) fn enter(&mut self, variable: LemkeVariable, m: &[f64], scaling: &Scaling) {
        if let Some(slot) = self.slot_of(variable) {
            let at = slot * self.n;
            self.u.copy_from_slice(&self.columns[at..at + self.n]);
        } else {
            self.load(variable, m, scaling);
            let mut u = core::mem::take(&mut self.u);
            self.eliminate(&mut u);
            self.u = u;
        }
    }

    /// The largest magnitude of an entry of `source_column`, the column of the balanced M, or d, from which the entering column was last
    /// computed.
    pub(super) fn source_size(&self) -> f64 {
        largest(&self.source_column)
    }

    /// Writes into `effect` the changes of the basic variables if r is added to the right-hand side q. They are computed by equation (1) of the head,
    /// with r in place of a column of M.
    pub(super) fn effect(&mut self, r: &[f64], effect: &mut [f64]) {
        self.source_column[..self.n].copy_from_slice(r);
        self.spread();
        self.eliminate(effect);
    }

    /// Computes y = `first_term` − Σ c_i D_{w_i} over the stored columns D_{w_i} of the nonbasic slacks, after [`Self::spread`] has prepared
    /// `first_term` and the factors c_i in `c`.
    fn eliminate(&self, y: &mut [f64]) {
        y.copy_from_slice(&self.first_term);
        wide(Combine::<false> { columns: &self.columns, n: self.n, c: &self.c, y });
    }

    /// Recomputes `term_sizes`: for each row, the sum of the magnitudes of the terms of its basic value as computed from the right-hand side q.
    /// The rounding error of the value is proportional to this sum. The terms are q_i if the slack w_i is basic in the row, and q_j times an entry of
    /// D_{w_j} for each nonbasic slack w_j. D_{w_j} is the stored column of w_j, and the entry is that of the row.
    pub(super) fn sum_terms(&mut self, q: &[f64]) {
        self.c.clear();
        self.c.extend(self.kept.iter().map(|i| q[*i]));
        for (term_size, slack) in self.term_sizes.iter_mut().zip(&self.slack) {
            *term_size = q.get(*slack).map_or(0.0, |q| q.abs());
        }
        wide(Combine::<true> { columns: &self.columns, n: self.n, c: &self.c, y: &mut self.term_sizes });
    }

    /// Sets to zero those entries of the entering column `u` that are only noise: rounding alone may have produced them.
    ///
    /// In a column that was computed as a sum by equation (1) of the head, an entry is noise below `tolerance` times the magnitude of its terms. In
    /// the stored column of a slack, an entry is noise below [`STORED_ROUNDING`] (64 ε, ε = 2⁻⁵²) times the largest entry.
    pub(super) fn clear_noise(&mut self, entering: LemkeVariable, tolerance: f64) {
        if let LemkeVariable::W(_) = entering {
            let rounding = STORED_ROUNDING * largest(&self.u);
            for u in self.u.iter_mut().filter(|u| u.abs() <= rounding) {
                *u = 0.0;
            }
            return;
        }
        self.spread();
        for to in &mut self.first_term {
            *to = to.abs();
        }
        wide(Combine::<true> { columns: &self.columns, n: self.n, c: &self.c, y: &mut self.first_term });
        for (u, terms) in self.u.iter_mut().zip(&self.first_term) {
            if u.abs() <= tolerance * terms {
                *u = 0.0;
            }
        }
    }

    /// Copies into `source_column` the column of the balanced M that belongs to the variable z_e, or d for z₀. Then prepares the computation of
    /// the entering column with [`Self::spread`].
    fn load(&mut self, variable: LemkeVariable, m: &[f64], scaling: &Scaling) {
        if let LemkeVariable::Z(e) = variable {
            let column = &m[e * self.n..(e + 1) * self.n];
            let factor = scaling.column[e];
            for ((to, m), row) in self.source_column.iter_mut().zip(column).zip(&scaling.row) {
                *to = m * row * factor;
            }
        } else {
            self.source_column[..self.n].copy_from_slice(&self.d);
        }
        self.spread();
    }

    /// Prepares [`Self::eliminate`] for the column M_·e in `source_column`. Its entries M_ie go to `first_term` where the slack w_i is basic,
    /// and to `c` as factors of the stored columns D_{w_i} where w_i is nonbasic.
    fn spread(&mut self) {
        for (to, i) in self.first_term.iter_mut().zip(&self.slack) {
            *to = self.source_column[*i];
        }
        self.c.clear();
        self.c.extend(self.kept.iter().map(|i| self.source_column[*i]));
    }

    /// Exchanges the entering variable, whose column is in `u`, with the basic variable of row r, which is returned. Then computes the column of
    /// the leaving variable's complement in `u`, unless z₀ has left.
    pub(super) fn pivot(
        &mut self,
        entering: LemkeVariable,
        r: usize,
        m: &[f64],
        scaling: &Scaling,
    ) -> LemkeVariable {
        let leaving = self.rearrange(entering, r);
        if let LemkeVariable::W(l) = leaving {
            self.load(LemkeVariable::Z(l), m, scaling);
            wide(UpdateAndCombine {
                columns: &mut self.columns,
                n: self.n,
                g: &self.g,
                u: &self.u,
                c: &self.c,
                y: &mut self.first_term,
            });
            core::mem::swap(&mut self.u, &mut self.first_term);
        } else {
            wide(Update { columns: &mut self.columns, n: self.n, g: &self.g, u: &self.u });
            if leaving != LemkeVariable::Covering {
                self.enter(leaving.complement(), m, scaling);
            }
        }
        leaving
    }

    /// Makes the exchange of [`Self::pivot`] without computing the next entering column.
    pub(super) fn exchange(&mut self, entering: LemkeVariable, r: usize) {
        self.rearrange(entering, r);
        wide(Update { columns: &mut self.columns, n: self.n, g: &self.g, u: &self.u });
    }

    /// Exchanges z_j, basic in row r, with w_j. Nothing is changed if w_j is basic too, or if the pivot is so small that it amplifies rounding
    /// errors. A pivot is too small below [`RETIRING_PIVOT`] (1e-5) times the largest entry of its column, which counts as at least 1.
    pub(super) fn retire(&mut self, j: usize, r: usize, scaling: &Scaling, m: &[f64]) {
        if !self.is_active(j) {
            return;
        }
        self.enter(LemkeVariable::W(j), m, scaling);
        if self.u[r].abs() >= RETIRING_PIVOT * largest(&self.u).max(1.0) {
            self.exchange(LemkeVariable::W(j), r);
        }
    }

    /// Exchanges the entering variable with the basic variable of row r, except for the update `D_v += g u` of the stored columns. Leaves the
    /// factors g and u of this update in `g` and `u`; returns the leaving variable.
    fn rearrange(&mut self, entering: LemkeVariable, r: usize) -> LemkeVariable {
        let n = self.n;
        let leaving = self.basic[r];
        let pivot = self.u[r];
        let inverse = 1.0 / pivot;
        self.step(r, pivot);

        // In row r the update `D_v += g u` must give g alone. Row r of each column D_v is therefore set to 0 and row r of u to 1, so the update
        // needs no branch.
        self.u[r] = 1.0;
        let factor = -self.p[r] * inverse;
        self.p[r] = 0.0;
        kernel::add(&mut self.p, factor, &self.u);
        self.g.clear();
        for column in self.columns.chunks_exact_mut(n.max(1)) {
            self.g.push(-column[r] * inverse);
            column[r] = 0.0;
        }
        let own = self.slot_of(entering);
        if let Some(own) = own {
            // The stored column of the entering slack becomes the column of the leaving variable: the entering column u divided by its pivot.
            self.g[own] = inverse;
            self.columns[own * n..(own + 1) * n].fill(0.0);
        }
        self.basic[r] = entering;
        self.slack[r] = if let LemkeVariable::W(i) = entering { i } else { n };
        match (leaving, own) {
            (LemkeVariable::W(l), None) => {
                self.slot[l] = Some(self.kept.len());
                self.kept.push(l);
                self.columns.resize(self.columns.len() + n, 0.0);
                self.g.push(inverse);
            }
            (LemkeVariable::W(l), Some(own)) => {
                self.slot[self.kept[own]] = None;
                self.slot[l] = Some(own);
                self.kept[own] = l;
            }
            (_, Some(own)) => self.forget(own),
            (_, None) => {}
        }
        leaving
    }

    /// Increases the entering variable until the basic variable of row r is zero; `pivot` is the entry of the entering column in this row. Updates
    /// the basic values in `x` and the magnitudes of their terms in `term_sizes`.
    fn step(&mut self, r: usize, pivot: f64) {
        let step = -self.x[r] / pivot;
        let term_size = self.term_sizes[r] / pivot.abs();
        for ((x, l), u) in self.x.iter_mut().zip(&mut self.term_sizes).zip(&self.u) {
            *x += u * step;
            let inherited = u.abs() * term_size;
            *l = if inherited > *l { inherited } else { *l };
        }
        self.x[r] = step;
        self.term_sizes[r] = term_size;
    }

    /// Removes the stored column with the index `slot`, whose slack becomes basic; the last column takes its position in `columns`.
    fn forget(&mut self, slot: usize) {
        let n = self.n;
        self.slot[self.kept[slot]] = None;
        self.kept.swap_remove(slot);
        self.g.swap_remove(slot);
        let last = self.kept.len();
        if slot != last {
            self.columns.copy_within(last * n..(last + 1) * n, slot * n);
            self.slot[self.kept[slot]] = Some(slot);
        }
        self.columns.truncate(last * n);
    }
}

/// max_i |v_i|; NaN entries are ignored. Eight independent maxima allow SIMD instructions.
pub(super) fn largest(v: &[f64]) -> f64 {
    let mut lanes = [0.0_f64; 8];
    let mut chunks = v.chunks_exact(8);
    for chunk in &mut chunks {
        for lane in 0..8 {
            let size = chunk[lane].abs();
            lanes[lane] = if size > lanes[lane] { size } else { lanes[lane] };
        }
    }
    amax(chunks.remainder()).max(amax(&lanes))
}
