//! The best finger places and squeezes: optima in closed form, multipliers against differences, and random starts against a grid.

mod against_a_grid;
mod at_the_limit;
mod bad_questions;
mod closed_forms;
mod in_space;
mod multipliers;
mod no_move_is_better;
mod reserve;
mod same_bits;
mod typed_in;
mod without_force;
