//! A count of what happened on many paths.

use grasp_lcp::load_path::{Change, Event, LoadPath, PathEnd};

/// What happened on many paths.
#[derive(Debug, Default, Clone)]
pub(crate) struct Tally {
    pub(crate) scenes: usize,
    pub(crate) events: usize,
    pub(crate) slides: usize,
    pub(crate) sticks: usize,
    pub(crate) reverses: usize,
    pub(crate) turns: usize,
    pub(crate) opens: usize,
    pub(crate) closes: usize,
    pub(crate) completed: usize,
    pub(crate) limits: usize,
    pub(crate) snaps: usize,
    pub(crate) gives_way: usize,
    pub(crate) no_start: usize,
    pub(crate) undecided: usize,
    /// Losses just beyond which another method finds no equilibrium at all.
    pub(crate) nothing_beyond: usize,
    /// Paths whose steps add up to a large error.
    pub(crate) inaccurate: usize,
    /// What the property itself was checked on.
    pub(crate) checked: usize,
}

impl Tally {
    pub(crate) fn count<const D: usize, const C: usize>(
        &mut self,
        events: &[Event<D, C>],
        path: &LoadPath<'_, D, C>,
    ) {
        self.scenes += 1;
        self.events += events.len();
        for (_, change) in events.iter().flat_map(|e| &e.changes) {
            *match change {
                Change::Slides { .. } => &mut self.slides,
                Change::Sticks => &mut self.sticks,
                Change::Reverses { .. } => &mut self.reverses,
                Change::Turns { .. } => &mut self.turns,
                Change::Opens => &mut self.opens,
                Change::Closes | Change::ClosesSliding { .. } => &mut self.closes,
            } += 1;
        }
        *match path.end().expect("followed to the end") {
            PathEnd::Completed => &mut self.completed,
            PathEnd::LimitLoad(_) => &mut self.limits,
            PathEnd::Snap(_) | PathEnd::Ends(_) => &mut self.snaps,
            PathEnd::GivesWay { .. } => &mut self.gives_way,
            PathEnd::NoStart(_) => &mut self.no_start,
            _ => &mut self.undecided,
        } += 1;
    }
}
