//! Malformed input.

use crate::lcp::LcpError;

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
}
