//! Detection of periods that last several load cycles. If friction falls as contacts begin to slide, a slip in one cycle may not occur in the next.
//!
//! The state after each cycle (contact forces and gaps) is compared with one earlier state, which is replaced after 1, 2, 4, ... cycles (R. P. Brent,
//! *An improved Monte Carlo factorization algorithm*, 1980). Thus every period is found, with a single state in store.

use super::cycle::Cycle;

/// The cycles since the reference state: an earlier state, with which the state after each new cycle is compared.
#[derive(Debug)]
pub(super) struct PeriodSearch {
    /// All cycles since the reference state, joined to one; `many` is their number.
    all: Option<Cycle>,
    many: usize,
    /// Once `many`, the number of cycles since the reference state, reaches this number, the latest state becomes the reference state.
    most: usize,
}

impl PeriodSearch {
    /// No cycles yet; the state at the beginning of the first cycle is the reference state.
    pub(super) fn new() -> Self {
        Self { all: None, many: 0, most: 1 }
    }

    /// Adds a cycle. If the state at its end equals the reference state up to rounding, returns all cycles since then, joined to one, and their
    /// number. Otherwise `None`.
    pub(super) fn closed_by(&mut self, cycle: &Cycle) -> Option<(&Cycle, usize)> {
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
