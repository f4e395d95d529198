//! Malformed input.

use crate::lcp::LcpError;

/// Faults of the input of a frictional contact problem.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The matrix W is not square or has an entry that is not finite, or a vector has the wrong length.
    #[error(transparent)]
    Numbers(#[from] LcpError),
    /// The friction coefficient of a contact is negative or not finite.
    #[error("friction of contact {contact} is {value}, but must be finite and not negative")]
    Friction {
        /// The contact with this coefficient, counted from 0.
        contact: usize,
        /// The friction coefficient that was given.
        value: f64,
    },
}
