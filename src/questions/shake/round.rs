//! Detection of periods that last several cycles. If friction falls as contacts begin to slide, a slip in one cycle may be absent in the next.
//!
//! Each state is compared with one earlier state, which is replaced after 1, 2, 4, ... cycles (R. P. Brent, *An improved Monte Carlo factorization
//! algorithm*, 1980). Thus every period is found, with a single state in store.

use super::cycle::Cycle;

/// The cycles since the reference state, the earlier state with which the end of each new cycle is compared.
#[derive(Debug)]
pub(super) struct Round {
    /// All cycles since the reference state, joined to one; `many` is their number.
    all: Option<Cycle>,
    many: usize,
    /// Once there are this many cycles, the latest state becomes the reference state.
    most: usize,
}

impl Round {
    /// No cycles yet; the first one sets the reference state.
    pub(super) fn new() -> Self {
        Self { all: None, many: 0, most: 1 }
    }

    /// Adds a cycle. If it ends at the reference state, returns all cycles since then, joined to one, and their number.
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
