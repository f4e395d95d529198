//! Times, and how they are printed.

use std::time::Instant;

/// Best time of several runs, s.
pub fn best(runs: usize, mut work: impl FnMut()) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

/// Heads of the columns.
pub fn head() {
    println!(
        "{:<56} {:>10} {:>10} {:>8} {:>10} {:>9}  remarks",
        "work", "time", "in general", "ratio", "today", "ratio"
    );
}

/// One row; times that are not numbers are left out.
pub fn row(work: &str, time: f64, in_general: f64, today: f64, remarks: &str) {
    let ratio = |other: f64| match other / time {
        r if r.is_nan() => String::new(),
        r if r < 100.0 => format!("{r:.1}"),
        r => format!("{r:.0}"),
    };
    println!(
        "{work:<56} {:>10} {:>10} {:>8} {:>10} {:>9}  {remarks}",
        unit(time),
        unit(in_general),
        ratio(in_general),
        unit(today),
        ratio(today)
    );
}

fn unit(time: f64) -> String {
    match time {
        t if t.is_nan() => String::new(),
        t if t < 1e-6 => format!("{:.1} ns", t * 1e9),
        t if t < 1e-3 => format!("{:.2} µs", t * 1e6),
        t => format!("{:.2} ms", t * 1e3),
    }
}
