//! Lemke's method on contact states.

mod allocation;
mod path;
mod path_pad;
mod path_work;
mod pivots;
mod workspace;
