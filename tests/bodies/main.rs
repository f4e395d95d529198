//! Several bodies that touch each other.

mod closed_forms;
mod enumerated;
mod invariance;
mod law;
mod loads;
mod malformed;
mod stacks;
