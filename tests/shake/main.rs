//! Loads that repeat: closed forms, and cycles followed one by one.

mod asked;
mod followed_cycles;
mod rocked_ball;
mod shakedown;
mod to_and_fro;
mod two_nodes;
mod walking_block;
mod within_a_play;
