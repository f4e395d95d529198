//! Answers for the page of `try-it`: a scene in JSON on one line, answered by the crate, in WebAssembly or natively.
//!
//! The page knows nothing of mechanics. It writes a scene ([the format](grasp_lcp::scene)), and draws the answer.
//!
//! # Why not wasm-bindgen
//!
//! One text goes in and one comes out: three functions of the [`memory`] do that. wasm-bindgen would save some twenty lines of
//! JavaScript, and its command-line tool, of exactly the version of the library, would have to be installed first. So `cargo` alone builds the page.

#[cfg(target_family = "wasm")]
pub mod memory;

use grasp_lcp::stream::{StreamOptions, answer_line};

/// Largest number of contact points that a page may ask about. With twice as many an answer may take longer than a frame of the screen.
const MOST_POINTS: usize = 12;
/// Largest number of combinations of contact states that are tried, some microseconds each: with more a drag would falter.
const MOST_STATES: usize = 1000;
/// Steps along sliding arcs; in the plane there are none.
const MOST_STEPS: usize = 100;

/// The answer to a scene on one line, with bounded work.
#[must_use]
pub fn reply(text: &[u8]) -> String {
    let mut options = StreamOptions::default().on_threads(1);
    options.most_points = MOST_POINTS;
    options.most_states = MOST_STATES;
    options.most_steps = MOST_STEPS;
    // An empty answer means that the text is no JSON, which the page reports.
    answer_line(text, &options).unwrap_or_default()
}
