//! Shows the progress of a sweep, i.e. of the same computation for every direction of a map, and stops the sweep if it takes too long.

use std::io::{self, IsTerminal};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use grasp_lcp::Error;
use grasp_lcp::sweep::map_watched;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Time limit of one sweep over the directions of a map; a sweep that takes longer is stopped and has no result. A sweep computes forces at first
/// slip, forces that allow for uncertain data, or load paths in the plane.
pub(crate) const MOST_SWEEP_TIME: Duration = Duration::from_secs(300);

/// The display of progress: a bar on a terminal; otherwise, if `lines` is set, one line each second.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MapProgress {
    pub(crate) lines: bool,
}

impl MapProgress {
    /// Calls `f` for every item in parallel, and meanwhile shows `what` and the number of answers so far. Returns all answers in order, or the first
    /// error; `None` if the sweep takes longer than `most`.
    pub(crate) fn sweep<T: Sync, R: Send>(
        self,
        what: &'static str,
        items: &[T],
        most: Duration,
        f: impl Fn(&T) -> Result<R, Error> + Sync + Send,
    ) -> Result<Option<Vec<R>>, Error> {
        let start = Instant::now();
        let bar = ProgressBar::with_draw_target(Some(items.len() as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos} of {len}, {eta}") {
            bar.set_style(style);
        }
        bar.set_message(what);
        let is_seen = io::stderr().is_terminal();
        let seconds_reported = AtomicU64::new(0);
        let answers = map_watched(items, f, |progress| {
            let seconds = start.elapsed().as_secs();
            // The progress bar appears only if the sweep takes more than a second.
            if bar.is_hidden() && start.elapsed() > Duration::from_secs(1) && is_seen {
                bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            if self.lines && !is_seen && seconds_reported.fetch_max(seconds, Ordering::Relaxed) < seconds {
                eprintln!("{what}: {} of {} after {seconds} s", progress.answered, progress.of);
            }
            bar.set_position(progress.answered as u64);
            if start.elapsed() > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        bar.finish_and_clear();
        // If the time limit has stopped the sweep, an answer is missing, and the result is `None`.
        let answered: Option<Vec<_>> = answers.into_iter().collect();
        answered.map(|answers| answers.into_iter().collect()).transpose()
    }
}
