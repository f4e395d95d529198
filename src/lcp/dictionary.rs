//! The condensed tableau and its pivot.
//!
//! With r the right-hand side, every basis of w = q + M z + d z₀ gives a *dictionary*
//!
//! ```text
//! basic = x + Σ over the nonbasic variables v of D_v · v.
//! ```
//!
//! Only the columns D_v of nonbasic slacks v = w_i are stored. Since w_i enters the equations exactly as −q_i does, all the rest
//! follows from them: the column of a nonbasic z_e is the effect of adding column e of M to q,
//!
//! ```text
//! D_e = (M_ie on the rows where w_i is basic, 0 elsewhere) − Σ over the nonbasic w_i of M_ie D_{w_i},   (1)
//! ```
//!
//! and the column of z₀ is the same with d in the place of M_·e. If k slacks are nonbasic, a pivot
//! costs 2nk flops for (1) and 2nk for the update: over a path on which k grows from 0 to n no more than the
//! 2n² of a full tableau, over one that ends with half the slacks nonbasic half of that.

use super::scaling::{Scaling, power_of_two};

/// A variable: w_i, z_i, or the covering variable z₀.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Variable {
    Slack(usize),
    Unknown(usize),
    Covering,
}

impl Variable {
    /// The other variable of the pair; z₀ has none.
    pub(crate) fn complement(self) -> Self {
        match self {
            Self::Slack(i) => Self::Unknown(i),
            Self::Unknown(i) => Self::Slack(i),
            Self::Covering => Self::Covering,
        }
    }
}

const NONE: usize = usize::MAX;

/// The dictionary of one basis. All vectors keep their memory between problems.
#[derive(Debug, Clone, Default)]
pub(crate) struct Dictionary {
    n: usize,
    /// The variable that is basic in each row.
    pub(crate) basic: Vec<Variable>,
    /// The i of the nonbasic slack w_i kept in each stored column.
    kept: Vec<usize>,
    /// Where w_i is kept, or NONE.
    slot: Vec<usize>,
    /// The stored columns, one after the other.
    columns: Vec<f64>,
    /// Values of the basic variables.
    pub(crate) x: Vec<f64>,
    /// The perturbation column: the effect of adding p to q, used to break ties.
    pub(crate) p: Vec<f64>,
    /// For each row, the size of the largest term that has gone into its value.
    pub(crate) level: Vec<f64>,
    /// The entering column.
    pub(crate) u: Vec<f64>,
    /// The largest entry of the entering column before elimination.
    pub(crate) unit: f64,
    /// The covering vector d.
    pub(crate) d: Vec<f64>,
    entering: Vec<f64>,
}

impl Dictionary {
    /// The dictionary of the slack basis, with right-hand side q, perturbation p and covering vector d.
    pub(crate) fn reset(&mut self, q: &[f64], p: &[f64], d: &[f64]) {
        let n = q.len();
        self.n = n;
        self.basic.clear();
        self.basic.extend((0..n).map(Variable::Slack));
        self.kept.clear();
        self.slot.clear();
        self.slot.resize(n, NONE);
        self.columns.clear();
        for (to, from) in [(&mut self.x, q), (&mut self.p, p), (&mut self.d, d)] {
            to.clear();
            to.extend_from_slice(from);
        }
        self.level.clear();
        self.level.extend(q.iter().map(|q| q.abs()));
        for scratch in [&mut self.u, &mut self.entering] {
            scratch.clear();
            scratch.resize(n, 0.0);
        }
    }

    /// Puts the column of a nonbasic variable into `u`.
    pub(crate) fn enter(&mut self, variable: Variable, m: &[f64], scaling: &Scaling) {
        let n = self.n;
        match variable {
            Variable::Slack(i) => {
                let at = self.slot[i] * n;
                self.u.copy_from_slice(&self.columns[at..at + n]);
                self.unit = 1.0;
                return;
            }
            Variable::Unknown(e) => {
                let shift = scaling.column[e];
                let column = &m[e * n..(e + 1) * n];
                for ((to, m), row) in self.entering.iter_mut().zip(column).zip(&scaling.row) {
                    *to = m * power_of_two(row + shift);
                }
            }
            Variable::Covering => self.entering.copy_from_slice(&self.d),
        }
        self.unit = self.entering.iter().fold(0.0, |unit: f64, m| unit.max(m.abs()));
        for (u, basic) in self.u.iter_mut().zip(&self.basic) {
            *u = if let Variable::Slack(i) = *basic { self.entering[i] } else { 0.0 };
        }
        for (column, i) in self.columns.chunks_exact(n).zip(&self.kept) {
            let factor = self.entering[*i];
            if factor != 0.0 {
                for (u, d) in self.u.iter_mut().zip(column) {
                    *u -= factor * d;
                }
            }
        }
    }

    /// Exchanges the entering variable, whose column is in `u`, with the basic variable of row r. Returns the latter.
    pub(crate) fn pivot(&mut self, entering: Variable, r: usize) -> Variable {
        let n = self.n;
        let pivot = self.u[r];
        let leaving = self.basic[r];
        let step = -self.x[r] / pivot;
        let level = self.level[r] / pivot.abs();
        for ((x, l), u) in self.x.iter_mut().zip(&mut self.level).zip(&self.u) {
            *x += u * step;
            *l = l.max(u.abs() * level);
        }
        self.x[r] = step;
        self.level[r] = level;

        // With row r of the column set to 0 and that of u to 1, the update of row r is the same as of all others.
        self.u[r] = 1.0;
        let eliminate = |column: &mut [f64], u: &[f64]| {
            let factor = -column[r] / pivot;
            if factor != 0.0 {
                column[r] = 0.0;
                for (c, u) in column.iter_mut().zip(u) {
                    *c += factor * u;
                }
            }
        };
        eliminate(&mut self.p, &self.u);
        let own = if let Variable::Slack(i) = entering { self.slot[i] } else { NONE };
        for (slot, column) in self.columns.chunks_exact_mut(n).enumerate() {
            if slot != own {
                eliminate(column, &self.u);
            }
        }
        // The leaving variable's column is u / pivot, with 1 / pivot in row r.
        match (own, leaving) {
            (NONE, Variable::Slack(l)) => {
                self.slot[l] = self.kept.len();
                self.kept.push(l);
                self.columns.extend(self.u.iter().map(|u| u / pivot));
            }
            (own, Variable::Slack(l)) => {
                self.slot[self.kept[own]] = NONE;
                self.slot[l] = own;
                self.kept[own] = l;
                for (c, u) in self.columns[own * n..(own + 1) * n].iter_mut().zip(&self.u) {
                    *c = u / pivot;
                }
            }
            (NONE, _) => {}
            (own, _) => {
                self.slot[self.kept[own]] = NONE;
                self.kept.swap_remove(own);
                let last = self.kept.len();
                if own != last {
                    self.columns.copy_within(last * n..(last + 1) * n, own * n);
                    self.slot[self.kept[own]] = own;
                }
                self.columns.truncate(last * n);
            }
        }
        self.basic[r] = entering;
        leaving
    }
}
