//! How accurate are answers if stiffness, friction, squeeze, lengths or normals are extreme?
//!
//! `cargo run --release -p reports --bin stiff_and_extreme` computes one equilibrium for each row, in the plane and in space, and compares it with
//! exact arithmetic. The resulting contact states are solved again, with every number of the scene and every rounded contact frame regarded as exact. A
//! row shows
//!
//! ```text
//! true error       largest error of a contact force / largest force, load included
//! estimate         the error that the answer itself states, over the same force (Accuracy::force)
//! condition        Accuracy::condition
//! states           right: every condition of every state holds in exact arithmetic
//!                  edge k: the states of k contacts are marked as not distinct from other states (ContactAnswer::distinct)
//!                  WRONG: a condition fails and nothing says so
//! ```
//!
//! Everything is also written to `output/stiff_and_extreme.csv`; the picture shows errors against the stiffness ratio beside the textbook's
//! normal equations.

mod edges;
mod friction;
mod geometry;
mod measure;
mod picture;
mod ring;
mod stiffness;
mod summary;
mod textbook;

use measure::Table;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut table = Table::default();
    stiffness::rows(&mut table)?;
    friction::rows(&mut table)?;
    geometry::rows(&mut table)?;
    edges::rows(&mut table)?;
    table.print();
    table.save()?;
    picture::save(&table)?;
    summary::print(&table);
    Ok(())
}
