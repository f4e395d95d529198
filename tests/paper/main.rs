//! The paper: its numbers, its matrices, its tables.

mod grasp;
mod load_path;
mod matrices;
mod tables;
