//! The limits of size and of work that several searches for equilibria share.

/// Covering vectors tried after a ray, where all combinations of states are tried next. Each path costs as much as the first.
///
/// Smaller, equilibria that a second path finds are missed; larger, a search that fails takes longer.
pub(super) const COVERING_VECTORS: usize = 3;

/// From this many contacts on, Newton's method and the search for a separating motion come first. With few contacts Newton's method often
/// cycles; with many hardly ever, unless stiffnesses and friction lie decades apart. Above this number a linear program hardly finds a proof
/// that the search has missed.
///
/// Smaller, scenes of few contacts miss proofs; larger, scenes of many wait for a search that finds nothing.
pub(super) const MANY_CONTACTS: usize = 32;

/// Multiplications of all paths of one rung where the caller sets no limit on pivots: about a second. With a larger limit a scene of thousands of
/// contacts without an equilibrium takes minutes to give up. With a smaller one some solvable scenes are given up.
pub(super) const MOST_WORK: usize = 500_000_000;

/// Distance, as a part of the way on which the stuck grasp relaxed, up to which Newton's method has ended at the equilibrium of that way.
///
/// Smaller, equilibria are refused to which slow relaxation has farther to go than its steps show; larger, equilibria are taken that only Newton's method
/// jumps to.
pub(super) const BESIDE_THE_WAY: f64 = 0.3;
