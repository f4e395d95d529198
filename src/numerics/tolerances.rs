//! Tolerances of linear algebra, and scales that several higher modules share.
//!
//! All tolerances are without units. They are fractions of the terms, or of the largest value, from which a result was computed. ε = 2⁻⁵².

/// The rounding of a few operations, relative to their terms: 4 ε.
///
/// Examples: a normal computed as (cos π/2, sin π/2) has a component of 6e-17 instead of zero; the residual of Newton's method stagnates at this
/// level. With a smaller tolerance such a component counts as a true direction of a spring, and iterations continue on rounding errors. With a larger
/// one the contributions of soft springs are dropped where stiff springs act too, and contact forces lose their last digit.
pub(crate) const FEW_ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// The rounding of a short sum, relative to its largest term: some sixteen operations, 16 ε.
///
/// If smaller, rounding separates exact ties. Rows of a complementarity problem that block a pivot together are then not treated as a tie. And an
/// angle at which two functions only touch is taken for a crossing, or missed. If larger, rows that block a pivot one after another count as ties,
/// and functions that cross slowly count as touching.
pub(crate) const ROUNDED_SUM: f64 = 16.0 * f64::EPSILON;

/// The rounding of a quantity that results from linear solves, relative to the largest of its kind.
///
/// Systems of condition 1e3 leave rounding errors of 1e-13. With a smaller tolerance ties of symmetric grasps are separated, and forces that balance
/// seem not to. With a larger one quantities that the caller can see count as zero.
pub(crate) const SOLVED_ROUNDING: f64 = 1e-12;

/// Relative magnitude below which a quantity is negligible: a gap, a slip, a gain, a difference of two results.
///
/// It lies between the rounding of solves (1e-12) and the digits of data and sentences (1e-6). With a smaller tolerance results of iterations differ
/// by their own error. With a larger one measurable effects are omitted.
pub(crate) const NEGLIGIBLE: f64 = 1e-9;

/// The fraction t of a Newton step is accepted if it reduces the error by at least this part of the decrease that the linearisation predicts.
///
/// This is Armijo's rule. With a value near 1, full Newton steps would be rejected. With the value 0, steps without progress would be accepted, and a
/// search could cycle.
pub(crate) const SUFFICIENT_DECREASE: f64 = 0.1;

/// A vector is linearly dependent on others if its component orthogonal to them is below this fraction of its length. A matrix whose smallest
/// pivot is below this fraction of its largest pivot is singular.
///
/// Rounding leaves some 1e-15 of an exactly dependent vector. Two unit normals whose directions differ by 1e-12 still count as independent. If the
/// fraction were smaller, rounding errors would count as stiffness along a motion that no spring resists. If it were larger, the stiffness of soft
/// springs would be dropped where stiff springs act too.
pub(crate) const LINEARLY_DEPENDENT: f64 = 1e-13;

/// LU with partial pivoting gives no factors if a pivot is at most this fraction of the largest entry of the matrix.
///
/// [`CompletePivoting`](super::CompletePivoting) or [`Orthogonal`](super::Orthogonal) must then find out whether the matrix is singular or only soft
/// in some direction. With pivots above this limit a solution has some six correct digits without refinement. If the limit were smaller, callers that
/// do not refine would get wrong digits; if it were larger, more matrices would need the slower factors.
pub(super) const PARTIAL_PIVOT: f64 = 1e-10;

/// A pivot of a band matrix counts as zero if it is at most this fraction of the largest entry of the matrix.
///
/// The fraction is smaller than [`PARTIAL_PIVOT`], since solutions of band systems are refined. In an exactly singular matrix rounding leaves a pivot
/// of some 1e-16 of the largest entry. If `BAND_PIVOT` were larger, the stiffness of soft springs would be dropped where stiff springs act too.
pub(super) const BAND_PIVOT: f64 = 1e-11;

/// A matrix does not count as positive definite if a pivot is below this fraction of the original diagonal entry in the same row.
///
/// If smaller, a semidefinite matrix gets factors that consist of rounding. If larger, matrices of condition 1e12 get no factors.
pub(super) const POSITIVE_PIVOT: f64 = 1e-12;

/// A convex set counts as flat if, in some direction, it is thinner than this fraction of the largest distance of its support points from the origin.
///
/// If smaller, a flat set gets a volume that consists of rounding. If larger, thin sets count as flat, and wrenches inside such a set count as
/// outside.
pub(super) const FLAT_SET: f64 = 1e-10;

/// The search for the largest ball about the origin in a convex set lets a polytope grow within the set. The distance of the polytope's closest face
/// from the origin should not decrease. A decrease up to this fraction of the distance of the first vertices from the origin is accepted as rounding;
/// a larger one ends the search.
///
/// If smaller, sets of many points end with a loose bound. If larger, a polytope with a wrong face continues to grow.
pub(super) const POLYTOPE_SHRINKS: f64 = 1e-7;

/// Limit for rounding in the search for the point where a ray leaves a convex set. The ray crosses a plane through some points of the set. No point
/// of the set lies beyond this plane if none is farther from the start of the ray than the plane by more than this fraction. The length of a ray
/// counts as zero up to this fraction of the norms of its two ends, and a pivot up to this fraction of the largest.
///
/// If smaller, rounding exchanges points of the plane until the limit of the number of pivots. If larger, the length of a ray has fewer correct
/// digits.
pub(super) const BEYOND_PLANE: f64 = 1e-13;
