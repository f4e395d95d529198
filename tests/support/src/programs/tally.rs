//! A count of what happened on many paths.

use grasp_lcp::load_path::{Beyond, Change, Event, LoadPath, LossKind, PathEnd};

/// What happened on many paths.
#[derive(Debug, Default, Clone)]
pub struct Tally {
    /// Paths.
    pub scenes: usize,
    /// Of all kinds.
    pub events: usize,
    /// Contacts that start to slide.
    pub slides: usize,
    /// That stop.
    pub sticks: usize,
    /// That slide the other way.
    pub reverses: usize,
    /// That go on along another edge.
    pub turns: usize,
    /// That open.
    pub opens: usize,
    /// That close.
    pub closes: usize,
    /// Paths followed to the end of the last leg.
    pub completed: usize,
    /// To a limit load.
    pub limits: usize,
    /// To a snap, or to where nothing more is known than that they end.
    pub snaps: usize,
    /// To where the object gives way.
    pub gives_way: usize,
    /// Without an equilibrium to start from.
    pub no_start: usize,
    /// With any other end.
    pub undecided: usize,
    /// Losses just beyond which another method finds no equilibrium at all.
    pub nothing_beyond: usize,
    /// Paths whose steps add up to a large error.
    pub inaccurate: usize,
    /// Events whose state breaks the law by more than rounding, and says so.
    pub admitted: usize,
    /// What the property itself was checked on.
    pub checked: usize,
}

impl Tally {
    /// Adds a path with its events.
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
        *match path.end().expect("followed to the end") {
            PathEnd::Completed => &mut self.completed,
            PathEnd::Lost(loss) if loss.kind == LossKind::GivesWay => &mut self.gives_way,
            PathEnd::Lost(_) if matches!(path.beyond(), Some(Beyond::LimitLoad)) => &mut self.limits,
            PathEnd::Lost(_) => &mut self.snaps,
            PathEnd::NoStart(_) => &mut self.no_start,
            _ => &mut self.undecided,
        } += 1;
    }
}
