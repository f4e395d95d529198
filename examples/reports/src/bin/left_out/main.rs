//! Omitted work: rows of the contact law that a scene does not need, and dependencies of features that a user does not select.
//!
//! Each scene is solved by the crate and by the full kinematic formulation, with a row for the gap and one for every facet of every contact. The
//! latter is assembled and solved here from the grasp's data alone; forces must agree. Then follow the dependencies of each cargo feature.
//!
//! `cargo run --release -p reports --bin left_out`, and with `-- --compile` the compile times of the features, each in a fresh temporary folder.
#![allow(unreachable_pub)]

mod features;
mod full;
mod growth;
mod rows;
mod scene;

use scene::Failure;

fn main() -> Result<(), Failure> {
    rows::report()?;
    growth::report()?;
    features::report(std::env::args().any(|argument| argument == "--compile"))
}
