//! Detection of periods that last several load cycles. If friction falls as contacts begin to slide, a slip in one cycle may not occur in the next.
//!
//! The cycle state after each cycle (contact forces and gaps) is compared with one earlier cycle state, which is replaced after 1, 2, 4, ... cycles
//! (R. P. Brent, *An improved Monte Carlo factorization algorithm*, 1980). Thus every period is found, while a single cycle state is stored.

use super::cycle::Cycle;

/// The cycles since the reference: an earlier cycle state, with which that after each new cycle is compared.
#[derive(Debug)]
pub(super) struct PeriodSearch {
    /// All cycles since the reference, joined to one; `many` is their number.
    all: Option<Cycle>,
    many: usize,
    /// Once `many`, the number of cycles since the reference, reaches this number, the latest cycle state becomes the reference.
    most: usize,
}

impl PeriodSearch {
    /// No cycles yet; the cycle state at the beginning of the first cycle is the reference.
    pub(super) fn new() -> Self {
        Self { all: None, many: 0, most: 1 }
    }

    /// Adds a cycle. If the cycle state at its end equals the reference up to rounding, returns all cycles since then, joined to one, and their
    /// number. Otherwise returns `None`.
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
