//! Friction that falls from a static to a kinetic value when a contact slides.

mod catching_sets;
mod closed_forms;
mod closing;
mod in_space;
mod nearly_static;
mod overdamped;
mod pad;
mod programs;
mod unequal;
mod with_joints;
