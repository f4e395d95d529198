//! Lemke's method on contact states.

mod allocation;
mod pivots;
mod workspace;
