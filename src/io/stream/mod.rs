//! Scenes in JSON, one a line, answered in order on all cores in bounded memory (feature `json`).
//!
//! Every line of input is a scene ([the format](crate::scene)) on one line. Every line of output is an object for that line:
//!
//! | field | value |
//! |---|---|
//! | `line` | number of the line in this input, from 1 |
//! | `id` | the `id` of the scene, if it has one |
//! | `hash` | if there is no id: 64 bits of FNV-1a over the bytes of the line, without white space at its ends, in 16 hexadecimal digits |
//! | `answers` | one answer for each question, in order |
//! | `brief` | short answers ([`Brief`](crate::scene::Brief)) in place of `answers`, if [`StreamOptions::brief`] is set |
//! | `warnings` | probable mistakes in the scene ([`Warning`](crate::scene::Warning)), if there are any |
//! | `error` | in place of the answers: `kind`, `message`, `field`, `column`; see [`Fault`](crate::scene::Fault). Its kind is `internal` if this library failed; all other lines are answered nevertheless |
//! | `begins` | the first characters of a line that is no scene and has no id |
//! | `blank` | `true` for a line of white space; the object then has only this field and `line` |
//!
//! The `id` or `hash` identifies a line if its input was split between several processes, each of which counts lines from 1.
//!
//! [`answer_line`] answers a single line without threads, as in a web page.
//! In [`answer_lines`], one thread reads lines into blocks, workers answer blocks, and the caller's thread writes the answers in order.

mod line;
mod lines;
mod options;
mod reply;
mod single;

pub use line::LONGEST_LINE;
pub use lines::{BLOCK_BYTES, Tally, answer_lines, most_ahead};
pub use options::StreamOptions;
#[cfg(feature = "schema")]
pub(crate) use reply::Reply;
pub use single::answer_line;
