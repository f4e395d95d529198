//! The numbers that several searches for equilibria share.

/// Covering vectors tried after a ray where all combinations of states are tried next. Each path costs as much as the first.
///
/// Smaller, equilibria that a second path finds are missed; larger, a search that fails takes longer.
pub(super) const COVERING_VECTORS: usize = 3;
