//! Limits below which a quantity of a contact counts as zero, for all uses of the contact law.

/// Slacks below this fraction of their size are zero: the rounding of forces and gaps from one linear solve. Symmetric grasps reach several
/// edges at once, and these must count as one event.
pub(crate) const ZERO_SLACK: f64 = 5e-14;

/// Largest allowance for rounding, relative to the size of a condition, if ill-conditioning of the linear system amplifies rounding.
///
/// Smaller, true answers of ill-conditioned systems are refused. Larger, violated conditions pass as satisfied.
pub(crate) const MOST_SLACK: f64 = 1e-10;

/// A force below this fraction of its size is zero, so that the contact is at the apex of its cone. Looser than [`ZERO_SLACK`], since facets
/// that meet near the apex cannot be told apart there.
pub(crate) const WEIGHTLESS: f64 = 1e-12;

/// Added to every size: below it, intermediate results are subnormal and lose relative precision.
pub(crate) const SMALLEST: f64 = 1e-250;

/// Least width of a sector of friction directions that is still divided, rad. The flatter its taper, the farther a wedged object travels. If
/// fingers deviate from symmetry by 1e-8 in their normals, slip directions matter to that angle; below it a contradiction is rounding.
///
/// Smaller, a search divides sectors whose contradiction is only rounding. Larger, grasps that wedge the object remain undecided.
pub(super) const NARROWEST_ARC: f64 = 1e-8;
