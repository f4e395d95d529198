//! How do the solvers scale, from a pinch to a hundred thousand contacts?
//!
//! `cargo run --release -p reports --bin scaling [most contacts or bodies]` prints each run time, best of several runs, with ratios to two other run
//! times of the same run, if these do not take too long to measure. The first is the crate's general method for a few contacts (the dense form for
//! an equilibrium, `Grasp::onset`, `Grasp::follow`). The second is the usual method without the crate (the reduced quadratic program by an
//! interior-point method: once for an equilibrium, bisected for an onset). The column "of the limit" is the least time of the machine for the bytes
//! and operations of the work, see [`limits`], over the measured time. With `--features simd` batches use wider vectors. For several bodies each row
//! is the cost of one body.
#![allow(clippy::doc_markdown, unreachable_pub)]

mod bodies;
mod equilibria;
mod limits;
mod onsets;
mod paths;
mod report;
mod today;

/// The numbers of contacts up to `most`.
fn up_to<const N: usize>(most: usize, counts: [usize; N]) -> impl Iterator<Item = usize> {
    counts.into_iter().filter(move |n| *n <= most)
}

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn main() -> Outcome {
    let most = std::env::args().nth(1).map_or(Ok(usize::MAX), |most| most.parse())?;
    limits::print_machine();
    report::head();
    onsets::rows()?;
    equilibria::few_contacts()?;
    equilibria::patches(most)?;
    paths::rows(most)?;
    equilibria::whole_solve(most)?;
    bodies::rows(most)
}
