//! Limits below which a quantity of a contact counts as zero, shared by several rooms.

/// Slacks below this part of their size are zero: rounding of forces and gaps that result from one linear solve. Symmetric grasps reach
/// several edges at once, and edges reached together must count as one event.
pub(crate) const ZERO_SLACK: f64 = 5e-14;

/// Upper bound of the slack for rounding, relative to the size of a condition, where a piece amplifies rounding.
///
/// Smaller, true answers of badly conditioned pieces are refused. Larger, conditions that are broken count as kept.
pub(crate) const MOST_SLACK: f64 = 1e-10;

/// A force below this part of its size is zero: the contact is at the apex of its cone. Looser than [`ZERO_SLACK`], since facets
/// that meet near the apex cannot be distinguished there.
pub(crate) const WEIGHTLESS: f64 = 1e-12;

/// Added to every size: below it, intermediate results are subnormal and lose relative precision.
pub(crate) const SMALLEST: f64 = 1e-250;

/// Arcs are not divided below this angle. A wedged object travels the farther the flatter its taper is. Where fingers are symmetric but for
/// 1e-8 of their normals, directions of slip matter to that angle; below it the distance that contradicts is rounding.
///
/// Smaller, a search divides arcs whose contradiction is rounding; larger, wedged objects are not decided.
pub(super) const NARROWEST_ARC: f64 = 1e-8;
