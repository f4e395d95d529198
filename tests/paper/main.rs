//! The numbers, matrices and tables of the paper.

mod grasp;
mod load_path;
mod matrices;
mod tables;
