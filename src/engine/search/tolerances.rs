//! Limits that several methods of the search for an equilibrium share: numbers of contacts, covering vectors and multiplications.

/// If Lemke's method ends on a ray, it runs again with another covering vector (the vector along which it starts), at most this many times. This
/// limit is used on the round cone, and if all combinations of contact states can be tried afterwards. In other searches the limit is 16. Each run
/// costs as much as the first.
///
/// If smaller, equilibria that a second run finds are missed; if larger, a search that fails takes longer.
pub(super) const COVERING_VECTORS: usize = 3;

/// From this number of contacts on, Newton's method and the search for a separating motion are tried before Lemke's method. With few contacts
/// Newton's method often cycles. With many it hardly ever does, unless stiffnesses and friction differ by orders of magnitude. With fewer contacts
/// the solver of the complementarity problem also searches for a proof by a linear program. With more contacts such a program hardly ever finds a
/// proof that the search for a separating motion has not found before.
///
/// If smaller, some grasps with few contacts get no proof that no equilibrium exists; if larger, grasps with many contacts wait for a linear program
/// that finds nothing.
pub(super) const MANY_CONTACTS: usize = 32;

/// From this number of contacts on, Newton's method is tried before Lemke's method in the plane and on polygonal cones, if the twist has at most six
/// coordinates (one object). With 8 to 20 contacts it needs two thirds of the time of Lemke's method. With more coordinates it often cycles.
///
/// If smaller, Newton's method is often tried in vain; if larger, grasps by a dozen fingers take longer.
pub(super) const SEVERAL_CONTACTS: usize = 8;

/// Upper limit of the number of multiplications of all runs of Lemke's method on one complementarity problem, if the caller sets no limit on pivots.
/// This number takes about a second. With a larger number a search over thousands of contacts without an equilibrium takes minutes to give up. With a
/// smaller one some equilibria are missed.
pub(super) const MOST_WORK: usize = 500_000_000;

/// An artificial viscous motion leads from the elastic trial (every contact sticks) towards an equilibrium (`object/relaxing`), and Newton's method
/// continues from points of this motion. The result of Newton's method is taken as this equilibrium if it is near the point from which Newton's
/// method started. Their distance must be at most this fraction of the displacement from the elastic trial to that point.
///
/// If smaller, this equilibrium is refused if the viscous motion has not come close enough to it yet. If larger, another equilibrium, to which
/// Newton's method has jumped, is taken as this equilibrium.
pub(super) const NEAR_THE_RELAXED_STATE: f64 = 0.3;

/// In branch and bound on the round cone, an equilibrium with stretches and forces at least this multiple of those of the elastic trial, in energy
/// units, counts as none: parts would have to move by kilometres. This is asked before the relaxation of a case is solved to the end, where rounding hides
/// the contradiction.
///
/// If smaller, equilibria of very soft contacts beside very stiff ones are missed; if larger, cases whose only equilibrium is near infinity stay
/// undecided.
pub(super) const OUT_OF_REACH: f64 = 1e8;
