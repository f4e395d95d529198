//! Shared by tests and examples: scenes, independent oracles for their answers, and the paper's numbers.
//!
//! An oracle takes from the library only the answer to judge and the data of the scene.
#![allow(
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use,
    reason = "tests and examples use whatever they ask for, and stop at whatever fails"
)]

mod affine;
pub mod amounts;
pub mod best_time;
pub mod bracket;
pub mod cards;
mod close;
pub mod closure_margin;
pub mod compiled;
pub mod coulomb;
pub mod dyadic;
pub mod elimination;
pub mod ends;
pub mod exact;
pub mod exact_lcp;
mod facts;
pub mod friction_alone;
pub mod identified;
pub mod interior_point;
pub mod jaws;
pub mod kinetic;
pub mod limit_analysis;
pub mod loaded;
pub mod measured_pushes;
pub mod minimum_power;
pub mod odd_paths;
pub mod paper;
pub mod patches;
pub mod piles;
pub mod pointed_arch;
pub mod printed_program;
pub mod programs;
pub mod quadratic_program;
pub mod ramps;
pub mod random;
pub mod reduced_program;
pub mod samples;
pub mod scene;
pub mod shaken;
pub mod siconos;
mod siconos_matrix;
pub mod soft_tips;
pub mod spatial_piles;
pub mod splitmix;
pub mod stacks;
pub mod sticking;
pub mod svg;
pub mod tractrix;
pub mod transform;
pub mod truth;
mod truth_equations;
pub mod two_bodies;
pub mod voussoirs;

pub use close::relatively_close;
pub use facts::facts;

use std::io;
use std::path::PathBuf;

/// Any error that stops an example.
pub type Failure = Box<dyn std::error::Error>;

/// Writes a picture into `output/` and prints its path.
pub fn save(name: &str, svg: &str) -> io::Result<()> {
    let folder = PathBuf::from("output");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join(name);
    std::fs::write(&path, svg)?;
    println!("wrote {}", path.display());
    Ok(())
}
