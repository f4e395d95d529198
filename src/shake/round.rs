//! Cycles that repeat after several of them: where friction falls as contacts begin to slide, what is slipped in one may be missing in the next.
//!
//! Each place is compared with one of those before, which is moved up after 1, 2, 4, ... cycles (R. P. Brent, *An improved Monte Carlo factorization algorithm*, 1980): so any
//! number of cycles after which everything repeats is found, with one place that is kept.

use super::cycle::Cycle;
use crate::numerics::Size;

/// Cycles since the place with which others are compared.
#[derive(Debug)]
pub(super) struct Round<D: Size, const C: usize> {
    /// All of them as one.
    all: Option<Cycle<D, C>>,
    many: usize,
    /// After so many the place is moved up.
    most: usize,
}

impl<D: Size, const C: usize> Round<D, C> {
    /// Of no cycle yet.
    pub(super) fn new() -> Self {
        Self { all: None, many: 0, most: 1 }
    }

    /// Goes on with a cycle. Where that ends at the place with which others are compared: all of them since as one, and how many.
    pub(super) fn closed_by(&mut self, cycle: &Cycle<D, C>) -> Option<(&Cycle<D, C>, usize)> {
        if self.many == self.most {
            (self.all, self.many, self.most) = (None, 0, 2 * self.most);
        }
        self.many += 1;
        match &mut self.all {
            Some(all) => all.append(cycle),
            None => self.all = Some(cycle.clone()),
        }
        self.all.as_ref().filter(|all| all.change() <= cycle.same()).map(|all| (all, self.many))
    }
}
