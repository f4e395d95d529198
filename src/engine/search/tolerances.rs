//! Limits that several methods of the search for an equilibrium share: numbers of contacts, covering vectors and multiplications.

/// Number of further covering vectors, one for each further run, after Lemke's method has ended on a ray. This number is used if all combinations of
/// contact states are tried next. Each run costs as much as the first.
///
/// If smaller, equilibria that a second run finds are missed; if larger, a search that fails takes longer.
pub(super) const COVERING_VECTORS: usize = 3;

/// From this number of contacts on, Newton's method and the search for a separating motion precede Lemke's method. With few contacts Newton's method
/// often cycles; with many hardly ever, unless stiffnesses and friction differ by orders of magnitude. From this number on a linear program hardly
/// ever finds a proof that the search for a separating motion has missed.
///
/// If smaller, some grasps with few contacts get no proof; if larger, grasps with many contacts wait for a search that finds nothing.
pub(super) const MANY_CONTACTS: usize = 32;

/// In the plane and on polygons, Newton's method precedes Lemke's method from this number of contacts on, if there are at most six coordinates. With
/// 8 to 20 contacts Newton's method needs two thirds of the time of Lemke's method on a matrix. With more coordinates it often cycles.
///
/// If smaller, Newton's method is often tried in vain; if larger, grasps by a dozen fingers take longer.
pub(super) const SEVERAL_CONTACTS: usize = 8;

/// Upper limit of the number of multiplications of all runs of Lemke's method on one complementarity problem, if the caller sets no limit on pivots.
/// This number takes about a second. If larger, a search over thousands of contacts without an equilibrium takes minutes to give up. If smaller, some
/// equilibria are missed.
pub(super) const MOST_WORK: usize = 500_000_000;

/// An artificial viscous motion leads from the elastic trial (every contact sticks) towards an equilibrium (`object/relaxing`), and Newton's method
/// continues from points of this motion. Newton's method has found that equilibrium if its result differs from its start by less than this fraction
/// of the displacement so far.
///
/// If smaller, that equilibrium is refused if the motion is slow and more of it remains than its steps suggest. If larger, other equilibria, to
/// which only a jump of Newton's method leads, are taken for it.
pub(super) const NEAR_THE_RELAXED_STATE: f64 = 0.3;
