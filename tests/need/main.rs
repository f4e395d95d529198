//! How much it needs: by closed forms, and tried from both sides.

mod both_sides;
mod brute_force;
mod closed_forms;
mod repeated;
mod said_in_full;
mod windows;
