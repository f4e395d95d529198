//! Accuracies of the load factors and failure probabilities in the search for a reserve. A reserve is the load up to which all contacts stick with a
//! required probability. A facet is a plane that bounds a friction cone, or touches a round one; it fails if its margin is negative. The point of
//! failure is the smallest set of data errors at which the margin vanishes. The interaction of errors is the change of a force due to all errors
//! together, less the sum of the changes due to single errors.

/// Relative accuracy of the load factor at which the failure probability equals the allowed one.
///
/// If it were smaller, the search would take more steps, each with the failure probabilities of all contacts. If it were larger, the load factor
/// would no longer be smooth as a function of the data.
pub(super) const PRECISE_FACTOR: f64 = 1e-8;

/// Number of directions around a round cone that are compared to find the direction that most probably fails.
///
/// The failure probability of a round cone is an integral over directions. The interval of integration extends from the direction found at least to
/// the next compared direction on either side, so it contains the true worst direction. Fewer directions can miss the worst direction; each further
/// direction costs a search.
pub(super) const AROUND_A_CONE: usize = 16;

/// Lower limit of the terms (a diagonal entry, a determinant) that describe how a margin curves, and by which its failure probability is corrected to
/// second order.
///
/// Where a term is below this limit, the expansion about the point of failure no longer describes the margin; the limit replaces the term. If the
/// limit were smaller, corrected probabilities might become far too large, so that no reserve is left. If it were larger, they might become far too
/// small.
pub(super) const LEAST_CURVED: f64 = 0.1;

/// Fraction by which the allowed failure probability is reduced, because some effects of the interactions of data errors are neglected.
///
/// If it were larger, reserves would be smaller. If it were smaller, contacts might slide more often than allowed.
pub(super) const NEGLECTED_SHARE: f64 = 0.25;

/// A failure of a facet or contact is rare if its probability is below this fraction of the allowed one. Then neither interactions of data errors nor
/// its correlation with other failures are computed.
///
/// If it were larger, reserves would be smaller. If it were smaller, the search would also compute failures that hardly matter.
pub(super) const RARE_SHARE: f64 = 1e-3;
