//! Counts of events and endings of many paths.

use grasp_lcp::load_path::{Beyond, Change, Event, LoadPath, LossKind, PathEnd};

/// Counts of events and endings of many paths.
#[derive(Debug, Default, Clone)]
pub struct Tally {
    /// Number of paths.
    pub scenes: usize,
    /// Events of all kinds.
    pub events: usize,
    /// Contacts that start to slide.
    pub slides: usize,
    /// Contacts that stop sliding.
    pub sticks: usize,
    /// Contacts that reverse their slip.
    pub reverses: usize,
    /// Contacts that continue to slide along another edge.
    pub turns: usize,
    /// Contacts that open.
    pub opens: usize,
    /// Contacts that close.
    pub closes: usize,
    /// Paths completed to the end of the last leg.
    pub completed: usize,
    /// Paths that end at a limit load.
    pub limits: usize,
    /// Paths that end at a snap, or at a loss whose continuation is unknown.
    pub snaps: usize,
    /// Paths that end where the object gives way.
    pub gives_way: usize,
    /// Paths without an equilibrium at the start.
    pub no_start: usize,
    /// Paths with any other end.
    pub undecided: usize,
    /// Losses just beyond which another method finds no equilibrium at all.
    pub nothing_beyond: usize,
    /// Paths with a large sum of step errors.
    pub inaccurate: usize,
    /// Events whose state violates the law by more than rounding, and reports this in its residuals.
    pub admitted: usize,
    /// Cases on which the property itself was checked.
    pub checked: usize,
}

impl Tally {
    /// Counts a path with its events.
    pub fn count<const C: usize>(&mut self, events: &[Event<C>], path: &LoadPath<'_, C>) {
        self.scenes += 1;
        self.events += events.len();
        for change in events.iter().flat_map(|e| &e.changes) {
            *match change.what {
                Change::Slides { .. } => &mut self.slides,
                Change::Sticks => &mut self.sticks,
                Change::Reverses { .. } => &mut self.reverses,
                Change::Turns { .. } => &mut self.turns,
                Change::Opens => &mut self.opens,
                Change::Closes | Change::ClosesSliding { .. } => &mut self.closes,
            } += 1;
        }
        *match path.end().unwrap() {
            PathEnd::Completed => &mut self.completed,
            PathEnd::Lost(loss) if loss.kind == LossKind::GivesWay => &mut self.gives_way,
            PathEnd::Lost(_) if matches!(path.beyond(), Some(Beyond::LimitLoad)) => &mut self.limits,
            PathEnd::Lost(_) => &mut self.snaps,
            PathEnd::NoStart(_) => &mut self.no_start,
            _ => &mut self.undecided,
        } += 1;
    }
}
