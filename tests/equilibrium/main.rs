//! The equilibrium of one grasp under one load.

mod bad_contacts;
mod bad_fingertips;
mod bad_questions;
mod closed_forms;
mod condition;
mod foreign_answers;
mod foreign_vectors;
mod frames;
mod frictionless_sliding;
mod invariance;
mod motion_words;
mod near_the_trial;
mod nearly_symmetric;
mod overlap_and_world_commands;
mod pads;
mod pinch;
mod properties_law;
mod rectangular_pad;
mod round_cone;
mod sliding_and_overloaded;
mod small_motions;
mod soft_fingertip;
mod soft_fingertip_torsion;
mod solution_interval;
mod valid;
mod viscous_slip;
