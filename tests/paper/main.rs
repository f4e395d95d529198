//! The paper: its numbers, its matrices, its tables.

#[path = "../common/mod.rs"]
mod common;
#[path = "../../examples/support/paper.rs"]
#[allow(dead_code, unreachable_pub)]
mod paper;

mod grasp;
mod load_path;
mod matrices;
mod tables;
