//! Frictional contact problems (W, q, μ).

mod closed_forms;
mod invariance;
mod islands;
mod malformed;
mod many;
mod planar;
mod proofs;
mod round;
mod siconos;
mod wedged;
