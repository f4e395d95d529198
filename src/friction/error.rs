//! Malformed input.

use crate::lcp::LcpError;
use crate::prelude::*;

/// The faults that the numbers of a frictional contact problem can have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// W is not square or has an entry that is not finite, or a vector does not fit.
    #[error(transparent)]
    Numbers(#[from] LcpError),
    /// The friction of a contact is negative or not finite.
    #[error("friction of contact {contact} is {value}, but must be finite and not negative")]
    Friction {
        /// The contact, counted from 0.
        contact: usize,
        /// Its friction.
        value: f64,
    },
    /// A word of a file is not of the kind that must be there.
    #[error("word {at} of the file is {}, but must be {allowed}", named(word.as_deref()))]
    Word {
        /// Its position, counted from 1.
        at: usize,
        /// The word; `None` where the file ends.
        word: Option<String>,
        /// The kind of word that must be there.
        allowed: &'static str,
    },
    /// The masses of a file have no inverse.
    #[error("M is not square or singular, but must have an inverse")]
    Masses,
}

/// A word as shown in a message; control characters are escaped, in case the file is no text.
fn named(word: Option<&str>) -> String {
    word.map_or("missing".to_owned(), |word| format!("`{}`", word.escape_default()))
}
