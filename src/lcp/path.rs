//! A path through the dictionaries of one problem.

use super::dictionary::{Dictionary, Unknown};
use super::scaling::Scaling;
use crate::draw::generic;

/// A path through the dictionaries of one balanced problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct Path {
    pub(crate) scaling: Scaling,
    pub(crate) dictionary: Dictionary,
    /// The balanced right-hand side, perturbation and covering vector.
    pub(crate) q: Vec<f64>,
    pub(crate) p: Vec<f64>,
    pub(crate) d: Vec<f64>,
    pub(crate) pivots: usize,
    /// Pivots since the dictionary was last computed from the data.
    pub(super) age: usize,
    /// The perturbation of each basic variable while the dictionary is computed anew.
    pub(super) saved: Vec<f64>,
    pub(super) members: Vec<Unknown>,
    pub(super) active: Vec<bool>,
    pub(super) defect: Vec<f64>,
    pub(super) terms: Vec<f64>,
}

impl Path {
    /// Balances M, and q and p with it. The dictionary still has to be started.
    pub(crate) fn prepare(&mut self, m: &[f64], q: &[f64]) {
        self.scaling.balance(q.len(), m, q);
        self.p.clear();
        self.p.extend(self.scaling.row_unit.iter().enumerate().map(|(i, unit)| unit * generic(i)));
        self.set_right_hand_side(q);
        self.pivots = 0;
        self.reserve(q.len());
    }

    /// Room for what only some problems need, so that no later problem of this size has to allocate.
    fn reserve(&mut self, n: usize) {
        self.d.reserve(n.saturating_sub(self.d.len()));
        self.saved.reserve((2 * n + 1).saturating_sub(self.saved.len()));
        self.members.reserve((n + 1).saturating_sub(self.members.len()));
        self.active.reserve(n.saturating_sub(self.active.len()));
        for scratch in [&mut self.defect, &mut self.terms] {
            scratch.reserve(n.saturating_sub(scratch.len()));
        }
    }

    pub(crate) fn set_right_hand_side(&mut self, q: &[f64]) {
        self.q.clear();
        self.q.extend(q.iter().zip(&self.scaling.row).map(|(q, row)| q * row));
    }

    /// Starts from the slack basis with the present q, p and d.
    pub(crate) fn start_from_slacks(&mut self) {
        self.dictionary.reset(&self.q, &self.p, &self.d);
        self.age = 0;
    }
}
