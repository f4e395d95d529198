//! The accuracy of factors and probabilities.

/// Relative accuracy of the load factor that holds with a probability.
///
/// If smaller, the search takes more steps, each with the failure probabilities of all contacts. If larger, the load factor jumps with the data.
pub(super) const PRECISE_FACTOR: f64 = 1e-8;

/// Number of directions around a round cone among which the worst is sought.
///
/// The distance between two of them is also the least half width of the integral about the worst one, so that it contains the true worst direction.
/// Fewer directions can miss it; more cost a search each.
pub(super) const AROUND_A_CONE: usize = 16;

/// Least eigenvalue and determinant of second derivatives by which a failure probability is corrected.
///
/// Where it is reached the expansion about the point of failure no longer describes the margin. If smaller, a few failures that are
/// counted too often leave no reserve; if larger, frequent failures are counted as rare.
pub(super) const LEAST_CURVED: f64 = 0.1;

/// Share of the allowed failure probability that is kept for what is neglected: joint effects of two data on the curvature of a margin.
///
/// If larger, reserves are smaller. If smaller, grasps may slide more often than allowed.
pub(super) const NEGLECTED_SHARE: f64 = 0.25;

/// Of failures that are rarer than this share of the allowed probability neither joint effects of data nor correlations with others are computed.
///
/// If larger, reserves are smaller. If smaller, the search computes what does not count.
pub(super) const RARE_SHARE: f64 = 1e-3;
