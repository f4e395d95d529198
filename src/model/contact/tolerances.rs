//! Limits below which a quantity of a contact counts as zero, for all users of the contact law. A size is the magnitude of the terms whose difference
//! the quantity is.

/// A margin or gap below this fraction of its size is zero: that much is the rounding of forces and gaps from one linear solve. Symmetric grasps
/// reach several edges at once, and these must count as one event.
pub(crate) const ZERO_SLACK: f64 = 5e-14;

/// Largest allowance for the rounding of a condition, relative to its size. The allowance grows with the condition number of the linear system, up to
/// this bound.
///
/// If smaller, true answers of ill-conditioned systems are refused. If larger, violated conditions pass as satisfied.
pub(crate) const MOST_SLACK: f64 = 1e-10;

/// A force below this fraction of its size is zero, so that the contact is at the apex of its cone. Looser than [`ZERO_SLACK`], since facets
/// that meet near the apex cannot be told apart there.
pub(crate) const WEIGHTLESS: f64 = 1e-12;

/// Added to every size, so that a quantity counts as zero before it is subnormal and has lost its relative precision.
pub(crate) const SMALLEST: f64 = 1e-250;

/// Least width of a sector of friction directions that is still divided, rad. Fingers whose normals deviate from symmetry by 1e-8 may wedge the
/// object, so that slip directions matter to that angle. In narrower sectors a contradiction is only rounding.
///
/// If smaller, a search divides sectors whose contradiction is only rounding. If larger, grasps that wedge the object remain undecided.
pub(super) const NARROWEST_ARC: f64 = 1e-8;
