//! Numbers, loads, motions and names in sentences.
//!
//! Every number has its unit. It has six significant digits unless [`Words::with_digits`], or the precision of a formatted answer,
//! `format!("{verdict:.12}")`, asks for others.
//!
//! ```
//! use grasp_lcp::nalgebra::Vector2;
//! use grasp_lcp::planar::Wrench;
//! use grasp_lcp::words::{Unit, Words, printable};
//!
//! let words = Words::default();
//! assert_eq!(words.number(-0.0), "0");
//! assert_eq!((words.length(0.002_846_12), words.length(0.25)), ("2.84612 mm".to_owned(), "0.25 m".to_owned()));
//! assert_eq!(words.place(&Vector2::new(0.03, -0.0)), "(0.03, 0) m");
//! assert_eq!(words.in_unit(Unit::Millimetre).place(&Vector2::new(0.03, -0.25)), "(30, -250) mm");
//! assert_eq!(words.load(&Wrench::new([0.0, -4.905], 0.2)), "(0, -4.905) N and 0.2 N m");
//! assert_eq!(Words::with_digits(3).angle(0.5), "28.6°");
//! assert_eq!(printable("left\u{1b}[2J\n"), "left\\u{1b}[2J\\n");
//! ```

mod contact_label;
mod link_kind;
mod names;
mod numbers;
mod tolerances;
mod unit;

pub use contact_label::ContactLabel;
pub use link_kind::LinkKind;
pub(crate) use link_kind::{open, opens};
pub(crate) use names::listed;
pub use names::printable;
pub use numbers::Words;
pub(crate) use tolerances::{ALIKE_IN_WORDS, MOST_NAMES};
pub use unit::Unit;
