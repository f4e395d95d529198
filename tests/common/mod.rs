//! What several test files share. Each file uses its own part of it.
#![allow(dead_code, reason = "no test file uses all of it")]

mod affine;
pub(crate) mod close;
pub(crate) mod dyadic;
pub(crate) mod exact;
pub(crate) mod pinch;
pub(crate) mod ramps;
pub(crate) mod random;
pub(crate) mod rolling;
pub(crate) mod scene;
pub(crate) mod transform;
pub(crate) mod truth;
pub(crate) mod valid;
