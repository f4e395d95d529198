//! Verdicts: does the grasp hold a load that is applied from rest, and what does the answer say?

mod buckling;
mod buckling_fingers;
mod everyday;
mod hangs_on_hinges;
mod kinetic;
mod kinetic_described_anew;
mod leaks;
mod left_out;
mod limit_of_rotations;
mod named_together;
mod nothing_near;
mod nothing_near_in_space;
mod payload;
mod seals;
mod slides_to_a_stop;
mod small_motions;
mod snap_through;
mod suction;
mod touching;
mod turns_over;
mod ways_out;
mod within_small_motions;
mod words;
