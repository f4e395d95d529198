//! Does it hold: loads put on from rest, and what is said of them.

mod everyday;
mod nothing_near;
mod payload;
mod seals;
mod suction;
mod ways_out;
mod words;
