//! Progress of a sweep, where somebody looks, and its end, if it takes too long.

use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use grasp_lcp::Error;
use grasp_lcp::sweep::map_watched;

/// All answers in order, or the first error; `None` if they are not there within the time.
pub(crate) fn sweep<T: Sync, R: Send>(
    what: &str,
    items: &[T],
    most: Duration,
    f: impl Fn(&T) -> Result<R, Error> + Sync + Send,
) -> Result<Option<Vec<R>>, Error> {
    let (seen, start) = (std::io::stderr().is_terminal(), Instant::now());
    let answers = map_watched(items, f, |progress| {
        let percent = |answered: usize| 100 * answered / progress.of;
        if seen && percent(progress.answered) != percent(progress.answered - 1) {
            eprint!("\r{what}: {} of {}  ", progress.answered, progress.of);
        }
        if start.elapsed() > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    if seen {
        eprintln!();
    }
    // `None` as soon as one is missing.
    let answered: Option<Vec<_>> = answers.into_iter().collect();
    answered.map(|answers| answers.into_iter().collect()).transpose()
}
