//! Run time and error of answers: each question by the crate's method and by the usual alternatives.
//!
//! Six parts: the onset of sliding, a load that turns, the friction cone in space, the forces while everything sticks, a load path, and a round fingertip. Errors
//! are taken against closed forms and exact rational arithmetic; a time is the shortest one of many calls, with
//! the assembly of matrices. Calls of more than a second are timed once; on a busy machine their times are too long.
//!
//! `cargo run --release -p reports --bin error_vs_runtime`
#![allow(unreachable_pub)]

mod exact_sticking;

mod cone;
mod onset;
mod patch;
mod path;
mod report;
mod sticking;
mod turn;

use support::Failure;

fn main() -> Result<(), Failure> {
    let mut report = report::Report::default();
    onset::measure(&mut report)?;
    turn::measure(&mut report)?;
    cone::measure(&mut report)?;
    sticking::measure(&mut report)?;
    path::measure(&mut report)?;
    patch::measure(&mut report)?;
    report.save("error_vs_runtime")
}
