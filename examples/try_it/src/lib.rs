//! Answers for the page of `try-it`: a scene in a line of JSON, answered by the crate, in WebAssembly or natively.
//!
//! The page contains no mechanics. It writes a scene ([the format](grasp_lcp::scene)) and draws the answers.
//!
//! # Why not wasm-bindgen
//!
//! One text is passed in and one is returned, for which three functions in [`memory`] suffice. wasm-bindgen would save some twenty lines of
//! JavaScript. But its command-line tool would have to be installed first, in exactly the version of the library. `cargo` alone builds the page.

#[cfg(target_family = "wasm")]
pub mod memory;

use grasp_lcp::stream::{StreamOptions, answer_line};

/// Largest number of contact points. With twice as many an answer may take longer than a frame of the screen.
const MOST_POINTS: usize = 12;
/// Largest number of combinations of contact states to try, at some microseconds each. With more, dragging on the page would not be smooth.
const MOST_STATES: usize = 1000;
/// Largest number of steps along sliding arcs. Scenes in the plane need none.
const MOST_STEPS: usize = 100;

/// The answer to a scene, in one line, with bounded work. It is empty for text that is not JSON.
#[must_use]
pub fn reply(text: &[u8]) -> String {
    let mut options = StreamOptions::default().on_threads(1);
    options.most_points = MOST_POINTS;
    options.most_states = MOST_STATES;
    options.most_steps = MOST_STEPS;
    // Text that is not JSON gives an empty answer, which the page reports.
    answer_line(text, &options).unwrap_or_default()
}
