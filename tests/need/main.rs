//! Needed amounts: closed forms, and tests on both sides of each amount.

mod both_sides;
mod brute_force;
mod closed_forms;
mod repeated;
mod windows;
