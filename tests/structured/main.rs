//! Lemke's method on contact states.

#[path = "../common/mod.rs"]
mod common;
#[path = "../load_path/programs/mod.rs"]
mod programs;

mod allocation;
mod path;
mod path_pad;
mod path_work;
mod pivots;
mod workspace;
