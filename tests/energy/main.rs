//! The quadratic program of the paper, laws of friction, stability.

#[path = "../common/mod.rs"]
mod common;
#[path = "../../examples/support/interior_point.rs"]
#[allow(dead_code, unreachable_pub)]
mod interior_point;
#[path = "../../examples/support/minimum_power.rs"]
#[allow(dead_code, unreachable_pub)]
mod minimum_power;
#[path = "../../examples/support/paper.rs"]
#[allow(dead_code, unreachable_pub)]
mod paper;

mod agreement;
mod associated_friction;
mod fixed_points;
mod onset;
mod stability;
