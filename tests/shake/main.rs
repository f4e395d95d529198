//! Loads that repeat: closed forms, and comparison with cycles that are followed.

mod asked;
mod followed_cycles;
mod momentum;
mod opens;
mod rocked_ball;
mod shakedown;
mod to_and_fro;
mod too_far;
mod two_nodes;
mod walking_block;
mod within_a_play;
