//! Lemke's path through the dictionaries of one problem 0 ≤ z ⟂ w = M z + q ≥ 0. A dictionary is the condensed tableau of one basis; each pivot leads
//! from one dictionary to the next. On the path w = M z + q + d z₀ with a covering vector d and a covering variable z₀ ≥ 0. The path ends in a
//! solution once z₀ is zero. It is computed in a balanced problem: rows and columns are scaled by powers of two, so that nonzero entries of M lie
//! near 1. In the slack basis all slacks w_i are basic.

use super::dictionary::{Dictionary, LemkeVariable};
use super::memory::{make_room, refill};
use super::scaling::Scaling;
use crate::numerics::{IntoList, generic};
use crate::prelude::*;

/// A path through the dictionaries of one balanced problem, as far as it has been followed.
#[derive(Debug, Clone, Default)]
pub(super) struct LemkePath {
    pub(super) scaling: Scaling,
    pub(super) dictionary: Dictionary,
    /// Right-hand side q in balanced rows.
    pub(super) q: Vec<f64>,
    /// Perturbation p in balanced rows. Ties between rows are broken as if the right-hand side were q + ε p with ε → 0+.
    pub(super) p: Vec<f64>,
    /// Covering vector d in balanced rows: the coefficients of the covering variable z₀.
    pub(super) d: Vec<f64>,
    pub(super) pivots: usize,
    /// Number of pivots since the dictionary was last computed from M, q and d by elimination.
    pub(super) age: usize,
    /// A copy of the dictionary's tie-breaking column p, kept by variable while the dictionary is recomputed: entry i for w_i, entry n + i for
    /// z_i, entry 2n for z₀. Entries of nonbasic variables are 0.
    pub(super) saved: Vec<f64>,
    /// Variables that become basic as the dictionary is recomputed from the slack basis.
    pub(super) members: Vec<LemkeVariable>,
    /// Rows whose slacks become nonbasic as the dictionary is recomputed from the slack basis.
    pub(super) leaving: Vec<usize>,
    /// For each row, the defect q + M z + d z₀ − w of the current values, which is zero without rounding.
    pub(super) defect: Vec<f64>,
    /// For each row, the sum of the magnitudes of the terms of the defect q + M z + d z₀ − w, to which its rounding error is proportional.
    pub(super) terms: Vec<f64>,
}

impl LemkePath {
    /// Computes the factors that balance the rows and columns of M, and multiplies q by the factors of the rows. Sets the perturbation p, which
    /// breaks ties, to irregular numbers, so that no two rows tie. A dictionary must be computed afterwards, for example by
    /// [`Self::start_from_slacks`].
    pub(super) fn prepare(&mut self, m: &[f64], q: &[f64]) {
        self.scaling.balance(q.len(), m, q);
        self.p.clear();
        self.scaling.row_unit.iter().enumerate().map(|(i, unit)| unit * generic(i)).append_to(&mut self.p);
        self.set_right_hand_side(q);
        self.pivots = 0;
        self.reserve(q.len());
    }

    /// Reserves scratch buffers for recomputing a dictionary by elimination, which only some paths of n rows need. Later paths of n rows then
    /// allocate nothing.
    fn reserve(&mut self, n: usize) {
        for list in [&mut self.d, &mut self.defect, &mut self.terms] {
            make_room(list, n);
        }
        make_room(&mut self.saved, 2 * n + 1);
        make_room(&mut self.members, n + 1);
        make_room(&mut self.leaving, n);
    }

    pub(super) fn set_right_hand_side(&mut self, q: &[f64]) {
        self.q.clear();
        q.iter().zip(&self.scaling.row).map(|(q, row)| q * row).append_to(&mut self.q);
    }

    /// Sets the dictionary to the slack basis, in which every slack w_i is basic, with the right-hand side q, perturbation p and covering vector
    /// d of this path.
    pub(super) fn start_from_slacks(&mut self) {
        self.dictionary.reset(&self.q, &self.p, &self.d);
        self.age = 0;
    }

    /// Converts numbers given for the basic variables, one for each row, to a vector z in the caller's units. Returns the number given for z₀, or
    /// `None` if z₀ is not basic.
    pub(super) fn unknowns(&self, rows: &[f64], z: &mut Vec<f64>) -> Option<f64> {
        refill(z, self.q.len(), 0.0);
        let mut covering = None;
        for (basic, x) in self.dictionary.basic.iter().zip(rows) {
            match *basic {
                LemkeVariable::Z(j) => z[j] = x * self.scaling.column[j],
                LemkeVariable::Covering => covering = Some(*x),
                LemkeVariable::W(_) => {}
            }
        }
        covering
    }

    /// Writes the current z into `z`, and returns the value of the covering variable z₀, or `None` if z₀ is not basic. Negative entries of z are
    /// noise and are set to zero.
    pub(super) fn read_point(&self, z: &mut Vec<f64>) -> Option<f64> {
        let covering = self.unknowns(&self.dictionary.x, z);
        for z in z.iter_mut() {
            *z = z.max(0.0);
        }
        covering
    }
}
