//! The load at which a contact starts to slide.

#[path = "../common/mod.rs"]
mod common;
#[path = "../../examples/support/paper.rs"]
#[allow(dead_code, unreachable_pub)]
mod paper;

mod bracket;
mod closed_forms;
mod every_direction;
mod invariance;
mod search;
mod sensitivity;
