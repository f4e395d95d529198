//! Malformed input.

use crate::lcp::LcpError;
use crate::prelude::*;

/// Faults of the input of a frictional contact problem.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// W is not square or has an entry that is not finite, or a vector has the wrong length.
    #[error(transparent)]
    Numbers(#[from] LcpError),
    /// The friction coefficient of a contact is negative or not finite.
    #[error("friction of contact {contact} is {value}, but must be finite and not negative")]
    Friction {
        /// The contact, counted from 0.
        contact: usize,
        /// The friction coefficient that was given.
        value: f64,
    },
    /// A word of a file is not of the required kind.
    #[error("word {at} of the file is {}, but must be {allowed}", named(word.as_deref()))]
    Word {
        /// Its position, counted from 1.
        at: usize,
        /// The word; `None` at the end of the file.
        word: Option<String>,
        /// The required kind of word.
        allowed: &'static str,
    },
    /// The mass matrix of a file has no inverse.
    #[error("M is not square or singular, but must have an inverse")]
    Masses,
}

/// A word as messages show it. Control characters are escaped, in case the file is not text.
fn named(word: Option<&str>) -> String {
    word.map_or("missing".to_owned(), |word| format!("`{}`", word.escape_default()))
}
