//! How do the solvers scale, from a pinch to a hundred thousand contacts?
//!
//! `cargo run --release -p reports --bin scaling [most contacts or bodies]` prints each figure, best of several runs, as ratios beside two others of the same run where those are
//! still affordable: what the crate does in general for a few contacts (the dense form for an equilibrium, `Grasp::onset`, `Grasp::follow`), and what one
//! does today without it (the reduced quadratic program by an interior-point method: once for an equilibrium, bisected for an onset). The
//! column "of the limit" says which part of the least time that the machine takes for the bytes and operations of the work, see [`limits`]. With
//! `--features simd` batches use wider vectors. Of several bodies each row is what one of them costs.
#![allow(clippy::doc_markdown, unreachable_pub)]

mod bodies;
mod equilibria;
mod limits;
mod onsets;
mod paths;
mod report;
mod today;

/// Those numbers of contacts that are not too many.
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
    if most >= 100_000 {
        equilibria::growth()?;
    }
    equilibria::whole_solve(most)?;
    bodies::rows(most)
}
