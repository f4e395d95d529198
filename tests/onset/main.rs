//! The load at which a contact starts to slide.

mod bracket;
mod closed_forms;
mod every_direction;
mod invariance;
mod least_squeeze;
mod search;
mod sensitivity;
mod turn;
mod turn_exact;
