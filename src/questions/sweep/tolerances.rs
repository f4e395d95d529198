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
