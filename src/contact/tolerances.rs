//! What counts as zero for a contact, where more than one room has to agree on it.

/// Slacks below this part of their size are zero: rounding of forces and gaps that come out of one linear solve. Symmetric grasps reach
/// several edges at once, and what is reached together must be told as one.
pub(crate) const ZERO_SLACK: f64 = 5e-14;

/// A force below this part of its size is none: the contact stands at the apex of its cone. Looser than [`ZERO_SLACK`], since facets
/// that meet near the apex cannot be told apart there.
pub(crate) const WEIGHTLESS: f64 = 1e-12;

/// Added to every size: below, numbers are subnormal somewhere on the way and have no relative precision.
pub(crate) const SMALLEST: f64 = 1e-250;
