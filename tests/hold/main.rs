//! Does it hold: loads put on from rest, and what is said of them.

mod everyday;
mod kinetic;
mod nothing_near;
mod nothing_near_in_space;
mod payload;
mod seals;
mod suction;
mod touching;
mod ways_out;
mod words;
