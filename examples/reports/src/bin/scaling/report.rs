//! The printed table of run times.

use crate::limits::Limit;

/// Prints the heads of the columns.
pub fn head() {
    println!(
        "{:<62} {:>10} {:>10} {:>6} {:>10} {:>7} {:>15}  remarks",
        "work", "time", "in general", "ratio", "today", "ratio", "of the limit"
    );
}

/// Run times for comparison, s; NaN is not printed.
#[derive(Clone, Copy)]
pub struct Beside {
    /// Time of the crate's general method.
    pub in_general: f64,
    /// Time of the usual method without the crate.
    pub today: f64,
    /// Lower bound of the time on this machine.
    pub limit: Limit,
}

impl Beside {
    pub const NOTHING: Self =
        Self { in_general: f64::NAN, today: f64::NAN, limit: Limit { time: f64::NAN, by: "" } };
}

/// Prints one row of the table.
pub fn row(work: &str, time: f64, beside: Beside, remarks: &str) {
    let Beside { in_general, today, limit } = beside;
    let ratio = |other: f64| match other / time {
        r if r.is_nan() => String::new(),
        r if r < 100.0 => format!("{r:.1}"),
        r => format!("{r:.0}"),
    };
    let reached = match limit.time / time {
        part if part.is_nan() => String::new(),
        part => format!("{:.0} % {}", 100.0 * part, limit.by),
    };
    println!(
        "{work:<62} {:>10} {:>10} {:>6} {:>10} {:>7} {reached:>15}  {remarks}",
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
