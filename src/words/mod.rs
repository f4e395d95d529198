//! Numbers, loads, motions and names as people read them.
//!
//! Every number has its unit, and six digits unless more are asked for: [`Words::with_digits`], or a precision where a whole answer is written,
//! `format!("{verdict:.12}")`.
//!
//! ```
//! use grasp_lcp::planar::Wrench;
//! use grasp_lcp::words::{Words, printable};
//!
//! let words = Words::default();
//! assert_eq!(words.number(-0.0), "0");
//! assert_eq!(words.length(0.002_846_12), "2.84612 mm");
//! assert_eq!(words.load(&Wrench::new([0.0, -4.905], 0.2)), "(0, -4.905) N and 0.2 N m");
//! assert_eq!(Words::with_digits(3).angle(0.5), "28.6°");
//! assert_eq!(printable("left\u{1b}[2J\n"), "left\\u{1b}[2J\\n");
//! ```

/// What a sentence adds where its answer lies beyond small motions.
pub(crate) const TOO_FAR: &str = "The object turns too far for that: all this is good for small motions";

mod link_kind;
mod names;
mod numbers;

pub use link_kind::LinkKind;
pub(crate) use link_kind::{open, opens};
pub(crate) use names::listed;
pub use names::printable;
pub use numbers::Words;
