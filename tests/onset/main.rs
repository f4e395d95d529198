//! The load at which a contact starts to slide.

mod bracket;
mod closed_forms;
mod every_direction;
mod geometry;
mod geometry_closed_forms;
mod invariance;
mod kept_closed;
mod least_squeeze;
mod search;
mod sensitivity;
mod turn;
mod turn_exact;
mod workspace;
