//! Frictional contact problems (W, q, μ).

mod closed_forms;
mod invariance;
mod malformed;
mod planar;
mod proofs;
mod round;
