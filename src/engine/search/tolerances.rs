//! Limits that several methods of the search for an equilibrium share: numbers of contacts, covering vectors and multiplications.

/// Number of covering vectors that Lemke's method tries after it has ended on a ray, if all combinations of states are tried next. Each run costs as
/// much as the first.
///
/// If smaller, equilibria that a second run finds are missed; if larger, a search that fails takes longer.
pub(super) const COVERING_VECTORS: usize = 3;

/// From this many contacts on, Newton's method and the search for a separating motion come first. With few contacts Newton's method often cycles;
/// with many hardly ever, unless stiffnesses and friction lie decades apart. Above this number a linear program hardly ever finds a proof that the
/// search for a separating motion has missed.
///
/// If smaller, some grasps with few contacts get no proof; if larger, grasps with many contacts wait for a search that finds nothing.
pub(super) const MANY_CONTACTS: usize = 32;

/// From this many contacts on Newton's method comes first in the plane and on polygons. There must be no more coordinates than those of one object in
/// space. With 8 to 20 contacts it then needs two thirds of the time of Lemke's method on a matrix. With more coordinates it often cycles.
///
/// If smaller, Newton's method is often tried in vain; if larger, grasps by a dozen fingers take longer.
pub(super) const SEVERAL_CONTACTS: usize = 8;

/// Upper limit of the number of multiplications of all runs of Lemke's method on one complementarity problem, if the caller sets no limit on pivots:
/// about a second. If larger, a search over thousands of contacts without an equilibrium takes minutes to give up. If smaller, some equilibria are
/// missed.
pub(super) const MOST_WORK: usize = 500_000_000;

/// The stuck grasp relaxes towards an equilibrium (`ViscousRelaxation`), and Newton's method continues from the end of the relaxation. If Newton's
/// method ends within this fraction of the distance relaxed, it has found that equilibrium.
///
/// If smaller, equilibria are refused if relaxation is slow and the remaining distance is longer than its steps suggest. If larger, other equilibria,
/// to which only a jump of Newton's method leads, are taken for that equilibrium.
pub(super) const BESIDE_THE_WAY: f64 = 0.3;
