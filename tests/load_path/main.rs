//! Load programs, followed with the memory of slip.

mod budget;
mod closed_forms;
mod cut;
mod default_error;
mod ends;
mod energy;
mod everyday;
mod fold;
mod free_motion;
mod in_space;
mod invariance;
mod law;
mod leg_ends;
mod memory;

mod on_facets;
mod pace;
mod partial_slip;
mod recontact;
mod rings;
mod round_cone;
mod sliding_arcs;
mod small_steps;
mod start_at_rest;
mod stepped;
mod story;
mod turning;
mod wedged;
