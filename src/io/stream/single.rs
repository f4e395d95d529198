//! Answers one line of a stream of scenes (one JSON scene a line), for callers without threads.

use super::line::{InputLine, LONGEST_LINE};
use super::options::StreamOptions;
use super::reply::Reply;

/// The line of output for one line of input, as [`answer_lines`](super::answer_lines) writes it, with line number 1 and without a newline. The
/// caller's thread computes it; [`StreamOptions::threads`] has no effect.
///
/// ```
/// use grasp_lcp::stream::{StreamOptions, answer_line};
///
/// assert_eq!(answer_line(b"  ", &StreamOptions::default())?, r#"{"line":1,"blank":true}"#);
/// assert!(answer_line(b"{}", &StreamOptions::default())?.contains(r#""error":{"kind":"scene""#));
/// # Ok::<(), serde_json::Error>(())
/// ```
///
/// # Errors
/// The error of writing the answer in JSON. If the line is no scene, the returned line contains the fault.
pub fn answer_line(text: &[u8], options: &StreamOptions) -> serde_json::Result<String> {
    let line = InputLine { number: 1, text: text.to_vec(), too_long: text.len() > LONGEST_LINE };
    serde_json::to_string(&Reply::to(&line, options))
}
