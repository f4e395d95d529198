//! Computes contact forces from a validated grasp, commands and a load: the coupling of the contacts, complementarity problems, searches, proofs,
//! equilibria and load paths.

pub mod equilibrium;
pub mod forms;
pub mod load_path;
pub(crate) mod object;
pub(crate) mod proofs;
pub(crate) mod search;
