//! Shows on standard error which question is being answered, while its answer takes long.

use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Time between two lines. An answer that takes less time shows no line.
const INTERVAL: Duration = Duration::from_secs(1);

/// Prints a line of progress each second until this value is dropped. A terminal shows one line, which is cleared at the end.
pub(crate) struct ProgressLine(Option<(Sender<()>, JoinHandle<()>)>);

impl ProgressLine {
    /// The result of `work`. In the meantime lines of progress show `what` and the time; without a terminal they are printed only if `lines` is set.
    pub(crate) fn during<R>(what: &str, lines: bool, work: impl FnOnce() -> R) -> R {
        let _waiting = Self::begin(what.to_owned(), lines);
        work()
    }

    fn begin(what: String, lines: bool) -> Self {
        let is_seen = io::stderr().is_terminal();
        if !is_seen && !lines {
            return Self(None);
        }
        let (stop, stopped) = channel();
        let start = Instant::now();
        let tell = move || {
            let mut shown = 0;
            while stopped.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
                let line = format!("{what}: {} s", start.elapsed().as_secs());
                if is_seen {
                    shown = line.chars().count();
                    let _ = write!(io::stderr(), "\r{line}");
                } else {
                    eprintln!("{line}");
                }
            }
            if shown > 0 {
                let _ = write!(io::stderr(), "\r{:shown$}\r", "");
            }
        };
        Self(thread::Builder::new().spawn(tell).ok().map(|thread| (stop, thread)))
    }
}

impl Drop for ProgressLine {
    fn drop(&mut self) {
        if let Some((stop, thread)) = self.0.take() {
            drop(stop);
            let _ = thread.join();
        }
    }
}
