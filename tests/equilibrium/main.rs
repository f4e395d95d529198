//! The equilibrium of one grasp under one load.

mod any_numbers;
mod bad_contacts;
mod bad_fingertips;
mod bad_questions;
mod branch_and_bound;
mod closed_forms;
mod condition;
mod exact_equilibria;
mod exact_states;
mod foreign_answers;
mod foreign_vectors;
mod frames;
mod frictionless_sliding;
mod invariance;
mod near_the_trial;
mod nearly_symmetric;
mod overlap_and_world_commands;
mod pinch;
mod properties_law;
mod rectangular_pad;
mod round_cone;
mod small_motions;
mod soft_fingertip;
mod soft_fingertip_torsion;
mod valid;
